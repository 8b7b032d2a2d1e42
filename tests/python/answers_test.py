"""How the package puts answers of a service together, of hand-made messages."""

import pathlib
import sys
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support" / "python"))
import geodesic_service  # noqa: E402, F401: skips the test without grpcio
import numpy as np  # noqa: E402

import geodesic  # noqa: E402
from geodesic import answers, calls  # noqa: E402
from geodesic.v1 import (answer_pb2, query_pb2,  # noqa: E402
                         question_service_pb2)

FLOAT64, FLOAT32 = query_pb2.VALUE_TYPE_FLOAT64, query_pb2.VALUE_TYPE_FLOAT32
UINT32, UINT64 = query_pb2.VALUE_TYPE_UINT32, query_pb2.VALUE_TYPE_UINT64
UINT8 = query_pb2.VALUE_TYPE_UINT8


def message(*blocks, header=(), trailer=False, answer_id=""):
    """`blocks`: (array, first, numbers of the type they travel in); `header`:
    (name, type, shape) of each array."""
    made = answer_pb2.Answer(answer_id=answer_id)
    for name, kind, shape in header:
        made.header.arrays.add(name=name, type=kind, shape=shape)
    for array, first, numbers in blocks:
        made.blocks.add(array=array, first=first, values=numbers.tobytes())
    if trailer:
        made.trailer.SetInParent()
    return made


def answer_of(*messages, **options):
    answer = answers.Answer(**options)
    for one in messages:
        answer.add(one)
    answer.check()
    return answer


DISTANCE = ("distance", FLOAT64, [5])
VALUES = np.array([0.5, 1, np.inf, 3, 4], "<f8")


class AnswerTest(unittest.TestCase):

    def test_an_answer_may_be_one_message(self):
        answer = answer_of(message((0, 0, VALUES), header=[DISTANCE],
                                   trailer=True))
        np.testing.assert_array_equal(answer["distance"], VALUES)

    def test_arrays_of_all_types_and_shapes_in_blocks(self):
        gradient = np.arange(9.0).astype("<f4")
        ends = np.array([2**40, 2**64 - 1], "<u8")
        places = np.array([1, 2, 3, 2**32 - 1], "<u4")
        answer = answer_of(
            message(header=[("gradient", FLOAT32, [3, 3]), ("end", UINT64, [2]),
                            ("place", UINT32, [-1, 2]), ("kind", UINT8, [-1]),
                            ("none", FLOAT64, [-1, 3])]),
            # In the middle of a row.
            message((0, 0, gradient[:4]), (2, 0, places[:1])),
            message((0, 4, gradient[4:]), (1, 0, ends), (2, 1, places[1:]),
                    (3, 0, np.arange(200, dtype="u1"))),
            message(trailer=True))
        for name, wanted in (("gradient", gradient.reshape(3, 3)),
                             ("end", ends), ("place", places.reshape(2, 2)),
                             ("kind", np.arange(200, dtype="u1")),
                             ("none", np.empty((0, 3)))):
            np.testing.assert_array_equal(answer[name], wanted)
            self.assertEqual(answer[name].dtype, wanted.dtype)
            self.assertTrue(answer[name].flags.writeable)

    def test_numbers_go_where_they_are_wanted(self):
        out = np.zeros((3, 5), np.float32)
        answer_of(message((0, 0, VALUES), header=[DISTANCE], trailer=True),
                  out={"distance": out[1]})
        np.testing.assert_array_equal(out[1], VALUES)
        self.assertFalse(out[[0, 2]].any())

    def test_what_is_not_known_is_skipped(self):
        answer = answer_of(message(
            (0, 0, VALUES), (1, 0, VALUES), (2, 0, VALUES), trailer=True,
            header=[("colour", 99, [7]), DISTANCE, ("taste", FLOAT64, [-1])]))
        np.testing.assert_array_equal(answer["distance"], VALUES)

    def test_progress_is_reported(self):
        told = []
        progress = answer_pb2.Answer()
        progress.progress.vertices_reached = 7
        answer_of(message(header=[DISTANCE]), progress,
                  message((0, 0, VALUES), trailer=True),
                  report=lambda p: told.append(p.vertices_reached))
        self.assertEqual(told, [7])

    def test_damaged_answers_are_refused(self):
        begin = message(header=[DISTANCE, ("vertex", UINT32, [-1, 3])])
        end = message(trailer=True)
        for words, messages in (
                ("without a trailer", []),
                ("without a trailer", [begin, message((0, 0, VALUES))]),
                ("after 0 numbers of distance", [begin, end]),
                ("after 3 numbers", [begin, message((0, 0, VALUES[:3])), end]),
                ("after 5 numbers of vertex",
                 [begin, message((0, 0, VALUES), (1, 0, np.arange(5, dtype="<u4"))),
                  end]),
                ("distance goes on .* from number 1 on, not from 0",
                 [begin, message((0, 1, VALUES[1:]))]),
                ("from number 2 on, not from 3",
                 [begin, message((0, 0, VALUES[:3]), (0, 2, VALUES[2:]))]),
                ("distance goes on",
                 [begin, message((0, 0, VALUES), (0, 5, VALUES[:1]))]),
                ("with 7 bytes",
                 [begin, message((0, 0, np.zeros(7, "u1")))]),
                ("no array 2", [begin, message((2, 0, VALUES))]),
                ("no array 0", [message((0, 0, VALUES))]),
                ("another answer",
                 [begin, message(header=[("distance", FLOAT64, [6])])])):
            with self.subTest(words):
                with self.assertRaisesRegex(geodesic.InternalError, words):
                    answer_of(*messages)
        with self.assertRaisesRegex(geodesic.InternalError, "has no colour"):
            answer_of(message(trailer=True))["colour"]
        with self.assertRaisesRegex(geodesic.InternalError, "not that of 4"):
            answer_of(begin, out={"distance": np.empty(4)})


