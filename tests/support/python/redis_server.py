"""A redis-server of a test's own, and the few words of its protocol that tests
say to it.

Importing it ends the test as skipped (exit code 77) where Debian's redis-server
is not installed.
"""

import os
import shutil
import signal
import socket
import subprocess
import sys
import time

from waiting import free_port

if shutil.which("redis-server") is None:
    print("redis-server is not installed: skipped")
    sys.exit(77)


class Redis:
    """Killed, stopped, continued and started again on the same port."""

    def __init__(self, folder, configuration=None, flags=()):
        self.port = free_port()
        self.address = "127.0.0.1:%d" % self.port
        self._command = (
            ["redis-server"] + ([configuration] if configuration else []) +
            ["--port", str(self.port), "--bind", "127.0.0.1", "--save", "",
             "--appendonly", "no", "--dir", folder, "--logfile",
             os.path.join(folder, "redis.log")] + list(flags))
        self._process = None

    def start(self):
        self.kill()
        self._process = subprocess.Popen(self._command)
        end = time.monotonic() + 20
        while True:
            try:
                self.ask("PING")
                return
            except RuntimeError:  # it wants a password first
                return
            except OSError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.02)

    @property
    def pid(self):
        return self._process.pid

    def kill(self):
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None

    def stop(self):
        """It takes connections, and says nothing."""
        self._process.send_signal(signal.SIGSTOP)

    def go_on(self):
        self._process.send_signal(signal.SIGCONT)

    def ask(self, *words):
        """The reply: bytes, a number, a list, or None. Errors are raised."""
        words = [w if isinstance(w, bytes) else str(w).encode() for w in words]
        with socket.create_connection(("127.0.0.1", self.port),
                                      timeout=10) as connection:
            connection.sendall(b"*%d\r\n" % len(words) + b"".join(
                b"$%d\r\n%s\r\n" % (len(w), w) for w in words))
            with connection.makefile("rb") as replies:
                return self._read(replies)

    def _read(self, replies):
        line = replies.readline()
        if not line:
            raise ConnectionResetError("Redis has closed the connection")
        kind, rest = line[:1], line[1:-2]
        if kind == b"-":
            raise RuntimeError(rest.decode())
        if kind == b":":
            return int(rest)
        if kind == b"$":
            return None if rest == b"-1" else replies.read(int(rest) + 2)[:-2]
        if kind == b"*":
            return [self._read(replies) for _ in range(int(rest))]
        return rest
