#!/usr/bin/python3
"""Processor time that a balancer and a server take for a small and a large answer.

    bench/cluster/balancer_cost.py --server GEODESICD [--calls N]

Three geodesicd behind deploy/cluster/haproxy.cfg, then behind nginx.conf, are asked
for fields that they have cached: small ones (169 vertices, 1.3 KiB) and large ones
(63,001 vertices, 0.5 MiB), sixteen at a time. Processor time, not seconds on the wall,
which other work on the machine changes less.
"""

import argparse
import concurrent.futures
import os
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "cluster"),
                str(ROOT / "tests" / "support" / "python")]
from balancers import Haproxy, Nginx  # noqa: E402
from load import Client, bumpy_grid  # noqa: E402
from replica import Replica, free_port  # noqa: E402
import geodesic_service  # noqa: E402

_AT_ONCE = 16


def processor_seconds(pid):
    """Of a process and its children, so far."""
    total = 0.0
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(stat.parent.name) == pid or int(fields[1]) == pid:
            total += (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    return total


def measure(balancer_type, arguments, stubs, folder):
    ports = [(free_port(), free_port()) for _ in range(3)]
    replicas = [Replica(arguments.server, folder, name, pair,
                        [port for port, _ in ports])
                for name, pair in zip("abc", ports)]
    for replica in replicas:
        replica.start()
    port = free_port()
    balancer = balancer_type(folder, port, replicas)
    client = Client(stubs, "127.0.0.1:%d" % port)
    costs = []
    try:
        for side, calls in ((12, arguments.calls), (250, arguments.calls // 5)):
            digest = client.upload(*bumpy_grid(0, side))
            with concurrent.futures.ThreadPoolExecutor(_AT_ONCE) as pool:
                # Wherever it is asked, it is cached.
                sizes = [len(field[0]) for field in pool.map(
                    lambda _, d=digest: client.field(d, 0), range(100))]
            size = sizes[0] / 2**20
            pids = [balancer._process.pid] + [r._process.pid for r in replicas]
            before = [processor_seconds(pid) for pid in pids]
            with concurrent.futures.ThreadPoolExecutor(_AT_ONCE) as pool:
                for _ in pool.map(lambda _, d=digest: client.field(d, 0),
                                  range(calls)):
                    pass
            spent = [processor_seconds(pid) - b for pid, b in zip(pids, before)]
            costs.append((size, spent[0] / calls, sum(spent[1:]) / calls))
    finally:
        client.channel.close()
        balancer.stop()
        for replica in replicas:
            replica.kill()
    for size, passed_on, answered in costs:
        print("%-8s %7.4f MiB: %5.0f us of the balancer, %5.0f us of geodesicd" %
              (balancer_type.__name__, size, 1e6 * passed_on, 1e6 * answered),
              flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--server", required=True)
    parser.add_argument("--protos", default=str(ROOT / "proto"))
    parser.add_argument("--protoc", default="/usr/bin/protoc")
    parser.add_argument("--plugin", default="/usr/bin/grpc_python_plugin")
    parser.add_argument("--calls", type=int, default=4000)
    arguments = parser.parse_args()
    os.environ["PATH"] += ":/usr/sbin"
    with tempfile.TemporaryDirectory() as folder:
        stubs = geodesic_service.generate_stubs(arguments, folder)
        for balancer in (Haproxy, Nginx):
            place = os.path.join(folder, balancer.__name__)
            os.mkdir(place)
            measure(balancer, arguments, stubs, place)


if __name__ == "__main__":
    main()
