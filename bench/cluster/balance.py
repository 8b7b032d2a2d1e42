#!/usr/bin/python3
"""How evenly the work of many meshes falls on real servers behind HAProxy.

    bench/cluster/balance.py --server GEODESICD [--replicas 16] [--tier]

Servers behind deploy/cluster/haproxy.cfg, all on this machine, with a thread each, and
with a Redis that they share if wished. Clients ask without pause about meshes that are
popular by Zipf's law, for fields from random sources, which are computed or found.
Printed is the processor time of the busiest and the idlest server, of the mean.
"""

import argparse
import itertools
import os
import pathlib
import random
import string
import sys
import tempfile
import threading
import time

import psutil

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "cluster"),
                str(ROOT / "tests" / "support" / "python")]
from balancers import Haproxy  # noqa: E402
from load import Client, bumpy_grid  # noqa: E402
from replica import Replica, free_port  # noqa: E402
import geodesic_service  # noqa: E402
from redis_server import Redis  # noqa: E402

_SIDE = 40
_CHANNELS = 16
_MESHES_A_REPLICA = 8
_ASKERS_A_REPLICA = 10


def ask(clients, digests, weights, stop, asker, answers):
    values = random.Random(asker)
    client = clients[asker % len(clients)]
    while not stop.is_set():
        # Equal questions at the same time would be computed once for all.
        client.field(values.choices(digests, cum_weights=weights)[0],
                     values.randrange((_SIDE + 1) ** 2))
        answers[asker] += 1


def seconds_of(replicas):
    return [sum(psutil.Process(replica.pid).cpu_times()[:2])
            for replica in replicas]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--server", required=True)
    parser.add_argument("--protos", default=str(ROOT / "proto"))
    parser.add_argument("--protoc", default="/usr/bin/protoc")
    parser.add_argument("--plugin", default="/usr/bin/grpc_python_plugin")
    parser.add_argument("--replicas", type=int, default=16)
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--tier", action="store_true", help="with Redis")
    parser.add_argument("--zipf", type=float, default=0.9,
                        help="exponent of popularity")
    arguments = parser.parse_args()
    os.environ["PATH"] += ":/usr/sbin"
    count = arguments.replicas
    with tempfile.TemporaryDirectory() as folder:
        stubs = geodesic_service.generate_stubs(arguments, folder)
        tier = Redis(folder, str(ROOT / "deploy" / "cluster" / "redis.conf"))
        flags = ["--field-cache", "256KiB", "--field-disk", "1"]
        if arguments.tier:
            tier.start()
            flags += ["--shared-tier", tier.address]
        ports = [(free_port(), free_port()) for _ in range(count)]
        replicas = [
            Replica(arguments.server, folder, name, pair,
                    [port for port, _ in ports if port != pair[0]],
                    flags)
            for name, pair in zip(string.ascii_lowercase, ports)
        ]
        for replica in replicas:
            replica.start()
        port = free_port()
        balancer = Haproxy(folder, port, replicas)
        clients = [Client(stubs, "127.0.0.1:%d" % port) for _ in range(_CHANNELS)]
        stop = threading.Event()
        threads = []
        try:
            digests = [clients[0].upload(*bumpy_grid(seed, _SIDE))
                       for seed in range(_MESHES_A_REPLICA * count)]
            weights = [1 / rank ** arguments.zipf
                       for rank in range(1, len(digests) + 1)]
            weights = list(itertools.accumulate(weights))
            answers = [0] * (_ASKERS_A_REPLICA * count)
            threads = [threading.Thread(target=ask, args=(
                clients, digests, weights, stop, asker, answers))
                for asker in range(len(answers))]
            for thread in threads:
                thread.start()
            # Until meshes are where bounded load sends their questions.
            time.sleep(arguments.seconds / 3)
            before, answered = seconds_of(replicas), sum(answers)
            psutil.cpu_percent()
            time.sleep(arguments.seconds)
            busy = psutil.cpu_percent()
            spent = [after - begun
                     for after, begun in zip(seconds_of(replicas), before)]
            answered = sum(answers) - answered
        finally:
            stop.set()
            for thread in threads:
                thread.join()
            for client in clients:
                client.channel.close()
            balancer.stop()
            for replica in replicas:
                replica.kill()
            tier.kill()
    mean = sum(spent) / count
    print("%d servers, %d answers of %.1f ms each, processors %.0f %% busy: busiest "
          "server %.2f of the mean, idlest %.2f" % (
              count, answered, 1e3 * sum(spent) / answered, busy,
              max(spent) / mean, min(spent) / mean))


if __name__ == "__main__":
    main()
