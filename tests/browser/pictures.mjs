// Makes the page's pictures for README: the Horse, a click, the front, and the
// path under the cursor. Reads HORSE, writes into PICTURES.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { launch, openPage } from "./browser.mjs";
import { need, startServer } from "./server.mjs";

const FRAME_MS = 80;
const SWEEP_FRAMES = 10;
const MOVE_FRAMES = 60;
// The nose, and where the cursor goes: between these points, smoothly.
const SOURCE = [-0.9, 0.375];
const TRACK = [
  [-0.73, 0.56], [-0.46, 0.6], [-0.17, 0.21], [0.21, 0.22], [0.54, 0.17], [0.62, -0.04],
  [0.63, -0.33], [0.55, -0.15], [0.2, 0], [-0.2, 0.1], [-0.22, -0.17], [-0.25, -0.29],
];

const [horse] = need("HORSE");
const [folder] = need("PICTURES");
const frames = mkdtempSync(join(tmpdir(), "frames-"));
const server = await startServer();
const browser = await launch();
try {
  const viewer = await openPage(browser, server.url, { viewport: { width: 1060, height: 480 } });
  await viewer.choose(horse);
  await viewer.shown("horse-input.ply");
  const stage = viewer.page.locator("#stage");
  const shots = [];
  const shoot = async (milliseconds) => {
    const path = join(frames, `${shots.length}.png`);
    await stage.screenshot({ path });
    shots.push("-d", String(milliseconds), path);
  };

  await viewer.page.clock.install();
  await viewer.page.clock.pauseAt(Date.now() + 60_000);
  await viewer.click(...SOURCE);
  await viewer.page.waitForSelector("#figures dt", { state: "attached" });
  for (let i = 0; i < SWEEP_FRAMES; i++) {
    await viewer.page.clock.runFor(FRAME_MS);
    await shoot(FRAME_MS);
  }
  await viewer.page.clock.resume();
  await viewer.solved();
  for (let i = 0; i <= MOVE_FRAMES; i++) {
    await viewer.move(...along(i / MOVE_FRAMES));
    await viewer.exactValue();
    await shoot(FRAME_MS);
  }
  execFileSync("img2webp", ["-lossy", "-q", "75", "-m", "6", ...shots, "-o", join(folder, "page.webp")]);

  // The whole page, dark, with kept paths.
  await viewer.page.setViewportSize({ width: 1060, height: 600 });
  await viewer.page.emulateMedia({ colorScheme: "dark" });
  for (const place of [TRACK[4], TRACK[11]]) {
    await viewer.move(...place);
    await viewer.exactValue();
    await viewer.click(...place);
  }
  await viewer.move(...TRACK[8]);
  await viewer.exactValue();
  await viewer.page.screenshot({ path: join(folder, "page.png") });
} finally {
  await browser.close();
  await server.stop();
  rmSync(frames, { recursive: true });
}

/** A point of the track, by Catmull and Rom; `t` is from 0 to 1. */
function along(t) {
  const place = Math.min(t * (TRACK.length - 1), TRACK.length - 1 - 1e-9);
  const i = Math.floor(place);
  const s = place - i;
  const at = (k) => TRACK[Math.min(Math.max(k, 0), TRACK.length - 1)];
  return [0, 1].map((axis) => {
    const [a, b, c, d] = [i - 1, i, i + 1, i + 2].map((k) => at(k)[axis]);
    return b + 0.5 * s * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a)));
  });
}
