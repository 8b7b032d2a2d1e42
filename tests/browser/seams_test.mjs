// What the server joined when it read a mesh, and the choice to join otherwise.

import assert from "node:assert/strict";
import { test } from "node:test";

import { openPage } from "./browser.mjs";
import { browser, server, sphere, SPHERE } from "./setup.mjs";

/** A message of gRPC-Web, and that the call went well. */
function answer(message) {
  const frame = (flags, bytes) => {
    const head = Buffer.alloc(5, flags);
    head.writeUInt32BE(bytes.length, 1);
    return Buffer.concat([head, bytes]);
  };
  return {
    contentType: "application/grpc-web+proto",
    body: Buffer.concat([frame(0, message), frame(0x80, Buffer.from("grpc-status: 0\r\n"))]),
  };
}

/** A field of a message: bytes that are shorter than 128, or a double. */
const bytesField = (number, bytes) =>
  Buffer.concat([Buffer.from(number < 16 ? [8 * number + 2] : [(8 * number + 2) % 128 + 128, number >> 4]), Buffer.from([bytes.length]), bytes]);
function doubleField(number, value) {
  const field = Buffer.alloc(9, 8 * number + 1);
  field.writeDoubleLE(value, 1);
  return field;
}
const trueField = (number) => Buffer.from([8 * number, 1]);

test("the notes about a mesh are shown", async (t) => {
  const viewer = await openPage(browser, server.url);
  t.after(() => viewer.close());
  const notes = ["12 edges were joined.", "2 faces name a vertex twice & were left out."];
  await viewer.page.route("**/GetMesh", (route) =>
    route.fulfill(answer(bytesField(1, Buffer.concat(notes.map((note) => bytesField(24, Buffer.from(note))))))), { times: 1 });
  await viewer.drop("sphere.obj", SPHERE);
  await viewer.shown("sphere.obj");
  assert.deepEqual(await viewer.page.locator("#mesh-notes li").allTextContents(), notes);
  // Those of the mesh that is shown: this one has none.
  await viewer.drop("other.obj", `${SPHERE}v 2 2 2\n`);
  await viewer.shown("other.obj");
  assert.ok(await viewer.page.locator("#mesh-notes").isHidden());
  assert.deepEqual(viewer.errors, []);
});

test("a file is sent anew to be joined within a distance, or not at all", async (t) => {
  const viewer = await sphere(t);
  await viewer.page.evaluate(() => {
    window.sent = [];
    const { send } = XMLHttpRequest.prototype;
    XMLHttpRequest.prototype.send = function (body) {
      window.sent.push(body.slice(0, 200).arrayBuffer());
      send.call(this, body);
    };
  });
  // As if the server did not know the file, read so.
  const asked = [];
  await viewer.page.route("**/FindMissingMeshes", (route) => {
    asked.push(route.request().postDataBuffer());
    void route.fulfill(answer(Buffer.alloc(0)));
  });
  await viewer.click(0, 0);
  await viewer.solved();
  const address = await viewer.address();
  const readAs = async (choice, distance) => {
    await viewer.page.selectOption("#join", choice);
    if (distance) await viewer.page.fill("#join-distance", distance);
    await viewer.page.click("#join-again");
    // Nothing of a closed sphere is joined.
    await viewer.waitForText("#notice-text", "It is the same mesh");
    assert.equal(await viewer.page.inputValue("#join"), choice);
    await viewer.page.click("#notice-close");
    const head = await viewer.page.evaluate(async () => [...new Uint8Array(await window.sent.at(-1))]);
    return { file: asked.at(-1), header: Buffer.from(head) };
  };
  const within = await readAs("distance", "0.25");
  assert.ok(within.file.includes(doubleField(3, 0.25)));
  assert.ok(within.header.includes(doubleField(6, 0.25)));
  const none = await readAs("none");
  assert.ok(none.file.subarray(-2).equals(trueField(4)));
  assert.ok(none.header.includes(trueField(7)) && !none.header.includes(doubleField(6, 0.25)));
  const usual = await readAs("rounding");
  assert.ok(!usual.file.includes(doubleField(3, 0.25)) && !usual.file.subarray(-2).equals(trueField(4)));

  // A distance that is none is no question.
  await viewer.page.selectOption("#join", "distance");
  await viewer.page.fill("#join-distance", "-1");
  await viewer.page.click("#join-again");
  assert.equal(asked.length, 3);
  assert.equal(await viewer.address(), address, "what was asked of the mesh stays");

  // A page without the file cannot send it.
  const linked = await openPage(browser, address);
  t.after(() => linked.close());
  await linked.solved();
  assert.ok(await linked.page.locator("#joining").isHidden());
  assert.deepEqual([...viewer.errors, ...linked.errors], []);
});
