// How long it takes from a move of the cursor to the drawn path, and from a click
// to the whole field, which may be within 0.1 % until it is exact. Printed, not
// asserted: it depends on the machine.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { loadavg } from "node:os";
import { basename, join } from "node:path";
import { test } from "node:test";

import { launch, openPage } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { outsideMesh, roughRadius, sphereObj } from "./meshes.mjs";
import { startServer } from "./server.mjs";

const MOVES = 150;
const MESHES = ["real/horse_be.ply", "real/terrain_n44w072_500k.ply"];

async function measure(t, name, open) {
  const server = await startServer();
  t.after(() => server.stop());
  const browser = await launch();
  t.after(() => browser.close());
  const viewer = await openPage(browser, server.url);
  await open(viewer);
  await viewer.shown(name);
  await viewer.settled();
  t.diagnostic(`${name}: ${loadavg()[0].toFixed(1)} processes ran in the last minute`);
  const start = performance.now();
  await viewer.click(0, 0);
  await viewer.swept();
  t.diagnostic(`${name}: ${(performance.now() - start).toFixed(0)} ms from the click to the whole field, swept`);
  await viewer.solved();
  t.diagnostic(`${name}: ${(performance.now() - start).toFixed(0)} ms until it is exact`);
  await viewer.settled();
  t.diagnostic(`${name}: ${(performance.now() - start).toFixed(0)} ms until all faces are drawn, ` +
    `solved in ${await viewer.text("#figures dd:last-of-type")}`);
  for (let i = 0; i < MOVES; i++) {
    await viewer.move(-0.3 * Math.sin(i / 25), 0.2 * Math.sin(i / 9));
    await viewer.page.waitForTimeout(33);
  }
  const times = await viewer.page.evaluate(() =>
    performance.getEntriesByName("path under the cursor").map((entry) => entry.duration));
  times.sort((a, b) => a - b);
  const quantile = (q) => times[Math.min(Math.floor(q * times.length), times.length - 1)].toFixed(1);
  assert.ok(times.length > 0, "paths were drawn");
  t.diagnostic(`${name}: ${MOVES} moves of the cursor, ${times.length} paths drawn, ` +
    `from event to line p50 ${quantile(0.5)} ms, p99 ${quantile(0.99)} ms`);
}

test("a sphere of 80,000 faces", (t) => measure(t, "sphere.obj", (viewer) => viewer.drop("sphere.obj", sphereObj(100))));

// A smooth one is the hardest for the solver, which cuts no window short there.
for (const [kind, radius] of [["smooth", undefined], ["rough", roughRadius]]) {
  test(`a ${kind} sphere of a million faces`, (t) => {
    const folder = temporaryFolder(t);
    const path = join(folder, `${kind}.obj`);
    writeFileSync(path, sphereObj(354, radius));
    return measure(t, `${kind}.obj`, (viewer) => viewer.choose(path));
  });
}

for (const mesh of MESHES) {
  const path = outsideMesh(mesh);
  test(basename(mesh), { skip: path ? false : "the mesh is not here" }, (t) =>
    measure(t, basename(mesh), (viewer) => viewer.choose(path)));
}
