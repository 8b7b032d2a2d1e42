"""The answer to any question of a server, with grpcio and the stubs of protoc:

    read(QuestionServiceStub(channel).ComputeField(request, timeout=60))["distance"]
"""

import numpy

TYPES = {1: "<f8", 2: "<f4", 3: "<u4", 4: "<u8", 5: "u1"}


def read(stream):
    """The arrays of an answer by name."""
    complete = False
    for answer in stream:
        if answer.HasField("header"):
            infos = answer.header.arrays
            values = [bytearray() for _ in infos]
        for block in answer.blocks:
            values[block.array] += block.values
        complete = answer.HasField("trailer")
    if not complete:
        raise EOFError("the stream ended without a trailer")
    return {info.name: numpy.frombuffer(array, TYPES[info.type]).reshape(info.shape)
            for info, array in zip(infos, values) if info.type in TYPES}
