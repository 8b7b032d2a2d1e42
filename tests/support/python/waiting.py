"""Free ports, and conditions that come about."""

import socket
import time


_given = set()


def free_port():
    """Of this machine's loopback, never the same twice; nobody keeps it from
    others."""
    while True:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        if port not in _given:
            _given.add(port)
            return port


def await_that(condition, seconds=30.0):
    """Errors: AssertionError if `condition` is not true within the time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("did not come about within %g s" % seconds)
        time.sleep(0.02)
