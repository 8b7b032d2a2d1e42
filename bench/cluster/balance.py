#!/usr/bin/python3
"""How evenly the work of many meshes falls on real servers behind HAProxy.

    bench/cluster/balance.py --server GEODESICD [--replicas 16] [--tier]

Servers behind deploy/cluster/haproxy.cfg, all on this machine, with a thread each, and
with a Redis that they share if wished. Clients ask without pause about meshes that are
popular by Zipf's law, for fields from random sources, which are computed or found.
Printed is the processor time of the busiest and the idlest server, of the mean.
"""

import itertools
import random
import tempfile
import threading
import time

import psutil
from servers import parser, processor_seconds, running

from balancers import Haproxy
from load import Client, bumpy_grid
import geodesic_service

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


def main():
    options = parser(__doc__)
    options.add_argument("--replicas", type=int, default=16,
                         help="three or more")
    options.add_argument("--seconds", type=float, default=30)
    options.add_argument("--tier", action="store_true", help="with Redis")
    options.add_argument("--zipf", type=float, default=0.9,
                         help="exponent of popularity")
    arguments = options.parse_args()
    count = arguments.replicas
    stop = threading.Event()
    with tempfile.TemporaryDirectory() as folder, running(
            arguments.server, folder, count, Haproxy,
            ["--limit", "field-cache=256KiB", "--limit", "field-disk=1"],
            arguments.tier) as (address, replicas, _):
        stubs = geodesic_service.generate_stubs(arguments, folder)
        meshes = [bumpy_grid(seed, _SIDE)
                  for seed in range(_MESHES_A_REPLICA * count)]
        clients = [Client(stubs, address, meshes=meshes)
                   for _ in range(_CHANNELS)]
        digests = [clients[0].upload(*mesh) for mesh in meshes]
        weights = list(itertools.accumulate(
            1 / rank ** arguments.zipf for rank in range(1, len(digests) + 1)))
        answers = [0] * (_ASKERS_A_REPLICA * count)
        threads = [threading.Thread(target=ask, args=(
            clients, digests, weights, stop, asker, answers))
            for asker in range(len(answers))]
        for thread in threads:
            thread.start()
        try:
            # Until meshes are where bounded load sends their questions.
            time.sleep(arguments.seconds / 3)
            before = list(map(processor_seconds, replicas))
            answered = sum(answers)
            psutil.cpu_percent()
            time.sleep(arguments.seconds)
            busy = psutil.cpu_percent()
            spent = [after - begun for after, begun in zip(
                map(processor_seconds, replicas), before)]
            answered = sum(answers) - answered
        finally:
            stop.set()
            for thread in threads:
                thread.join()
            for client in clients:
                client.channel.close()
    mean = sum(spent) / count
    print("%d servers, %d answers of %.1f ms each, processors %.0f %% busy: busiest "
          "server %.2f of the mean, idlest %.2f" % (
              count, answered, 1e3 * sum(spent) / answered, busy,
              max(spent) / mean, min(spent) / mean))


if __name__ == "__main__":
    main()
