"""The balancers as deploy/cluster configures them, on the test's ports."""

import abc
import os
import signal
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
DEPLOY = os.path.join(HERE, "..", "..", "deploy", "cluster")


class Balancer(abc.ABC):
    """Runs until it is stopped."""

    def __init__(self, command, environment=None):
        self._process = subprocess.Popen(command, env=environment)

    @property
    def pid(self):
        return self._process.pid

    @abc.abstractmethod
    def reload(self):
        """New processes take over; connections to replicas are made anew."""

    def stop(self):
        self._process.terminate()
        self._process.wait()


class Haproxy(Balancer):
    """haproxy.cfg as shipped, and more servers like its last if there are more."""

    def __init__(self, folder, port, replicas):
        environment = dict(os.environ,
                           GEODESIC_LISTEN="127.0.0.1:%d" % port)
        for replica in replicas:
            prefix = "GEODESIC_" + replica.name.upper()
            environment[prefix] = "127.0.0.1:%d" % replica.port
            environment[prefix + "_READY"] = str(replica.ready_port)
        with open(os.path.join(DEPLOY, "haproxy.cfg")) as shipped:
            text = shipped.read()
        last = next(line for line in text.splitlines(keepends=True)
                    if line.startswith("  server c "))
        for replica in replicas[3:]:
            text += last.replace(" c ", " %s " % replica.name).replace(
                "_C", "_" + replica.name.upper())
        path = os.path.join(folder, "haproxy.cfg")
        with open(path, "w") as written:
            written.write(text)
        super().__init__(["haproxy", "-W", "-db", "-q", "-f", path], environment)

    def reload(self):
        self._process.send_signal(signal.SIGUSR2)


class Nginx(Balancer):
    """nginx.conf as shipped, with this test's ports."""

    def __init__(self, folder, port, replicas):
        with open(os.path.join(DEPLOY, "nginx.conf")) as shipped:
            text = shipped.read()
        text = text.replace("/tmp/geodesic-nginx.pid",
                            os.path.join(folder, "nginx.pid"))
        text = text.replace("127.0.0.1:50060", "127.0.0.1:%d" % port)
        for number, replica in enumerate(replicas):
            text = text.replace("127.0.0.1:%d" % (50061 + number),
                                "127.0.0.1:%d" % replica.port)
        path = os.path.join(folder, "nginx.conf")
        with open(path, "w") as written:
            written.write(text)
        super().__init__(["nginx", "-p", folder, "-g", "daemon off;", "-c", path])

    def reload(self):
        self._process.send_signal(signal.SIGHUP)
