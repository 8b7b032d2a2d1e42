#!/usr/bin/python3
"""Answers a second of servers on this machine, and the processor time of each.

    bench/cluster/throughput.py --server GEODESICD [--seconds N]

One geodesicd, then three behind deploy/cluster/haproxy.cfg, then behind nginx.conf.
h2load asks each without pause for fields that are cached in memory, small ones (1.3
KiB) and large ones (0.5 MiB), and for the distance of two corners of a mesh of 20,000
faces, computed each time by one thread a server.

If nothing but processors bounds them, the machine is busy and an answer of three
servers takes no more processor time of geodesicd than one of a single server.
"""

import os
import pathlib
import re
import struct
import subprocess
import tempfile
import time

import psutil
from servers import parser, processor_seconds, running

from balancers import Haproxy, Nginx
from load import Client, bumpy_grid
import geodesic_service

_MESHES = 12


class Question:
    """What all clients ask, of a grid each.

    Args:
        name: printed.
        side: of the grids, in squares.
        at_once: questions of each client that wait for an answer.
    """

    def __init__(self, name, side, at_once):
        self.name, self.side, self.at_once = name, side, at_once


class Field(Question):
    """The distances from vertex 0."""

    known_vertex = 0
    method = "/geodesic.v1.QuestionService/ComputeField"

    def request(self, stubs, digest):
        return stubs.question_service_pb2.ComputeFieldRequest(
            mesh_digest=digest, sources=[stubs.surface_pb2.Source(vertex=0)])

    def least_bytes(self):
        """Of the answer."""
        return 8 * (self.side + 1) ** 2


class Pair(Question):
    """The distance of two opposite corners, of which no field is known."""

    known_vertex = 1
    method = "/geodesic.v1.QuestionService/ComputePairs"

    def request(self, stubs, digest):
        return stubs.question_service_pb2.ComputePairsRequest(
            mesh_digest=digest, vertex_pairs=[0, (self.side + 1) ** 2 - 1])

    def least_bytes(self):
        return 8


QUESTIONS = [Field("cached, 1.3 KiB", 12, 4), Field("cached, 0.5 MiB", 250, 2),
             Pair("pair", 100, 1)]


def busy_seconds():
    """Of all processors, so far."""
    times = psutil.cpu_times()
    return sum(times) - times.idle - times.iowait - times.guest - times.guest_nice


def start_clients(address, question, requests, seconds):
    return [
        subprocess.Popen(
            ["h2load", "-D", str(seconds), "-c", "1", "-m", str(question.at_once),
             "-t", "1", "-d", path, "-H", "geo-mesh-digest: " + digest,
             "-H", "content-type: application/grpc", "-H", "te: trailers",
             "http://" + address + question.method],
            stdout=subprocess.PIPE, text=True)
        for digest, path in requests.items()
    ]


def count_answers(clients, question):
    """Of clients that have ended. All must have been answers, not errors."""
    answers = 0
    for client in clients:
        report = client.stdout.read()
        client.wait()
        failed, wrong = map(int, re.search(r"(\d+) failed, (\d+) errored",
                                           report).groups())
        done = int(re.search(r"(\d+) succeeded", report)[1])
        data = int(re.search(r"\((\d+)\) data", report)[1])
        # Not all of the last ones has come when h2load counts.
        if failed or wrong or data < 0.9 * done * question.least_bytes():
            raise AssertionError(report)
        answers += done
    return answers


def measure(name, count, balancer_type, question, arguments, stubs, folder):
    """Prints one row."""
    with running(arguments.server, folder, count,
                 balancer_type) as (address, replicas, balancer):
        client = Client(stubs, address)
        requests = {}
        meshes = [bumpy_grid(seed, question.side) for seed in range(_MESHES)]
        for mesh in meshes:
            digest = client.upload(*mesh)
            message = question.request(stubs, digest).SerializeToString()
            requests[digest] = os.path.join(folder, digest)
            pathlib.Path(requests[digest]).write_bytes(
                struct.pack(">BI", 0, len(message)) + message)
        client.channel.close()
        # Every server has every mesh, and a field of it: bounded load may send
        # the question to any.
        for replica in replicas:
            client = Client(stubs, "127.0.0.1:%d" % replica.port,
                            meshes=meshes)
            for digest in requests:
                client.field(digest, question.known_vertex)
            client.channel.close()
        processes = [replicas, [balancer] if balancer else []]
        before = [sum(map(processor_seconds, of)) for of in processes]
        busy, began = busy_seconds(), time.monotonic()
        clients = start_clients(address, question, requests, arguments.seconds)
        for process in clients:
            process.wait()
        took, busy = time.monotonic() - began, busy_seconds() - busy
        spent = [sum(map(processor_seconds, of)) - begun
                 for of, begun in zip(processes, before)]
        answers = count_answers(clients, question)
    print("%-16s  %-20s %9.0f %7.2f" % (
        question.name, name, answers / took, busy / took / psutil.cpu_count()) +
        "".join(" %10.0f" % (1e6 * seconds / answers) for seconds in spent),
        flush=True)


def main():
    options = parser(__doc__)
    options.add_argument("--seconds", type=int, default=5,
                         help="of load, for each row")
    options.add_argument("--only", default="",
                         help="rows whose names have this in them")
    arguments = options.parse_args()
    setups = [("one server", 1, None), ("three, HAProxy", 3, Haproxy),
              ("three, nginx", 3, Nginx)]
    print("                                        answers   share   processor time "
          "of an answer, us\n                                       a second    busy"
          "  geodesicd   balancer")
    with tempfile.TemporaryDirectory() as folder:
        stubs = geodesic_service.generate_stubs(arguments, folder)
        for question in QUESTIONS:
            for name, count, balancer in setups:
                if arguments.only not in question.name + ", " + name:
                    continue
                with tempfile.TemporaryDirectory(dir=folder) as place:
                    measure(name, count, balancer, question, arguments, stubs,
                            place)


if __name__ == "__main__":
    main()
