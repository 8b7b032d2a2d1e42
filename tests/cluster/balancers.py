"""The balancers as deploy/cluster configures them, on the test's ports."""

import os
import signal
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
DEPLOY = os.path.join(HERE, "..", "..", "deploy", "cluster")


class Haproxy:
    def __init__(self, folder, port, replicas):
        environment = dict(os.environ,
                           GEODESIC_LISTEN="127.0.0.1:%d" % port)
        for replica in replicas:
            prefix = "GEODESIC_" + replica.name.upper()
            environment[prefix] = "127.0.0.1:%d" % replica.port
            environment[prefix + "_READY"] = str(replica.ready_port)
        self._process = subprocess.Popen(
            ["haproxy", "-W", "-db", "-q", "-f",
             os.path.join(DEPLOY, "haproxy.cfg")], env=environment)

    def reload(self):
        """New processes take over; connections to replicas are made anew."""
        self._process.send_signal(signal.SIGUSR2)

    def stop(self):
        self._process.terminate()
        self._process.wait()


class Nginx:
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
        self._process = subprocess.Popen(
            ["nginx", "-p", folder, "-g", "daemon off;", "-c", path])

    def reload(self):
        self._process.send_signal(signal.SIGHUP)

    def stop(self):
        self._process.terminate()
        self._process.wait()
