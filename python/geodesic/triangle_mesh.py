"""What a mesh is made of, and its places; without questions."""

from __future__ import annotations

import functools
import os
import pathlib
from typing import Any, Dict, List, Optional, Sequence, Type, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, inputs
from .arguments import to_array
from .backend import Backend
from .digest import Reading
from .errors import InvalidArgument, naming
from .face_geometry import FaceFinder, PointFinder
from .local import LocalBackend
from .places import (FacePoint, Places, Source, SurfacePoint, to_numbers, to_places,
                     to_sources)
from .reach import joined_into, warn, warn_of_isolated

OneOrManySources = Union[Source, Sequence[Source], NDArray[Any], Places]
OneOrManyPlaces = Union[SurfacePoint, Sequence[SurfacePoint], NDArray[Any],
                        Places]
_Self = TypeVar("_Self", bound="TriangleMesh")


def _mask(values: Optional[ArrayLike], name: str, count: int) -> np.ndarray:
    """Which of `count` are named, by numbers or by a mask; bool (count,)."""
    mask = np.zeros(count, bool)
    if values is not None and to_array(values, name).size:
        numbers = to_numbers(to_array(values, name), name, count)
        if numbers.size and numbers.max() >= count:
            first = int(np.argmax(numbers >= count))
            raise InvalidArgument(f"{name}[{first}] is {numbers[first]}, but the "
                                  f"mesh has {count}, numbered from 0")
        mask[numbers] = True
    return mask


def _restored(kind: Type[_Self], vertices: np.ndarray, faces: np.ndarray,
              reading: Reading, kept_faces: Optional[np.ndarray]) -> _Self:
    """What a pickled mesh becomes."""
    mesh = kind._on(LocalBackend(_core.Mesh.restore(vertices, faces, *reading)))
    mesh._kept_faces = kept_faces
    return mesh


