"""What ``progress=`` takes."""

from __future__ import annotations

import contextlib
from typing import Callable, Iterator, Optional, Union

from .errors import InvalidArgument

# Called as progress(done, total) now and then, from the thread that asked, and
# with done == total at the end. What it raises stops the computation.
ProgressCallback = Callable[[int, int], object]
ProgressOption = Union[None, bool, ProgressCallback]


@contextlib.contextmanager
def reporting(progress: ProgressOption, unit: str,
              ) -> Iterator[Optional[ProgressCallback]]:
    """A callback for the option: itself, or a bar of tqdm for True."""
    if progress is None or progress is False:
        yield None
        return
    if callable(progress):
        report = progress
        last = (0, 0)

        def tell(done: int, total: int) -> None:
            nonlocal last
            last = (done, total)
            report(done, total)

        yield tell
        done, total = last
        if done < total:
            report(total, total)
        return
    if progress is not True:
        raise InvalidArgument(f"progress is {progress!r}; it may be True, or a "
                              "function f(done, total)")
    try:
        import tqdm.auto
    except ImportError:
        raise ImportError("progress=True draws its bar with tqdm, which is not "
                          "installed; progress may also be a function "
                          "f(done, total)") from None
    with tqdm.auto.tqdm(unit=unit, unit_scale=True) as bar:

        def show(done: int, total: int) -> None:
            bar.total = total
            bar.update(done - bar.n)

        yield show
        if bar.total is not None:
            bar.update(bar.total - bar.n)
