// The server goes away, comes back without its meshes, or cannot be reached rightly:
// what the page does by itself, and what it says.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { launch, openPage } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { sphereObj, TWO_SQUARES } from "./meshes.mjs";
import { startProxy } from "./proxy.mjs";
import { startServer, startServerOn } from "./server.mjs";

const SPHERE = sphereObj(24);

let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

/** A page of a server of its own, which shows the sphere; `restart` and `stop` are the server's. */
async function sphere(t) {
  let own = await startServer();
  t.after(() => own.stop());
  const viewer = await openPage(browser, own.url);
  t.after(() => viewer.close());
  await viewer.drop("sphere.obj", SPHERE);
  await viewer.shown("sphere.obj");
  const calls = [];
  viewer.page.on("request", (request) => calls.push(request.url().split("/").pop()));
  const start = async () => (own = await startServerOn(own.port));
  return {
    viewer,
    calls,
    grpcPort: own.grpcPort,
    stop: () => own.stop(),
    start,
    restart: () => own.stop().then(start),
  };
}

/** Puts the mesh into the server, without the page; returns its digest. */
function upload(grpcPort, t, name, mesh) {
  const folder = temporaryFolder(t);
  writeFileSync(join(folder, name), mesh);
  const answer = execFileSync(
    process.env.GEODESIC, ["--server", `127.0.0.1:${grpcPort}`, "--json", "upload", name], { cwd: folder, encoding: "utf8" });
  return answer.match(/[0-9a-f]{64}/)[0];
}

/** The address of a mesh, in the page's tab. */
const go = (viewer, digest) => viewer.page.evaluate((digest) => (location.hash = `mesh=${digest}`), digest);

test("the page goes on when the server is back, without its meshes", async (t) => {
  const { viewer, stop, start } = await sphere(t);
  await stop();
  await viewer.click(0, 0);
  await viewer.waitForText("#notice-text", "The server does not answer");
  // A path that failed, too, is not asked in the field's place.
  const failed = viewer.page.waitForEvent("requestfailed", (request) => request.url().endsWith("/ComputePaths"));
  await viewer.move(0.3, 0.2);
  await failed;
  await start();
  await viewer.solved();
  await viewer.move(0.2, 0.2);
  await viewer.exactValue();
  assert.deepEqual(viewer.errors, []);
});

test("a lost mesh is not made up for by the file of another one", async (t) => {
  const { viewer, calls, grpcPort, restart } = await sphere(t);
  const first = await viewer.page.locator("#mesh-name").getAttribute("title");
  const other = upload(grpcPort, t, "two.off", TWO_SQUARES);
  await go(viewer, other);
  await viewer.shown(other.slice(0, 8));
  await restart();
  calls.length = 0;
  await viewer.click(-0.4, 0);
  await viewer.waitForText("#notice-text", "has lost this mesh. Drop its file here again.");
  const refused = viewer.page.waitForResponse((response) => response.url().endsWith("/ComputeField"));
  await viewer.page.keyboard.press("s");
  await viewer.click(-0.5, 0.1);
  await refused;
  // The mesh whose file the page has comes back.
  await go(viewer, first);
  await viewer.shown("sphere.obj");
  await viewer.click(0, 0);
  await viewer.solved();
  assert.equal(calls.filter((call) => call === "CreateMesh").length, 1, "one file was sent, once");
  assert.equal(calls.filter((call) => call === "ComputeField").length, 3, "each click asked once");
  assert.deepEqual(viewer.errors, []);
});

test("a file that is dropped while the server is away is shown when it is back", async (t) => {
  const { viewer, calls, stop, start } = await sphere(t);
  await stop();
  await viewer.click(0, 0);
  await viewer.waitForText("#notice-text", "The server does not answer");
  const failed = viewer.page.waitForEvent("requestfailed", (request) => request.url().endsWith("/FindMissingMeshes"));
  await viewer.drop("two.off", TWO_SQUARES);
  await failed;
  await viewer.waitForText("#notice-text", "The server does not answer");
  await start();
  await viewer.shown("two.off");
  await viewer.click(-0.4, 0);
  await viewer.solved();
  assert.equal(await viewer.text("#mesh-name"), "two.off");
  assert.ok(calls.filter((call) => call === "CreateMesh").length <= 2, "each file was sent once at the most");
  assert.deepEqual(viewer.errors, []);
});

test("a file that is none takes nothing off the mesh that is shown", async (t) => {
  const { viewer, restart } = await sphere(t);
  await viewer.drop("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  await viewer.waitForText("#notice-text", "bad.obj: ");
  await restart();
  await viewer.click(0, 0);
  await viewer.solved();
  assert.deepEqual(viewer.errors, []);
});

/** A page behind a proxy of a server that allows the proxy's address, or not. */
async function behindProxy(t, isAllowed, maxBytes) {
  const target = {};
  const proxy = await startProxy(target, maxBytes);
  t.after(() => proxy.stop());
  const server = await startServer(...(isAllowed ? ["--web-allow-origin", proxy.url] : []));
  t.after(() => server.stop());
  Object.assign(target, { url: server.url, port: server.port });
  const viewer = await openPage(browser, proxy.url);
  t.after(() => viewer.close());
  return viewer;
}

test("a file that is too large for a proxy is sent once", async (t) => {
  const viewer = await behindProxy(t, true, 100_000);
  let sent = 0;
  viewer.page.on("request", (request) => (sent += request.url().endsWith("/CreateMesh") ? 1 : 0));
  await viewer.drop("sphere.obj", SPHERE);
  await viewer.waitForText("#notice-text", "sphere.obj: The server, or a proxy before it, refuses files of this size.");
  assert.equal(sent, 1);
  await viewer.drop("two.off", TWO_SQUARES);
  await viewer.shown("two.off");
  assert.deepEqual(viewer.errors, []);
});

test("an address that the server does not allow is told, and no token asked for", async (t) => {
  const viewer = await behindProxy(t, false);
  await viewer.waitForText("#notice-text", "its flag --web-allow-origin must name this address");
  assert.ok(await viewer.page.locator("#notice-action").isHidden());
  assert.ok(await viewer.page.locator("#token-dialog").isHidden());
});
