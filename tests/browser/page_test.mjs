// What a user does on the page, and what must then be seen.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

import { apart, DRAWS_NOTHING, isGrey, launch, openPage } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { sphereObj, TWO_SQUARES, TWO_SQUARES_VTP } from "./meshes.mjs";
import { startServer, until, writeTokens } from "./server.mjs";
import { ask, browser, server, sphere, SPHERE } from "./setup.mjs";

const LARGE_SPHERE = sphereObj(200);

/** A server that asks for "right-token". */
async function startGuarded(t) {
  const tokens = writeTokens({ ada: ["right-token", ["read", "upload"]] });
  t.after(() => tokens.remove());
  const guarded = await startServer("--token-file", tokens.path);
  t.after(() => guarded.stop());
  return guarded;
}

test("a dropped file is sent once, and shown", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  const calls = [];
  viewer.page.on("request", (request) => calls.push(request.url().split("/").pop()));
  const mesh = SPHERE.replace("\n", "\n# another file\n");
  await viewer.drop("first.obj", mesh);
  await viewer.shown("first.obj");
  assert.match(await viewer.text("#mesh-size"), /4,608 faces/);
  const picture = await viewer.picture();
  assert.ok(isGrey(picture.at(await viewer.at(0, 0))), "the bare mesh is grey");
  assert.ok(apart(picture.at(await viewer.at(0, 0)), picture.at(await viewer.at(-1, 0.99))) > 40);
  assert.equal(calls.filter((name) => name === "CreateMesh").length, 1);
  await viewer.drop("again.obj", mesh);
  await viewer.shown("again.obj");
  assert.equal(calls.filter((name) => name === "CreateMesh").length, 1, "known files are not sent again");
  assert.deepEqual(viewer.errors, []);
});

test("a click sends a front over the surface, up to yellow", async (t) => {
  const viewer = await sphere(t);
  const [near, far] = [await viewer.at(0.05, 0), await viewer.at(0.7, 0)];
  // A frame that was asked for by then would come at the browser's own time.
  await viewer.settled();
  // From here on the page's clock, and with it the front, goes on when told.
  await viewer.page.clock.install();
  await viewer.page.clock.pauseAt(Date.now() + 60_000);
  await viewer.click(0, 0);
  await viewer.page.waitForSelector("#figures dt", { state: "attached" });
  await viewer.page.clock.runFor(120);
  const halfway = await viewer.picture();
  assert.ok(!isGrey(halfway.at(near)), "the front has passed the source");
  assert.ok(isGrey(halfway.at(far)), "the front has not come to the limb");
  await viewer.page.clock.resume();
  await viewer.solved();
  let [red, green, blue] = (await viewer.picture()).at(near);
  assert.ok(blue > green + 20, `near is violet: ${red} ${green} ${blue}`);
  // Half around, 26 steps of 0.12, and from 16 degrees above to 18 below.
  for (let i = 0; i < 26; i++) await viewer.page.keyboard.press("ArrowRight");
  for (let i = 0; i < 5; i++) await viewer.page.keyboard.press("ArrowDown");
  // The picture of the last key may be on its way.
  [red, green, blue] = (await viewer.pictureOnce((picture) => picture.at(near)[0] > 180)).at(near);
  assert.ok(red > 180 && green > 180 && blue < 120, `far is yellow: ${red} ${green} ${blue}`);
  assert.deepEqual(viewer.errors, []);
});

test("isolines are round on a sphere", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  // Where no value hides a line.
  await viewer.move(-1.2, 0.9);
  const lined = await viewer.picture();
  await viewer.page.keyboard.press("i");
  const bare = await viewer.picture();
  const middle = await viewer.at(0, 0);
  // Where the lines are along rays from the source: the first beyond its dot.
  const radii = [];
  for (let ray = 0; ray < 24; ray++) {
    const angle = (ray * Math.PI) / 12 + 0.05;
    let strongest = 0;
    let at = 0;
    let began = false;
    for (let r = 14; r < 200; r += 0.5) {
      const pixel = [middle[0] + r * Math.cos(angle), middle[1] + r * Math.sin(angle)];
      const difference = apart(lined.at(pixel), bare.at(pixel));
      if (difference > 12) began = true;
      if (began && difference <= 6) break;
      if (difference > strongest) [strongest, at] = [difference, r];
    }
    assert.ok(began, `a line crosses ray ${ray}`);
    radii.push(at);
  }
  const mean = radii.reduce((sum, r) => sum + r) / radii.length;
  // Two pixels: half the width of a line, and the rounding of pixels.
  for (const r of radii) assert.ok(Math.abs(r - mean) <= 2, `${radii}`);
  assert.deepEqual(viewer.errors, []);
});

