"""Which replica a balancer sends a mesh to: the hashes of HAProxy 2.6 and nginx 1.22,
as deploy/cluster configures them.

tests/cluster/rings_test.py compares them with the balancers themselves.
"""

import bisect
import zlib

_32_BITS = 2**32 - 1


def _avalanche(a):
    """Bob Jenkins' full avalanche of 32 bits and a multiplication, as HAProxy
    has them."""
    a = (a + 0x7ED55D16 + (a << 12)) & _32_BITS
    a = (a ^ 0xC761C23C ^ (a >> 19)) & _32_BITS
    a = (a + 0x165667B1 + (a << 5)) & _32_BITS
    a = ((a + 0xD3A2646C) ^ (a << 9)) & _32_BITS
    a = (a + 0xFD7046C5 + (a << 3)) & _32_BITS
    a = (a ^ 0xB55A4F09 ^ (a >> 16)) & _32_BITS
    return a * 3221225473 & _32_BITS


def _sdbm(text):
    value = 0
    for byte in text.encode():
        value = (byte + (value << 6) + (value << 16) - value) & _32_BITS
    return value


class HaproxyRing:
    """`balance hdr(...)`, `hash-type consistent sdbm avalanche`.

    Args:
        replicas: how many servers, numbered from 0 in the file's order.
        weight: of each server. Each has 16 points on the ring for one of weight.
        balance_factor: `hash-balance-factor`; 0 for none.
    """

    name = "HAProxy"
    _POINTS_OF_WEIGHT = 16
    _POINTS_OF_SERVER = 256 * 16

    def __init__(self, replicas, weight=1, balance_factor=150):
        self.replicas = replicas
        self._factor = balance_factor
        self._share = weight * self._POINTS_OF_WEIGHT
        self._all = sorted(
            (_avalanche((replica + 1) * self._POINTS_OF_SERVER + point), replica)
            for replica in range(replicas) for point in range(self._share))
        self._set_alive(list(range(replicas)))

    def _set_alive(self, alive):
        kept = set(alive)
        points = [point for point in self._all if point[1] in kept]
        self._keys = [key for key, _ in points]
        self._owners = [replica for _, replica in points]
        # The weight of the living before each.
        self._before = {r: n * self._share for n, r in enumerate(alive)}
        self._total = len(alive) * self._share

    def without(self, dead):
        """Takes a replica out, as a failed check does."""
        self._set_alive([r for r in range(self.replicas) if r != dead])

    def place(self, digest):
        """Where a mesh is on the ring, for route()."""
        value = _avalanche(_sdbm(digest))
        after = bisect.bisect_left(self._keys, value) % len(self._keys)
        before = after - 1  # from the first to the last
        distance = (self._keys[after] - value) & _32_BITS
        return (before if (value - self._keys[before]) & _32_BITS <= distance else
                after) % len(self._keys)

    def _has_room(self, replica, open_calls, total_open):
        slots, rest = divmod(
            ((total_open + 1) * self._factor + 99) // 100, self._total)
        before = self._before[replica]
        slots = self._share * slots + (
            (before + self._share) * rest // self._total -
            before * rest // self._total)
        return open_calls[replica] < max(slots, 1)

    def home(self, place):
        """The replica that has the mesh when nobody is busy."""
        return self._owners[place]

    def route(self, place, open_calls, total_open):
        """The replica that gets the next call.

        Args:
            open_calls: of each replica.
            total_open: their sum.
        """
        if not self._factor:
            return self._owners[place]
        count = len(self._owners)
        for step in range(2 * count):
            replica = self._owners[(place + step) % count]
            if self._has_room(replica, open_calls, total_open):
                return replica
        return replica


class NginxRing:
    """`hash ... consistent`: 160 points a server, of ketama's kind; no bound of
    load.

    Args:
        servers: (host, port) of each, as the file has them.
    """

    name = "nginx"

    def __init__(self, servers):
        self.replicas = len(servers)
        points = {}
        for replica, (host, port) in enumerate(servers):
            base = zlib.crc32(b"%s\0%d" % (host.encode(), port))
            previous = bytes(4)
            for _ in range(160):
                key = zlib.crc32(previous, base)
                points.setdefault(key, replica)
                previous = key.to_bytes(4, "little")
        self._all = sorted(points.items())
        self._set(self._all)

    def _set(self, points):
        self._keys = [key for key, _ in points]
        self._owners = [replica for _, replica in points]

    def without(self, dead):
        """Passes a replica over, as nginx does after failures."""
        self._set([point for point in self._all if point[1] != dead])

    def place(self, digest):
        return bisect.bisect_left(self._keys, zlib.crc32(digest.encode())
                                  ) % len(self._keys)

    def home(self, place):
        return self._owners[place]

    def route(self, place, open_calls, total_open):
        return self._owners[place]
