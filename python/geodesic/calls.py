"""Calls of a service, made by threads beside the one that asks.

Ctrl-C raises KeyboardInterrupt wherever Python's main thread happens to be. In
the middle of grpcio that leaves locks behind that nobody opens again, and the
next call, or the end of the process, waits for them forever. So the threads that
ask never enter grpcio: they put what they want into queue.SimpleQueue, which is
one step for signals, and wait for what comes out of another.
"""

from __future__ import annotations

import functools
import math
import os
import queue
import random
import threading
import time
import weakref
from typing import Any, Callable, Dict, Iterator, Optional, Tuple, TypeVar

import grpc

from .error_details import error_of
from .errors import (Cancelled, DeadlineExceeded, GeodesicError,
                     ResourceExhausted, Unavailable)

# A call that finds the service away or full is repeated after these pauses, in
# seconds, each some 20 % longer or shorter so that clients do not come back all
# at once.
_PAUSES = (0.2, 0.4, 0.8)
_JITTER = 0.2
# The longest pause that a service may ask for, in seconds.
_LONGEST_PAUSE = 10.0
# A call that waits for a connection during these pauses, and no longer than the
# longest. gRPC comes forward with a connection only while some call waits for it,
# and else every five seconds: repetitions would fail with what is long over.
_LOOK = "/geodesic.v1.CapabilitiesService/GetCapabilities"
_LOOK_SECONDS = _PAUSES[-1] * (1 + _JITTER)
# Messages that wait for their reader, up to 1 MiB each.
_ROOM = 8
# Threads that wait for the next call. To start one costs more than to wake one.
_IDLE_WORKERS = 4
# gRPC itself ends calls at their deadline. Should it not, they end so many
# seconds later, and a process that ends waits so long for its connections.
_GRACE = 1.0
_END_OF_PROCESS = 5.0

T = TypeVar("T")


class Patience:
    """How often, and when, what failed is tried again.

    Attributes:
        deadline: of all attempts, by time.monotonic(); +inf where there is none.
    """

    def __init__(self, deadline: float) -> None:
        self.deadline = deadline
        self.begin_again()

    def begin_again(self) -> None:
        """After a success."""
        self._pauses = list(_PAUSES)

    def pause(self, error: GeodesicError) -> None:
        """Waits before the next attempt; raises the error if there is none."""
        if not self._pauses or error.retry_after == math.inf:
            raise error
        seconds = self._pauses.pop(0) * random.uniform(1 - _JITTER, 1 + _JITTER)
        if error.retry_after is not None:
            seconds = min(error.retry_after, _LONGEST_PAUSE)
        if time.monotonic() + seconds >= self.deadline:
            raise error
        time.sleep(seconds)


class _Call:
    """A call as its reader and the thread that makes it share it.

    `begin` starts it; `arrivals` brings (message, None) for each message, then
    (None, error or None). `room` holds an item for each message that may still
    be fetched.
    """

    def __init__(self, begin: Callable[[], Any], streams: bool) -> None:
        self._begin = begin
        self._streams = streams
        self._running: Any = None
        self._is_cancelled = False
        self.arrivals: "queue.SimpleQueue[Tuple[Any, Any]]" = (
            queue.SimpleQueue())
        self.room: "queue.SimpleQueue[None]" = queue.SimpleQueue()
        for _ in range(_ROOM):
            self.room.put(None)

    def run(self, ending: Callable[[], None]) -> None:
        """Makes the call, from the beginning to its end. `ending` is called
        before the reader learns of the end."""
        error: Optional[BaseException] = None
        try:
            running = self._running = self._begin()
            if self._is_cancelled:
                running.cancel()
            if self._streams:
                self.room.get()
                for message in running:
                    self.arrivals.put((message, None))
                    self.room.get()
            else:
                self.arrivals.put((running.result(), None))
        except grpc.RpcError as raised:
            # It is the call itself. Its traceback would keep it until some
            # other thread collects garbage, and grpcio takes locks then.
            raised.__traceback__ = None
            error = error_of(raised)
        except ValueError as raised:  # of a channel that is closed
            error = Cancelled(str(raised))
        except BaseException as raised:
            error = raised
        running = self._running = None
        ending()
        self.arrivals.put((None, error))

    def cancel(self) -> None:
        self._is_cancelled = True
        running = self._running
        if running is not None:
            running.cancel()
        self.room.put(None)


_Inbox = queue.SimpleQueue  # of calls; None ends the thread that reads it


class _Idle:
    """The inboxes of threads that wait for a call, of which there are only so
    many as there are places."""

    def __init__(self) -> None:
        self.inboxes: "queue.SimpleQueue[_Inbox]" = queue.SimpleQueue()
        self.places: "queue.SimpleQueue[None]" = queue.SimpleQueue()
        for _ in range(_IDLE_WORKERS):
            self.places.put(None)


def _work(inbox: _Inbox, idle: _Idle) -> None:
    """Makes the calls that come in, until there are idle threads enough."""
    stays = False

    def ending() -> None:
        # Who learns of the end may ask the next thing at once, and finds this
        # thread idle.
        nonlocal stays
        try:
            idle.places.get_nowait()
        except queue.Empty:
            return
        stays = True
        idle.inboxes.put(inbox)

    while (call := inbox.get()) is not None:
        if stays:
            idle.places.put(None)
        stays = False
        call.run(ending)
        del call
        if not stays:
            return


