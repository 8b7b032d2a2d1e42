"""The class that users see."""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import Any, Iterator, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .approximate import Approximate
from .arguments import to_array, to_count, to_radius, to_real, to_threads
from .asynchronous import AsyncMesh
from .backend import Options
from .errors import InvalidArgument
from .places import Curve, Places, Sources, SurfacePoint, to_sources
from .progress import ProgressOption, reporting
from .reach import warn, why_unreached
from .results import Field, Isoline, Line, LogMap, Path
from .triangle_mesh import OneOrManyPlaces, OneOrManySources, TriangleMesh

AnyAlgorithm = Union[str, Approximate, None]

# Values in rows of k for fewer targets: a slip of the pen must not take all memory.
_MOST_PADDED = 10**8


class Mesh(TriangleMesh):
    """A triangle mesh, and the questions about distances along its surface.

        mesh = geodesic.Mesh(V, F)
        d = mesh.distances(0)          # from vertex 0 to every vertex
        path = mesh.path(0, 99)        # the shortest path between two vertices

    Distances are exact up to rounding (relative error below 1e-10): they are
    lengths of shortest paths across the faces, not along the edges. They are
    +inf where no path leads; a source of no face reaches nothing else, which a
    GeodesicWarning tells. Numbers of vertices and faces start from 0 and are
    those of your arrays; lengths have the unit of your vertices.

    Any triangles will do: boundaries, holes, several pieces, isolated vertices,
    faces without area, edges of three faces, faces turned either way. A face that
    names a vertex twice is left out of the surface and keeps its number. What was
    joined, left out or guessed is told by a GeodesicWarning, and by info()["notes"].

    A source or target is a vertex number, an EdgePoint or a FacePoint; many of
    them are a list, an array of vertex numbers or a mask of the vertices. A
    source may also be a Curve. For points in space use nearest_point().

    What the methods have in common:
        radius: stop there; what lies beyond is +inf. Costs what lies within.
        offsets: one per source, >= 0, added to the distances from it.
        algorithm: a name from geodesic.algorithms(). All give the same
            distances. distances, field, matrix, nearest and pairs also take an
            approximate one (geodesic.Approximate), with no bound on its error.
        tolerance: the largest relative error that distances may have, from 1e-9
            to 0.1: less time on large meshes, and a bound that holds
            (Field.certified_error). 0: exact. An exact answer that is there
            already may come instead.
        threads: how many may work on the question; None for as many as this
            process may use. The answer has the same bits with any number, up to
            rounding for pairs and paths to few targets.
        progress: True for a bar of tqdm, or a function f(done, total) that is
            called some times a second; what it raises stops the computation.
    Ctrl-C stops them, too. A mesh never changes; use it in as many threads as
    you like.
    """

    def distances(self, source: OneOrManySources, *,
                  targets: Optional[OneOrManyPlaces] = None,
                  radius: Optional[float] = None,
                  offsets: Optional[ArrayLike] = None,
                  algorithm: AnyAlgorithm = None,
                  tolerance: float = 0, threads: Optional[int] = 1,
                  progress: ProgressOption = None) -> NDArray[np.float64]:
        """The distance from the nearest source to every vertex.

            d = mesh.distances(0)
            d = mesh.distances([0, 5, 9], radius=20)
            d = mesh.distances(0, targets=[7, 99])     # just these two
            d = mesh.distances(0, tolerance=1e-3)      # within 0.1 %

        Returns:
            (V,); with targets (T,), one per target, at the cost of a search that
            ends with the last of them.
        """
        points, sources = self._places(targets, "targets"), self._sources(
            source, offsets)
        if targets is not None and len(points) == 0:
            return np.empty(0)
        options = Options(algorithm, to_threads(threads), tolerance=tolerance)
        options.check_places(points, "targets")
        stops = targets is not None and options.approximate is None
        with reporting(progress, "vertices") as options.progress:
            field = self._backend.field(
                sources, points, to_radius(radius),
                len(points) if stops else None, False, False, False, options)
        if targets is None:
            return field.distances
        assert field.target_distances is not None
        return field.target_distances

    def field(self, source: OneOrManySources, *, labels: bool = False,
              gradients: bool = False, certified_errors: bool = False,
              targets: Optional[OneOrManyPlaces] = None,
              stop_after_targets: Optional[int] = None,
              radius: Optional[float] = None,
              offsets: Optional[ArrayLike] = None,
              algorithm: AnyAlgorithm = None, tolerance: float = 0,
              threads: Optional[int] = 1,
              progress: ProgressOption = None) -> Field:
        """Distances, and what else one search knows.

            field = mesh.field(sources, labels=True, gradients=True)
            field.distances, field.labels, field.gradients

        Args:
            labels: also the number of the nearest source of every vertex.
            gradients: also the direction in which the distance grows.
            certified_errors: also by how much the distance of every vertex may
                be off, with a tolerance.
            targets: places whose distances are wanted beside the vertices'.
            stop_after_targets: stop when so many targets are known.
        """
        points, sources = self._places(targets, "targets"), self._sources(
            source, offsets)
        if stop_after_targets is not None:
            stop_after_targets = to_count(stop_after_targets,
                                          "stop_after_targets")
        options = Options(algorithm, to_threads(threads), tolerance=tolerance)
        if options.tolerance != 0 and (labels or gradients):
            raise InvalidArgument(
                f"{'labels' if labels else 'gradients'}: a field within a "
                "tolerance keeps no paths; leave the tolerance out")
        for is_asked, what in ((labels, "labels are"),
                               (gradients, "gradients are"),
                               (certified_errors, "certified errors are"),
                               (stop_after_targets, "fields that stop are")):
            if is_asked:
                options.exact_alone(what)
        options.check_places(points, "targets")
        with reporting(progress, "vertices") as options.progress:
            field = self._backend.field(
                sources, points, to_radius(radius), stop_after_targets, labels,
                gradients, certified_errors, options)
        return (dataclasses.replace(field, target_distances=None)
                if targets is None else field)

    def labels(self, sources: OneOrManySources, **options: Any,
               ) -> NDArray[np.int32]:
        """The number of the nearest source of every vertex, (V,): its Voronoi
        cell. -1 where no path leads; at a tie one of the nearest. Options as in
        field()."""
        labels = self.field(sources, labels=True, **options).labels
        assert labels is not None
        return labels

    def gradients(self, source: OneOrManySources, **options: Any,
                  ) -> NDArray[np.float64]:
        """The unit vector in which the distance grows at every vertex, (V, 3).
        Options as in field()."""
        gradients = self.field(source, gradients=True, **options).gradients
        assert gradients is not None
        return gradients

    def progressive(self, source: OneOrManySources, *,
                    interval: float = 0.1, radius: Optional[float] = None,
                    offsets: Optional[ArrayLike] = None,
                    algorithm: Optional[str] = None,
                    threads: Optional[int] = 1,
                    ) -> Iterator[Tuple[NDArray[np.int64], NDArray[np.float64]]]:
        """Distances as they become final, in order of distance.

            for vertices, distances in mesh.progressive(0):
                d[vertices] = distances

        Leave the loop when you have seen enough; what came is final. Vertices
        that never come cannot be reached.

        Args:
            interval: seconds between two parts, about.
        """
        interval = to_real(interval, "interval")
        if not interval >= 0:
            raise InvalidArgument(f"interval is {interval}; seconds are wanted")
        return self._backend.progressive(
            self._sources(source, offsets), to_radius(radius), interval,
            Options(algorithm, to_threads(threads)).exact_alone(
                "progressive fields are"))

    def distance(self, source: SurfacePoint, target: SurfacePoint, *,
                 tolerance: float = 0) -> float:
        """The distance between two places, by a search that is directed at the
        second: a small part of a field's cost. A tolerance as in pairs()."""
        distance = float(self.pairs([source], [target], tolerance=tolerance,
                                    threads=1)[0])
        if distance == math.inf:
            why = self._why_unreached(
                to_sources(source, None, self.n_vertices),
                self._places(target, "targets"), math.inf)
            warn(f"the target cannot be reached: {why}")
        return distance

    def pairs(self, sources: Union[OneOrManyPlaces, Sequence[Sequence[int]]],
              targets: Optional[OneOrManyPlaces] = None, *,
              algorithm: AnyAlgorithm = None, tolerance: float = 0,
              threads: Optional[int] = None,
              progress: ProgressOption = None) -> NDArray[np.float64]:
        """The distance from each source to the target of the same number.

            d = mesh.pairs([0, 1, 2], [7, 8, 9])  # places of any kind
            d = mesh.pairs(vertex_pairs)          # integers (N, 2)

        Args:
            algorithm: an approximate one, for vertices; None for exact distances.
            tolerance: the largest relative error, from 1e-9 to 0.1, or 0.
                Searches then end as soon as they have a path that is longer
                than the shortest by this part at the most.

        Returns:
            (N,). Up to rounding the same as those of distances().
        """
        if targets is None:
            both = to_array(sources, "pairs")
            if both.ndim != 2 or both.shape[1] != 2:
                raise InvalidArgument(
                    f"pairs have shape {both.shape}, not (N, 2)")
            if both.dtype.kind not in "iu":
                raise InvalidArgument(
                    f"pairs are of type {both.dtype}, but (N, 2) are vertex "
                    "numbers; other places come as pairs(sources, targets)")
            sources, targets = both[:, 0], both[:, 1]
        starts = self._places(sources, "sources")
        ends = self._places(targets, "targets")
        if len(starts) != len(ends):
            raise InvalidArgument(f"there are {len(starts)} sources, but "
                                  f"{len(ends)} targets: pairs need as many")
        if len(starts) == 0:
            return np.empty(0)
        options = Options(algorithm, to_threads(threads), tolerance=tolerance)
        if options.exact is not None:
            raise InvalidArgument(
                f"algorithm is {options.exact!r}, but exact pairs are searched "
                "for by the default one; name none, or an approximate one")
        options.check_places(starts, "sources")
        options.check_places(ends, "targets")
        with reporting(progress, "sources") as options.progress:
            return self._backend.pairs(starts, ends, options)

    def path(self, source: OneOrManySources, target: SurfacePoint,
             **options: Any) -> Path:
        """A shortest path from the nearest source to a place.

            path = mesh.path(0, 99)
            path.points, path.length

        Options as in paths().
        """
        points = self._places(target, "targets")
        if len(points) != 1:
            raise InvalidArgument(
                f"there are {len(points)} targets; paths() takes many")
        return self.paths(source, points, **options)[0]

    def paths(self, source: OneOrManySources, targets: OneOrManyPlaces, *,
              radius: Optional[float] = None,
              offsets: Optional[ArrayLike] = None,
              algorithm: Optional[str] = None, threads: Optional[int] = 1,
              progress: ProgressOption = None) -> List[Path]:
        """Shortest paths from the nearest source to each target, by one search
        that ends with the last of them. Path.unreached says why one has no
        points; of the first such one a GeodesicWarning tells."""
        points, sources = self._places(targets, "targets"), self._sources(
            source, offsets)
        if len(points) == 0:
            return []
        with reporting(progress, "vertices") as report:
            paths = self._paths(
                sources, points, to_radius(radius),
                Options(algorithm, to_threads(threads),
                        report).exact_alone("paths are"))
        for i, path in enumerate(paths):
            if path.unreached is not None:
                warn(f"targets[{i}] cannot be reached: {path.unreached}")
                break
        return paths

    def _paths(self, sources: Sources, targets: Places, radius: float,
               options: Options) -> List[Path]:
        return [
            Path(self, a.places, a.points, a.distance, a.length, a.source,
                 functools.partial(self._why_unreached, sources,
                                   targets[i:i + 1], radius))
            for i, a in enumerate(
                self._backend.paths(sources, targets, radius, options))
        ]

    def _why_unreached(self, sources: Sources, target: Places,
                       radius: float) -> str:
        return why_unreached(
            self.vertices, self.faces, self._backend.reading(), sources, target,
            radius)

    def isolines(self, source: OneOrManySources, *,
                 levels: Optional[ArrayLike] = None,
                 count: Optional[int] = None,
                 chord_error: Optional[float] = None,
                 offsets: Optional[ArrayLike] = None,
                 algorithm: Optional[str] = None, tolerance: float = 0,
                 threads: Optional[int] = 1,
                 progress: ProgressOption = None) -> List[Isoline]:
        """Lines of equal distance, as ordered polylines on the surface.

        Args:
            levels: the distances, > 0.
            count: instead of levels: so many, 10 if neither is given, evenly
                spread up to the largest distance.
            chord_error: no chord between two points is farther from the line
                than this, > 0; +inf: points on edges alone, but for lines
                inside a face. None: a thousandth of each level.

        Returns:
            In order of level. A level may have many lines.
        """
        sources = self._sources(source, offsets)
        options = Options(
            algorithm, to_threads(threads),
            tolerance=tolerance).exact_alone("isolines are")
        if levels is None:
            count = 10 if count is None else to_count(count, "count")
            distances = self._backend.field(
                sources, self._places(None, "targets"), math.inf, None, False,
                False, False, options).distances
            largest = distances[np.isfinite(distances)].max(initial=0)
            if largest == 0:
                return []
            levels = largest * np.arange(1, count + 1) / (count + 1)
        elif count is not None:
            raise InvalidArgument("levels and count are given; they say the same "
                                  "thing")
        wanted = to_array(levels, "levels", np.float64).reshape(-1).tolist()
        error = 0.0
        if chord_error is not None:
            error = to_real(chord_error, "chord_error")
            if not error > 0:
                raise InvalidArgument(f"chord_error is {error}, which is not > 0")
        with reporting(progress, "vertices") as options.progress:
            answers = self._backend.isolines(sources, wanted, error,
                                             options)
        return [
            Isoline(self, a.places, a.points, a.level, a.closed)
            for a in answers
        ]

    def matrix(self, sources: Optional[OneOrManySources] = None,
               targets: Optional[OneOrManyPlaces] = None, *,
               radius: Optional[float] = None, dtype: Any = np.float64,
               out: Optional[np.ndarray] = None,
               offsets: Optional[ArrayLike] = None,
               algorithm: AnyAlgorithm = None, tolerance: float = 0,
               threads: Optional[int] = None,
               progress: ProgressOption = None) -> Any:
        """The distance from every source to every target.

            D = mesh.matrix([0, 5], [7, 8, 9])           # (2, 3)
            D = mesh.matrix(radius=10, progress=True)    # all vertices, sparse

        Args:
            sources: None for every vertex. Each has a row of its own.
            targets: None for every vertex.
            radius: makes the matrix sparse: a scipy.sparse.csr_matrix of the
                distances up to there, diagonal zeros included.
            dtype: float64 or float32 (the nearest to the exact values).
            out: a C-contiguous array to fill, such as a np.memmap.
            threads: rows at a time; None for as many as this process may use.

        Returns:
            (S, T) dense, or a csr_matrix where a radius is given.
        """
        try:
            dtype = np.dtype(dtype)
        except TypeError:
            raise InvalidArgument(f"dtype is {dtype!r}, which is no type"
                                  ) from None
        if dtype not in (np.float64, np.float32):
            raise InvalidArgument(f"dtype is {dtype}, not float64 or float32")
        if sources is None:  # nobody named those of no face
            rows = to_sources(np.arange(self.n_vertices), offsets,
                              self.n_vertices)
        else:
            rows = self._sources(sources, offsets)
        points = None if targets is None else self._places(targets, "targets")
        if points is not None and len(points) == 0:
            raise InvalidArgument("there is no target")
        columns = self.n_vertices if points is None else len(points)
        with reporting(progress, "rows") as report:
            options = Options(algorithm, to_threads(threads), report, tolerance)
            if points is not None:
                options.check_places(points, "targets")
            if radius is not None and out is None:
                return self._sparse(rows, points, columns, to_radius(radius),
                                    dtype, options)
            if out is None:
                out = np.empty((len(rows), columns), dtype)
            if not isinstance(out, np.ndarray):
                raise InvalidArgument(
                    f"out is of type {type(out).__name__}, not a numpy array")
            if (out.shape != (len(rows), columns) or
                    out.dtype not in (np.float64, np.float32) or
                    not out.flags.c_contiguous or not out.flags.writeable):
                raise InvalidArgument(
                    f"out has shape {out.shape} and type {out.dtype}; it must be "
                    f"a writeable array of shape ({len(rows)}, {columns}) in C "
                    "order, of float64 or float32")
            self._backend.fill_matrix(rows, points, to_radius(radius), out,
                                      options)
            return out

    def _sparse(self, rows, points, columns, radius, dtype, options):
        try:
            import scipy.sparse
        except ImportError:
            raise ImportError(
                "matrix(radius=...) makes a scipy.sparse.csr_matrix, but scipy "
                "is not installed; matrix(radius=..., out=array) fills a dense "
                "array") from None
        counts, indices, values = self._backend.sparse_matrix(
            rows, points, radius, None, options)
        starts = np.concatenate([[0], np.cumsum(counts)])
        return scipy.sparse.csr_matrix(
            (values.astype(dtype, copy=False), indices, starts),
            shape=(len(rows), columns))

    def nearest(self, sources: OneOrManySources, targets: OneOrManyPlaces,
                k: int = 1, *, radius: Optional[float] = None,
                offsets: Optional[ArrayLike] = None,
                algorithm: AnyAlgorithm = None, tolerance: float = 0,
                threads: Optional[int] = None,
                progress: ProgressOption = None,
                ) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Of each source the k nearest targets, in order of distance.

        Returns:
            (numbers, distances), each (S, k). Numbers are positions in targets;
            -1, and +inf, where there are fewer.
        """
        rows = self._sources(sources, offsets)
        points = self._places(targets, "targets")
        if len(points) == 0:
            raise InvalidArgument("there is no target")
        k = to_count(k, "k", "ask for at least one target")
        if k > len(points) and k * len(rows) > _MOST_PADDED:
            raise InvalidArgument(f"k is {k}, but there are only {len(points)} "
                                  "targets")
        options = Options(algorithm, to_threads(threads), tolerance=tolerance)
        options.check_places(points, "targets")
        with reporting(progress, "rows") as options.progress:
            counts, found, values = self._backend.sparse_matrix(
                rows, points, to_radius(radius), k, options)
        is_there = np.arange(k) < counts[:, np.newaxis]
        numbers = np.full(is_there.shape, -1, np.int64)
        distances = np.full(is_there.shape, np.inf)
        numbers[is_there], distances[is_there] = found, values
        return numbers, distances

    def samples(self, count: int, source: OneOrManySources, *,
                algorithm: Optional[str] = None, tolerance: float = 0,
                threads: Optional[int] = 1,
                progress: ProgressOption = None,
                ) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Farthest-point samples: vertices, each the farthest from the source
        and from all samples before it. The source is not among them.

        Returns:
            (vertices, distances), each (count,); the distances fall, and the
            first on a piece without a source is +inf. Fewer, with a
            GeodesicWarning, where every vertex of a face is at distance 0.
        """
        count = to_count(count, "count")
        with reporting(progress, "vertices") as report:
            vertices, distances = self._backend.samples(
                self._sources(source, None), count,
                Options(algorithm, to_threads(threads), report,
                        tolerance).exact_alone("samples are"))
        if len(vertices) < count:
            warn(f"{count} samples were asked for and {len(vertices)} are there: "
                 "then every vertex of a face is a source or a sample, or in the "
                 "same place as one")
        return vertices, distances

    def log_map(self, source: SurfacePoint, *,
                radius: Optional[float] = None,
                algorithm: Optional[str] = None, threads: Optional[int] = 1,
                progress: ProgressOption = None) -> LogMap:
        """The surface around a source laid into the plane, by direction and
        distance. The surface around it must be a disk or half-disk."""
        with reporting(progress, "vertices") as report:
            coordinates, zero_direction = self._backend.log_map(
                self._sources(source, None), to_radius(radius),
                Options(algorithm, to_threads(threads),
                        report).exact_alone("log maps are"))
        return LogMap(coordinates, zero_direction)

    def trace(self, source: OneOrManyPlaces, *,
              direction: Optional[ArrayLike] = None,
              angle: Optional[ArrayLike] = None,
              towards: Optional[OneOrManyPlaces] = None,
              length: ArrayLike = math.inf, threads: Optional[int] = 1,
              progress: ProgressOption = None) -> Union[Line, List[Line]]:
        """Lines that run straight on: straight across edges when the faces on both
        sides are laid into one plane, past vertices with equal angles on their left
        and right.

            line = mesh.trace(0, direction=[1, 0, 0], length=0.1)
            star = mesh.trace(0, angle=np.linspace(0, 6.28, 100), length=0.1)

        Args:
            source: where lines start, around which the surface is a disk or
                half-disk.
            direction: (3,) or (N, 3): vectors in space, of any length; a line starts
                in the direction of the surface that makes the least angle with its
                vector.
            angle: or angles in the log map of the source, one or (N,).
            towards: or places that such vectors lead to.
            length: where lines end, unless a boundary comes first; one or (N,).

        Returns:
            A Line; a list of them if there are several sources, or if directions
            or lengths are arrays. Of each there is one for all lines, or one for
            each.
        """
        sources = self._places(source, "source")
        given = [x is not None for x in (direction, angle, towards)]
        if sum(given) != 1:
            raise InvalidArgument("name one of direction, angle and towards")
        if angle is not None:
            ways = to_array(angle, "angle", np.float64)
            is_one = ways.ndim == 0
            ways = ways.reshape(-1) if is_one else ways
        elif direction is not None:
            ways = to_array(direction, "direction", np.float64)
            is_one = ways.ndim == 1
            ways = ways.reshape(1, -1) if is_one else ways
        else:
            ends = self._places(towards, "towards")
            is_one = len(ends) == 1 and not isinstance(towards, (list, np.ndarray))
            ways = (self._backend.positions(ends) -
                    self._backend.positions(sources))
        if ways.shape[1:] not in ((), (3,)) or ways.ndim == 0:
            raise InvalidArgument(
                f"directions have shape {ways.shape}, not (N, 3), or (N,) as angles")
        lengths = to_array(length, "length", np.float64)
        is_one = is_one and lengths.ndim == 0 and len(sources) == 1
        with reporting(progress, "lines") as report:
            answers = self._backend.trace(
                sources, ways, lengths.reshape(-1),
                Options(None, to_threads(threads), report))
        lines = [Line(self, a.places, a.points, a.length, a.end) for a in answers]
        return lines[0] if is_one else lines

    def curve(self, places: OneOrManyPlaces, *, closed: bool = False) -> Curve:
        """A curve through places that need not share faces: shortest paths from
        each to the next. Curve.length and Curve.added tell what came of them.

            d = mesh.distances(mesh.curve([0, 99, 7]))
            d = mesh.distances(mesh.curve(mesh.nearest_point(drawn_in_space)))
        """
        stops = list(self._places(places, "places"))
        if len(stops) < 2:
            raise InvalidArgument("a curve has at least two places")
        if closed:
            stops.append(stops[0])
        points: List[SurfacePoint] = stops[:1]
        length = 0.0
        for i, (start, end) in enumerate(zip(stops, stops[1:])):
            [path] = self._paths(self._sources(start, None),
                                 self._places(end, "places"), math.inf, Options())
            if path.unreached is not None:
                raise InvalidArgument(f"no path leads from places[{i}] to the "
                                      f"next: {path.unreached}")
            points += path.places[1:]
            length += path.length
        return Curve(points, length, len(points) - len(stops))

    @property
    def aio(self) -> "AsyncMesh":
        """The same methods to await: d = await mesh.aio.distances(0)."""
        return AsyncMesh(self)