test("the exact path follows the cursor, and a click keeps it", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  await viewer.move(0.5, 0.25);
  const value = await viewer.exactValue();
  // From the middle of a sphere paths are straight on the screen.
  const between = await viewer.at(0.25, 0.125);
  let picture = await viewer.picture();
  assert.ok(Math.min(...picture.at(between)) > 200, `the path is white: ${picture.at(between)}`);
  await viewer.click(0.5, 0.25);
  await viewer.page.waitForSelector("#paths li");
  const length = parseFloat(await viewer.text("#paths li"));
  assert.ok(Math.abs(length - value) < 1e-6 * value, `${length} ${value}`);
  const label = viewer.page.locator("#labels span");
  assert.equal(parseFloat(await label.textContent()), Number(length.toPrecision(6)));
  const [box, end] = [await label.boundingBox(), await viewer.at(0.5, 0.25)];
  assert.ok(Math.hypot(box.x - end[0], box.y + box.height / 2 - end[1]) < 30, "the length stands beside the end");
  await viewer.move(-0.5, 0.4);
  await viewer.exactValue();
  picture = await viewer.picture();
  const [red, green, blue] = picture.at(between);
  assert.ok(red > 200 && green > 100 && blue < 130, `the kept path is orange: ${red} ${green} ${blue}`);

  for (let i = 0; i < 26; i++) await viewer.page.keyboard.press("ArrowLeft");
  await label.waitFor({ state: "detached" });  // The ball hides it.
  for (let i = 0; i < 26; i++) await viewer.page.keyboard.press("ArrowRight");
  await label.waitFor();

  // The command finds the same, asked as the page says.
  await viewer.page.locator("#copy-command").evaluate((button) => button.click());
  const [, pathCommand] = (await viewer.text("#question-text")).split("\n");
  const [path] = ask(server, t, SPHERE, pathCommand).paths;
  assert.ok(Math.abs(path.length - length) < 1e-9 * length, `${path.length} ${length}`);
  assert.deepEqual(viewer.errors, []);
});

test("the value under a cursor that rests is that of the view and the sources", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(-0.3, 0);
  await viewer.solved();
  await viewer.move(0.2, 0.1);
  const first = await viewer.exactValue();
  const anotherThan = async (value) => {
    await viewer.page.waitForFunction((value) => {
      const box = document.getElementById("value");
      return !box.hidden && box.dataset.exact === "true" && Number(box.textContent) !== value;
    }, value);
    return viewer.exactValue();
  };
  for (let i = 0; i < 4; i++) await viewer.page.keyboard.press("ArrowRight");
  const turned = await anotherThan(first);
  await viewer.move(-0.2, 0.1);
  await anotherThan(turned);
  await viewer.move(0.2, 0.1);
  assert.ok(Math.abs((await viewer.exactValue()) - turned) < 1e-6);
  await viewer.page.keyboard.down("Shift");
  await viewer.click(0.2, 0.1);
  await viewer.page.keyboard.up("Shift");
  assert.ok((await anotherThan(turned)) < 1e-6, "a source lies there");
  await viewer.page.keyboard.press("Backspace");
  assert.ok(Math.abs((await anotherThan(0)) - turned) < 1e-6);
  assert.deepEqual(viewer.errors, []);
});

test("a vertex that no face has does not make the mesh small", async (t) => {
  const viewer = await sphere(t);
  await viewer.drop("far.obj", `${SPHERE}\nv 1000 1000 1000\n`);
  await viewer.shown("far.obj");
  await viewer.click(0.6, 0);
  await viewer.solved();
  assert.deepEqual(viewer.errors, []);
});

test("a source that is dragged takes its field along", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  const from = await viewer.address();
  await viewer.move(0, 0);
  await viewer.page.mouse.down();
  for (let i = 1; i <= 5; i++) await viewer.move(0.1 * i, 0);
  await viewer.page.mouse.up();
  await viewer.page.waitForFunction((from) => location.href !== from, from);
  // The dot is there, and so is the middle of the isolines, once the fields of the places
  // on the way there have come and gone.
  await viewer.move(0.5, 0);
  await until(async () => (await viewer.exactValue()) < 0.02);
  const picture = await viewer.picture();
  assert.ok(Math.min(...picture.at(await viewer.at(0.5, 0))) > 200, "the dot is at the cursor");
  const [near, far] = [picture.at(await viewer.at(0.45, 0)), picture.at(await viewer.at(-0.5, 0.02))];
  assert.ok(near[2] > near[1] + 20, `near is violet: ${near}`);
  assert.ok(far[1] > far[0] + 40, `far is not: ${far}`);
  assert.deepEqual(viewer.errors, []);
});

test("a source that the mesh hides is not taken hold of", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  const address = await viewer.address();
  // Half around, 26 steps of 0.12, and from 16 degrees above to 18 below.
  for (let i = 0; i < 26; i++) await viewer.page.keyboard.press("ArrowRight");
  for (let i = 0; i < 5; i++) await viewer.page.keyboard.press("ArrowDown");
  await viewer.settled();
  const before = (await viewer.picture()).bytes;
  for (const x of [-0.1, -0.05, 0, 0.05, 0.1]) {
    for (const y of [-0.1, -0.05, 0, 0.05, 0.1]) {
      await viewer.move(x, y);
      assert.equal(await viewer.page.getAttribute("#picture", "class") ?? "", "", `nothing is held at ${x} ${y}`);
    }
  }
  await viewer.move(0, 0);
  await viewer.page.mouse.down();
  for (let i = 1; i <= 5; i++) await viewer.move(0.05 * i, 0);
  await viewer.page.mouse.up();
  await viewer.settled();
  assert.equal(await viewer.address(), address, "the source is where it was");
  assert.ok((await viewer.pictureOnce((picture) => !picture.bytes.equals(before))).bytes.compare(before), "the view has turned");
  assert.deepEqual(viewer.errors, []);
});

test("what the slider says is what is asked, shown and saved", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  await viewer.page.fill("#radius", "300");
  const asked = [];
  await viewer.page.route("**/ComputeField", (route) => {
    // The field within the radius is under way for as long as it takes.
    if (asked.push(route) > 1) void route.continue();
  });
  await viewer.page.keyboard.press("s");
  await viewer.click(0.3, 0);
  await until(() => asked.length === 1);
  await viewer.page.fill("#radius", "1000");
  await until(() => asked.length === 2);
  await viewer.solved();
  assert.equal(await viewer.text("#radius-value"), "all");
  const csv = (await viewer.save("#save-csv")).bytes.toString();
  assert.doesNotMatch(csv, /inf/);

  // With a radius a new source's field ends there: the slider still goes on to all.
  await viewer.page.fill("#radius", "300");
  await viewer.page.keyboard.press("s");
  await viewer.click(0, 0.2);
  await viewer.waitForText("#figures", "farthest up to");
  await viewer.solved();
  assert.ok(Number(await viewer.page.inputValue("#radius")) < 1000);
  assert.match(await viewer.address(), /&radius=[\d.]+$/);
  await viewer.page.locator("#radius").press("End");
  await viewer.solved();
  assert.equal(await viewer.text("#radius-value"), "all");
  assert.doesNotMatch(await viewer.text("#figures"), /up to/);
  assert.doesNotMatch(await viewer.address(), /radius/);
  assert.deepEqual(viewer.errors, []);
});

