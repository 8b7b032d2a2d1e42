// Lines that run straight on from a source: drawn by a drag, and kept.

import assert from "node:assert/strict";
import { test } from "node:test";

import { planeObj } from "./meshes.mjs";
import { lengthOf, linesIn } from "./obj_lines.mjs";
import { until } from "./server.mjs";
import { ask, server, shows, sphere, SPHERE } from "./setup.mjs";

const WIDTH = 1.5;
const HEIGHT = 1;
const PLANE = planeObj(6, WIDTH, HEIGHT);
/** The vertex in the middle of the plane, and of the picture. */
const MIDDLE = 84;

const items = (viewer) => viewer.page.locator("#paths li");
const saved = async (viewer) => linesIn((await viewer.save("#save-paths")).bytes.toString());
const addressIs = (viewer, wanted) => until(async () => (await viewer.address()) === wanted);

function assertNear(value, expected, error) {
  assert.ok(Math.abs(value - expected) <= error * expected, `${value} ${expected}`);
}

/** The page with a source in the middle of the plane and its field. */
async function plane(t) {
  const viewer = await shows(t, "plane.obj", PLANE);
  await viewer.address();
  await viewer.page.evaluate((middle) => (location.hash += `&source=${middle}`), MIDDLE);
  await viewer.waitForText("#source-count", "1 source");
  await viewer.solved();
  return viewer;
}

/** Draws a line by a drag from a place to another, and waits until it is kept. */
async function draw(viewer, from, to) {
  const count = await items(viewer).count();
  await viewer.drag(from, to);
  await viewer.page.mouse.up();
  await items(viewer).nth(count).waitFor();
}

/** What an address says of the lines that run straight on. */
function straightIn(address) {
  return new URLSearchParams(new URL(address).hash.slice(1)).getAll("path").flatMap((path) => {
    const parts = /^(.*);straight:(.*)@(.*)$/.exec(path);
    return parts ? [{ from: parts[1], direction: parts[2].split(",").map(Number), length: Number(parts[3]) }] : [];
  });
}

/** The commands that the page writes down. */
async function commands(viewer) {
  await viewer.page.locator("#copy-command").evaluate((button) => button.click());
  return (await viewer.text("#question-text")).split("\n");
}

test("a line runs straight on from a source under the cursor, up to the boundary", async (t) => {
  const viewer = await plane(t);
  const { page } = viewer;
  await page.keyboard.press("d");
  await viewer.waitForText("#next-step", "Drag from a source's dot");
  const to = [0.2, 0.12];
  // In one step, so that one line is asked for.
  await viewer.move(0, 0);
  await page.mouse.down();
  await viewer.move(...to);
  let live;
  await until(async () => (live = await viewer.exactValue()) > 0);
  // What is straight in the plane is straight on the screen; the line does not end at the cursor.
  const along = await Promise.all([0.5, 1.4].map((share) => viewer.at(share * to[0], share * to[1])));
  let picture = await viewer.picture();
  for (const pixel of along) assert.ok(Math.min(...picture.at(pixel)) > 200, `the line is white: ${picture.at(pixel)}`);
  assert.equal(await items(viewer).count(), 0);
  await page.mouse.up();
  await items(viewer).waitFor();

  const [{ from, direction, length: asked }] = straightIn(await viewer.address());
  assert.equal(from, String(MIDDLE), "the source is where it was");
  assertNear(asked, Math.hypot(WIDTH, HEIGHT), 1e-12);
  const [x, y, z] = direction;
  assert.ok(Math.abs(z) < 1e-6, `the direction is in the plane: ${direction}`);
  const toBoundary = Math.min(WIDTH / Math.abs(x), HEIGHT / Math.abs(y));
  const expected = toBoundary * Math.hypot(x, y);
  assert.ok(expected < 0.99 * asked);
  assertNear(live, expected, 1e-7);
  assertNear(parseFloat(await viewer.text("#paths li")), expected, 1e-9);
  assert.equal(await viewer.text("#paths small"), `from vertex ${MIDDLE} straight on, up to the boundary`);
  assert.equal(await viewer.text("#labels span"), String(Number(expected.toPrecision(6))));
  assert.match(await viewer.text("#legend"), /pink: 1 line straight on/);
  await viewer.move(-0.3, -0.3);
  await viewer.exactValue();
  picture = await viewer.picture();
  for (const pixel of along) {
    const [red, green, blue] = picture.at(pixel);
    assert.ok(red > 200 && blue > 140 && green < 180, `the kept line is pink: ${red} ${green} ${blue}`);
  }

  const [line] = await saved(viewer);
  assertNear(lengthOf(line), expected, 1e-12);
  for (const point of line) assert.ok(Math.hypot(point[0] * y - point[1] * x, point[2]) < 1e-12 * Math.hypot(x, y) + 1e-14, `${line}`);
  assertNear(Math.hypot(...line.at(-1).map((value, k) => value - toBoundary * [x, y, 0][k])) + 1, 1, 1e-12);
  const [, command] = await commands(viewer);
  const [answer] = ask(server, t, PLANE, command, "plane.obj").lines;
  assert.equal(answer.end, "boundary");
  assert.deepEqual(answer.positions, line);

  // It leads where the place under the cursor was: so does the path to that place.
  await page.keyboard.press("p");
  await viewer.click(...to);
  await items(viewer).nth(1).waitFor();
  const end = (await saved(viewer))[1].at(-1);
  // The cursor is on a pixel, and so are both places.
  assertNear(Math.hypot(...end.map((value, k) => value - direction[k])) + 1, 1, 1e-6);
  assert.deepEqual(viewer.errors, []);
});

