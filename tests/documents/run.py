"""Runs the commands and code of a document, in order, as somebody would who copies
them.

    run.py DOCUMENT --build FOLDER --prefixes FOLDER... --package FOLDER
        on this machine, with what was built: in a folder that looks like the
        repository after scripts/demo and scripts/python. The Horse is generated
        where GEODESIC_TEST_MESHES has none.
    run.py DOCUMENT --chroot ROOT --folder FOLDER
        in a fresh system that has the repository in FOLDER.

left_out.py says what is not run. Servers have the ports that the document says: on this
machine in a network of their own, where that can be had.
"""

import argparse
import fcntl
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import tempfile

import blocks
import left_out
import session

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def own_network():
    """Starts this program again where nobody else has a port, if it may."""
    mark = "GEODESIC_DOCUMENTS_NETWORK"
    if mark not in os.environ:
        os.environ[mark] = "own"
        for options in (["-n"], ["-rn"]):
            unshare = ["unshare"] + options
            if shutil.which("unshare") and not subprocess.run(
                    unshare + ["true"], stderr=subprocess.DEVNULL,
                    check=False).returncode:
                os.execvp("unshare", unshare + [sys.executable] + sys.argv)
        os.environ[mark] = "shared"
    if os.environ[mark] == "own":
        # ip may not be installed: SIOCSIFFLAGS, IFF_UP.
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            fcntl.ioctl(probe, 0x8914, struct.pack("16sH14x", b"lo", 1))


def put_horse(folder):
    """The Horse or, of about as many faces, a terrain in its place; True if it is
    the Horse."""
    meshes = pathlib.Path(os.environ.get("GEODESIC_TEST_MESHES",
                                         REPOSITORY.parent / "shared" / "meshes"))
    horse = meshes / "real" / "horse_be.ply"
    for name in ("horse.ply", "horse-input.ply"):
        if horse.exists():
            shutil.copyfile(horse, folder / name)
            continue
        sys.path.insert(0, str(REPOSITORY / "tests" / "python"))
        import meshes as generated
        vertices, faces = generated.terrain(220)
        with open(folder / name, "w", encoding="utf-8") as file:
            file.write("ply\nformat ascii 1.0\n"
                       f"element vertex {len(vertices)}\n"
                       "property float x\nproperty float y\nproperty float z\n"
                       f"element face {len(faces)}\n"
                       "property list uchar int vertex_indices\nend_header\n")
            file.writelines("%.9g %.9g %.9g\n" % tuple(v) for v in vertices)
            file.writelines("3 %d %d %d\n" % tuple(f) for f in faces)
    return horse.exists()


def this_machine(arguments, folder):
    """The session, and whether numbers printed are those of the document."""
    (folder / "build" / "demo").mkdir(parents=True)
    os.symlink(arguments.build, folder / "build" / "release")
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith("GEODESIC")}
    (folder / "own").mkdir(mode=0o700)
    environment.update(
        XDG_RUNTIME_DIR=str(folder / "own"), MPLBACKEND="Agg",
        PYTHONPATH=arguments.package,
        CMAKE_PREFIX_PATH=":".join(arguments.prefixes),
        PKG_CONFIG_PATH=":".join(
            str(file.parent) for prefix in arguments.prefixes
            for file in pathlib.Path(prefix).rglob("geodesic_*.pc")))
    is_horse = put_horse(folder / "build" / "demo")
    return session.Session([], environment, str(folder),
                           sys.executable), is_horse


def fresh_system(arguments):
    environment = {"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
                   "HOME": "/root", "LC_ALL": "C.UTF-8", "MPLBACKEND": "Agg",
                   "DEBIAN_FRONTEND": "noninteractive"}
    return session.Session(
        ["chroot", arguments.chroot], environment, arguments.folder,
        arguments.folder + "/build/python-environment/bin/python"), True


def run_shell(block, place, skipped, here):
    for before, command in blocks.commands(block.text):
        where = f"{place.name}:{block.line + before}"
        reason = next((why for start, why in skipped.items()
                       if command.startswith(start)), None)
        if reason:
            print(f"{where}: left out: {command.split(chr(10))[0]} ({reason})",
                  flush=True)
            continue
        print(f"{where}: {command}", flush=True)
        if command.split()[0].rpartition("/")[2] == "geodesicd":
            here.start_server(command)
        else:
            here.run(command)


def run_console(text, is_horse, here):
    """Each command prints first what follows it; the first line of it, if the mesh is
    not the document's."""
    for part in ("\n" + text).split("\n$ ")[1:]:
        command, _, expected = part.partition("\n")
        printed = here.run(command)
        if not is_horse:
            expected = expected.split("\n")[0]
        words = expected.split()
        if not words or printed.split()[:len(words)] != words:
            raise AssertionError(f"{command} printed\n{printed}\nnot\n{expected}")


def run(path, skipped, is_horse, here):
    """Errors: AssertionError for the first that does not do what it should."""
    found = blocks.extract(path.read_text(encoding="utf-8"))
    if not found:
        raise AssertionError("nothing to run")
    for block in found:
        where = f"{path.name}:{block.line}"
        try:
            if block.kind == "shell":
                run_shell(block, path, skipped, here)
                continue
            print(f"{where}: {block.kind} {block.file}", flush=True)
            if block.kind == "console":
                run_console(block.text, is_horse, here)
            elif block.kind in ("python", "pycon"):
                here.run_python(path.name, block.line, block.text,
                                block.kind == "pycon")
            elif block.file:
                here.write(block.file, block.text + "\n")
            else:
                raise AssertionError("no name of a file, nor a way to run it")
        except AssertionError as error:
            raise AssertionError(f"{where}: {error}") from None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("document", type=pathlib.Path)
    parser.add_argument("--build")
    parser.add_argument("--prefixes", nargs="*", default=[])
    parser.add_argument("--package")
    parser.add_argument("--chroot")
    parser.add_argument("--folder")
    arguments = parser.parse_args()
    if arguments.chroot:
        here, is_horse = fresh_system(arguments)
        with here:
            run(arguments.document, left_out.ALWAYS, is_horse, here)
        return
    own_network()
    with tempfile.TemporaryDirectory() as folder:
        here, is_horse = this_machine(arguments, pathlib.Path(folder))
        program = shutil.which("geodesic", path=arguments.build + "/bin")
        try:
            with here:
                run(arguments.document,
                    {**left_out.ALWAYS, **left_out.ON_THIS_MACHINE}, is_horse, here)
        finally:
            # Ends the command's own server, if one runs.
            subprocess.run([program, "server", "stop"], check=False,
                           env={"XDG_RUNTIME_DIR": folder + "/own"},
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


if __name__ == "__main__":
    main()
