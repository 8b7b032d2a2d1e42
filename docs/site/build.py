"""Makes the pages that Sphinx builds the site from.

    build.py FOLDER [PROGRAMS]

writes to FOLDER the documents written by hand, and the reference: C++ headers, protos,
the Python package, and what the programs in the folder PROGRAMS say to --help. Exits
with 1 for a link to nothing and for a public name that no comment tells of.
"""

import os
import pathlib
import re
import subprocess
import sys

import declarations
import docstrings

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = ("core/include", "client/include", "types/include", "proto/geodesic")
ORDER = ("README", "guide", "python", "questions", "limits", "operations", "protocol",
         "batches", "benchmarks", "design", "algorithm")
FENCE = "```"
errors = []


def code(language, lines):
    return f"{FENCE}{language}\n" + "\n".join(lines).rstrip() + f"\n{FENCE}\n"


def prose(lines):
    """A comment as Markdown: paragraphs, and what is indented as it stands."""
    found = []
    for paragraph in "\n".join(lines).split("\n\n"):
        parts = paragraph.strip("\n").split("\n")
        if any(re.match(" {2,}|[A-Za-z ]+:$", line) for line in parts):
            found.append(code("text", parts))
        else:
            # What stands between backticks is code.
            words = "\n".join(parts).split("`")
            words[::2] = [re.sub(r"([\\*_<>\[\]#|~$])", r"\\\1", w) for w in words[::2]]
            found.append("`".join(words) + "\n")
    return "\n".join(found)


def reference(folder):
    """Pages of the headers and protos; their paths in the site by those here."""
    pages = {}
    for top in HEADERS:
        for path in sorted([*(ROOT / top).rglob("*.h"), *(ROOT / top).rglob("*.proto")]):
            intro, blocks, undocumented = declarations.read(path.read_text("utf-8"))
            here = path.relative_to(ROOT)
            errors.extend(f"{here}: {name} has no comment" for name in undocumented)
            text = [f"# {path.relative_to(ROOT / top)}\n", prose(intro)]
            language = "cpp" if path.suffix == ".h" else "proto"
            for names, comment, lines in blocks:
                text += [f"## {', '.join(names)}\n", prose(comment), code(language, lines)]
            pages[here] = f"reference/{top.split('/')[0]}/{path.stem}"
            write(folder / f"{pages[here]}.md", "\n".join(text))
    return pages


def python_reference(folder):
    for module, entries in docstrings.read(ROOT / "python/geodesic"):
        text = [f"# {module}\n"]
        for name, signature, documentation in entries:
            if not documentation:
                errors.append(f"{module}: {name} has no docstring")
            text += [f"## {name}\n", code("python", [signature]),
                     code("text", (documentation or "").splitlines())]
        write(folder / f"reference/python/{module}.md", "\n".join(text))


def program_reference(folder, programs):
    def said(*words):
        done = subprocess.run([programs / words[0], *words[1:], "--help"], text=True,
                              check=True, stdout=subprocess.PIPE)
        return code("text", done.stdout.splitlines())
    for program in ("geodesicd", "geodesic"):
        text = [f"# {program}\n", said(program)]
        commands = re.search(r"^(?:Subcommands|Commands):\n((?: .*\n)+)", text[1], re.M)
        for name in re.findall(r"^ {2}(\w+)", commands[1] if commands else "", re.M):
            text += [f"## {program} {name}\n", said(program, name)]
        write(folder / f"reference/programs/{program}.md", "\n".join(text))


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def documents():
    """All, in the order of the site's contents; new ones come last."""
    found = [path.relative_to(ROOT) for pattern in ("*.md", "docs/*.md", "docs/*/*.md")
             for path in sorted(ROOT.glob(pattern))]
    return sorted(found, key=lambda path: ORDER.index(path.stem)
                  if path.stem in ORDER else len(ORDER))


def put_document(document, folder, pages):
    """With links to what is not in the site as text."""
    known = set(documents())

    def link(match):
        text, target = match[1], match[2]
        path, _, anchor = target.partition("#")
        if re.match("https?:|#", target):
            return match[0]
        there = pathlib.Path(os.path.normpath(document.parent / path))
        if not (ROOT / there).exists():
            errors.append(f"{document}: {target} is not there")
        if there in known or there.suffix in (".png", ".webp"):
            return match[0]
        if there in pages:
            up = os.path.relpath(f"{pages[there]}.md", document.parent)
            return f"[{text}]({up})"
        return text
    parts = re.split(r"(^```.*?^```$)", (ROOT / document).read_text("utf-8"),
                     flags=re.M | re.S)
    parts[::2] = [re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)", link, part)
                  for part in parts[::2]]
    write(folder / document, "".join(parts))
    for image in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", "".join(parts)):
        there = folder / document.parent / image
        there.parent.mkdir(parents=True, exist_ok=True)
        try:
            there.write_bytes((ROOT / document.parent / image).read_bytes())
        except FileNotFoundError:
            errors.append(f"{document}: {image} is not there")


def contents(title, paths):
    entries = "\n".join(str(path.with_suffix("")) for path in paths)
    return f"\n{FENCE}{{toctree}}\n:caption: {title}\n:maxdepth: 1\n\n{entries}\n{FENCE}\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    pages = reference(folder)
    python_reference(folder)
    if len(sys.argv) > 2:
        program_reference(folder, pathlib.Path(sys.argv[2]))
    for document in documents():
        put_document(document, folder, pages)
    made = sorted(path.relative_to(folder) for path in folder.glob("reference/*/*.md"))
    index = contents("Documents", documents())
    for kind in ("programs", "python", "core", "client", "types", "proto"):
        if any(path.parts[1] == kind for path in made):
            index += contents(kind, [path for path in made if path.parts[1] == kind])
    write(folder / "index.md", "# geodesic\n" + index)
    print("\n".join(errors), file=sys.stderr)
    return bool(errors)


if __name__ == "__main__":
    sys.exit(main())