test("a line is undone, done again, taken away, and comes back with its address", async (t) => {
  const viewer = await plane(t);
  const { page } = viewer;
  const before = await viewer.address();
  await page.keyboard.press("d");
  await draw(viewer, [0, 0], [-0.3, 0.1]);
  const address = await viewer.address();
  const [text, lines] = [await items(viewer).textContent(), await saved(viewer)];
  await page.keyboard.press("Control+z");
  await addressIs(viewer, before);
  assert.equal(await items(viewer).count(), 0);
  assert.ok(await page.locator("input[value=straight]").isChecked(), "another may be drawn");
  await page.keyboard.press("Control+Shift+z");
  await addressIs(viewer, address);
  for (const takeAway of [() => page.keyboard.press("Backspace"), () => page.click("#paths button")]) {
    await takeAway();
    await addressIs(viewer, before);
    await page.click("#undo");
    await addressIs(viewer, address);
  }
  assert.equal(await items(viewer).textContent(), text);

  await page.reload();
  await items(viewer).waitFor();
  await viewer.solved();
  await addressIs(viewer, address);
  assert.equal(await items(viewer).textContent(), text);
  assert.deepEqual(await saved(viewer), lines);
  assert.deepEqual(viewer.errors, []);
});

test("on a closed mesh a line is as long as the slider says, else as the farthest distance", async (t) => {
  const viewer = await sphere(t);
  const { page } = viewer;
  await viewer.click(0, 0);
  await viewer.solved();
  await viewer.click(0.5, 0.25);
  await items(viewer).waitFor();
  const farthest = Number(await viewer.text("#figures dd"));
  await page.keyboard.press("d");
  await draw(viewer, [0, 0], [0.3, -0.2]);
  await page.fill("#radius", "300");
  const address = await viewer.address();
  const radius = Number(new URLSearchParams(new URL(address).hash.slice(1)).get("radius"));
  assert.ok(radius > 0.25 * farthest && radius < 0.35 * farthest);
  await draw(viewer, [0, 0], [-0.3, 0.2]);
  const lengths = (await items(viewer).allTextContents()).slice(1).map(parseFloat);
  const lines = (await saved(viewer)).slice(1);
  [farthest, radius].forEach((length, i) => {
    assertNear(lengths[i], length, 1e-9);
    assertNear(lengthOf(lines[i]), length, 1e-9);
  });
  for (const words of (await page.locator("#paths small").allTextContents()).slice(1)) assert.match(words, / straight on$/);

  const [, path, ...traces] = await commands(viewer);
  assert.match(path, /^geodesic path .* -o paths\.obj$/);
  assert.deepEqual(traces.map((trace) => trace.split(" ").at(-1)), ["line.obj", "line-2.obj"]);
  traces.forEach((trace, i) => {
    const [answer] = ask(server, t, SPHERE, trace).lines;
    assert.equal(answer.end, "length");
    assert.deepEqual(answer.positions, lines[i]);
  });
  await page.locator("#copy-python").evaluate((button) => button.click());
  const [, line] = straightIn(await viewer.address());
  assert.ok((await viewer.text("#question-text")).includes(
    `direction=[${line.direction.join(", ")}], length=${line.length}),\n]`));

  // Paths and lines come back in their order.
  const all = await viewer.address();
  const texts = await items(viewer).allTextContents();
  await page.reload();
  await items(viewer).nth(2).waitFor();
  await addressIs(viewer, all);
  assert.deepEqual(await items(viewer).allTextContents(), texts);
  assert.deepEqual(viewer.errors, []);
});

