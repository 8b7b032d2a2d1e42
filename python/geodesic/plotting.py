"""Pictures of meshes and distances, by PyVista or matplotlib, and pages."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from .arguments import to_array
from .errors import InvalidArgument

if TYPE_CHECKING:
    from .triangle_mesh import TriangleMesh


def plot(mesh: "TriangleMesh", values: Optional[ArrayLike] = None, *,
         lines: Sequence[Any] = (), view: str = "xy",
         file: Optional[str] = None, title: Optional[str] = None,
         cmap: str = "viridis", backend: Optional[str] = None) -> Any:
    """Draws the mesh, coloured by a value per vertex.

    Args:
        values: (V,), such as distances; what is not finite is grey. Integers and
            bools are labels: each has one colour, a point that of the nearest
            corner of its face, without a mean; negative ones are grey.
        lines: Paths and Isolines to draw on it.
        view: which way to look: "xy" along the z axis, likewise "xz", "yz"; a
            "-" in front looks from the other side (matplotlib).
        file: write a picture there instead of showing it, or a page if it ends
            in .html, which shows no labels.
        cmap: of values that are no labels.
        backend: "pyvista", "matplotlib" or "page", which a notebook shows and
            which has no lines; otherwise the first of the two installed.

    Returns:
        PyVista's plotter, matplotlib's axes or a Page.
    """
    if values is not None:
        values = to_array(values, "values")
        if values.dtype.kind not in "iub":
            values = to_array(values, "values", np.float64)
        if values.shape != (mesh.n_vertices,):
            raise InvalidArgument(
                f"values have shape {values.shape}; one per vertex is "
                f"({mesh.n_vertices},)")
    if backend == "page" or backend is None and str(file).endswith(".html"):
        return _as_page(mesh, values, lines, file, title)
    if backend in (None, "pyvista"):
        try:
            import pyvista
        except ImportError:
            if backend == "pyvista":
                raise
        else:
            return _with_pyvista(pyvista, mesh, values, lines, file, title, cmap)
    elif backend != "matplotlib":
        raise InvalidArgument(
            f"backend is {backend!r}; there are 'pyvista', 'matplotlib' and "
            "'page'")
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise ImportError("mesh.plot draws with PyVista or matplotlib; neither "
                          "is installed") from None
    return _with_matplotlib(mesh, values, lines, view, file, title, cmap)


def _as_page(mesh, values, lines, file, title):
    from .page import page
    if len(lines):
        raise InvalidArgument("a page shows no lines: leave them out, or draw "
                              "with backend='matplotlib'")
    if _are_labels(values):
        raise InvalidArgument(
            "a page blends values between vertices, which labels (integers) must "
            "not be: draw with backend='matplotlib', or give floats")
    shown = page(mesh, np.zeros(mesh.n_vertices) if values is None else values,
                 title)
    if file is not None:
        shown.save(file)
    return shown


# Labels that a legend has room for.
_MOST_IN_LEGEND = 20
_GREY = 0.7


def _are_labels(values):
    return values is not None and values.dtype.kind in "iub"


def _colours_of(labels):
    """RGB, (N, 3): hues a golden section apart, so that the next numbers are
    unlike; in three strengths. Grey for negative ones."""
    steps = np.asarray(labels, np.float64)[:, None]
    hues = steps * 0.6180339887498949 + np.array([0, 1 / 3, 2 / 3])
    # One channel after the other is full, as around a wheel.
    wheel = np.clip(np.abs(hues % 1 * 6 - 3) - 1, 0, 1)
    colours = (0.95 - 0.12 * (steps % 3)) * (0.25 + 0.75 * wheel)
    return np.where(steps < 0, _GREY, colours)


def _legend_of(labels):
    """(text, colour) of each label; none of too many."""
    there = np.unique(labels)
    if len(there) > _MOST_IN_LEGEND:
        return []
    return list(zip(map(str, there.tolist()), _colours_of(there)))


def _cells(mesh, labels):
    """Triangles that have one label each, and which. A face whose corners have
    several is cut from its middle to those of its sides."""
    corners, of_corners = mesh.vertices[mesh.faces], labels[mesh.faces]
    mixed = np.any(of_corners != of_corners[:, :1], axis=1)
    cut, middle = corners[mixed], corners[mixed].mean(axis=1)
    triangles, of_triangles = [corners[~mixed]], [of_corners[~mixed, 0]]
    for i in range(3):
        for other in (i - 1, i - 2):
            half = (cut[:, i] + cut[:, other]) / 2
            triangles.append(np.stack([cut[:, i], half, middle], axis=1))
            of_triangles.append(of_corners[mixed, i])
    return np.concatenate(triangles), np.concatenate(of_triangles)


def _with_pyvista(pyvista, mesh, values, lines, file, title, cmap):
    plotter = pyvista.Plotter(off_screen=file is not None)
    points, triangles = np.array(mesh.vertices), mesh.faces
    if _are_labels(values):
        corners, labels = _cells(mesh, values)
        points = corners.reshape(-1, 3)
        triangles = np.arange(len(points)).reshape(-1, 3)
    faces = np.column_stack([np.full(len(triangles), 3), triangles])
    surface = pyvista.PolyData(points, faces.reshape(-1))
    if values is None:
        plotter.add_mesh(surface)
    elif _are_labels(values):
        # A colour for each face; there are three times as many points.
        plotter.add_mesh(surface, scalars=_colours_of(labels), rgb=True)
        legend = _legend_of(values)
        if legend:
            plotter.add_legend([[text, tuple(colour)] for text, colour in legend])
    else:
        colours = np.where(np.isfinite(values), values, np.nan)
        plotter.add_mesh(surface, scalars=colours, cmap=cmap,
                         scalar_bar_args={"title": title or "distance"})
    for line in lines:
        plotter.add_lines(_segments(line).reshape(-1, 3), color="black")
    if file is None:
        plotter.show()
    else:
        plotter.screenshot(file)
    return plotter


# How far lines are drawn in front of the surface that they run on, as a part of
# its extent: more than a face is deep, less than an ear is thick.
_LIFT = 0.01


def _segments(line):
    """The pieces of a line, (N, 2, 3)."""
    points = line.points
    if getattr(line, "closed", False):
        points = np.concatenate([points, points[:1]])
    return np.stack([points[:-1], points[1:]], axis=1)


def _with_matplotlib(mesh, values, lines, view, file, title, cmap):
    """Faces and lines from back to front, with a light from the viewer."""
    import matplotlib
    from matplotlib.cm import ScalarMappable
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

    axes_of = {"xy": (0, 1, 2, 1), "xz": (0, 2, 1, -1), "yz": (1, 2, 0, 1)}
    plane = view.lstrip("-")
    if plane not in axes_of:
        raise InvalidArgument(f"view is {view!r}; there are 'xy', 'xz', 'yz', "
                              "'-xy', '-xz' and '-yz'")
    right, up, depth, towards = axes_of[plane]
    side = -1.0 if view.startswith("-") else 1.0

    def seen(points):
        """As (right, up, towards the viewer)."""
        return points[..., [right, up, depth]] * [side, 1, side * towards]

    corners = mesh.vertices[mesh.faces]
    if _are_labels(values):
        corners, labels = _cells(mesh, values)
    corners = seen(corners)
    normals = np.cross(corners[:, 1] - corners[:, 0],
                       corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    light = np.abs(normals[:, 2]) / np.where(lengths > 0, lengths, 1)
    colours = np.full((len(corners), 3), _GREY)
    if file is None:
        from matplotlib import pyplot
        figure, axes = pyplot.subplots(figsize=(8, 6))
    else:  # needs no display, and leaves pyplot's as it is
        figure = Figure(figsize=(8, 6))
        axes = figure.subplots()
    if _are_labels(values):
        colours = _colours_of(labels)
        legend = [Patch(color=colour, label=text)
                  for text, colour in _legend_of(values)]
        if legend:
            axes.legend(handles=legend, loc="center left",
                        bbox_to_anchor=(1, 0.5))
    elif values is not None:
        of_faces = values[mesh.faces].mean(axis=1)
        shown = np.isfinite(of_faces)
        if shown.any():
            scale = Normalize(of_faces[shown].min(), of_faces[shown].max())
            colour_map = matplotlib.colormaps[cmap]
            colours[shown] = colour_map(scale(of_faces[shown]))[:, :3]
            figure.colorbar(ScalarMappable(scale, colour_map), ax=axes,
                            label="distance", shrink=0.8)
    colours *= (0.35 + 0.65 * light)[:, None]

    pieces = seen(np.concatenate([np.empty((0, 2, 3))] +
                                 [_segments(line) for line in lines]))
    # There and back again: a polygon without an inside.
    polygons = np.concatenate([corners, pieces[:, [0, 1, 0]]])
    colours = np.concatenate([colours, np.zeros((len(pieces), 3))])
    widths = np.repeat([0.2, 1.0], [len(corners), len(pieces)])
    extent = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    front = polygons[:, :, 2].mean(axis=1) + np.where(
        widths == 1.0, _LIFT * extent, 0)
    order = np.argsort(front)
    axes.add_collection(PolyCollection(
        polygons[order][:, :, :2], facecolors=colours[order],
        edgecolors=colours[order], linewidths=widths[order]))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_axis_off()
    if title:
        axes.set_title(title)
    if file is None:
        pyplot.show()
    else:
        figure.savefig(file, dpi=150, bbox_inches="tight")
    return axes
