"""Approximate algorithms by name, with their parameters."""

from __future__ import annotations

import dataclasses
import math
from typing import Optional, Tuple

from . import _core
from .arguments import to_count, to_real
from .errors import InvalidArgument

# Each, and the parameter that it takes.
_PARAMETERS = {name: parameter for name, parameter, _ in _core.METHODS}
NAMES: Tuple[str, ...] = tuple(_PARAMETERS)
_DEFAULTS = {parameter: value for _, parameter, value in _core.METHODS if parameter}


@dataclasses.dataclass(frozen=True)
class Approximate:
    """An approximate algorithm: fast, and with no bound on its error.

        d = mesh.distances(0, algorithm="svg")
        d = mesh.distances(0, algorithm=geodesic.Approximate("svg", neighbours=100))

    distances, field, matrix, nearest and pairs take one, with vertices as
    targets. docs/questions.md says which to choose.

    Attributes:
        name: "fmm", "fmm-untidy" (fast marching), "heat", "svg" (the saddle
            vertex graph) or "gtu" (geodesic triangle unfolding).
        neighbours: of svg: how many vertices around each one are looked at, from
            1 to 10000; None for 50.
        lambda_: of heat: it spreads for lambda times the square of the mean edge
            length; None for 1.
        samples: of gtu: how many vertices' exact fields are kept, from 1 to
            20000; None for 200.
    """

    name: str
    neighbours: Optional[int] = None
    lambda_: Optional[float] = None
    samples: Optional[int] = None

    def __post_init__(self) -> None:
        if self.name not in _PARAMETERS:
            raise InvalidArgument(
                f"{self.name!r} is no approximate algorithm; these are: " +
                ", ".join(NAMES))
        for parameter in _DEFAULTS:
            value = getattr(self, parameter)
            if value is None:
                continue
            if _PARAMETERS[self.name] != parameter:
                raise InvalidArgument(
                    f"{parameter} is no parameter of {self.name}")
            if parameter != "lambda_":
                to_count(value, parameter)
            elif not 0 < to_real(value, parameter) < math.inf:
                raise InvalidArgument(f"lambda_ is {value}, not above 0")

    def complete(self) -> "Approximate":
        """The same, with its parameter's default where nothing was said."""
        parameter = _PARAMETERS[self.name]
        if parameter is None or getattr(self, parameter) is not None:
            return self
        return dataclasses.replace(self, **{parameter: _DEFAULTS[parameter]})
