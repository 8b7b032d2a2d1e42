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
from typing import Any, Callable, Iterator, Optional, Set, Tuple

import grpc

from .errors import (Cancelled, DeadlineExceeded, GeodesicError,
                     ResourceExhausted, Unavailable)
from .wire import error_of

# A call that finds the service away or full is repeated after these pauses, in
# seconds, each some 20 % longer or shorter so that clients do not come back all
# at once.
_PAUSES = (0.2, 0.4, 0.8)
_JITTER = 0.2
# Messages that wait for their reader, up to 1 MiB each.
_ROOM = 8
# gRPC itself ends calls at their deadline. Should it not, they end so many
# seconds later, and a process that ends waits so long for its connections.
_GRACE = 1.0
_END_OF_PROCESS = 5.0


def deadline_after(timeout: Optional[float]) -> float:
    """By time.monotonic(); +inf where there is none."""
    return math.inf if timeout is None else time.monotonic() + timeout


class Patience:
    """How often, and when, what failed is tried again."""

    def __init__(self, deadline: float) -> None:
        self._deadline = deadline
        self.begin_again()

    def begin_again(self) -> None:
        """After a success."""
        self._pauses = list(_PAUSES)

    def pause(self, error: GeodesicError) -> None:
        """Waits before the next attempt; raises the error if there is none."""
        if not self._pauses:
            raise error
        seconds = self._pauses.pop(0) * random.uniform(1 - _JITTER, 1 + _JITTER)
        if error.retry_after is not None:
            seconds = error.retry_after
        if time.monotonic() + seconds >= self._deadline:
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

    def run(self) -> None:
        """Makes the call, from the beginning to its end."""
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
        self.arrivals.put((None, error))

    def cancel(self) -> None:
        self._is_cancelled = True
        running = self._running
        if running is not None:
            running.cancel()
        self.room.put(None)


def _serve(channel: grpc.Channel, orders: "queue.SimpleQueue[Any]") -> None:
    """Follows orders until the last, None: (call, None) runs a call, (call,
    True) cancels it, (None, done) closes the channel."""
    workers: Set[threading.Thread] = set()
    while (order := orders.get()) is not None:
        call, what = order
        if call is None:
            channel.close()
            what.put(None)
        elif what:
            call.cancel()
        else:
            workers = {worker for worker in workers if worker.is_alive()}
            worker = threading.Thread(target=call.run, daemon=True)
            try:
                worker.start()
                workers.add(worker)
            except RuntimeError as error:  # no more threads
                call.arrivals.put((None, ResourceExhausted(str(error))))
        del order, call, what
    channel.close()
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
        self._timeout = timeout
        self._metadata = metadata
        self._process = os.getpid()
        self._orders: "queue.SimpleQueue[Any]" = queue.SimpleQueue()
        thread = threading.Thread(target=_serve, args=(channel, self._orders),
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

    def deadline(self) -> float:
        """Of what begins now."""
        return deadline_after(self._timeout)

    def call(self, method: Callable, request: Any, repeat: bool = True) -> Any:
        """The response of a call that has one. A `request` in messages is a
        function that returns their iterator.

        Raises: the package's errors; Unavailable and ResourceExhausted only
            after some attempts, where calls may be repeated.
        """
        [response] = self._messages(method, request, False, repeat,
                                    self.deadline())
        return response

    def stream(self, method: Callable, request: Any, repeat: bool = True,
               deadline: Optional[float] = None) -> Iterator[Any]:
        """The responses of a call that streams them; likewise, but what breaks
        after the first message is not repeated. Whoever stops reading, also by
        an exception, cancels the call."""
        return self._messages(method, request, True, repeat,
                              self.deadline() if deadline is None else deadline)

    def _messages(self, method: Callable, request: Any, streams: bool,
                  repeat: bool, deadline: float) -> Iterator[Any]:
        patience = Patience(deadline)
        while True:
            has_begun = False
            try:
                for message in self._once(method, request, streams, deadline):
                    has_begun = True
                    yield message
                return
            except (Unavailable, ResourceExhausted) as error:
                if has_begun or not repeat:
                    raise
                patience.pause(error)

    def _once(self, method: Callable, request: Any, streams: bool,
              deadline: float) -> Iterator[Any]:
        if self._process != os.getpid():
            raise Unavailable("the connection is another process's, which this "
                              "one was forked from: call geodesic.connect here")
        left = None if deadline == math.inf else deadline - time.monotonic()
        if left is not None and left <= 0:
            raise self._late()
        begin = functools.partial(_begin, method, streams, request, left,
                                  self._metadata)
        call = _Call(begin, streams)
        try:
            self._orders.put((call, None))
            while True:
                message, error = self._arrival(call, deadline)
                if error is not None:
                    raise error
                if message is None:
                    return
                yield message
                call.room.put(None)
        finally:
            self._orders.put((call, True))

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


def _begin(method: Any, streams: bool, request: Any, timeout: Optional[float],
           metadata: Tuple[Tuple[str, str], ...]) -> Any:
    start = method if streams else method.future
    return start(request() if callable(request) else request, timeout=timeout,
                 metadata=metadata)