test("several sources, cells, samples, curves, a radius, comparison", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(-0.5, 0);
  await viewer.solved();
  await viewer.page.keyboard.down("Shift");
  await viewer.click(0.5, 0);
  await viewer.page.keyboard.up("Shift");
  await viewer.waitForText("#source-count", "2 sources");
  await viewer.solved();
  await viewer.page.check("#cells");
  await viewer.page.waitForFunction(() => document.getElementById("scale").hidden);
  const [left, right] = [await viewer.at(-0.35, -0.15), await viewer.at(0.35, -0.15)];
  let picture = await viewer.picture();
  assert.ok(picture.at(left)[0] > picture.at(left)[2] + 60, "the first cell is orange");
  assert.ok(picture.at(right)[2] > picture.at(right)[0] + 60, "the second cell is blue");
  // In saved pictures the scale is from 28 to 72 % of the height.
  const scaleOf = async () => {
    const saved = viewer.decode((await viewer.save("#save-picture")).bytes);
    return saved.then((picture) => [0.35, 0.65].map((y) => picture.at([31 * (picture.height / 700), y * picture.height])));
  };
  assert.ok((await scaleOf()).every(isGrey), "cells have no scale");
  await viewer.page.uncheck("#cells");

  await viewer.page.locator("#sample-count").evaluate((input) => (input.value = "7"));
  await viewer.page.locator("#sample").evaluate((button) => button.click());
  await viewer.waitForText("#figures", "samples7");

  const compare = async (name) => {
    await viewer.page.locator("#against").evaluate((select, name) => {
      select.value = [...select.options].find((option) => option.text === name).value;
    }, name);
    await viewer.page.locator("#compare").evaluate((button) => button.click());
    await viewer.waitForText("#difference", "largest difference");
    return Number(await viewer.text("#difference dd"));
  };
  // Exact algorithms differ by rounding, fast marching by more.
  assert.ok((await compare("mmp")) < 1e-10);
  const error = await compare("fmm");
  assert.ok(error > 1e-3 && error < 0.2, `${error}`);
  assert.match(await viewer.address(), /source=\d+&source=\d+$/, "sources are at vertices now");
  await viewer.solved();
  assert.ok(!isGrey((await viewer.picture()).at(left)), "the error is coloured");
  const ticks = (await viewer.page.locator("#scale span").allTextContents()).map(Number);
  assert.ok(ticks.length > 1 && ticks.every((tick) => tick <= error), `the scale is the error's: ${ticks}`);
  assert.ok(!(await scaleOf()).some(isGrey), "the error has its scale");

  await viewer.page.click("#clear");
  await viewer.waitForText("#source-count", "no source");
  await viewer.page.keyboard.press("c");
  await viewer.page.mouse.move(...(await viewer.at(-0.4, 0.3)));
  await viewer.page.mouse.down();
  for (let i = 1; i <= 12; i++) await viewer.page.mouse.move(...(await viewer.at(-0.4 + (0.8 * i) / 12, 0.3)));
  await viewer.page.mouse.up();
  await viewer.waitForText("#source-count", "1 source");
  await viewer.solved();
  picture = await viewer.picture();
  const onCurve = picture.at(await viewer.at(0.03, 0.3));
  assert.ok(onCurve[2] > 180 && onCurve[2] > onCurve[0], `the curve is light blue: ${onCurve}`);

  await viewer.page.fill("#radius", "200");
  await viewer.page.waitForFunction(() => document.getElementById("radius-value").textContent !== "all");
  picture = await viewer.picture();
  assert.ok(isGrey(picture.at(await viewer.at(0.1, -0.6))), "grey beyond the radius");
  assert.ok(!isGrey(picture.at(await viewer.at(0.1, 0.2))), "coloured within");
  assert.deepEqual(viewer.errors, []);
});

test("fingers: a tap is a click, one turns, two zoom", async (t) => {
  const viewer = await sphere(t, { hasTouch: true });
  const line = (from, to) => Array.from({ length: 11 }, (_, i) => from.map((x, k) => x + ((to[k] - x) * i) / 10));
  await viewer.touch([[0.2, 0.1]]);
  await viewer.waitForText("#source-count", "1 source");
  await viewer.solved();
  await viewer.touch([[-0.4, 0.3]]);
  await viewer.page.waitForSelector("#paths li");
  const address = await viewer.address();
  const dot = await viewer.at(0.2, 0.1);
  assert.ok(Math.min(...(await viewer.picture()).at(dot)) > 200, "the source is where the finger was");

  await viewer.touch(line([-0.3, -0.5], [0.3, -0.5]));
  await viewer.settled();
  assert.ok(Math.min(...(await viewer.picture()).at(dot)) < 200, "the view has turned");
  const beside = await viewer.at(1.05, 0);
  const background = (await viewer.picture()).at(beside);
  await viewer.touch(line([-0.2, -0.5], [-0.7, -0.5]), line([0.2, -0.5], [0.7, -0.5]));
  await viewer.settled();
  assert.ok(apart((await viewer.picture()).at(beside), background) > 40, "the view is nearer");
  assert.equal(await viewer.address(), address, "nothing else was asked");
  assert.equal(await viewer.page.locator("#paths li").count(), 1);
  assert.deepEqual(viewer.errors, []);
});

