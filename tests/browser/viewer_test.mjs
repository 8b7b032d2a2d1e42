// The page that `geodesic field -o field.html` writes, opened from the disk.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

import { isGrey, launch, openPage } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { TWO_SQUARES } from "./meshes.mjs";
import { startServer } from "./server.mjs";

test("a field in a file is shown without a server", async (t) => {
  const folder = temporaryFolder(t);
  const server = await startServer();
  writeFileSync(join(folder, "two.off"), TWO_SQUARES);
  execFileSync(process.env.GEODESIC, [
    "--server", `127.0.0.1:${server.grpcPort}`, "--quiet", "field", "two.off", "--source", "face:0@0.5,0,0.5",
    "-o", "field.html"], { cwd: folder });
  await server.stop();

  const browser = await launch();
  t.after(() => browser.close());
  const viewer = await openPage(browser, pathToFileURL(join(folder, "field.html")).href, { colorScheme: "dark" });
  const asked = [];
  viewer.page.on("request", (request) => asked.push(request.url()));
  await viewer.waitForText("#mesh-name", "two.off");
  const picture = await viewer.picture();
  const near = picture.at(await viewer.at(-0.52, 0.195));
  assert.ok(near[2] > near[1] + 20, `near the source is violet: ${near}`);
  assert.ok(isGrey(picture.at(await viewer.at(0.625, -0.3))), "what no path leads to is grey");
  await viewer.move(0.625, -0.3);
  await viewer.waitForText("#value", "not reached");

  // Inside these faces the source is in sight: what is told is the distance
  // itself, |x - source|. Moving by a pixel changes it by as much everywhere.
  const along = [];
  for (const x of [-0.44, -0.38, -0.32]) {
    await viewer.move(x, 0.2);
    await viewer.waitForText("#value", "vertex");
    along.push(Number((await viewer.text("#value")).match(/≈ ([\d.]+)/)[1]));
  }
  assert.ok(along[0] > 0 && along[1] > along[0]);
  const steps = [along[1] - along[0], along[2] - along[1]];
  // Perspective, and five digits.
  assert.ok(Math.abs(steps[0] - steps[1]) < 0.1 * steps[0], `${along}`);
  const vertex = (await viewer.text("#value")).match(/vertex (\d): ([\d.]+)/);
  assert.ok(Math.abs(Number(vertex[2]) - Math.SQRT1_2) < 1e-9, "corners are at sqrt(1/2)");
  // All of it is on the picture, however large the letters are.
  await viewer.page.evaluate(() => (document.documentElement.style.fontSize = "24px"));
  await viewer.page.setViewportSize({ width: 380, height: 640 });
  await viewer.move(-0.38, 0.2);
  const box = await viewer.page.locator("#value").boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 380, `from ${box.x}, ${box.width} wide`);
  assert.deepEqual(asked, []);
  assert.deepEqual(viewer.errors, []);
});
