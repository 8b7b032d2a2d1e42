"""A connection to a service, and the meshes there."""

from __future__ import annotations

import functools
import hashlib
import ipaddress
import math
import os
import pathlib
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple, Union

import grpc
import grpc.experimental
import numpy as np
from numpy.typing import ArrayLike

from . import _core, inputs
from .arguments import to_real
from .calls import Caller
from .digest import mesh_digest
from .errors import InvalidArgument, NotFound
from .mesh import Mesh
from .remote import RemoteBackend, Stubs
from .v1 import mesh_pb2, mesh_service_pb2

_CHUNK_BYTES = 512 * 1024

# gRPC answers calls with its last failure until it tries again to connect: it
# does so sooner than geodesic.calls repeats a call, after 0.16 s at the least, or
# the repetition would be in vain. gRPC makes it up to 20 % longer, and takes no
# less than this.
_RECONNECT_MILLISECONDS = 100

# Of gRPC's names of servers that are more than HOST:PORT.
_LOCAL_SCHEMES = ("unix", "unix-abstract")
_SCHEMES = _LOCAL_SCHEMES + ("dns", "ipv4", "ipv6")

PemOrPath = Union[str, bytes, os.PathLike]


def _pem(value: Optional[PemOrPath]) -> Optional[bytes]:
    """The text of a certificate or key, or the content of its file."""
    if value is None or isinstance(value, bytes):
        return value
    if isinstance(value, str) and value.lstrip().startswith("-----BEGIN"):
        return value.encode()
    return pathlib.Path(value).read_bytes()


