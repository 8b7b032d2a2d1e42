"""Free ports, and conditions that come about."""

import socket
import time


def free_port():
    """Of this machine's loopback; nobody keeps it from others."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def await_that(condition, seconds=30.0):
    """Errors: AssertionError if `condition` is not true within the time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("did not come about within %g s" % seconds)
        time.sleep(0.02)
