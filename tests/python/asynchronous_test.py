"""Questions that are awaited."""

import asyncio
import threading
import unittest

import meshes
import numpy as np

import geodesic


class AsynchronousTest(unittest.IsolatedAsyncioTestCase):

    async def test_same_answers(self):
        mesh = geodesic.Mesh(*meshes.terrain(20))
        d, path, place = await asyncio.gather(
            mesh.aio.distances(3), mesh.aio.path(3, 99),
            mesh.aio.nearest_point([0.5, 0.5, 0]))
        np.testing.assert_array_equal(d, mesh.distances(3))
        np.testing.assert_array_equal(path.points, mesh.path(3, 99).points)
        self.assertEqual(place, mesh.nearest_point([0.5, 0.5, 0]))
        parts = [v async for v, _ in mesh.aio.progressive(3, interval=0)]
        self.assertEqual(sum(len(part) for part in parts), mesh.n_vertices)

    async def test_cancelling_stops_the_computation(self):
        mesh = geodesic.Mesh(*meshes.terrain(300))
        runs = threading.Event()
        last_call = []
        loop = asyncio.get_running_loop()
        started = asyncio.Event()

        def progress(done, total):
            last_call.append(done)
            if not runs.is_set():
                runs.set()
                loop.call_soon_threadsafe(started.set)

        before = set(threading.enumerate())
        # Takes minutes, so whether it was stopped shows in the thread's end.
        task = asyncio.create_task(
            mesh.aio.distances(0, algorithm="ch", progress=progress))
        await started.wait()
        task.cancel()
        with self.assertRaises(asyncio.CancelledError):
            await task
        # The loop's threads end when what they run does.
        await loop.shutdown_default_executor()
        self.assertEqual(set(threading.enumerate()), before)

    async def test_errors(self):
        mesh = geodesic.Mesh(*meshes.octahedron())
        with self.assertRaises(geodesic.InvalidArgument):
            await mesh.aio.distances(6)
        with self.assertRaises(AttributeError):
            mesh.aio.vertices
        with self.assertRaisesRegex(TypeError, "source"):
            await mesh.aio.distances()
        with self.assertRaisesRegex(TypeError, "source"):
            async for _ in mesh.aio.progressive():
                pass


if __name__ == "__main__":
    unittest.main()
