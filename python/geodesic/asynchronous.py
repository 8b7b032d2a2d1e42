"""Questions that are awaited."""

from __future__ import annotations

import asyncio
import inspect
import threading
from typing import TYPE_CHECKING, Any, AsyncIterator, Callable, Optional, Tuple

import numpy as np

from .errors import Cancelled

if TYPE_CHECKING:
    from .mesh import Mesh


class AsyncMesh:
    """A mesh whose methods are coroutines; geodesic.Mesh documents them.

        d = await mesh.aio.distances(0)
        async for vertices, distances in mesh.aio.progressive(0): ...

    Each question runs in a thread, beside the event loop. Cancelling its task
    stops the computation, in this process or at the service. `progress` is
    called from that thread.
    """

    def __init__(self, mesh: "Mesh") -> None:
        self._mesh = mesh

    def __repr__(self) -> str:
        return f"{self._mesh!r}.aio"

    def __getattr__(self, name: str) -> Callable[..., Any]:
        method = getattr(self._mesh, name)
        if name.startswith("_") or not inspect.ismethod(method):
            raise AttributeError(
                f"{name!r} is nothing to await: ask the mesh itself")

        async def ask(*arguments: Any, progress: Any = None,
                      **options: Any) -> Any:
            parameters = inspect.signature(method).parameters
            if "progress" not in parameters and "options" not in parameters:
                return await asyncio.to_thread(method, *arguments, **options)
            is_cancelled = threading.Event()

            def report(done: int, total: int) -> None:
                if is_cancelled.is_set():
                    raise Cancelled("the task was cancelled")
                if progress is not None:
                    progress(done, total)

            try:
                return await asyncio.to_thread(method, *arguments,
                                               progress=report, **options)
            except asyncio.CancelledError:
                is_cancelled.set()
                raise

        return ask

    async def progressive(self, *arguments: Any, **options: Any,
                          ) -> AsyncIterator[Tuple[np.ndarray, np.ndarray]]:
        parts = self._mesh.progressive(*arguments, **options)

        def take() -> Optional[Tuple[np.ndarray, np.ndarray]]:
            return next(parts, None)

        while (part := await asyncio.to_thread(take)) is not None:
            yield part
