// Paths that were kept are results of their own: they stay, with their own sources.

import assert from "node:assert/strict";
import { test } from "node:test";

import { openPage } from "./browser.mjs";
import { lengthOf, linesIn } from "./obj_lines.mjs";
import { ask, browser, server, sphere, SPHERE } from "./setup.mjs";

/** Keeps the path to a place; its length is what the cursor shows there before. */
async function keep(viewer, x, y) {
  const paths = viewer.page.locator("#paths li");
  const count = await paths.count();
  await viewer.move(x, y);
  const length = await viewer.exactValue();
  await viewer.click(x, y);
  await paths.nth(count).waitFor();
  return length;
}

const lengths = async (viewer) => (await viewer.page.locator("#paths li").allTextContents()).map(parseFloat);

const savedLengths = async (viewer) => linesIn((await viewer.save("#save-paths")).bytes.toString()).map(lengthOf);

function assertNear(actual, expected, error) {
  assert.equal(actual.length, expected.length);
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < error * expected[i], `${actual} ${expected}`));
}

test("kept paths stay when sources are others; they are in the link and in what is saved", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  const expected = [await keep(viewer, 0.5, 0.25)];
  await viewer.page.keyboard.down("Shift");
  await viewer.click(-0.5, 0);
  await viewer.page.keyboard.up("Shift");
  await viewer.waitForText("#source-count", "2 sources");
  await viewer.solved();
  assertNear(await lengths(viewer), expected, 1e-6);
  await viewer.page.keyboard.press("s");
  await viewer.click(-0.2, -0.4);
  await viewer.waitForText("#source-count", "1 source");
  await viewer.solved();
  assertNear(await lengths(viewer), expected, 1e-6);
  expected.push(await keep(viewer, 0.3, -0.5));
  assertNear(await lengths(viewer), expected, 1e-6);
  assertNear(await savedLengths(viewer), expected, 1e-6);

  // Each is asked from its own source.
  await viewer.page.locator("#copy-command").evaluate((button) => button.click());
  const [, ...commands] = (await viewer.text("#question-text")).split("\n");
  assertNear(commands.map((command) => ask(server, t, SPHERE, command).paths[0].length), expected, 1e-6);
  assert.notEqual(commands[0].split(" ").at(-1), commands[1].split(" ").at(-1), "no file is written twice");

  const linked = await openPage(browser, await viewer.address());
  t.after(() => linked.close());
  await linked.page.locator("#paths li").nth(1).waitFor();
  assertNear(await lengths(linked), expected, 1e-6);
  assert.equal(await linked.address(), await viewer.address());

  await viewer.page.click("#paths li >> nth=0 >> button");
  assertNear(await lengths(viewer), expected.slice(1), 1e-6);
  assertNear(await savedLengths(viewer), expected.slice(1), 1e-6);
  // Without a source they are there, too.
  await viewer.page.keyboard.press("Control+z");
  for (const button of ["#paths li >> nth=1 >> button", "#paths li >> nth=0 >> button"]) await viewer.page.click(button);
  assert.equal(await viewer.page.locator("#paths li").count(), 0);
  await viewer.page.keyboard.press("Backspace");
  await viewer.waitForText("#source-count", "no source");
  await viewer.page.keyboard.press("Control+z");
  await viewer.page.keyboard.press("Control+z");
  assertNear(await lengths(viewer), expected.slice(0, 1), 1e-6);
  assert.deepEqual([...viewer.errors, ...linked.errors], []);
});

test("a path that is on its way when the source moves is kept", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  let goOn;
  const mayGoOn = new Promise((resolve) => (goOn = resolve));
  await viewer.page.route("**/ComputePaths", async (route) => {
    await mayGoOn;
    await route.continue();
  });
  const asked = viewer.page.waitForRequest((request) => request.url().endsWith("/ComputePaths"));
  const from = (await viewer.address()).match(/source=([^&]*)/)[1];
  await viewer.click(0.5, 0.25);
  await asked;
  await viewer.page.keyboard.press("s");
  await viewer.click(-0.5, 0);
  await viewer.solved();
  goOn();
  await viewer.page.waitForSelector("#paths li");
  assert.ok((await viewer.address()).includes(`&path=${from}%3B`), "it starts where the source was");
  assert.deepEqual(viewer.errors, []);
});
