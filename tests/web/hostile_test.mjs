// Those who mean no good: malformed frames, slow requests, huge headers, half
// bodies, browsers that do not read. Raw sockets; the server must go on serving
// others, bounded in memory.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { connect as openSocket } from "node:net";
import { after, before, test } from "node:test";

import { create, toBinary } from "@bufbuild/protobuf";

import { connect, frame, message, upload, uploadFrames } from "./client.mjs";
import { asArrays, bumpyGrid, planarGrid } from "./grid.mjs";
import { startServer, until, writeTokens } from "./server.mjs";

// Short, so that what is late is late soon.
const PATIENCE = 2;

let server;
before(async () => { server = await startServer("--limit", `receive-seconds=${PATIENCE}`); });
after(() => server.stop());

/** A connection on which `text` was sent; `answer()` is what came until it ended. */
function send(text, port = server.port) {
  const socket = openSocket(port, "127.0.0.1");
  const pieces = [];
  socket.on("data", (piece) => pieces.push(piece));
  socket.on("error", () => {});
  const closed = new Promise((resolve) => { socket.on("close", resolve); });
  socket.write(text);
  return {
    socket, closed, pieces,
    received: () => Buffer.concat(pieces).toString("latin1"),
    answer: async () => {
      await closed;
      return Buffer.concat(pieces).toString("latin1");
    },
  };
}

const head = (method, headers = {}, type = "application/grpc-web+proto") => {
  const all = { host: "127.0.0.1", "content-type": type, ...headers };
  const path = method.includes(".") ? method : `geodesic.v1.${method}`;
  return `POST /${path} HTTP/1.1\r\n` +
      Object.entries(all).map(([name, value]) => `${name}: ${value}\r\n`).join("") + "\r\n";
};

/** The whole answer to one request with this body. */
async function call(method, body, type) {
  const bytes = Buffer.from(body, "latin1");
  const sent = send(Buffer.concat([
    Buffer.from(head(method, { "content-length": bytes.length, connection: "close" }, type)),
    bytes]));
  return sent.answer();
}

const isServing = async () =>
  assert.ok((await connect(server.url).CapabilitiesService.getCapabilities({})).version);

test("a header named by nothing but the ending of binary ones is text", async () => {
  const body = "\0\0\0\0\0";
  for (const value of ["AAAA", "", "\x01"]) {
    const sent = send(head("MeshService/GetMesh",
      { "content-length": body.length, connection: "close", "-bin": value }) + body);
    assert.match(await sent.answer(), /^HTTP\/1.1 (200|400)/);
    await isServing();
  }
});

test("malformed bodies are refused in words", async () => {
  const get = "MeshService/GetMesh";
  for (const [body, type, status, words] of [
    ["\x00\x00\x00", undefined, 3, /ends within a frame/],
    ["\x00\x00\x00\x00\x09abc", undefined, 3, /ends within a frame/],
    ["\x01\x00\x00\x00\x00", undefined, 12, /compressed/],
    ["\x80\x00\x00\x00\x00", undefined, 3, /no trailers/],
    ["\x40\x00\x00\x00\x00", undefined, 3, /unknown flags 64/],
    ["\x00\xff\xff\xff\xff", undefined, 8, /4294967295 bytes/],
    ["\x00\x00\x00\x00\x03\xff\xff\xff", undefined, 3, /grpc-message/],
    ["", undefined, 3, /no message/],
    ["!!!!", "application/grpc-web-text", 3, /not base64/],
    ["AAAA AAA=", "application/grpc-web-text", 3, /not base64/],
    ["AAAAAA", "application/grpc-web-text", 3, /ends within a frame/],
  ]) {
    const answer = await call(get, body, type);
    assert.match(answer, /^HTTP\/1\.1 200 /, body);
    const text = type ? Buffer.from(answer.split("\r\n\r\n")[1].split("\r\n")[1], "base64")
      .toString("latin1") : answer;
    assert.match(text, new RegExp(`grpc-status: ${status}\\r\\n`), JSON.stringify(body));
    assert.match(decodeURIComponent(text.replace(/%(?![0-9A-F]{2})/g, "%25")), words);
  }
  await isServing();
});

test("messages after the one that is asked for keep nobody waiting", async () => {
  const many = frame(Buffer.alloc(0)).toString("latin1").repeat(1000);
  const started = Date.now();
  for (const path of ["grpc.health.v1.Health/Check",
    "geodesic.v1.CapabilitiesService/GetCapabilities",
    "geodesic.v1.MeshService/GetMesh", "geodesic.v1.MeshService/ReadMesh",
    "geodesic.v1.MeshService/FindMissingMeshes"]) {
    for (const type of ["application/grpc-web+proto", "application/grpc-web-text"]) {
      const body = type.endsWith("text") ? Buffer.from(many, "latin1").toString("base64") : many;
      assert.match(await call(path, body, type), /^HTTP\/1\.1 200 [^]*\r\n0\r\n/, path);
    }
  }
  assert.ok(Date.now() - started < 1000 * PATIENCE, "some waited until their time was up");
  await isServing();
});