class TriangleMesh:
    """A mesh that is kept in this process or at a service."""

    def __init__(self, vertices: Any, faces: Optional[ArrayLike] = None, *,
                 weld: inputs.Weld = None) -> None:
        """Takes arrays, a file, or another library's mesh.

        Args:
            vertices: numbers (V, 3); or a file's path (.obj, .ply, .off, .stl,
                .vtk, .vtp, .glb, .gltf, or .gz of these);
                or a mesh of trimesh, meshio or PyVista.
            faces: integers (F, 3), the vertices of each triangle; polygons of
                files and other libraries' meshes become triangles inside them.

            weld: how edges are joined at which faces are kept apart, as programs
                do where a texture, a normal or a colour changes: True joins
                boundary edges that lie on each other within rounding, a number
                those whose ends lie within that distance, False none. None:
                True for files, False for arrays and other libraries' meshes.
                Vertices keep their numbers: a repeated one has the answers of
                the place that it is part of.

        Raises:
            InvalidArgument: naming the first offender: a wrong shape or type, a
                coordinate that is not finite, a vertex that is not there, a
                malformed line of a file.
        """
        if isinstance(vertices, (str, os.PathLike)):
            if faces is not None:
                raise InvalidArgument("faces come from the file, too: "
                                      f"Mesh({os.fspath(vertices)!r})")
            path = pathlib.Path(vertices)
            with naming(path):
                mesh = _core.Mesh.read(path.read_bytes(), path.name,
                                       *inputs.to_welding(weld, True))
        else:
            arrays = (inputs.arrays_of(vertices) if faces is None else
                      (inputs.to_vertices(vertices), inputs.to_faces(faces)))
            mesh = _core.Mesh(*arrays, *inputs.to_welding(weld, False))
        self._backend: Backend = LocalBackend(mesh)
        self._kept_faces: Optional[NDArray[np.int64]] = None

        self._tell()

    def _tell(self: _Self) -> _Self:
        """Itself; warns whoever made it of what was joined, left out or guessed."""
        for note in self._backend.notes():
            warn(note)
        return self

    @classmethod
    def _on(cls: Type[_Self], backend: Backend) -> _Self:
        """A mesh whose questions another place answers."""
        mesh = cls.__new__(cls)
        mesh._backend = backend
        mesh._kept_faces = None
        return mesh

    def __repr__(self) -> str:
        return (f"<geodesic.Mesh: {self.n_vertices} vertices, {self.n_faces} "
                f"faces, {self._backend.where()}>")

    def __reduce__(self):
        # So that multiprocessing and joblib can send it.
        if not isinstance(self._backend, LocalBackend):
            raise TypeError("a mesh of a service cannot be pickled; the other "
                            "process can open it by its digest")
        return _restored, (type(self), np.array(self.vertices), self.faces,
                           self._backend.reading(), self.kept_faces)

    @property
    def n_vertices(self) -> int:
        """V."""
        return self._backend.vertex_count

    @property
    def n_faces(self) -> int:
        """F."""
        return self._backend.face_count

    @property
    def vertices(self) -> NDArray[np.float64]:
        """(V, 3), read only."""
        return self._vertices

    @property
    def faces(self) -> NDArray[np.int32]:
        """(F, 3), read only."""
        return self._faces

    @property
    def kept_faces(self) -> Optional[NDArray[np.int64]]:
        """Of a mesh made by without(): the numbers of its faces in the whole."""
        return self._kept_faces

    @property
    def digest(self) -> str:
        """The mesh's name on every server: a sha-256 of its arrays."""
        return self._digest

    def info(self) -> Dict[str, Any]:
        """What there is to know of the mesh: numbers of edges, boundary_loops,
        components, isolated_vertices, non_manifold_edges, degenerate_faces, its
        genus, bounding_box_min and _max, mean_edge_length, anisotropy; and what
        was joined or left out: notes, seam_edges, joined_vertices,
        left_out_faces, close_edges (not joined), close_edge_distance and
        touching_edges (which nothing joins)."""
        return self._backend.facts()

    def without(self: _Self, vertices: Optional[ArrayLike] = None,
                faces: Optional[ArrayLike] = None) -> _Self:
        """The mesh with a part left out, such as a cortex's medial wall.

            cortex = mesh.without(medial_wall)      # bool (V,), or numbers

        Args:
            vertices: numbers or a mask (V,); their faces go.
            faces: numbers or a mask (F,).

        Returns:
            A mesh whose vertices have the same numbers; those left out have no
            faces, so nothing leads there. Faces are numbered anew: `kept_faces`
            has their numbers in this mesh.
        """
        gone = _mask(faces, "faces", self.n_faces)
        masked = _mask(vertices, "vertices", self.n_vertices)
        joined = self._backend.reading()[0].astype(np.intp)
        np.logical_or.at(masked, joined[:, 1], masked[joined[:, 0]])
        gone |= np.any(masked[self.faces], axis=1)
        if gone.all():
            raise InvalidArgument("no face is left")
        rest = self._on(self._backend.with_faces(self.faces[~gone]))
        rest._kept_faces = np.flatnonzero(~gone)
        return rest

    def nearest_point(self, xyz: ArrayLike,
                      ) -> Union[FacePoint, List[FacePoint]]:
        """The place on the surface that is nearest to a point in space.

            d = mesh.distances(mesh.nearest_point([0.1, 2, 3]))

        Args:
            xyz: (3,), or (N, 3) for a list of N places. The first question sorts
                the faces; then each takes about a millisecond.
        """
        points = to_array(xyz, "xyz", np.float64)
        if points.shape[-1:] != (3,) or points.ndim > 2:
            raise InvalidArgument(
                f"points in space have shape {points.shape}, not (3,) or (N, 3)")
        if not np.all(np.isfinite(points)):
            raise InvalidArgument("a point in space is not finite")
        if points.ndim == 1:
            return self._point_finder.nearest(points)
        return [self._point_finder.nearest(point) for point in points]

    def positions(self, places: OneOrManyPlaces) -> NDArray[np.float64]:
        """Where places lie in space, (N, 3).

        Raises:
            InvalidArgument: naming a place that is not on the mesh.
        """
        return self._backend.positions(self._places(places, "places"))

    def plot(self, values: Optional[ArrayLike] = None, **options: Any) -> Any:
        """Draws the mesh, coloured by a value per vertex; see
        geodesic.plotting.plot."""
        from . import plotting
        return plotting.plot(self, values, **options)

    # A cached_property alone could be assigned: these have properties above.

    @functools.cached_property
    def _vertices(self) -> NDArray[np.float64]:
        return self._backend.vertices()

    @functools.cached_property
    def _faces(self) -> NDArray[np.int32]:
        faces = self._backend.faces()
        faces.setflags(write=False)
        return faces

    @functools.cached_property
    def _digest(self) -> str:
        return self._backend.digest()

    @functools.cached_property
    def _face_finder(self) -> FaceFinder:
        return FaceFinder(self.faces, joined_into(self._backend.reading(),
                                                  self.n_vertices))

    @functools.cached_property
    def _point_finder(self) -> PointFinder:
        return PointFinder(self.vertices, self.faces)

    def _sources(self, source, offsets):
        sources = to_sources(source, offsets, self.n_vertices)
        warn_of_isolated(sources, self._backend.isolated)
        return sources

    def _places(self, places, name):
        return to_places(() if places is None else places, name,
                         self.n_vertices)
