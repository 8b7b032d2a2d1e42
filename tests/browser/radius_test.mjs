// How far: all, or a number.

import assert from "node:assert/strict";
import { test } from "node:test";

import { openPage } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { startServerOn } from "./server.mjs";
import { browser, SPHERE } from "./setup.mjs";

test("all is all, and a number that number, after a reload and a restart", async (t) => {
  const data = temporaryFolder(t);
  const start = (port) => startServerOn(port, "--data-dir", data);
  let own = await start(0);
  t.after(() => own.stop());
  const viewer = await openPage(browser, own.url);
  t.after(() => viewer.close());
  await viewer.drop("sphere.obj", SPHERE);
  await viewer.shown("sphere.obj");
  await viewer.click(0, 0);
  await viewer.solved();
  const farthest = await viewer.text("#figures dd");
  const reload = () => viewer.page.reload();
  const restart = async () => {
    await own.stop();
    own = await start(own.port);
    await viewer.page.reload();
  };
  for (const comeBack of [reload, restart]) {
    await comeBack();
    await viewer.solved();
    assert.equal(await viewer.text("#radius-value"), "all");
    assert.equal(await viewer.page.inputValue("#radius"), "1000");
    assert.equal(await viewer.text("#figures dd"), farthest);

    await viewer.page.fill("#radius", "300");
    const radius = await viewer.text("#radius-value");
    await comeBack();
    await viewer.solved();
    assert.equal(await viewer.text("#radius-value"), radius);
    // The server has the field of all: what is told is what was asked.
    assert.equal(await viewer.text("#figures dt"), `farthest up to ${radius}`);
    assert.ok(Number(await viewer.text("#figures dd")) <= Number(radius));
    await viewer.page.locator("#radius").press("End");
    await viewer.solved();
    assert.equal(await viewer.text("#radius-value"), "all");
    assert.equal(await viewer.text("#figures dt"), "farthest");
    assert.equal(await viewer.text("#figures dd"), farthest);
  }
  assert.deepEqual(viewer.errors, []);
});