class Service:
    """A connection to a geodesic service; made by geodesic.connect(). Thread-safe.
    Leave it by close(), or use it in a with statement."""

    def __init__(self, address: str, channel: grpc.Channel,
                 timeout: Optional[float],
                 metadata: Tuple[Tuple[str, str], ...]) -> None:
        self._stubs = Stubs(channel, address,
                            Caller(channel, timeout, metadata))

    def __repr__(self) -> str:
        return f"<geodesic.Service at {self._stubs.address}>"

    def __enter__(self) -> "Service":
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connection, and what runs on it."""
        self._stubs.caller.close()

    def version(self) -> str:
        """The server's version."""
        return self._stubs.capabilities().version

    def limits(self) -> Dict[str, int]:
        """What the server takes: max_sources, max_pairs, mesh_store_bytes..."""
        limits = self._stubs.capabilities().limits
        return {f.name: getattr(limits, f.name) for f in limits.DESCRIPTOR.fields}

    def algorithms(self) -> Dict[str, str]:
        """The server's exact algorithms by name, with a summary of each, as
        geodesic.algorithms() has those of this process."""
        return {a.name: a.summary for a in self._stubs.capabilities().algorithms}

    def approximate_algorithms(self) -> Dict[str, str]:
        """The server's approximate ones, likewise; see geodesic.Approximate."""
        return {
            a.name: a.summary
            for a in self._stubs.capabilities().approximate_algorithms
        }

    def mesh(self, vertices: Any, faces: Optional[ArrayLike] = None, *,
             weld: inputs.Weld = None) -> Mesh:
        """A mesh whose questions the service answers.

        Takes what geodesic.Mesh takes. The mesh is sent only if the service does
        not have it, and again if it was dropped there meanwhile.
        """
        if isinstance(vertices, (str, os.PathLike)):
            if faces is not None:
                raise InvalidArgument("faces come from the file, too")
            return self._file(pathlib.Path(vertices), weld)._tell()
        if faces is None:
            positions, triangles = inputs.arrays_of(vertices)
        else:
            positions = inputs.to_vertices(vertices)
            triangles = inputs.to_faces(faces)
        return Mesh._on(self._arrays(positions, triangles, weld))._tell()

    def open(self, digest: str) -> Mesh:
        """A mesh that the service has, by its name."""
        found = self._stubs.call(
            self._stubs.meshes.GetMesh,
            mesh_service_pb2.GetMeshRequest(digest=digest)).mesh
        return Mesh._on(
            RemoteBackend(self._stubs, found, None, None, self._arrays))

    def meshes(self) -> List[str]:
        """The names of the meshes that the service has."""
        digests: List[str] = []
        token = ""
        while True:
            page = self._stubs.call(
                self._stubs.meshes.ListMeshes,
                mesh_service_pb2.ListMeshesRequest(page_token=token))
            digests += [mesh.digest for mesh in page.meshes]
            token = page.next_page_token
            if not token:
                return digests

    def delete(self, mesh: Union[Mesh, str]) -> None:
        """Takes a mesh from the service, by itself or by its name."""
        digest = mesh if isinstance(mesh, str) else mesh.digest
        self._stubs.call(self._stubs.meshes.DeleteMesh,
                         mesh_service_pb2.DeleteMeshRequest(digest=digest),
                         repeat=False)

    def _arrays(self, positions: np.ndarray, triangles: np.ndarray,
                weld: inputs.Weld = None) -> RemoteBackend:
        wrong = np.argwhere((triangles < 0) | (triangles >= 2**32))
        if wrong.size:
            face, corner = wrong[0]
            raise InvalidArgument(
                f"faces[{face}, {corner}] is {triangles[face, corner]}, which is "
                "out of range: vertices are numbered from 0, below 2^32")
        kept = positions.astype("<f8", copy=False).view()
        kept.setflags(write=False)
        # The same bytes as the wire's uint32.
        numbers = np.ascontiguousarray(triangles).astype("<u4", copy=False).view(
            "<i4")
        digest = mesh_digest(kept, numbers)
        joins, distance = inputs.to_welding(weld, False)
        if joins and distance is None:
            raise InvalidArgument(
                "weld: a service joins arrays within a distance: name one (0 for "
                "equal places), or upload a file")

        def upload(route: str = digest) -> mesh_pb2.Mesh:
            header = mesh_service_pb2.UploadHeader(
                format=mesh_pb2.MESH_FORMAT_ARRAYS,
                size_bytes=kept.nbytes + numbers.nbytes,
                vertex_count=len(kept),
                face_count=len(numbers),
                weld_distance=distance,
                expected_digest="" if joins else digest)
            return self._upload(header, (kept, numbers), route)

        if joins:
            return RemoteBackend(self._stubs, upload(), None, upload,
                                 self._arrays)

        missing = self._stubs.call(
            self._stubs.meshes.FindMissingMeshes,
            mesh_service_pb2.FindMissingMeshesRequest(
                mesh_digests=[digest])).missing_mesh_digests
        mesh = upload() if missing else self._known(digest, upload)
        return RemoteBackend(self._stubs, mesh, (kept, numbers), upload,
                             self._arrays)

    def _file(self, path: pathlib.Path, weld: inputs.Weld) -> Mesh:
        joins, distance = inputs.to_welding(weld, True)
        name = _core.mesh_format(os.fsencode(path))
        data = np.frombuffer(path.read_bytes(), np.uint8)
        file = mesh_pb2.FileDigest(
            format=mesh_pb2.MeshFormat.Value("MESH_FORMAT_" + name.upper()),
            sha256=hashlib.sha256(data.data).hexdigest(),
            weld_distance=distance,
            keep_seams=not joins)

        def upload(route: str = file.sha256) -> mesh_pb2.Mesh:
            return self._upload(
                mesh_service_pb2.UploadHeader(format=file.format,
                                              size_bytes=data.nbytes,
                                              weld_distance=distance,
                                              keep_seams=not joins), (data,),
                route)

        known = self._stubs.call(
            self._stubs.meshes.FindMissingMeshes,
            mesh_service_pb2.FindMissingMeshesRequest(files=[file])).known_files
        mesh = (self._known(known[0].mesh_digest, upload) if known else
                upload())
        return Mesh._on(
            RemoteBackend(self._stubs, mesh, None, upload, self._arrays))

    def _known(self, digest: str,
               upload: Callable[[str], mesh_pb2.Mesh]) -> mesh_pb2.Mesh:
        """A mesh that a server has, if perhaps not the one to which a balancer
        sends questions about it: then that one gets it."""
        try:
            return self._stubs.call(
                self._stubs.meshes.GetMesh,
                mesh_service_pb2.GetMeshRequest(digest=digest)).mesh
        except NotFound:
            return upload(digest)

    def _upload(self, header: mesh_service_pb2.UploadHeader,
                arrays: Tuple[np.ndarray, ...],
                route: str) -> mesh_pb2.Mesh:
        """Sends a mesh's bytes, again where the connection breaks. `route`: the
        mesh's digest or, if that is not known, the file's."""
        return self._stubs.call(
            self._stubs.meshes.CreateMesh,
            functools.partial(_upload_messages, header, arrays),
            mesh=route).mesh


def _upload_messages(header: mesh_service_pb2.UploadHeader,
                     arrays: Tuple[np.ndarray, ...],
                     ) -> Iterator[mesh_service_pb2.CreateMeshRequest]:
    yield mesh_service_pb2.CreateMeshRequest(header=header)
    sent = 0
    for array in arrays:
        data = array.reshape(-1).data.cast("B")
        for at in range(0, len(data), _CHUNK_BYTES):
            chunk = bytes(data[at:at + _CHUNK_BYTES])
            yield mesh_service_pb2.CreateMeshRequest(
                chunk=mesh_service_pb2.UploadChunk(offset=sent, data=chunk))
            sent += len(chunk)