test("other drags turn, and Esc takes the line away before it is kept", async (t) => {
  const viewer = await sphere(t);
  const { page } = viewer;
  const traced = [];
  page.on("request", (request) => {
    if (request.url().endsWith("/TraceLines")) traced.push(request);
  });
  // The source is in the middle if nothing has turned. The cursor tells, of the picture there is by then.
  const isInMiddle = (wanted) => until(async () => {
    await viewer.move(0.1, 0.1);
    await viewer.move(0, 0);
    return (await page.locator("#picture.grab").count()) === (wanted ? 1 : 0);
  });
  const turns = async (from, to) => {
    await isInMiddle(true);
    await viewer.drag(from, to);
    await page.mouse.up();
    await isInMiddle(false);
    await page.keyboard.press("l");
    await isInMiddle(true);
  };
  await page.keyboard.press("d");
  assert.equal(await viewer.text("#next-step"), "Click a point of the surface.");
  await viewer.settled();
  const bare = (await viewer.picture()).bytes;
  await viewer.drag([0, 0], [0.3, 0]);
  await page.mouse.up();
  await viewer.pictureOnce(({ bytes }) => !bytes.equals(bare));
  assert.match(await viewer.text("#source-count"), /no source/);
  await page.keyboard.press("l");

  let goOn;
  const mayGoOn = new Promise((resolve) => (goOn = resolve));
  await page.route("**/ComputeField", async (route) => {
    await mayGoOn;
    await route.continue();
  });
  await viewer.click(0, 0);
  await viewer.waitForText("#next-step", "there is no such length yet");
  const address = await viewer.address();
  await turns([0, 0], [0.3, 0]);
  goOn();
  await viewer.solved();
  await viewer.waitForText("#next-step", "Drag from a source's dot");
  await turns([0.3, 0.3], [0.6, 0.3]);
  assert.equal(traced.length, 0);
  assert.equal(await viewer.address(), address);

  await viewer.drag([0, 0], [0.3, 0.1]);
  await viewer.exactValue();
  assert.ok(traced.length > 0);
  await page.keyboard.press("Escape");
  await page.waitForSelector("#value", { state: "hidden" });
  await page.mouse.up();
  assert.ok(await page.locator("input[value=straight]").isChecked(), "the line alone has ended");
  // What is asked next is answered, and no line with it.
  await draw(viewer, [0, 0], [-0.3, 0.1]);
  assert.equal(await items(viewer).count(), 1);
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("input[value=path]").isChecked());
  assert.deepEqual(viewer.errors, []);
});

test("an address whose line is none, or runs nowhere, is told", async (t) => {
  const viewer = await plane(t);
  const name = async (path) => {
    await viewer.address();
    await viewer.page.evaluate((path) => (location.hash += `&path=${path}`), path);
  };
  for (const path of ["0;straight:1,0@1", "0;straight:1,0,0@0", "0;straight:1,0,..@1", "999;straight:1,0,0@1"]) {
    await name(path);
    await viewer.waitForText("#notice-text", "names a path that is none of this mesh");
    await viewer.page.click("#notice-close");
  }
  await name(`${MIDDLE};straight:0,0,1@1`);
  await viewer.waitForText("#notice-text", "at right angles to the surface");
  assert.equal(await items(viewer).count(), 0);
  assert.deepEqual(viewer.errors, []);
});
