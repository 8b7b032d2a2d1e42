#!/usr/bin/python3
"""A cluster of replicas, simulated: the balancers' real hashes, measured times.

    bench/cluster/simulate.py [--replicas 3 16 256] [--users ...]   (--help: all)

Questions come at random (Poisson); meshes are popular by Zipf's law. A replica
answers from its cache of fields, or computes on a thread; where it lacks the mesh it
first fetches it from a sibling. After two thirds of the time one replica dies. What is
measured, and where, is said at each constant; the rest is a model, whose table
docs/operations.md explains.
"""

import argparse
import collections
import dataclasses
import hashlib
import heapq
import itertools
import random

import rings

# docs/benchmarks.md, horse (96,966 faces, 48,485 vertices): a field on one thread,
# and a cached one to a client at 1.5 GB/s.
FIELD_SECONDS = 0.122
CACHED_SECONDS = 0.0005
FIELD_BYTES = 8 * 48_485
# To parse and build a mesh of 97 thousand faces: half of blade's 60 ms.
BUILD_SECONDS = 0.03
MESH_BYTES = 24 * 48_485 + 12 * 96_966
RESIDENT_BYTES = 239 * 96_966
# From a sibling over 1 Gbit/s, without other traffic.
FETCH_SECONDS = MESH_BYTES / 125e6

THREADS = 16
MESH_STORE = 8 * 2**30
FIELD_CACHE = 4 * 2**30

# Names by which it is seen how evenly a ring is cut.
_KEYS = 20_000


class Lru:
    """The keys used last, up to so many, each with a value."""

    def __init__(self, capacity):
        self._capacity = capacity
        self._items = collections.OrderedDict()

    def get(self, key):
        value = self._items.get(key)
        if value is not None:
            self._items.move_to_end(key)
        return value

    def put(self, key, value):
        self._items[key] = value
        self._items.move_to_end(key)
        if len(self._items) > self._capacity:
            self._items.popitem(last=False)