def _stays_here(address: str) -> bool:
    """Whether what is sent to an address in clear stays on this machine."""
    scheme, colon, rest = address.partition(":")
    if colon and scheme in _LOCAL_SCHEMES:
        return True
    if colon and scheme in _SCHEMES:
        address = rest.rpartition("/")[2]
    return all(_is_loopback(one) for one in address.split(","))


def _is_complete(address: str) -> bool:
    """Whether it is HOST:PORT or [HOST]:PORT, or has one of gRPC's schemes."""
    host, colon, port = address.rpartition(":")
    if address.partition(":")[0] in _SCHEMES:
        return True
    if ":" in host and not (host.startswith("[") and host.endswith("]")):
        return False
    return bool(host and port.isdecimal() and 0 < int(port) < 2**16)


def _is_loopback(address: str) -> bool:
    """Of HOST, HOST:PORT or [HOST]:PORT."""
    if address.startswith("["):
        host = address[1:].partition("]")[0]
    else:
        host = address if address.count(":") > 1 else address.partition(":")[0]
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def connect(address: str, *, token: Optional[str] = None,
            insecure_token: bool = False,
            timeout: Optional[float] = None, tls: Optional[bool] = None,
            authorities: Optional[PemOrPath] = None,
            certificate: Optional[PemOrPath] = None,
            key: Optional[PemOrPath] = None,
            server_name: Optional[str] = None) -> Service:
    """Connects to a geodesic service.

        with geodesic.connect("host:50051") as service:
            d = service.mesh(V, F).distances(0)

    Args:
        address: host:port, or unix:/path.
        token: sent with each call, and to other machines by TLS only.
        insecure_token: lets the token go to another machine in clear, where
            whoever is on the way can read it.
        timeout: seconds that a call may take, or None.
        tls: whether to speak TLS; by default if any of what follows is given.
        authorities: who vouches for the server, as PEM or a path; by default
            those whom the system trusts.
        certificate, key: what to show a server that asks for one, likewise.
        server_name: the name in the server's certificate, if it is not the host.

    Nothing is sent before the first question. Calls that fail because the
    service is not there or is full are repeated up to three times, within the
    timeout.
    """
    if not isinstance(address, str) or not _is_complete(address):
        raise InvalidArgument(
            f"address is {address!r}, not HOST:PORT, such as 127.0.0.1:50051 or "
            "[::1]:50051, with a port from 1 to 65535")
    if timeout is not None:
        timeout = to_real(timeout, "timeout")
        if not 0 < timeout < math.inf:
            raise InvalidArgument(f"timeout is {timeout}; a call takes some "
                                  "seconds, or as many as it likes with None")
    options: List[Tuple[str, Union[int, str]]] = [
        # A service config's retryPolicy lets grpcio 1.51 wait forever, beyond
        # any timeout, for a stream whose server went away: geodesic.calls
        # repeats calls itself.
        ("grpc.enable_retries", 0),
        # Not grpc.min_reconnect_backoff_ms: it bounds the time to connect.
        ("grpc.initial_reconnect_backoff_ms", _RECONNECT_MILLISECONDS),
        ("grpc.max_reconnect_backoff_ms", _RECONNECT_MILLISECONDS),
        # The thread that reads a stream waits for gRPC itself, not for another
        # thread that does: two switches of threads less for each message.
        (grpc.experimental.ChannelOptions.SingleThreadedUnaryStream, 1),
        # Notices who is gone without a word. A server takes pings in silence
        # every five minutes for abuse if they come more often.
        ("grpc.keepalive_time_ms", 310_000),
        ("grpc.keepalive_timeout_ms", 20_000),
        # Parts of answers have their own bounds.
        ("grpc.max_receive_message_length", -1),
    ]
    if tls is None:
        tls = any(x is not None
                  for x in (authorities, certificate, key, server_name))
    if (certificate is None) != (key is None):
        raise InvalidArgument("a certificate needs its key, and a key its "
                              "certificate")
    metadata: Tuple[Tuple[str, str], ...] = ()
    if token is not None:
        if (not isinstance(token, str) or not token or
                not all("!" <= c <= "~" for c in token)):
            raise InvalidArgument("token is not a text of visible ASCII "
                                  "characters")
        if not tls:
            if _stays_here(address):
                # Nor does a proxy get it.
                options.append(("grpc.enable_http_proxy", 0))
            elif not insecure_token:
                raise InvalidArgument(
                    f"the token would go to {address} in clear: use TLS "
                    "(tls=True or authorities=...)")
        metadata = (("authorization", "Bearer " + token),)
    if not tls:
        channel = grpc.insecure_channel(address, options)
    else:
        if server_name is not None:
            options.append(("grpc.ssl_target_name_override", server_name))
        credentials = grpc.ssl_channel_credentials(
            _pem(authorities), _pem(key), _pem(certificate))
        channel = grpc.secure_channel(address, credentials, options)
    return Service(address, channel, timeout, metadata)
