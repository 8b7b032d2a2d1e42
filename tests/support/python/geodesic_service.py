"""What Python tests share: stubs from the protocol, a server of their own.

Importing it ends the test as skipped (exit code 77) where Debian's
python3-grpcio is not installed.
"""

import argparse
import importlib
import os
import signal
import subprocess
import sys
import types

try:
    import google.protobuf  # noqa: F401
    import grpc  # noqa: F401
except ImportError:
    print("python3-grpcio is not installed: skipped")
    sys.exit(77)


def parse_arguments(*more):
    """The programs a test is given; `more` names options beyond the usual."""
    parser = argparse.ArgumentParser()
    for name in ("server", "protos", "protoc", "plugin") + more:
        parser.add_argument("--" + name, required=True)
    return parser.parse_args()


def generate_stubs(arguments, folder):
    """The modules of the protocol by their names, e.g. `.mesh_pb2` or
    `.mesh_service_pb2_grpc`; written to `folder`.
    """
    protos = os.path.join(arguments.protos, "geodesic", "v1")
    names = [name[:-len(".proto")] for name in sorted(os.listdir(protos))
             if name.endswith(".proto")]
    subprocess.run(
        [
            arguments.protoc,
            "-I", arguments.protos,
            "--python_out=" + folder,
            "--grpc_out=" + folder,
            "--plugin=protoc-gen-grpc=" + arguments.plugin,
        ] + [os.path.join(protos, name + ".proto") for name in names],
        check=True)
    sys.path.insert(0, folder)
    return types.SimpleNamespace(**{
        name + ending: importlib.import_module("geodesic.v1." + name + ending)
        for name in names for ending in ("_pb2", "_pb2_grpc")
    })


class Server:
    """geodesicd on a free loopback port, once it serves."""

    def __init__(self, arguments, folder, flags=(), log=subprocess.DEVNULL):
        # A named pipe as the port file: reading it waits for the server.
        port_file = os.path.join(folder, "port")
        os.mkfifo(port_file)
        self.process = subprocess.Popen([
            arguments.server, "--listen", "127.0.0.1:0", "--port-file",
            port_file
        ] + list(flags), stderr=log)
        with open(port_file, encoding="ascii") as pipe:
            self.address = "127.0.0.1:" + pipe.readline().strip()

    def stop(self):
        """Its exit code."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=60)
