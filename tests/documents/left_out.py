"""Which commands of the documents a run leaves out, and why.

Each is named by how it begins. All others run, as do all other blocks.
"""

ALWAYS = {
    "./scripts/test": "it is what runs this; .ci/run runs it",
}

# By scripts/test, which installs nothing and has built all; scripts/checks/documents
# runs them in a fresh Debian.
ON_THIS_MACHINE = {
    "./scripts/python": "installs packages",
    "./scripts/demo": "installs packages",
    "apt-get install": "installs packages",
    "cmake -B build/core": "the core was built, tested and installed elsewhere",
    "cmake --build build/core": "as above",
    "cmake --install": "tests/install_consumer does, into a folder",
    "scripts/python": "installs packages",
    "scripts/install-dependencies": "installs packages",
    "/usr/bin/python3 -m venv": "tests/python installs the package into a folder",
    "environment/bin/pip": "as above",
    "(cd python && ../environment/bin/python setup.py":
        "tests/python/source_distribution_test.py does",
}
