"""A geodesicd of the cluster, on ports of its own."""

import http.client
import os
import signal
import subprocess

from waiting import await_that


class Replica:
    """A geodesicd with fixed ports, which may be killed and started again.

    `flags` go to geodesicd as they are.
    """

    def __init__(self, server, folder, name, ports, flags=()):
        self.name = name
        self.port, self.ready_port = ports
        self.folder = os.path.join(folder, name)
        self._command = [
            server, "--listen", "127.0.0.1:%d" % self.port,
            "--metrics-listen", "127.0.0.1:%d" % self.ready_port,
            "--data-dir", self.folder, "--threads", "1",
            "--log-level", "error",
        ] + list(flags)
        self._process = None

    def start(self):
        self._process = subprocess.Popen(self._command,
                                         stdout=subprocess.DEVNULL)
        await_that(self.is_ready, 60)

    def is_ready(self):
        if self._process.poll() is not None:
            raise AssertionError("%s ended with %d" % (
                self.name, self._process.returncode))
        try:
            connection = http.client.HTTPConnection(
                "127.0.0.1", self.ready_port, timeout=1)
            connection.request("GET", "/readyz")
            return connection.getresponse().status == 200
        except OSError:
            return False

    @property
    def pid(self):
        return self._process.pid

    def resident_bytes(self):
        """What the kernel counts; 0 while it does not run."""
        try:
            with open("/proc/%d/statm" % self.pid) as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")
        except (OSError, IndexError):
            return 0

    def kill(self):
        self._process.kill()
        self._process.wait()

    def signal(self, number):
        self._process.send_signal(number)

    def drain(self):
        """Ends in order, as an upgrade does. Returns the exit status."""
        self.signal(signal.SIGTERM)
        return self.wait()

    def wait(self):
        """Until it has ended. Returns the exit status."""
        return self._process.wait(timeout=60)
