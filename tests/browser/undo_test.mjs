// What was put on the mesh goes only if the user wants it to, and comes back.

import assert from "node:assert/strict";
import { test } from "node:test";

import { TWO_SQUARES } from "./meshes.mjs";
import { until } from "./server.mjs";
import { sphere, SPHERE } from "./setup.mjs";

const isChecked = (viewer, tool) => viewer.page.locator(`input[value=${tool}]`).isChecked();

test("Esc ends what is under way, and takes nothing away", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  await viewer.click(0.5, 0.25);
  await viewer.page.waitForSelector("#paths li");
  const address = await viewer.address();
  const addressIs = (wanted) => until(() => (viewer.page.url() === address) === wanted);

  await viewer.drag([0, 0], [0.3, 0]);
  await addressIs(false);
  await viewer.page.keyboard.press("Escape");
  await addressIs(true);
  await viewer.move(0.4, 0.1);
  await viewer.page.mouse.up();
  await viewer.solved();
  await viewer.page.keyboard.press("Escape");
  assert.equal(await viewer.address(), address, "the source is back");

  await viewer.page.keyboard.press("c");
  await viewer.drag([-0.4, 0.3], [0.4, 0.3]);
  await viewer.page.keyboard.press("Escape");
  await viewer.page.mouse.up();
  assert.ok(await isChecked(viewer, "curve"), "the curve alone has ended");
  await viewer.page.keyboard.press("Escape");
  assert.ok(await isChecked(viewer, "path"));
  await viewer.page.keyboard.press("Enter");
  await viewer.page.waitForSelector("#aim");
  await viewer.page.keyboard.press("Escape");
  await viewer.page.waitForSelector("#aim", { state: "hidden" });
  assert.equal(await viewer.address(), address);
  assert.equal(await viewer.page.locator("#paths li").count(), 1);

  // A drag that has come to its end is not under way.
  await viewer.drag([0, 0], [0.2, 0]);
  await viewer.page.mouse.up();
  await viewer.solved();
  const moved = await viewer.address();
  assert.notEqual(moved, address);
  await viewer.page.keyboard.press("c");
  await viewer.drag([-0.4, 0.3], [0.4, 0.3]);
  await viewer.page.keyboard.press("Escape");
  await viewer.page.mouse.up();
  assert.equal(await viewer.address(), moved, "the curve alone has ended");
  assert.deepEqual(viewer.errors, []);
});

test("sources, curves, paths and the radius are undone and done again, one by one", async (t) => {
  const viewer = await sphere(t);
  const { page } = viewer;
  // It tells all that is asked.
  const address = () => viewer.address();
  const addresses = [await address()];
  const step = async (what) => {
    await what();
    await until(async () => (await address()) !== addresses.at(-1));
    addresses.push(await address());
  };
  await step(() => viewer.click(0, 0));
  await viewer.solved();
  await step(() => viewer.click(0.5, 0.25));
  await step(async () => {
    await page.keyboard.down("Shift");
    await viewer.click(-0.5, 0);
    await page.keyboard.up("Shift");
  });
  await step(async () => {
    await page.keyboard.down("Alt");
    await viewer.drag([-0.3, 0.5], [0.3, 0.5]);
    await page.mouse.up();
    await page.keyboard.up("Alt");
  });
  await viewer.solved();
  // However many places it comes through.
  await viewer.drag([0, 0], [0.1, -0.3]);
  await page.mouse.up();
  await viewer.solved();
  addresses.push(await address());
  await page.fill("#radius", "300");
  await step(() => page.fill("#radius", "250"));
  await step(() => page.click("#clear"));
  assert.doesNotMatch(await address(), /source|path|radius/);
  assert.ok(await page.locator("#clear").isDisabled());
  assert.equal(await viewer.text("#radius-value"), "all");

  const isAt = (wanted) => until(async () => (await address()) === wanted);
  for (const before of addresses.slice(0, -1).reverse()) {
    await page.keyboard.press("Control+z");
    await isAt(before);
  }
  assert.ok(await page.locator("#undo").isDisabled());
  for (const after of addresses.slice(1)) {
    await page.click("#redo");
    await isAt(after);
  }
  assert.ok(await page.locator("#redo").isDisabled());
  await page.click("#undo");
  await isAt(addresses.at(-2));
  await viewer.solved();
  assert.equal(await viewer.text("#source-count"), "3 sources");
  assert.equal(await page.locator("#paths li").count(), 1);
  await page.keyboard.press("Control+Shift+z");
  await isAt(addresses.at(-1));
  assert.deepEqual(viewer.errors, []);
});

test("the same file, and the browser's Back to a mesh, keep what was asked", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  await viewer.click(0.5, 0.25);
  await viewer.page.waitForSelector("#paths li");
  const address = await viewer.address();
  await viewer.drop("again.obj", SPHERE);
  await viewer.shown("again.obj");
  assert.equal(await viewer.address(), address);
  await viewer.drop("two.off", TWO_SQUARES);
  await viewer.shown("two.off");
  assert.doesNotMatch(await viewer.address(), /source/);
  await viewer.page.goBack();
  await viewer.shown("again.obj");
  await viewer.page.waitForSelector("#paths li");
  assert.equal(await viewer.address(), address);
  assert.deepEqual(viewer.errors, []);
});
