"""Servers of the cluster's test, to be measured."""

import argparse
import contextlib
import os
import pathlib
import string
import sys

import psutil

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "cluster"),
                str(ROOT / "tests" / "support" / "python")]
from redis_server import Redis  # noqa: E402
from replica import Replica  # noqa: E402
from waiting import free_port  # noqa: E402


def parser(doc):
    """With what all of these programs are told; puts balancers into the path."""
    os.environ["PATH"] += ":/usr/sbin"
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("--server", required=True, help="the geodesicd to measure")
    parser.add_argument("--protos", default=str(ROOT / "proto"))
    parser.add_argument("--protoc", default="/usr/bin/protoc")
    parser.add_argument("--plugin", default="/usr/bin/grpc_python_plugin")
    return parser


@contextlib.contextmanager
def running(server, folder, count, balancer_type=None, flags=(), has_tier=False):
    """Servers, what is in front of them and behind them: gives the address to ask,
    the servers, and the balancer, which may be None."""
    with contextlib.ExitStack() as stack:
        flags = list(flags)
        if has_tier:
            tier = Redis(folder, str(ROOT / "deploy" / "cluster" / "redis.conf"))
            tier.start()
            stack.callback(tier.kill)
            flags += ["--shared-tier", tier.address]
        ports = [(free_port(), free_port()) for _ in range(count)]
        replicas = [Replica(server, folder, name, pair, flags)
                    for name, pair in zip(string.ascii_lowercase, ports)]
        for replica in replicas:
            replica.start()
            stack.callback(replica.kill)
        port, balancer = ports[0][0], None
        if balancer_type is not None:
            port = free_port()
            balancer = balancer_type(folder, port, replicas)
            stack.callback(balancer.stop)
        yield "127.0.0.1:%d" % port, replicas, balancer


def processor_seconds(process):
    """Of a replica or a balancer, and what it has started, so far."""
    parent = psutil.Process(process.pid)
    return sum(p.cpu_times().user + p.cpu_times().system
               for p in [parent, *parent.children(recursive=True)])