test("the text variant takes base64 in padded pieces", async () => {
  const request = frame(Buffer.from([0x0a, 3, 0x61, 0x62, 0x63]));
  const pieces = [request.subarray(0, 1), request.subarray(1, 5), request.subarray(5)];
  const body = pieces.map((piece) => piece.toString("base64")).join("");
  const answer = await call("MeshService/GetMesh", body, "application/grpc-web-text");
  const trailers = Buffer.from(answer.split("\r\n\r\n")[1].split("\r\n")[1], "base64");
  assert.match(trailers.toString("latin1"), /not "abc"/);
});

test("malformed HTTP is refused", async () => {
  for (const [request, status] of [
    [head("MeshService/GetMesh", { "grpc-timeout": "soon" }), 400],
    [head("MeshService/GetMesh", { "x-blob-bin": "*" }), 400],
    [head("MeshService/GetMesh", { "x-large": "a".repeat(20_000) }), 431],
    [head("MeshService/GetMesh", { "content-length": "99999999999999" }), 413],
    [head("../etc/passwd", { "content-length": 0 }), 404],
    ["GET / HTTP/1.1\r\n\r\n", 400],
    ["GET / HTTP/1.1\r\nhost: localhost\r\nHost: localhost\r\n\r\n", 400],
    [head("MeshService/GetMesh", { "content-length": 5, "transfer-encoding": "chunked" }), 400],
    [head("MeshService/GetMesh", { "content-length": 5, "Content-Length": 6 }), 400],
    ["GET /%00 HTTP/1.1\r\nhost: localhost\r\n\r\n", 404],
    ["GET /index.html%00.js HTTP/1.1\r\nhost: localhost\r\n\r\n", 404],
  ]) {
    const sent = send(request);
    await until(() => sent.received().includes("\r\n\r\n"));
    assert.match(sent.received(), new RegExp(`^HTTP/1\\.1 ${status} `), request.slice(0, 200));
    sent.socket.destroy();
  }
  // More than the server reads of a head.
  const huge = send(`GET / HTTP/1.1\r\nhost: localhost\r\nx: ${"a".repeat(200_000)}\r\n\r\n`);
  assert.match(await huge.answer(), /^(HTTP\/1\.1 431 .*)?/s);
  await isServing();
});

test("who sends a request byte by byte is cut off", async () => {
  const long = { "content-length": 1000 };
  const begun = frame(Buffer.alloc(900)).subarray(0, 5).toString("latin1");
  const slow = [
    "POST /geodesic.v1.MeshService/GetMesh HTTP/1.1\r\nx: ",
    head("MeshService/GetMesh", long) + begun,
    // gRPC itself would wait for ever for this one's message.
    head("MeshService/GetMesh", long)
      .replace("geodesic.v1.MeshService/GetMesh", "grpc.health.v1.Health/Check") + begun,
    // Refused at once; the rest of its body is awaited no longer than others'.
    `${head("MeshService/GetMesh", long)}@`,
  ].map((text) => send(Buffer.from(text, "latin1")));
  let drips = 0;
  const drip = setInterval(() => {
    ++drips;
    slow.forEach(({ socket }) => socket.write("a"));
  }, 100);
  await Promise.all(slow.map(({ closed }) => closed));
  clearInterval(drip);
  assert.ok(drips < 900, "none of them came to its end");
  await isServing();
});

test("who goes within a request's head keeps no connection", async () => {
  // One that waits for a minute before it cuts anybody off.
  const patient = await startServer("--limit", "receive-seconds=60");
  try {
    const before = performance.now();
    const gone = Array.from({ length: 20 }, () => {
      const one = send("GET / HTTP/1.1\r\nHost: loc", patient.port);
      one.socket.end();
      return one;
    });
    await Promise.all(gone.map(({ closed }) => closed));
    assert.ok(performance.now() - before < 30_000);
  } finally {
    await patient.stop();
  }
});

test("half a body that never goes on ends the call", async () => {
  const half = frame(Buffer.alloc(3_000_000)).subarray(0, 1_000_000);
  const sent = Array.from({ length: 20 }, () => {
    const one = send(head("MeshService/CreateMesh", { "content-length": 9_000_000 }));
    one.socket.write(half);
    return one;
  });
  await Promise.all(sent.map(({ closed }) => closed));
  await isServing();
});

test("a large upload is never in memory as a whole", async () => {
  // A stream that breaks its protocol at once: what follows is read and dropped.
  const before = residentBytes();
  const [first] = uploadFrames({ format: 2, sizeBytes: 5n }, Buffer.alloc(0));
  const count = 300;
  const chunk = frame(Buffer.alloc(1 << 20));
  const sent = send(head("MeshService/CreateMesh",
    { "content-length": first.length + count * chunk.length, connection: "close" }));
  sent.socket.write(first);
  for (let i = 0; i < count; ++i) {
    if (!sent.socket.write(chunk)) {
      await new Promise((resolve) => { sent.socket.once("drain", resolve); });
    }
  }
  assert.match(await sent.answer(), /grpc-status: 3/);
  assert.ok(residentBytes() - before < 100e6, `${residentBytes() - before} bytes more`);
});