test("no field of another source is saved while one is dragged", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  const save = () => viewer.page.locator("#save-npy").evaluate((button) => button.click());
  let goOn;
  const mayGoOn = new Promise((resolve) => (goOn = resolve));
  await viewer.page.route("**/ComputeField", async (route) => {
    await mayGoOn;
    await route.continue();
  });
  await viewer.move(0, 0);
  await viewer.page.mouse.down();
  await viewer.move(0.3, 0);
  await viewer.page.mouse.up();
  await save();
  await viewer.waitForText("#notice-text", "The exact field is still on its way.");
  goOn();
  // It is saved once it is there.
  const saved = viewer.page.waitForEvent("download").then(() => true);
  do await save();
  while (!(await Promise.race([saved, viewer.page.waitForTimeout(50)])));
  assert.deepEqual(viewer.errors, []);
});

test("what no path leads to is grey", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  await viewer.drop("two.off", TWO_SQUARES);
  await viewer.shown("two.off");
  await viewer.click(-0.4, 0);
  await viewer.solved();
  const picture = await viewer.picture();
  assert.ok(!isGrey(picture.at(await viewer.at(-0.25, 0.1))));
  assert.ok(isGrey(picture.at(await viewer.at(0.4, 0))));
  await viewer.move(0.4, 0);
  await viewer.waitForText("#value", "not reached");
  assert.deepEqual(viewer.errors, []);
});

test("the field, the picture and the paths are saved", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0.1, 0.1);
  await viewer.solved();
  await viewer.move(0.5, 0.3);
  await viewer.exactValue();
  await viewer.click(0.5, 0.3);
  await viewer.page.waitForSelector("#paths li");
  const vertices = (SPHERE.match(/^v /gm) ?? []).length;

  const npy = await viewer.save("#save-npy");
  assert.equal(npy.name, "sphere-field.npy");
  const head = npy.bytes.readUInt16LE(8) + 10;
  assert.equal(head % 64, 0);
  assert.ok(npy.bytes.toString("latin1", 10, head).includes(`'shape': (${vertices},)`));
  const distances = new Float64Array(npy.bytes.buffer.slice(npy.bytes.byteOffset + head, npy.bytes.byteOffset + npy.bytes.length));
  assert.equal(distances.length, vertices);

  // The same as the command's answer to the question as the page puts it.
  await viewer.page.locator("#copy-command").evaluate((button) => button.click());
  const answer = ask(server, t, SPHERE, (await viewer.text("#question-text")).split("\n")[0]);
  assert.equal(Math.max(...distances), answer.largest_distance);
  assert.equal(distances[answer.farthest_vertex], answer.largest_distance);

  const csv = (await viewer.save("#save-csv")).bytes.toString().trimEnd().split("\n");
  assert.equal(csv[0], "vertex,geodesic_distance");
  assert.equal(csv.length, vertices + 1);
  assert.equal(Number(csv[18].split(",")[1]), distances[17]);

  const ply = (await viewer.save("#save-ply")).bytes;
  assert.ok(ply.toString("latin1", 0, 400).includes("property double geodesic_distance"));
  const body = ply.indexOf("end_header\n") + 11;
  assert.equal(ply.readDoubleLE(body + 32 * 17 + 24), distances[17]);

  const obj = (await viewer.save("#save-paths")).bytes.toString();
  assert.match(obj, /^l 1 2/m);

  const png = await viewer.save("#save-picture");
  assert.equal(png.bytes.toString("latin1", 1, 4), "PNG");
  assert.ok(png.bytes.length > 20_000);

  await viewer.page.locator("#copy-python").evaluate((button) => button.click());
  const python = await viewer.text("#question-text");
  assert.match(python, /mesh\.distances\(geodesic\.FacePoint\(/);
  assert.match(python, /^path = mesh\.path\(/m);
  // The text is that of the question on the screen.
  await viewer.click(-0.5, 0.3);
  await viewer.waitForText("#question-text", "paths = [\n    mesh.path(");
  await viewer.page.keyboard.press("s");
  await viewer.click(0, 0);
  await viewer.page.waitForFunction((python) => {
    const distances = (text) => text.match(/^d = .*$/m)[0];
    return distances(document.getElementById("question-text").textContent) !== distances(python);
  }, python);
  await viewer.page.click("#clear");
  await viewer.page.waitForFunction(() => document.getElementById("question-text").hidden);
  assert.deepEqual(viewer.errors, []);
});

test("a compressed file is taken, and calls name its mesh for balancers", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  const named = {};
  viewer.page.on("request", (request) => {
    named[request.url().split("/").pop()] = request.headers()["geo-mesh-digest"];
  });
  await viewer.drop("squares.off.gz", gzipSync(TWO_SQUARES));
  await viewer.shown("squares.off.gz");
  await viewer.click(-0.4, 0);
  await viewer.solved();
  await viewer.move(-0.6, 0.1);
  await viewer.exactValue();
  assert.match(named.ReadMesh, /^[0-9a-f]{64}$/);
  assert.equal(named.ComputeField, named.ReadMesh);
  assert.equal(named.ComputePaths, named.ReadMesh);
  assert.deepEqual(viewer.errors, []);
});

