// How far: all, or a number.

import assert from "node:assert/strict";
import { test } from "node:test";

import { openPage } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { startServerOn, until } from "./server.mjs";
import { browser, sphere, SPHERE } from "./setup.mjs";

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

test("the address has the radius where a long drag of the slider ended", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  // Chromium drops all changes of the address after some two hundred in ten seconds.
  const shown = await viewer.page.evaluate(() => {
    const slider = document.getElementById("radius");
    for (let i = 0; i < 500; i++) {
      slider.value = String(900 - i);
      slider.dispatchEvent(new Event("input"));
    }
    return document.getElementById("radius-value").textContent;
  });
  const named = () => viewer.page.evaluate(() => Number(location.hash.match(/radius=([\d.]+)/)?.[1]).toPrecision(4));
  await until(async () => Number(await named()) === Number(shown));
  assert.deepEqual(viewer.errors, []);
});