function residentBytes(of = server) {
  const status = readFileSync(`/proc/${of.process.pid}/status`, "latin1");
  return 1024 * Number(status.match(/VmRSS:\s+(\d+) kB/)[1]);
}

test("calls leave nothing behind, however they end", { timeout: 240_000 }, async () => {
  const tokens = writeTokens({ ada: ["right-token", ["read", "upload"]] });
  const guarded = await startServer("--token-file", tokens.path);
  try {
    const small = asArrays(bumpyGrid(4));
    const uploaded = Buffer.concat(uploadFrames(small.header, small.bytes));
    const right = { authorization: "Bearer right-token" };
    const none = frame(Buffer.alloc(0));
    const kinds = {
      served: ["geodesic.v1.CapabilitiesService/GetCapabilities", none, right],
      "with a message too many": ["geodesic.v1.CapabilitiesService/GetCapabilities", Buffer.concat([none, none]), right],
      "without a token": ["geodesic.v1.CapabilitiesService/GetCapabilities", none, {}],
      "of no method": ["geodesic.v1.Nothing/Nothing", none, right],
      "without a message": ["geodesic.v1.MeshService/GetMesh", Buffer.alloc(0), right],
      malformed: ["geodesic.v1.MeshService/GetMesh", Buffer.from([0, 0, 0, 0, 9]), right],
      late: ["geodesic.v1.CapabilitiesService/GetCapabilities", none, { ...right, "grpc-timeout": "1n" }],
      uploaded: ["geodesic.v1.MeshService/CreateMesh", uploaded, right],
      "uploaded without a token": ["geodesic.v1.MeshService/CreateMesh", uploaded, {}],
    };
    for (const [kind, [path, body, headers]] of Object.entries(kinds)) {
      const ask = async (count) => {
        for (let i = 0; i < count; ++i) {
          const answer = await fetch(`${guarded.url}/${path}`, { method: "POST", body,
            headers: { "content-type": "application/grpc-web+proto", ...headers } });
          assert.equal(answer.status, 200);
          await answer.arrayBuffer();
        }
      };
      await ask(200);
      const before = residentBytes(guarded);
      await ask(1000);
      const more = residentBytes(guarded) - before;
      assert.ok(more < 10e6, `calls ${kind}: ${more} bytes more after 1000`);
    }
  } finally {
    await guarded.stop();
    tokens.remove();
  }
});

test("500 browsers that do not read harm nobody", { timeout: 240_000 }, async () => {
  const patient = await startServer();
  try {
    const { header, bytes } = asArrays(planarGrid(300));  // 4.3 MB
    const { mesh } = await upload(patient.url, header, bytes);
    const schema = message("ReadMeshRequest");
    const body = frame(toBinary(schema, create(schema, { digest: mesh.digest })));
    const request = Buffer.concat([
      Buffer.from(head("MeshService/ReadMesh", { "content-length": body.length })), body]);
    const before = residentBytes(patient);
    const stalled = Array.from({ length: 500 }, () => {
      const one = send(request, patient.port);
      one.socket.pause();
      return one;
    });
    await until(() => stalled.every(({ socket }) => socket.bytesWritten === request.length));
    // Others are served meanwhile, and whole.
    for (let i = 0; i < 50; ++i) {
      const small = asArrays(bumpyGrid(10 + i));
      assert.ok((await upload(patient.url, small.header, small.bytes)).mesh.digest);
    }
    const held = residentBytes(patient) - before;
    console.log(`# 500 stalled readers take ${Math.round(held / 1e6)} MB`);
    // A message of 512 KiB at the door, the next in the server and encoded, 64 KiB
    // of the connection, and change: less than two MB each.
    assert.ok(held < 500 * 2e6, `${Math.round(held / 1e6)} MB`);
    stalled.forEach(({ socket }) => socket.destroy());
    const ended = () => patient.log.filter((line) => line.includes("method=ReadMesh"));
    await until(() => ended().length === 500);
    assert.ok((await connect(patient.url).CapabilitiesService.getCapabilities({})).version);
  } finally {
    await patient.stop();
  }
});

test("who does not read an answer is cut off", async () => {
  const { header, bytes } = asArrays(planarGrid(700));  // 23 MB, more than sockets hold
  const { mesh } = await upload(server.url, header, bytes);
  const schema = message("ReadMeshRequest");
  const body = frame(toBinary(schema, create(schema, { digest: mesh.digest })));
  const one = send(Buffer.concat([
    Buffer.from(head("MeshService/ReadMesh",
      { "content-length": body.length, "x-request-id": "stalled-1" })), body]));
  one.socket.pause();
  await until(() => server.log.some(
    (line) => line.includes("id=stalled-1") && line.includes("code=CANCELLED")));
  one.socket.destroy();
});
