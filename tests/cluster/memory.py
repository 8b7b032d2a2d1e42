"""Budgets of memory, and whether replicas stay within them."""

import threading

_BUDGETS_MIB = {"mesh-store": 16, "field-cache": 8, "upload-memory": 32,
                "solver-memory": 32, "landmark-memory": 4, "prepared-memory": 4,
                "receive-memory": 8, "request-memory": 8}
FLAGS = ["--limit", ",".join(
    "%s=%dMiB" % budget
    for budget in [*_BUDGETS_MIB.items(), ("max-upload-bytes", 4)])]

# A process stays within the sum of its budgets and about a tenth more, beside what
# an empty one takes (docs/operations.md, "Sizing").
_EMPTY_MIB = 20
ALLOWED_MIB = _EMPTY_MIB + 1.1 * sum(_BUDGETS_MIB.values())


class MemoryWatch:
    """Looks ten times a second at what replicas take, until stop."""

    def __init__(self, replicas):
        self._replicas = replicas
        self._stop = threading.Event()
        self._most_bytes = 0
        self._thread = threading.Thread(target=self._watch)
        self._thread.start()

    def _watch(self):
        while not self._stop.wait(0.1):
            for replica in self._replicas:
                self._most_bytes = max(self._most_bytes, replica.resident_bytes())

    def stop(self):
        self._stop.set()
        self._thread.join()

    @property
    def most_mib(self):
        """The most that any of them took."""
        return self._most_bytes / 2**20