test("a file of VTK's XML format is taken", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  await viewer.drop("squares.vtp", TWO_SQUARES_VTP);
  await viewer.shown("squares.vtp");
  assert.match(await viewer.text("#mesh-size"), /^4 faces$/);
  assert.ok((await viewer.page.getAttribute("#file", "accept")).includes(".vtp"));
  assert.deepEqual(viewer.errors, []);
});

/** A page that shows a sphere of 320,000 faces. */
async function largeSphere(t) {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  const folder = temporaryFolder(t);
  writeFileSync(join(folder, "sphere.obj"), LARGE_SPHERE);
  await viewer.choose(join(folder, "sphere.obj"));
  await viewer.shown("sphere.obj");
  return viewer;
}

test("a large mesh is drawn with fewer faces while it moves, and asked whole", async (t) => {
  const viewer = await largeSphere(t);
  await viewer.settled();
  const [all, drawn] = (await viewer.text("#mesh-size")).match(/\d[\d,]*/g).map((text) => Number(text.replaceAll(",", "")));
  assert.equal(all, 320_000);
  // So many where there is no graphics processor.
  assert.ok(drawn <= 60_000 && drawn >= 59_000, `${drawn} faces are drawn`);

  await viewer.click(0.3, 0.2);
  await viewer.solved();
  await viewer.settled();
  await viewer.move(-0.3, 0.1);
  const value = await viewer.exactValue();
  const dot = await viewer.at(0.3, 0.2);
  // Between the source and the cursor, where the path is straight on the screen
  // but for what perspective and the ball do: its whole width is looked at.
  const column = await Promise.all(Array.from({ length: 41 }, (_, i) => viewer.at(0, 0.1 + 0.01 * i)));
  const isWhite = (color) => Math.min(...color) > 200;
  const places = await Promise.all([[0.6, 0.1], [-0.6, -0.3], [0.1, -0.6]].map(([x, y]) => viewer.at(x, y)));
  const whole = await viewer.picture();
  assert.ok(isWhite(whole.at(dot)), "the source is where the click was: its face is one of all faces");
  assert.ok(column.some((pixel) => isWhite(whole.at(pixel))), "the path is seen");

  // Time stands still, and with it the picture that changed last.
  await viewer.page.clock.install();
  await viewer.page.clock.pauseAt(Date.now() + 60_000);
  for (let i = 0; i < 2; i++) {
    await viewer.page.keyboard.press("i");
    await viewer.page.clock.runFor(50);
  }
  assert.equal(await viewer.page.evaluate(() => document.documentElement.dataset.detail), "coarse");
  const coarse = await viewer.picture();
  assert.ok(isWhite(coarse.at(dot)) && column.some((pixel) => isWhite(coarse.at(pixel))),
    "source and path are seen over the coarse faces");
  for (const pixel of places) {
    assert.ok(!isGrey(coarse.at(pixel)), "coarse faces are coloured");
    assert.ok(apart(coarse.at(pixel), whole.at(pixel)) < 30, `${coarse.at(pixel)} ${whole.at(pixel)}`);
  }
  await viewer.page.clock.resume();
  await viewer.settled();
  const again = await viewer.picture();
  for (const pixel of places) assert.deepEqual(again.at(pixel), whole.at(pixel), "all faces are drawn again");

  await viewer.click(-0.3, 0.1);
  await viewer.page.waitForSelector("#paths li");
  assert.ok(Math.abs(parseFloat(await viewer.text("#paths li")) - value) < 1e-6 * value);
  assert.deepEqual(viewer.errors, []);
});

test("a large field is shown nearly right until it is there exactly", async (t) => {
  const viewer = await largeSphere(t);
  const asked = [];
  await viewer.page.route("**/ComputeField", (route) => {
    // The exact field is the second that is asked for. It has to wait.
    if (asked.push(route) !== 2) void route.continue();
  });
  await viewer.click(0.3, 0.2);
  await viewer.waitForText("#figures", "within 0.1 %");
  await viewer.swept();
  assert.equal(await viewer.page.evaluate(() => document.documentElement.dataset.sweep), "preview");
  assert.ok(!isGrey((await viewer.picture()).at(await viewer.at(-0.8, -0.2))), "all is coloured");
  await viewer.move(-0.3, 0.1);
  assert.ok((await viewer.exactValue()) > 0.5, "paths are exact meanwhile");
  await viewer.page.locator("#save-npy").evaluate((button) => button.click());
  await viewer.waitForText("#notice-text", "exact field is still on its way");

  await asked[1].continue();
  await viewer.solved();
  assert.doesNotMatch(await viewer.text("#figures"), /within|≈/);
  const npy = (await viewer.save("#save-npy")).bytes;
  const head = npy.readUInt16LE(8) + 10;
  const distances = new Float64Array(npy.buffer.slice(npy.byteOffset + head, npy.byteOffset + npy.length));
  await viewer.page.locator("#copy-command").evaluate((button) => button.click());
  const answer = ask(server, t, LARGE_SPHERE, (await viewer.text("#question-text")).split("\n")[0]);
  assert.equal(answer.certified_error, null);
  assert.equal(distances.reduce((most, distance) => Math.max(most, distance)), answer.largest_distance);
  assert.deepEqual(viewer.errors, []);
});

test("who clicks elsewhere waits for neither of the fields before", async (t) => {
  const viewer = await largeSphere(t);
  const asked = [];
  const stopped = [];
  viewer.page.on("requestfailed", (request) => stopped.push(request));
  // The first field within 0.1 %, and the exact one of the second click, never come.
  await viewer.page.route("**/ComputeField", (route) => {
    if (![1, 3].includes(asked.push(route))) void route.continue();
  });
  await viewer.click(0.3, 0.2);
  await until(() => asked.length === 1);
  await viewer.page.keyboard.press("s");
  await viewer.click(-0.3, 0.2);
  await until(() => asked.length === 3);
  await viewer.page.keyboard.press("s");
  await viewer.click(0, 0.4);
  await viewer.solved();
  assert.equal(asked.length, 5);
  for (const route of [asked[0], asked[2]]) assert.ok(stopped.includes(route.request()), "it was cancelled");
  assert.deepEqual(viewer.errors, []);
});