def _serve(channel: grpc.Channel, orders: "queue.SimpleQueue[Any]",
           idle: _Idle) -> None:
    """Follows orders until the last, None: (call, None) runs a call in a new
    thread, (call, True) cancels it, (None, done) closes the channel."""
    workers: Dict[threading.Thread, _Inbox] = {}
    while (order := orders.get()) is not None:
        call, what = order
        if call is None:
            channel.close()
            what.put(None)
        elif what:
            call.cancel()
        else:
            workers = {w: inbox for w, inbox in workers.items() if w.is_alive()}
            inbox: _Inbox = queue.SimpleQueue()
            inbox.put(call)
            worker = threading.Thread(target=_work, args=(inbox, idle),
                                      name="geodesic.call", daemon=True)
            try:
                worker.start()
                workers[worker] = inbox
            except RuntimeError as error:  # no more threads
                call.arrivals.put((None, ResourceExhausted(str(error))))
        del order, call, what
    channel.close()
    for inbox in workers.values():
        inbox.put(None)
    for worker in workers:
        worker.join()


def _end(orders: "queue.SimpleQueue[Any]", thread: threading.Thread) -> None:
    orders.put(None)
    if not threading.main_thread().is_alive():  # the process ends
        thread.join(_END_OF_PROCESS)


class Caller:
    """Makes the calls on a channel. Thread-safe."""

    def __init__(self, channel: grpc.Channel, timeout: Optional[float],
                 metadata: Tuple[Tuple[str, str], ...]) -> None:
        self._look = channel.unary_unary(_LOOK)
        self._timeout = timeout
        self._metadata = metadata
        self._process = os.getpid()
        self._orders: "queue.SimpleQueue[Any]" = queue.SimpleQueue()
        self._idle = _Idle()
        thread = threading.Thread(target=_serve,
                                  args=(channel, self._orders, self._idle),
                                  name="geodesic.connect", daemon=True)
        thread.start()
        weakref.finalize(self, _end, self._orders, thread)

    def close(self) -> None:
        """Cancels all calls and ends the connection."""
        if self._process != os.getpid():
            return
        done: "queue.SimpleQueue[None]" = queue.SimpleQueue()
        self._orders.put((None, done))
        done.get()

    def repeat(self, attempt: Callable[[Patience], T]) -> T:
        """What `attempt` returns, which is called again where it finds the
        service away or full.

        Raises: the package's errors; Unavailable and ResourceExhausted only
            after some attempts.
        """
        patience = self._patience()
        while True:
            try:
                return attempt(patience)
            except (Unavailable, ResourceExhausted) as error:
                patience.pause(error)

    def call(self, method: Callable, request: Any, repeat: bool = True,
             mesh: str = "") -> Any:
        """The response of a call that has one. A `request` in messages is a
        function that returns their iterator. `mesh` is the digest that the call
        is about, if the request does not tell."""

        def attempt(patience: Patience) -> Any:
            [response] = self.stream(method, request, patience.deadline, mesh,
                                     streams=False)
            return response

        return self.repeat(attempt) if repeat else attempt(self._patience())

    def _patience(self) -> Patience:
        return Patience(math.inf if self._timeout is None else
                        time.monotonic() + self._timeout)

    def stream(self, method: Callable, request: Any, deadline: float,
               mesh: str = "", streams: bool = True) -> Iterator[Any]:
        """The messages of one call, which streams them or has one. Whoever stops
        reading, also by an exception, cancels it."""
        if self._process != os.getpid():
            raise Unavailable("the connection is another process's, which this "
                              "one was forked from: call geodesic.connect here")
        left = None if deadline == math.inf else deadline - time.monotonic()
        if left is not None and left <= 0:
            raise self._late()
        metadata = self._metadata
        mesh = mesh or _mesh_of(request)
        if mesh:
            metadata += (("geo-mesh-digest", mesh),)
        begin = functools.partial(_begin, method, streams, request, left,
                                  metadata)
        call = _Call(begin, streams)
        has_ended = False
        try:
            self._start(call)
            while True:
                message, error = self._arrival(call, deadline)
                if message is None:
                    has_ended = True
                    if isinstance(error, Unavailable):
                        self._look_for_service()
                    if error is not None:
                        raise error
                    return
                yield message
                call.room.put(None)
        finally:
            if not has_ended:
                self._orders.put((call, True))

    def _look_for_service(self) -> None:
        """Begins to, for this call's next attempt or for the next call."""
        begin = functools.partial(self._look.future, b"", _LOOK_SECONDS,
                                  self._metadata, wait_for_ready=True)
        self._start(_Call(begin, False))

    def _start(self, call: _Call) -> None:
        """Has an idle thread make the call, or else a new one."""
        try:
            self._idle.inboxes.get_nowait().put(call)
        except queue.Empty:
            self._orders.put((call, None))

    def _arrival(self, call: _Call, deadline: float) -> Tuple[Any, Any]:
        if deadline == math.inf:
            return call.arrivals.get()
        try:
            return call.arrivals.get(
                timeout=max(deadline - time.monotonic(), 0) + _GRACE)
        except queue.Empty:
            raise self._late() from None

    def _late(self) -> DeadlineExceeded:
        return DeadlineExceeded(
            f"the answer did not come within {self._timeout:g} seconds")


def _mesh_of(request: Any) -> str:
    """The digest that a request is about, by which a balancer finds the replica
    that has the mesh (protocol.md, "Several servers"); empty for none."""
    for name in ("mesh_digest", "digest"):
        if getattr(request, name, ""):
            return getattr(request, name)
    for digest in getattr(request, "mesh_digests", ()):
        return digest
    for file in getattr(request, "files", ()):
        return file.sha256
    return ""


def _begin(method: Any, streams: bool, request: Any, timeout: Optional[float],
           metadata: Tuple[Tuple[str, str], ...]) -> Any:
    start = method if streams else method.future
    return start(request() if callable(request) else request, timeout=timeout,
                 metadata=metadata)
