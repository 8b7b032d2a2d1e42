"""Faults at random, one at a time, for replicas of cluster_test.py and their tier.

One at a time, since a mesh is promised to outlive one replica, not two.
"""

import collections
import contextlib
import errno
import os
import random
import signal
import subprocess
import time

# Of a replica's disk, where it has one of its own.
DISK_BYTES = 24 * 2**20

# How far the clock jumps, in seconds; backwards and forwards.
JUMPS = (-3600, -30, -1, 1, 30, 3600)


@contextlib.contextmanager
def small_disks(replicas):
    """Gives each replica a disk of its own that can be really full. Yields whether
    it could (as root, where mounting is allowed); ends and starts the replicas."""
    mounted = []
    try:
        for replica in replicas:
            replica.drain()
            done = os.geteuid() == 0 and subprocess.run(
                ["mount", "-t", "tmpfs", "-o", "size=%d" % DISK_BYTES, "tmpfs",
                 replica.folder], stderr=subprocess.DEVNULL).returncode == 0
            if done:
                mounted.append(replica.folder)
            replica.start()
        yield len(mounted) == len(replicas)
    finally:
        for folder in mounted:
            # What runs keeps its files until it ends.
            subprocess.run(["umount", "--lazy", folder], check=True)


class Faults:
    """Breaks replicas and mends them.

    Args:
        replicas: of cluster_test.
        tier: the Redis that they share.
        with_disks: whether they are within small_disks().
        with_clock: whether to set the clock, which is the whole machine's.
        seed: of the order and the times.
        kinds: the names of the faults that come; all, if empty.
    """

    def __init__(self, replicas, tier, with_disks, with_clock, seed, kinds=()):
        self._replicas = replicas
        self._tier = tier
        self._values = random.Random(seed)
        self._kinds = [self.kill, self.stop_and_continue, self.drain,
                       self.silence_tier, self.falsify_tier]
        if with_disks:
            self._kinds.append(self.fill_disk)
        if with_clock:
            self._kinds.append(self.set_clock)
        if kinds:
            self._kinds = [getattr(self, name) for name in kinds]
        self.done = collections.Counter()

    def run(self, seconds):
        """Fault after fault until the time is up, each kind at least once; all
        replicas are there at the end."""
        end = time.monotonic() + seconds
        waiting = list(self._kinds)
        self._values.shuffle(waiting)
        while waiting or time.monotonic() < end:
            fault = waiting.pop() if waiting else self._values.choice(self._kinds)
            fault(self._values.choice(self._replicas))
            self.done[fault.__name__] += 1
            self._pause(0.2, 1.0)

    def _pause(self, least, most):
        """How long a fault lasts, and the time between two."""
        time.sleep(self._values.uniform(least, most))

    def kill(self, replica):
        replica.kill()
        self._pause(0, 2)
        replica.start()

    def drain(self, replica):
        status = replica.drain()
        if status != 0:
            raise AssertionError("a drained replica ended with %d" % status)
        self._pause(0, 2)
        replica.start()

    def stop_and_continue(self, replica):
        """Silent, but its connections are there."""
        replica.signal(signal.SIGSTOP)
        try:
            self._pause(0.2, 3)
        finally:
            replica.signal(signal.SIGCONT)

    def fill_disk(self, replica):
        """No byte can be written for a while, also not after a restart."""
        filler = os.path.join(replica.folder, "filler")
        try:
            with open(filler, "wb", buffering=0) as file:
                for size in (2**20, 2**12):
                    with contextlib.suppress(OSError):
                        while True:
                            file.write(bytes(size))
            self._check_full(replica)
            self._pause(0.5, 3)
        finally:
            os.unlink(filler)

    def silence_tier(self, _):
        """It takes connections and answers when the fault is over."""
        self._tier.stop()
        try:
            self._pause(0.2, 3)
        finally:
            self._tier.go_on()

    def falsify_tier(self, _):
        """Every value becomes another: bytes in it, its length, or all of it, which
        is then that of another key."""
        values = {key: self._tier.ask("GET", key)
                  for key in self._tier.ask("KEYS", "*")}
        for key, value in values.items():
            false = self._values.choice([self._corrupted, self._shortened, bytes])(
                value or b"") or self._values.choice(list(values.values()))
            self._tier.ask("SET", key, false or b"", "KEEPTTL")

    def _corrupted(self, value):
        corrupted = bytearray(value)
        for _ in range(1 + len(value) // 500):
            corrupted[self._values.randrange(len(value))] ^= (
                1 << self._values.randrange(8))
        return bytes(corrupted)

    def _shortened(self, value):
        return value[:self._values.randrange(len(value))]

    def set_clock(self, _):
        """The time of day jumps, and comes back. Files get times that lie."""
        jump = self._values.choice(JUMPS)
        before, since = time.time(), time.monotonic()
        time.clock_settime(time.CLOCK_REALTIME, before + jump)
        try:
            self._pause(0.5, 3)
        finally:
            time.clock_settime(time.CLOCK_REALTIME,
                               before + time.monotonic() - since)

    @staticmethod
    def _check_full(replica):
        try:
            with open(os.path.join(replica.folder, "more"), "wb") as file:
                file.write(bytes(2**16))
                file.flush()
        except OSError as error:
            if error.errno == errno.ENOSPC:
                return
            raise
        finally:
            with contextlib.suppress(FileNotFoundError):
                os.unlink(os.path.join(replica.folder, "more"))
        raise AssertionError("the disk is not full")