test("huge coordinates have values under the cursor, and names that look like options are files", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  await viewer.drop("-o.off", TWO_SQUARES.replaceAll(/^(-?[\d.]+) (-?0\.5) 0$/gm, "$1e200 $2e200 0"));
  await viewer.shown("-o.off");
  await viewer.click(-0.4, 0);
  await viewer.solved();
  await viewer.move(-0.3, 0.1);
  const value = await viewer.exactValue();
  assert.ok(value > 1e198 && value < 1e201, `${value}`);
  await viewer.page.locator("#copy-command").evaluate((button) => button.click());
  assert.match(await viewer.text("#question-text"), /^geodesic field \.\/-o\.off /);
  assert.deepEqual(viewer.errors, []);
});

test("a bad file is refused in words", async (t) => {
  const viewer = await sphere(t);
  await viewer.drop("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  await viewer.waitForText("#notice-text", "bad.obj: ");
  await viewer.waitForText("#notice-text", "names vertex 9");
  await viewer.drop("notes.txt", "hello");
  await viewer.waitForText("#notice-text", "notes.txt is none");
  // What was there goes on.
  await viewer.click(0, 0);
  await viewer.solved();
  assert.deepEqual(viewer.errors, []);
});

test("what is dropped and not shown is told", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  await viewer.drop("two.off", TWO_SQUARES, "other.obj");
  await viewer.waitForText("#notice-text", "One mesh at a time is shown: two.off.");
  await viewer.drop("line.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n3 3 3\n3 0 1 2\n");
  await viewer.waitForText("#notice-text", "line.off: no face has an area");
  assert.deepEqual(viewer.errors, []);
});

test("messages stay in their box, and use the width there is", async (t) => {
  for (const width of [320, 375, 768, 1000]) {
    const viewer = await openPage(browser, server.url, { viewport: { width, height: 640 } });
    t.after(() => viewer.close());
    await viewer.drop(`${"holiday_picture_".repeat(12)}.jpeg`, "");
    await viewer.waitForText("#notice-text", "holiday");
    const [stage, notice] = await viewer.page.evaluate(() => ["stage", "notice"].map((id) => {
      const { left, right } = document.getElementById(id).getBoundingClientRect();
      return { left, right, inside: document.getElementById(id).scrollWidth <= document.getElementById(id).clientWidth };
    }));
    assert.ok(notice.inside && notice.left >= stage.left && notice.right <= stage.right, `${width}: nothing juts out`);
    assert.ok(notice.right - notice.left > 0.8 * (stage.right - stage.left), `${width}: it is as wide as it may be`);
  }
});

test("a double click keeps no path", async (t) => {
  const viewer = await sphere(t);
  const answered = viewer.page.waitForResponse((response) => response.url().endsWith("/ComputePaths"));
  await viewer.page.mouse.dblclick(...(await viewer.at(0, 0)));
  await answered;
  await viewer.solved();
  await viewer.click(0.4, 0.1);
  await viewer.page.waitForSelector("#paths li");
  assert.equal(await viewer.page.locator("#paths li").count(), 1);
  assert.ok(parseFloat(await viewer.text("#paths li")) > 0.3);
  assert.deepEqual(viewer.errors, []);
});

test("a choice that is none, and counts and places that are none, are no questions", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  const calls = [];
  viewer.page.on("request", (request) => calls.push(request.url().split("/").pop()));
  const digest = await viewer.page.locator("#meshes").inputValue();
  await viewer.page.selectOption("#meshes", "");
  assert.equal(await viewer.page.locator("#meshes").inputValue(), digest);
  await viewer.page.locator("#sample-count").evaluate((input) => input.closest("details").open = true);
  for (const count of ["-5", "0", "2.5", ""]) {
    await viewer.page.fill("#sample-count", count);
    await viewer.page.click("#sample");
  }
  assert.ok(await viewer.page.locator("#notice").isHidden());
  await viewer.page.evaluate(() => (location.hash += "&source=99999999"));
  await viewer.waitForText("#notice-text", "no place of this mesh");
  // The source that is one is asked for.
  await viewer.solved();
  // Paths are asked for under a cursor that rests, whenever it has rested for long enough.
  assert.deepEqual(new Set(calls.filter((call) => call !== "ComputePaths")), new Set(["ComputeField"]));
  assert.deepEqual(viewer.errors, []);
});

test("a server that is full is asked again", async (t) => {
  const full = await startServer("--threads", "1", "--limit", "max-queued-jobs=0");
  t.after(() => full.stop());
  const viewer = await openPage(browser, full.url);
  t.after(() => viewer.close());
  await viewer.drop("sphere.obj", SPHERE);
  await viewer.shown("sphere.obj");
  // Thousands of rows: work for minutes, until it is stopped.
  const folder = temporaryFolder(t);
  writeFileSync(join(folder, "other.obj"), sphereObj(50));
  writeFileSync(join(folder, "rows.txt"), Array.from({ length: 10_000 }, (_, i) => `${i}\n`).join(""));
  const matrix = spawn(process.env.GEODESIC, ["--server", `127.0.0.1:${full.grpcPort}`, "matrix", "other.obj",
    "--sources", "rows.txt", "-o", "m.npy"], { cwd: folder, stdio: "ignore" });
  const ended = new Promise((resolve) => matrix.on("exit", resolve));
  t.after(() => matrix.kill());
  // A slow machine may miss a hint, which is shown for two seconds: it is written down.
  await viewer.page.evaluate(() => {
    const notice = document.getElementById("notice-text");
    new MutationObserver(() => {
      if (notice.textContent.includes("asks again")) window.asksAgain = true;
    }).observe(notice, { childList: true });
  });
  // Between two rows there is room for a moment, and what was solved is not refused:
  // other places are clicked until one is.
  let clicks = 0;
  await until(async () => {
    await viewer.page.keyboard.press("s");
    await viewer.click(0.5 * Math.sin(clicks++), 0);
    await viewer.page.waitForFunction(() => window.asksAgain || document.documentElement.dataset.sweep === "done");
    return viewer.page.evaluate(() => window.asksAgain);
  });
  matrix.kill();
  await ended;
  await viewer.solved();
  assert.deepEqual(viewer.errors, []);
});

