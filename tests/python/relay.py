"""A hop on the way to a server that can be cut, as cables are."""

import socket
import threading


class Relay:
    """Passes on what connections to its address say to a server's address."""

    def __init__(self, server):
        host, port = server.rsplit(":", 1)
        self._server = host, int(port)
        self._lock = threading.Lock()
        self._sockets = []
        self._bytes_left = None
        self.cuts = 0
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self._listener.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def cut_after(self, count):
        """Cuts all connections, once, when so many more bytes have come from the
        server."""
        with self._lock:
            self._bytes_left = count

    def close(self):
        self._listener.close()
        self._cut()

    def _cut(self):
        with self._lock:
            for end in self._sockets:
                try:
                    end.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass  # the other side was first
            self._sockets.clear()

    def _accept(self):
        while True:
            try:
                client, _ = self._listener.accept()
            except OSError:
                return
            server = socket.create_connection(self._server)
            with self._lock:
                self._sockets += [client, server]
            for ends in ((client, server, False), (server, client, True)):
                threading.Thread(target=self._copy, args=ends,
                                 daemon=True).start()

    def _copy(self, source, target, counts):
        try:
            while data := source.recv(16384):
                if counts and self._is_last(len(data)):
                    self._cut()
                    return
                target.sendall(data)
        except OSError:
            pass  # cut
        finally:
            source.close()

    def _is_last(self, count):
        with self._lock:
            if self._bytes_left is None:
                return False
            self._bytes_left -= count
            if self._bytes_left > 0:
                return False
            self._bytes_left = None
            self.cuts += 1
            return True
