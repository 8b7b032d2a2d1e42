#!/usr/bin/env python3
"""How long a server takes to start with many small files in its data folder.

    bench/start.py MESH [FILES]

Uploads MESH (a small one), makes FILES (50,000) meshes of it that differ in one
coordinate, and starts build/release/bin/geodesicd three times with the files in
the kernel's cache and three times without. Prints seconds until it serves and
the memory it has then.
"""

import hashlib
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time

BIN = pathlib.Path(__file__).resolve().parent.parent / "build/release/bin"
HEADER_BYTES = 168  # server/store/blob_format.h
FIRST_POSITION = 33  # after the counts (server/engine/meshes/mesh_digest.h)


def start(folder):
    """A server on the data folder, its address, and when it served."""
    port = folder / "port"
    port.unlink(missing_ok=True)
    begin = time.monotonic()
    server = subprocess.Popen(
        [BIN / "geodesicd", "--listen", "127.0.0.1:0", "--port-file", port,
         "--data-dir", folder / "data", "--log-level", "off"])
    while not port.exists() or not port.read_text().endswith("\n"):
        if server.poll() is not None:
            sys.exit("geodesicd did not start")
        time.sleep(0.01)
    return server, f"127.0.0.1:{port.read_text().strip()}", time.monotonic() - begin


def stop(server):
    server.terminate()
    server.wait()


def multiply(meshes, count):
    """Files as geodesicd would have written them."""
    original = next(meshes.iterdir()).read_bytes()
    body_bytes, _ = struct.unpack_from("<QQ", original, 24)
    body = original[HEADER_BYTES:HEADER_BYTES + body_bytes]
    metadata = original[HEADER_BYTES + body_bytes:]
    for i in range(count):
        changed = (body[:FIRST_POSITION] + struct.pack("<d", 1 + i * 1e-6) +
                   body[FIRST_POSITION + 8:])
        digest = hashlib.sha256(changed).digest()
        header = (original[:40] + digest + digest +
                  hashlib.sha256(metadata).digest())
        header += hashlib.sha256(header).digest()
        path = meshes / f"{digest.hex()}.mesh"
        path.write_bytes(header + changed + metadata)


def forget(meshes):
    """Takes the files' bytes out of the kernel's cache."""
    os.sync()
    for path in meshes.iterdir():
        with path.open("rb") as file:
            os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)


def main():
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 50_000
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        server, address, _ = start(folder)
        subprocess.run([BIN / "geodesic", "--server", address, "upload",
                        sys.argv[1]], check=True, stdout=subprocess.DEVNULL)
        stop(server)
        meshes = folder / "data/meshes"
        multiply(meshes, count)
        for is_cached in (True, False):
            for _ in range(3):
                if not is_cached:
                    forget(meshes)
                server, _, seconds = start(folder)
                status = pathlib.Path(f"/proc/{server.pid}/status").read_text()
                resident = status.split("VmRSS:")[1].split()[0]
                stop(server)
                print(f"{len(list(meshes.iterdir()))} files, "
                      f"{'cached' if is_cached else 'not cached'}: "
                      f"{seconds:.2f} s, {int(resident) / 1024:.0f} MiB")


if __name__ == "__main__":
    main()