test("a browser that cannot draw says so", async (t) => {
  const blind = await launch(DRAWS_NOTHING);
  t.after(() => blind.close());
  const viewer = await openPage(blind, server.url);
  await viewer.waitForText("#notice-text", "no WebGL 2");
});

test("a picture that the graphics processor lost comes back", async (t) => {
  const viewer = await sphere(t);
  await viewer.click(0, 0);
  await viewer.solved();
  await viewer.settled();
  const places = await Promise.all([[0.3, 0.3], [-0.6, 0.2], [0, 0], [1.05, 0]].map(([x, y]) => viewer.at(x, y)));
  const colours = (picture) => JSON.stringify(places.map((place) => picture.at(place)));
  const before = colours(await viewer.picture());
  const whenLost = viewer.page.evaluate(() => {
    const canvas = document.getElementById("picture");
    window.context = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const lost = new Promise((resolve) => canvas.addEventListener("webglcontextlost", resolve, { once: true }));
    window.context.loseContext();
    return lost.then(() => undefined);
  });
  await whenLost;
  await viewer.waitForText("#notice-text", "The graphics processor is away.");
  await viewer.page.evaluate(() => window.context.restoreContext());
  await viewer.page.waitForFunction(() => document.getElementById("notice").hidden);
  assert.equal(colours(await viewer.pictureOnce((picture) => colours(picture) === before)), before);
  assert.deepEqual(viewer.errors, []);
});

test("a list of meshes that fails late takes nothing off the mesh that is shown", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  // The list that the page begins with is there.
  await viewer.page.waitForSelector("#meshes option", { state: "attached" });
  let fail;
  const listed = new Promise((resolve) => {
    viewer.page.route("**/ListMeshes", (route) => {
      fail = () => route.abort();
      resolve();
    }, { times: 1 });
  });
  await viewer.drop("sphere.obj", SPHERE);
  await viewer.shown("sphere.obj");
  await viewer.click(0, 0);
  await viewer.solved();
  await listed;
  const again = viewer.page.waitForResponse((response) => response.url().endsWith("/ListMeshes"));
  await fail();
  await again;
  await viewer.solved();
  assert.match(await viewer.address(), /source=/);
  assert.equal(await viewer.text("#mesh-name"), "sphere.obj");
  assert.deepEqual(viewer.errors, []);
});

test("a token is asked for, refused, and taken", async (t) => {
  const guarded = await startGuarded(t);
  const viewer = await openPage(browser, guarded.url);
  t.after(() => viewer.close());
  await viewer.page.waitForSelector("#token-dialog[open]");
  await viewer.page.fill("#token", "wrong-token");
  await viewer.page.keyboard.press("Enter");
  await viewer.waitForText("#token-reason", "not known");
  await viewer.page.waitForSelector("#token-dialog[open]");
  await viewer.page.fill("#token", "right-token");
  await viewer.page.keyboard.press("Enter");
  await viewer.page.waitForSelector("#token-dialog:not([open])", { state: "attached" });
  await viewer.drop("sphere.obj", SPHERE);
  await viewer.shown("sphere.obj");

  const pasted = await openPage(browser, guarded.url);
  t.after(() => pasted.close());
  await pasted.page.waitForSelector("#token-dialog[open]");
  for (const token of ["", "right tok\u00e9n", "\u2019right-token"]) {
    await pasted.page.fill("#token", token);
    await pasted.page.keyboard.press("Enter");
    assert.ok(await pasted.page.locator("#token-dialog[open]").isVisible(), `"${token}" is no token`);
  }
  await pasted.page.evaluate(() => (location.hash = "token=%C3%A9"));
  await pasted.waitForText("#notice-text", "The token in the address is none");
  await pasted.page.evaluate(() => (location.hash = "token=right-token"));
  await pasted.page.waitForSelector("#token-dialog:not([open])", { state: "attached" });
  assert.ok(!pasted.page.url().includes("right-token"), "the address does not keep the token");
  await pasted.drop("sphere.obj", SPHERE);
  await pasted.shown("sphere.obj");

  const invited = await openPage(browser, `${guarded.url}/#token=right-token`);
  t.after(() => invited.close());
  await invited.drop("sphere.obj", SPHERE);
  await invited.shown("sphere.obj");
  assert.ok(!invited.page.url().includes("right-token"), "the address does not keep the token");
  assert.deepEqual([...viewer.errors, ...pasted.errors, ...invited.errors], []);
});

