"""The package's exceptions for gRPC's errors."""

from __future__ import annotations

import math
from typing import Any

import grpc
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

from .errors import GeodesicError, from_code


def _detail_types() -> Any:
    """google.rpc's Status and ErrorInfo, as far as they are read here, apart from
    any other package's."""
    file = descriptor_pb2.FileDescriptorProto(
        name="geodesic/error_details.proto", package="google.rpc",
        syntax="proto3")
    field = descriptor_pb2.FieldDescriptorProto

    def add(name, *fields):
        message = file.message_type.add(name=name)
        for number, field_name, label, kind, type_name in fields:
            message.field.add(name=field_name, number=number, label=label,
                              type=kind, type_name=type_name)

    add("Any", (1, "type_url", field.LABEL_OPTIONAL, field.TYPE_STRING, None),
        (2, "value", field.LABEL_OPTIONAL, field.TYPE_BYTES, None))
    add("Status", (3, "details", field.LABEL_REPEATED, field.TYPE_MESSAGE,
                   ".google.rpc.Any"))
    add("ErrorInfo", (1, "reason", field.LABEL_OPTIONAL, field.TYPE_STRING,
                      None))
    pool = descriptor_pool.DescriptorPool()
    pool.Add(file)
    factory = message_factory.MessageFactory(pool)
    return tuple(
        factory.GetPrototype(pool.FindMessageTypeByName("google.rpc." + name))
        for name in ("Status", "ErrorInfo"))


_Status, _ErrorInfo = _detail_types()


# What gRPC says of a stream that ends without a status: so balancers pass on
# that the server behind them is gone. HAProxy ends the connection, nginx resets
# the stream.
_BROKEN = ((grpc.StatusCode.UNKNOWN, "Stream removed"),
           (grpc.StatusCode.INTERNAL, "Received RST_STREAM with error code 2"))


def error_of(error: grpc.RpcError) -> GeodesicError:
    """The package's exception for one of gRPC's."""
    reason = None
    retry_after = None
    for key, value in error.trailing_metadata() or ():
        if key == "grpc-retry-pushback-ms":
            retry_after = (float(value) / 1000 if value.isdecimal() else
                           math.inf)
        if key != "grpc-status-details-bin":
            continue
        for detail in _Status.FromString(value).details:
            if detail.type_url.endswith("/google.rpc.ErrorInfo"):
                reason = _ErrorInfo.FromString(detail.value).reason
    code, details = error.code(), error.details() or error.code().name
    if (code, details) in _BROKEN:
        code = grpc.StatusCode.UNAVAILABLE
        details = "the connection broke within the answer"
    made = from_code(code.value[0], details, reason)
    made.retry_after = retry_after
    return made
