// The picture says what it shows, on the page and where it is saved.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { apart } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { server, sphere, SPHERE } from "./setup.mjs";

/** Shows these sources, in the words of the address. */
async function show(viewer, question) {
  await viewer.address();
  await viewer.page.evaluate((question) => (location.hash += question), question);
}

/** What is written on a picture that is saved, in a line, and the picture. */
async function savePicture(viewer) {
  await viewer.page.evaluate(() => {
    window.written = [];
    const { prototype } = CanvasRenderingContext2D;
    window.fillText ??= prototype.fillText;
    prototype.fillText = function (text, ...place) {
      window.written.push(text);
      window.fillText.call(this, text, ...place);
    };
  });
  const { bytes } = await viewer.save("#save-picture");
  const written = await viewer.page.evaluate(() => window.written);
  return { text: written.join(" "), picture: await viewer.decode(bytes) };
}

/** Distances of the sphere's vertices as the command answers. */
function distances(t, ...words) {
  const folder = temporaryFolder(t);
  writeFileSync(join(folder, "sphere.obj"), SPHERE);
  execFileSync(process.env.GEODESIC, [
    "--server", `127.0.0.1:${server.grpcPort}`, "--quiet", "field", "sphere.obj", ...words, "-o", "d.csv"], { cwd: folder });
  return readFileSync(join(folder, "d.csv"), "utf8").trim().split("\n").slice(1).map((line) => Number(line.split(",")[1]));
}

test("a picture says from which source, in which unit, how exactly and how far", async (t) => {
  const viewer = await sphere(t);
  await show(viewer, "&source=7&radius=1.5");
  await viewer.waitForText("#figures", "farthest up to 1.5");
  await viewer.solved();
  const place = SPHERE.match(/^v .*$/gm)[7].split(" ").slice(1).map((x) => Number(Number(x).toPrecision(4)));
  const { text, picture } = await savePicture(viewer);
  // The largest distance is nearly 1.5: lines are then every power of ten / 20.
  for (const part of [
    `sphere.obj: distance from vertex 7 (${place.join(", ")})`, "exact (fwp-list), in the unit of the file",
    "lines: distances, every 0.05", "up to 1.5; what is farther is grey"]) {
    assert.ok(text.includes(part), `"${part}" is written: ${text}`);
    assert.ok((await viewer.text("#legend")).includes(part), `"${part}" is on the page`);
  }
  const background = picture.at([5, 5]);
  let inked = 0;
  for (let x = 20; x < 220; x++) for (let y = 12; y < 24; y++) inked += apart(picture.at([x, y]), background) > 100 ? 1 : 0;
  assert.ok(inked > 200, `${inked} pixels of the first line are seen`);

  await viewer.page.keyboard.press("i");
  assert.doesNotMatch(await viewer.text("#legend"), /lines:/);
  await show(viewer, "&source=9");
  await viewer.waitForText("#legend", "distance from the nearest of 2 sources: vertex 7");
  await viewer.solved();
  assert.deepEqual(viewer.errors, []);
});

test("a comparison says which fields, the unit, the sign and the range", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0.1, 0.1);
  await viewer.solved();
  await viewer.page.locator("#against").evaluate((select) => {
    select.value = [...select.options].find((option) => option.text === "fmm").value;
  });
  await viewer.page.locator("#compare").evaluate((button) => button.click());
  await viewer.waitForText("#notice-text", "Sources are at the nearest vertices now");
  await viewer.waitForText("#difference", "largest difference");
  await viewer.solved();
  const vertex = (await viewer.address()).match(/source=(\d+)/)[1];
  const exact = distances(t, "--source", vertex);
  const differences = distances(t, "--source", vertex, "--algorithm", "fmm").map((d, v) => d - exact[v]);
  const [low, high] = [Math.min(0, ...differences), Math.max(0, ...differences)];
  const { text } = await savePicture(viewer);
  const legend = await viewer.text("#legend");
  for (const words of [text, legend.replaceAll("\n", " ")]) {
    assert.ok(words.includes("how far fmm (approximate) is from fwp-list (exact), without sign, in the unit of the file"), words);
    assert.ok(words.includes(`both: distance from vertex ${vertex} (`), words);
    const range = words.match(/fmm − fwp-list is from (\S+) to (\S+)/).slice(1).map(Number);
    // Three digits are written.
    [low, high].forEach((end, i) => assert.ok(Math.abs(range[i] - end) <= 0.006 * Math.abs(end) + 1e-14, `${range} ${low} ${high}`));
  }
  assert.ok(text.includes("lines: distances of fwp-list"));
  // The picture is of distances again, and says so.
  await viewer.page.keyboard.press("Control+z");
  await viewer.waitForText("#legend", "distance from a point in face");
  assert.doesNotMatch(await viewer.text("#legend"), /fmm/);
  assert.deepEqual(viewer.errors, []);
});

test("cells stay cells when a source comes, and say so", async (t) => {
  const viewer = await sphere(t);
  await show(viewer, "&source=7&source=9");
  await viewer.waitForText("#source-count", "2 sources");
  await viewer.solved();
  await viewer.page.check("#cells");
  await viewer.waitForText("#legend", "which source is nearest");
  await viewer.page.keyboard.down("Shift");
  await viewer.click(0.3, 0);
  await viewer.page.keyboard.up("Shift");
  await viewer.waitForText("#source-count", "3 sources");
  await viewer.waitForText("#legend", "which source is nearest, darker is farther: the nearest of 3 sources");
  assert.ok(await viewer.page.isChecked("#cells"));
  assert.ok((await savePicture(viewer)).text.includes("which source is nearest"));
  await viewer.page.uncheck("#cells");
  await viewer.waitForText("#legend", "sphere.obj: distance from");
  assert.deepEqual(viewer.errors, []);
});
