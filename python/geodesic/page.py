"""A mesh and its values as a web page of one file, for notebooks and to send."""

from __future__ import annotations

import base64
import html
import json
import pathlib
from typing import TYPE_CHECKING, Optional, Union

import numpy as np
import numpy.typing as npt

from .errors import InvalidArgument

if TYPE_CHECKING:
    from .mesh import Mesh

# What the template has where the answer belongs (web/src/embedded.ts).
_PLACEHOLDER = '"GEODESIC_ANSWER"'
_HEIGHT = 480


class Page:
    """A page that turns and zooms a mesh and tells the value and the vertex under
    the cursor. It needs no server and no network; a notebook shows it."""

    def __init__(self, html_text: str):
        self.html = html_text

    def save(self, file: Union[str, "pathlib.Path"]) -> None:
        """Writes the page into a file, e.g. "distances.html"."""
        pathlib.Path(file).write_text(self.html, encoding="utf-8")

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" width="100%" '
                f'height="{_HEIGHT}" style="border: 0"></iframe>')


def page(mesh: "Mesh", values: npt.NDArray[np.float64],
         title: Optional[str]) -> Page:
    """REQUIRES: one value per vertex."""
    if (values < 0).any():
        raise InvalidArgument("a page shows values that are 0 or more; values "
                              f"have {values.min()}")
    positions = mesh.vertices
    center = np.zeros(3)
    if len(positions):
        center = positions.min(axis=0) / 2 + positions.max(axis=0) / 2
    answer = json.dumps({
        "name": title or "mesh",
        "digest": mesh.digest,
        "center": center.tolist(),
        "positions": _base64(positions - center, "<f4"),
        "faces": _base64(mesh.faces, "<u4"),
        "distances": _base64(np.where(np.isnan(values), np.inf, values), "<f8"),
        "sources": "",
    })
    template = pathlib.Path(__file__).with_name("viewer.html").read_text(
        encoding="utf-8")
    # A title may not end the element of HTML that holds it.
    return Page(template.replace(_PLACEHOLDER, answer.replace("<", "\\u003c"), 1))


def _base64(values: npt.NDArray, dtype: str) -> str:
    array = np.ascontiguousarray(values, dtype)
    return base64.b64encode(array.tobytes()).decode("ascii")