test("who gives no token is not asked again until it is wanted", async (t) => {
  const guarded = await startGuarded(t);
  const viewer = await openPage(browser, guarded.url);
  t.after(() => viewer.close());
  for (const decline of [() => viewer.page.keyboard.press("Escape"), () => viewer.page.click("#token-dialog >> text=Cancel")]) {
    await viewer.page.waitForSelector("#token-dialog[open]");
    await decline();
    await viewer.page.waitForSelector("#token-dialog:not([open])", { state: "attached" });
    const refused = viewer.page.waitForResponse((response) => response.url().endsWith("/FindMissingMeshes"));
    await viewer.drop("sphere.obj", SPHERE);
    await refused;
    await viewer.page.waitForFunction(() => document.getElementById("notice").dataset.kind === "error");
    assert.ok(!(await viewer.page.locator("#token-dialog[open]").isVisible()));
    await viewer.page.click("#notice-action");
  }
  await viewer.page.fill("#token", "right-token");
  await viewer.page.keyboard.press("Enter");
  await viewer.shown("sphere.obj");
  assert.deepEqual(viewer.errors, []);
});

test("keys alone place sources and keep paths", async (t) => {
  const viewer = await sphere(t);
  await viewer.page.keyboard.press("Enter");
  await viewer.page.waitForSelector("#aim");
  await viewer.page.keyboard.press("Enter");
  await viewer.solved();
  const address = await viewer.address();
  for (let i = 0; i < 9; i++) await viewer.page.keyboard.press("Shift+ArrowRight");
  for (let i = 0; i < 5; i++) await viewer.page.keyboard.press("Shift+ArrowUp");
  await viewer.page.keyboard.press("Enter");
  await viewer.page.waitForSelector("#paths li");
  const distance = parseFloat(await viewer.text("#paths li"));
  // The values of the places on the way there may come and go before.
  await until(async () => Math.abs((await viewer.exactValue()) - distance) < 1e-6);
  await viewer.page.keyboard.press("Shift+Enter");
  await viewer.waitForText("#source-count", "2 sources");

  const mouse = await sphere(t);
  await mouse.click(0, 0);
  await mouse.solved();
  assert.equal(await mouse.address(), address);
  assert.ok(!(await mouse.page.locator("#aim").isVisible()));
  const [x, y] = await mouse.at(0, 0);
  await mouse.page.mouse.move(x + 9 * 12, y - 5 * 12);
  assert.ok(Math.abs((await mouse.exactValue()) - distance) < 1e-6);
  assert.deepEqual([...viewer.errors, ...mouse.errors], []);
});

test("an address holds curves and the radius, and its question is one for the command", async (t) => {
  const first = await sphere(t);
  await first.page.keyboard.press("c");
  await first.move(-0.4, 0.3);
  await first.page.mouse.down();
  for (let i = 1; i <= 12; i++) await first.move(-0.4 + (0.8 * i) / 12, 0.3);
  await first.page.mouse.up();
  await first.solved();
  await first.page.fill("#radius", "400");
  const radius = await first.text("#radius-value");

  const second = await openPage(browser, await first.address());
  t.after(() => second.close());
  await second.solved();
  assert.equal(await second.address(), await first.address());
  assert.equal(await second.text("#source-count"), "1 source");
  assert.equal(await second.text("#radius-value"), radius);
  // Somebody who opens a link looks at its sources, and moves none by a click.
  await second.click(0.2, 0.1);
  await second.page.waitForSelector("#paths li");
  await second.page.locator("#copy-command").evaluate((button) => button.click());
  const [command] = (await second.text("#question-text")).split("\n");
  assert.match(command, /^geodesic --server 127\.0\.0\.1:PORT field [0-9a-f]{64} --curve .* --radius /);
  const folder = temporaryFolder(t);
  execFileSync("sh", ["-c", command.replace("geodesic", '"$GEODESIC"').replace("PORT", server.grpcPort)], { cwd: folder });
  assert.equal(readFileSync(join(folder, "field.npy")).compare((await second.save("#save-npy")).bytes), 0);
  await second.page.locator("#copy-python").evaluate((button) => button.click());
  assert.match(await second.text("#question-text"), /^mesh = geodesic\.connect\("127\.0\.0\.1:PORT"\)\.open\("[0-9a-f]{64}"\)$/m);

  await second.page.evaluate(() => (location.hash = location.hash.replace(/radius=[^&]*/, "radius=far")));
  await second.waitForText("#notice-text", "names a radius that is no length");
  assert.deepEqual([...first.errors, ...second.errors], []);
});

test("an address with a mesh and a source shows them; keys and themes work", async (t) => {
  const first = await sphere(t);
  await first.click(0.2, 0.2);
  await first.solved();
  const farthest = await first.text("#figures dd");
  const second = await openPage(browser, await first.address(), { colorScheme: "dark" });
  t.after(() => second.close());
  await second.solved();
  assert.equal(await second.text("#figures dd"), farthest);
  // An address that is pasted into an open page, one that says nothing, and back.
  const sphereAddress = await first.address();
  await first.drop("two.off", TWO_SQUARES);
  await first.shown("two.off");
  await first.page.evaluate((url) => (location.href = url), sphereAddress);
  await first.shown("sphere.obj");
  await first.solved();
  assert.equal(await first.text("#figures dd"), farthest);
  await first.page.evaluate(() => (location.hash = "mesh=nonsense"));
  await first.waitForText("#notice-text", "names no mesh");
  await first.page.goBack();
  await first.solved();
  assert.equal(await first.text("#figures dd"), farthest);

  const corner = await second.at(-1.1, 0.95);
  assert.ok(Math.max(...(await second.picture()).at(corner)) < 60, "dark where the system is");
  await second.page.keyboard.press("t");
  assert.ok(Math.min(...(await second.picture()).at(corner)) > 200, "light when wished");
  await second.page.click("#clear");
  await second.waitForText("#source-count", "no source");
  assert.deepEqual([...first.errors, ...second.errors], []);
});
