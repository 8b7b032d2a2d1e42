"""Answers of a service, put together from their streams (answer.proto)."""

from __future__ import annotations

import math
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

import numpy as np

from .approximate import Approximate
from .calls import Caller, Patience
from .errors import InternalError, NotFound
from .places import Places
from .v1 import answer_pb2, query_pb2

_TYPES = {
    query_pb2.VALUE_TYPE_FLOAT64: "<f8",
    query_pb2.VALUE_TYPE_FLOAT32: "<f4",
    query_pb2.VALUE_TYPE_UINT32: "<u4",
    query_pb2.VALUE_TYPE_UINT64: "<u8",
    query_pb2.VALUE_TYPE_UINT8: "u1",
}


class _Array:
    """An array of which the first `count` numbers have come."""

    def __init__(self, info: answer_pb2.ArrayInfo,
                 out: Optional[np.ndarray]) -> None:
        self.name = info.name
        self.count = 0
        self._type = np.dtype(_TYPES[info.type])
        self._shape = tuple(info.shape)
        self._grows = self._shape[:1] == (-1,)
        size = 0 if self._grows else math.prod(self._shape)
        if out is None:
            out = np.empty(size, self._type.newbyteorder("="))
        if out.size != size:
            raise InternalError(f"{self.name} has the shape {self._shape}, which "
                                f"is not that of {out.size} numbers")
        self._values = out.reshape(-1)

    def add(self, block: answer_pb2.Block) -> None:
        data = block.values
        end = self.count + len(data) // self._type.itemsize
        if end > len(self._values) and self._grows:
            longer = np.empty(max(end, 2 * self.count), self._values.dtype)
            longer[:self.count] = self._values[:self.count]
            self._values = longer
        if (block.first != self.count or end > len(self._values) or
                len(data) % self._type.itemsize):
            raise InternalError(
                f"{self.name} goes on with {len(data)} bytes from number "
                f"{block.first} on, not from {self.count}")
        self._values[self.count:end] = np.frombuffer(data, self._type)
        self.count = end

    def is_complete(self) -> bool:
        return (self.count % math.prod(self._shape[1:]) == 0 if self._grows else
                self.count == len(self._values))

    def values(self) -> np.ndarray:
        """Those that have come, of the whole array or of one that grows."""
        return self._values[:self.count].reshape(self._shape)


class Answer:
    """An answer, as far as it has come in one stream or in several.

    `out` has arrays to be filled, by their names; others are made. `report` is
    called with each SolveProgress.

    Attributes:
        header, trailer: None before they have come.
    """

    def __init__(self, report: Optional[Callable[[Any], object]] = None,
                 out: Optional[Dict[str, np.ndarray]] = None) -> None:
        self._report = report
        self._out = out or {}
        # So much had come at the most; again is no success.
        self._most = 0
        self.forget()

    def forget(self) -> None:
        """What has come so far."""
        self.header: Any = None
        self.trailer: Any = None
        self._id = ""
        # In order of the header; None for one whose type is not known.
        self._arrays: List[Optional[_Array]] = []

    def resume(self, request: Any) -> None:
        """Makes the request one for what is missing."""
        if not self._id:
            self.forget()
            request.ClearField("resumption")
            return
        request.resumption.answer_id = self._id
        request.resumption.received[:] = [
            array.count if array else 0 for array in self._arrays]

    def add(self, message: answer_pb2.Answer) -> bool:
        """Whether numbers came that had never come before."""
        if message.HasField("header"):
            self._begin(message.header)
        if message.HasField("progress") and self._report is not None:
            self._report(message.progress)
        if message.answer_id:
            self._id = message.answer_id
        for block in message.blocks:
            if block.array >= len(self._arrays):
                raise InternalError(f"there is no array {block.array}")
            array = self._arrays[block.array]
            if array is not None:
                array.add(block)
        if message.HasField("trailer"):
            self.trailer = message.trailer
        before = self._most
        self._most = max(before, sum(a.count for a in self._arrays if a))
        return self._most > before

    def _begin(self, header: answer_pb2.AnswerHeader) -> None:
        if self.header is None:
            self._arrays = [
                _Array(info, self._out.get(info.name))
                if info.type in _TYPES else None for info in header.arrays]
        elif header.arrays != self.header.arrays:
            raise InternalError("the rest is that of another answer")
        self.header = header

    def check(self) -> None:
        """Whether all has come."""
        if self.trailer is None:
            raise InternalError("the stream ended without a trailer")
        for array in self._arrays:
            if array is not None and not array.is_complete():
                raise InternalError(
                    f"the stream ended after {array.count} numbers of "
                    f"{array.name}")

    def __getitem__(self, name: str) -> np.ndarray:
        """An array that is whole, or one that grows as far as it has come."""
        for array in self._arrays:
            if array is not None and array.name == name:
                return array.values()
        raise InternalError(f"the answer has no {name}")

    def lines(self) -> Iterator[Tuple[Places, np.ndarray]]:
        """The points of each line, as places and in space."""
        places = Places(self["point_kind"], self["point_numbers"],
                        self["point_weights"])
        positions = self["position"]
        first = 0
        for end in self["line_end"].tolist():
            yield places[first:end], positions[first:end]
            first = end

    def algorithm(self) -> str:
        """The name of the one that ran."""
        name = query_pb2.Algorithm.Name(self.header.algorithm)
        return name[len("ALGORITHM_"):].lower().replace("_", "-")

    def approximation(self) -> Optional[Approximate]:
        """None where distances are not approximate."""
        if not self.header.HasField("approximation"):
            return None
        used = {field.name: value
                for field, value in self.header.approximation.ListFields()}
        return Approximate(self.algorithm(), used.get("neighbours"),
                           used.get("lambda"), used.get("samples"))


def read(caller: Caller, method: Callable, request: Any,
         answer: Answer) -> None:
    """Asks for what is missing of an answer, and reads on where a stream
    breaks."""

    def attempt(patience: Patience) -> None:
        while True:
            answer.resume(request)
            try:
                for message in caller.stream(method, request,
                                             patience.deadline):
                    if answer.add(message):
                        patience.begin_again()
                answer.check()
                return
            except NotFound as error:
                if error.reason != "ANSWER_NOT_KEPT":
                    raise
                answer.forget()

    caller.repeat(attempt)