class Replica:
    def __init__(self):
        self.free_at = [0.0] * THREADS  # a heap
        # When each mesh and field is there.
        self.meshes = Lru(MESH_STORE // RESIDENT_BYTES)
        self.fields = Lru(FIELD_CACHE // FIELD_BYTES)
        self.busy = 0.0

    def answer(self, now, mesh, source, is_first_anywhere):
        """(end, whether it was cached, whether the mesh was fetched)."""
        there = self.fields.get((mesh, source))
        if there is not None:
            # Computed, or under way: who asks meanwhile joins.
            return max(there, now) + CACHED_SECONDS, True, False
        ready = self.meshes.get(mesh)
        work = FIELD_SECONDS
        fetched = ready is None
        if fetched:
            # The thread that loads waits for the network, too.
            work += BUILD_SECONDS + (0 if is_first_anywhere else FETCH_SECONDS)
            ready = now
        begin = max(now, self.free_at[0], ready)
        end = begin + work
        heapq.heapreplace(self.free_at, end)
        self.busy += work
        if fetched:
            self.meshes.put(mesh, end - FIELD_SECONDS)
        self.fields.put((mesh, source), end)
        return end, False, fetched and not is_first_anywhere


def zipf(count, exponent):
    """Cumulative weights for random.choices."""
    return list(itertools.accumulate(
        (rank + 1)**-exponent for rank in range(count)))


@dataclasses.dataclass
class Row:
    """A line of the table."""

    replicas: int
    balancer: str
    rate: float
    keys: float
    busy: float
    use: float
    cached: float
    spilled: float
    median: float
    p99: float
    fetched: float
    tier_reads: float
    tier_writes: float
    moved: float
    others_moved: float
    p99_after: float
    fetched_after: float


TITLES = (
    ("replicas", "%8d"), ("balancer", "%-16s"), ("questions/s", "%11.0f"),
    ("keys max/mean", "%13.2f"), ("busy max/mean", "%13.2f"), ("busy", "%5.2f"),
    ("cached", "%6.2f"), ("spilled", "%7.2f"), ("p50 ms", "%6.0f"),
    ("p99 ms", "%7.0f"), ("siblings MB/s", "%13.1f"), ("tier read", "%9.1f"),
    ("written MB/s", "%12.1f"), ("a death moves", "%13.3f"),
    ("of others'", "%10.3f"), ("p99 ms, 5 s after", "%17.0f"),
    ("siblings MB/s", "%13.1f"))


def percentile(values, share):
    values = sorted(values)
    return values[int(share * (len(values) - 1))] if values else float("nan")


def simulate(ring, name, options, seed=1):
    """One Row: `options` of the command line, and `ring` of rings.py."""
    values = random.Random(seed)
    count = ring.replicas
    replicas = [Replica() for _ in range(count)]
    rate = options.rate * count
    seconds = options.seconds
    digests = [hashlib.sha256(b"%d" % n).hexdigest()
               for n in range(options.meshes * count)]
    places = [ring.place(digest) for digest in digests]
    homes = [ring.home(place) for place in places]
    held = collections.Counter(ring.home(ring.place(
        hashlib.sha256(b"%d" % n).hexdigest())) for n in range(_KEYS))

    questions = int(rate * seconds)
    meshes = values.choices(range(len(digests)),
                            cum_weights=zipf(len(digests), options.zipf),
                            k=questions)
    popular = zipf(options.popular, options.zipf)
    known = values.choices(range(options.popular), cum_weights=popular,
                           k=questions)

    open_calls = [0] * count
    total_open = 0
    ends = []  # (end, replica), of open calls
    anywhere = set()
    made = set()
    warm, death = seconds / 3, 2 * seconds / 3
    busy_before = [0.0] * count
    busy = []
    latencies, latencies_after = [], []
    tally = collections.Counter()
    after = collections.Counter()
    moved = others_moved = 0.0
    is_dead = is_warm = False
    now = 0.0
    for number, mesh in enumerate(meshes):
        now += values.expovariate(rate)
        if now >= warm and not is_warm:
            is_warm = True
            busy_before = [replica.busy for replica in replicas]
        if now >= death and not is_dead:
            is_dead = True
            busy = [r.busy - b for r, b in zip(replicas, busy_before)]
            ring.without(0)
            places = [ring.place(digest) for digest in digests]
            new = [ring.home(place) for place in places]
            moved = sum(a != b for a, b in zip(homes, new)) / len(homes)
            others_moved = sum(a not in (b, 0)
                               for a, b in zip(homes, new)) / len(homes)
            homes = new
            # Its calls are repeated; the model lets them end as they would have.
            total_open -= open_calls[0]
            open_calls[0] = 0
        while ends and ends[0][0] <= now:
            _, ended = heapq.heappop(ends)
            if open_calls[ended]:
                open_calls[ended] -= 1
                total_open -= 1
        source = (known[number] if values.random() < options.repeats else
                  number + options.popular)
        chosen = ring.route(places[mesh], open_calls, total_open)
        end, cached, fetched = replicas[chosen].answer(
            now, mesh, source, mesh not in anywhere)
        anywhere.add(mesh)
        open_calls[chosen] += 1
        total_open += 1
        heapq.heappush(ends, (end, chosen))
        in_tier = not cached and (mesh, source) in made
        made.add((mesh, source))
        if warm <= now < death:
            counts = tally
            latencies.append(end - now)
        elif death <= now < death + 5:
            counts = after
            latencies_after.append(end - now)
        else:
            continue
        counts["all"] += 1
        counts["cached"] += cached
        counts["spilled"] += chosen != homes[mesh]
        counts["fetched"] += fetched
        counts["tier reads"] += in_tier
        counts["tier writes"] += not cached and not in_tier
    span = death - warm
    mean = sum(busy) / count
    return Row(
        replicas=count, balancer=name, rate=rate,
        keys=max(held.values()) * count / _KEYS,
        busy=max(busy) / mean, use=mean / (span * THREADS),
        cached=tally["cached"] / tally["all"],
        spilled=tally["spilled"] / tally["all"],
        median=1e3 * percentile(latencies, 0.5),
        p99=1e3 * percentile(latencies, 0.99),
        fetched=tally["fetched"] * MESH_BYTES / span / 1e6,
        tier_reads=tally["tier reads"] * FIELD_BYTES / span / 1e6,
        tier_writes=tally["tier writes"] * FIELD_BYTES / span / 1e6,
        moved=moved, others_moved=others_moved,
        p99_after=1e3 * percentile(latencies_after, 0.99),
        fetched_after=after["fetched"] * MESH_BYTES / min(5, seconds / 3) / 1e6)


def balancers(count):
    """(name, ring) of every way to balance that is compared: HAProxy with a weight
    and a balance factor."""
    for weight, factor in ((1, 125), (100, 125), (100, 150), (100, 0)):
        yield f"haproxy {weight}, {factor}", rings.HaproxyRing(count, weight,
                                                               factor)
    yield "nginx", rings.NginxRing(
        [("10.0.%d.%d" % divmod(n, 250), 50051) for n in range(count)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--replicas", type=int, nargs="+", default=[3, 16, 256])
    add("--rate", type=float, default=110, help="questions a second a replica")
    add("--seconds", type=float, default=20, help="of simulated time")
    add("--meshes", type=int, default=40, help="meshes a replica")
    add("--zipf", type=float, default=0.9, help="exponent of popularity")
    add("--repeats", type=float, default=0.6,
        help="share of questions whose source is a popular one")
    add("--popular", type=int, default=100, help="popular sources a mesh")
    options = parser.parse_args()
    print("  ".join(title.rjust(len(shape % 0)) if "s" not in shape else
                    title.ljust(len(shape % "")) for title, shape in TITLES))
    for count in options.replicas:
        for name, ring in balancers(count):
            row = dataclasses.astuple(simulate(ring, name, options))
            print("  ".join((shape % value).rjust(len(title))
                            if "s" not in shape else shape % value
                            for (title, shape), value in zip(TITLES, row)),
                  flush=True)


if __name__ == "__main__":
    main()