class Server:
    """Sends what it is told, a list for each call: messages, then perhaps an
    error."""

    def __init__(self, *streams):
        self._streams = list(streams)
        self.received = []
        self.pauses = 0
        self.caller = calls.Caller.__new__(calls.Caller)
        self.caller._timeout = None
        self.caller.stream = self._stream

    def _stream(self, method, request, deadline):
        self.received.append(
            (request.resumption.answer_id, list(request.resumption.received))
            if request.HasField("resumption") else None)
        for one in self._streams.pop(0):
            if isinstance(one, Exception):
                raise one
            yield one

    def ask(self):
        answer = answers.Answer()

        def sleep(_):
            self.pauses += 1

        with mock.patch.object(calls.time, "sleep", sleep):
            answers.read(self.caller, None,
                         question_service_pb2.ComputeFieldRequest(), answer)
        return answer


def broken():
    return geodesic.Unavailable("broken")


def not_kept():
    error = geodesic.NotFound("not kept")
    error.reason = "ANSWER_NOT_KEPT"
    return error


class ReadingOnTest(unittest.TestCase):

    header = [("distance", FLOAT64, [5]), ("vertex", UINT32, [-1])]

    def numbers(self, first, last):
        return message((0, first, VALUES[first:last]),
                       (1, 2 * first, np.arange(2 * first, 2 * last, dtype="<u4")),
                       answer_id="it")

    def assert_whole(self, answer):
        np.testing.assert_array_equal(answer["distance"], VALUES)
        np.testing.assert_array_equal(answer["vertex"], np.arange(10))

    def test_what_has_come_is_not_sent_again(self):
        server = Server(
            [message(header=self.header), self.numbers(0, 2), broken()],
            [message(header=self.header), broken()],
            [message(header=self.header), self.numbers(2, 5), broken()],
            [message(header=self.header, trailer=True)])
        self.assert_whole(server.ask())
        self.assertEqual(server.received, [
            None, ("it", [2, 4]), ("it", [2, 4]), ("it", [5, 10])])

    def test_as_often_as_more_comes(self):
        streams = [[message(header=self.header), self.numbers(i, i + 1), broken()]
                   for i in range(4)]
        streams.append([message(header=self.header), self.numbers(4, 5),
                        message(trailer=True)])
        server = Server(*streams)
        self.assert_whole(server.ask())
        self.assertEqual(server.pauses, 4)

    def test_what_is_not_kept_is_asked_anew(self):
        server = Server(
            [message(header=self.header), self.numbers(0, 2), broken()],
            [not_kept()],
            [message(header=self.header), self.numbers(0, 5),
             message(trailer=True)])
        self.assert_whole(server.ask())
        self.assertEqual(server.received, [None, ("it", [2, 4]), None])

    def test_what_broke_before_the_first_block_is_asked_anew(self):
        other = [("vertex", UINT32, [-1]), DISTANCE]
        server = Server(
            [message(header=other), broken()],
            [message(header=self.header), self.numbers(0, 5),
             message(trailer=True)])
        self.assert_whole(server.ask())
        self.assertEqual(server.received, [None, None])

    def test_there_is_an_end(self):
        never_more = [message(header=self.header), self.numbers(0, 2), broken()]
        for streams in ([[broken()]] * 9, [never_more, [not_kept()]] * 9):
            server = Server(*streams)
            with self.assertRaises(geodesic.Unavailable):
                server.ask()
            self.assertEqual(server.pauses, 3)


if __name__ == "__main__":
    unittest.main()
