// How calls end other than well: cancelled, late, refused; and other origins.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { request as httpRequest } from "node:http";
import { request as httpsRequest } from "node:https";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { Code, ConnectError } from "@connectrpc/connect";

import { create, toBinary } from "@bufbuild/protobuf";

import { all, connect, detail, frame, message, upload } from "./client.mjs";
import { asArrays, bumpyGrid, planarGrid } from "./grid.mjs";
import { startServer, until, writeTokens } from "./server.mjs";

const vertex = (number) => ({ place: { case: "vertex", value: BigInt(number) } });
const from = (number) => ({ ...vertex(number), offset: 0 });

let server;
const origin = "https://geo.example.org";
before(async () => { server = await startServer("--web-allow-origin", origin); });
after(() => server.stop());

async function uploadGrid(url, grid, options) {
  const { header, bytes } = asArrays(grid);
  return (await upload(url, header, bytes, options)).mesh.digest;
}

/** The ConnectError that a promise fails with. */
async function failure(promise) {
  const error = await promise.then(() => undefined, (reason) => reason);
  assert.ok(error instanceof ConnectError, `no ConnectError: ${error}`);
  return error;
}

const logged = (text) => server.log.some((line) => line.includes(text));

// Work for minutes: a row for every vertex, each a search of its own.
function longMatrix(digest) {
  return {
    meshDigest: digest,
    sources: Array.from({ length: 1000 }, (_, i) => from(i)),
  };
}

test("a call is cancelled when its fetch is aborted", async () => {
  const digest = await uploadGrid(server.url, bumpyGrid(150));
  const clients = connect(server.url);
  const stop = new AbortController();
  const error = await failure((async () => {
    for await (const answer of clients.QuestionService.computeMatrix(
      longMatrix(digest), { signal: stop.signal })) {
      if (answer.blocks.length) stop.abort();
    }
  })());
  assert.equal(error.code, Code.Canceled);
  await until(() => logged("method=ComputeMatrix code=CANCELLED"));
});

test("a call is cancelled when its browser goes without a word", async () => {
  const digest = await uploadGrid(server.url, bumpyGrid(151));
  const schema = message("ComputeMatrixRequest");
  const body = frame(toBinary(schema, create(schema, longMatrix(digest))));
  const request = httpRequest({
    port: server.port,
    path: "/geodesic.v1.QuestionService/ComputeMatrix",
    method: "POST",
    headers: { "content-type": "application/grpc-web+proto", "x-request-id": "gone-1" },
  });
  request.on("error", () => {});
  const answered = new Promise((resolve) => { request.on("response", resolve); });
  request.end(body);
  await answered;
  request.destroy();
  await until(() => server.log.some(
    (line) => line.includes("code=CANCELLED") && line.includes("id=gone-1")));
});

test("a deadline ends a call", async () => {
  const digest = await uploadGrid(server.url, bumpyGrid(152));
  const error = await failure(all(connect(server.url).QuestionService.computeMatrix(
    longMatrix(digest), { timeoutMs: 300 })));
  assert.equal(error.code, Code.DeadlineExceeded);
  // The server's own clock stops the work, not only the client's.
  await until(() => logged("method=ComputeMatrix code=DEADLINE_EXCEEDED") ||
                    logged("method=ComputeMatrix code=CANCELLED"));
});

test("errors carry their details", async () => {
  const clients = connect(server.url);
  const malformed = await failure(clients.MeshService.getMesh({ digest: "no digest" }));
  assert.equal(malformed.code, Code.InvalidArgument);
  const [bad] = malformed.findDetails(detail("BadRequest"));
  assert.equal(bad.fieldViolations[0].field, "digest");
  assert.equal(malformed.findDetails(detail("ErrorInfo"))[0].domain, "geodesic.v1");
  assert.match(malformed.metadata.get("x-request-id"), /^[0-9a-f]{16}$/);

  const absent = await failure(clients.MeshService.getMesh({ digest: "0".repeat(64) }));
  assert.equal(absent.code, Code.NotFound);
  assert.equal(absent.findDetails(detail("ResourceInfo"))[0].resourceName, "0".repeat(64));
});

test("errors that the door finds carry theirs, too", async () => {
  for (const [body, code, reason] of [
    [frame(Buffer.alloc(0), 1), Code.Unimplemented, "UNIMPLEMENTED"],
    [frame(Buffer.alloc(9)).subarray(0, 7), Code.InvalidArgument, "INVALID_REQUEST"],
    [Buffer.from([0, 255, 255, 255, 255]), Code.ResourceExhausted, "LIMIT_EXCEEDED"],
  ]) {
    const clients = connect(server.url, { fetch: (url, init) => fetch(url, { ...init, body }) });
    const error = await failure(clients.MeshService.getMesh({}));
    assert.equal(error.code, code);
    const [info] = error.findDetails(detail("ErrorInfo"));
    assert.deepEqual([info?.domain, info?.reason], ["geodesic.v1", reason]);
  }
});

test("a message beyond ASCII comes through", async () => {
  const error = await failure(connect(server.url).MeshService.getMesh({ digest: "Größe 100 %" }));
  assert.match(error.rawMessage, /Gr/);
  assert.match(error.rawMessage, /100 %/);
});

test("a method that does not exist is named", async () => {
  const response = await fetch(`${server.url}/geodesic.v1.MeshService/Nothing`, {
    method: "POST", headers: { "content-type": "application/grpc-web+proto" },
    body: new Uint8Array(5),
  });
  assert.equal(response.status, 200);
  assert.match(await response.text(), /grpc-status: 12/);
});

test("the browser's address is in the log, and nobody may say another", async () => {
  await connect(server.url).CapabilitiesService.getCapabilities({}, {
    headers: { "x-request-id": "address-1", "geodesicd-door-peer": "ipv4:10.0.0.1:1" },
  });
  await until(() => logged("id=address-1"));
  const line = server.log.find((text) => text.includes("id=address-1"));
  assert.match(line, / peer=ipv4:127\.0\.0\.1:\d+ /);
});

test("tokens are asked for as on the other port", async () => {
  const tokens = writeTokens(
    { reader: ["read-me", ["read"]], writer: ["write-me", ["read", "upload"]] });
  const guarded = await startServer("--token-file", tokens.path);
  try {
    const clients = connect(guarded.url);
    const ask = (token) => clients.CapabilitiesService.getCapabilities(
      {}, token && { headers: { authorization: `Bearer ${token}` } });
    assert.equal((await failure(ask())).code, Code.Unauthenticated);
    assert.equal((await failure(ask("guess"))).code, Code.Unauthenticated);
    assert.ok((await ask("read-me")).version);
    const asWriter = { headers: { authorization: "Bearer write-me" } };
    const asReader = { headers: { authorization: "Bearer read-me" } };
    const denied = await failure(uploadGrid(guarded.url, planarGrid(100), asReader));
    assert.equal(denied.code, Code.PermissionDenied);
    assert.ok(await uploadGrid(guarded.url, planarGrid(100), asWriter));
    assert.ok(!guarded.log.some((line) => line.includes("write-me")));
  } finally {
    await guarded.stop();
    tokens.remove();
  }
});

test("the door may have tokens of its own", async () => {
  const tokens = writeTokens({ page: ["page-token", ["admin"]] });
  const guarded = await startServer("--web-token-file", tokens.path);
  try {
    const clients = connect(guarded.url);
    assert.equal((await failure(clients.MeshService.listMeshes({}))).code,
      Code.Unauthenticated);
    const { meshes } = await clients.MeshService.listMeshes(
      {}, { headers: { authorization: "Bearer page-token" } });
    assert.deepEqual(meshes, []);
  } finally {
    await guarded.stop();
    tokens.remove();
  }
});

test("a client's quota holds at the door", async () => {
  const tokens = writeTokens({ slow: ["slow-token", ["read"]] },
    { slow: { requests_per_second: 0.001, burst: 1 } });
  const guarded = await startServer("--token-file", tokens.path);
  try {
    const ask = () => connect(guarded.url).CapabilitiesService.getCapabilities(
      {}, { headers: { authorization: "Bearer slow-token" } });
    await ask();
    const error = await failure(ask());
    assert.equal(error.code, Code.ResourceExhausted);
    assert.equal(error.findDetails(detail("QuotaFailure")).length, 1);
  } finally {
    await guarded.stop();
    tokens.remove();
  }
});

const method = "/geodesic.v1.CapabilitiesService/GetCapabilities";
const callHeaders = { "content-type": "application/grpc-web+proto" };
// fetch() of node leaves Origin and Host to the browser it is not.
function http(options, body) {
  return new Promise((resolve, reject) => {
    const request = httpRequest({ host: "127.0.0.1", port: server.port, path: method, method: "POST", ...options },
      (response) => {
        const pieces = [];
        response.on("data", (piece) => pieces.push(piece));
        response.on("end", () => resolve({
          status: response.statusCode, headers: response.headers,
          text: Buffer.concat(pieces).toString("latin1"),
        }));
      });
    request.on("error", reject);
    request.end(body);
  });
}

test("pages of an allowed origin may call", async () => {
  const preflight = await http({
    method: "OPTIONS",
    headers: {
      origin, "access-control-request-method": "POST",
      "access-control-request-headers": "authorization,content-type,x-grpc-web",
    },
  });
  assert.equal(preflight.status, 204);
  assert.equal(preflight.headers["access-control-allow-origin"], origin);
  assert.equal(preflight.headers["access-control-allow-headers"],
    "authorization,content-type,x-grpc-web");
  const answer = await http({ headers: { origin, ...callHeaders } }, Buffer.alloc(5));
  assert.equal(answer.status, 200);
  assert.equal(answer.headers["access-control-allow-origin"], origin);
  assert.match(answer.headers["access-control-expose-headers"], /grpc-status-details-bin/);
  const own = await http({
    headers: { origin: server.url, ...callHeaders },
  }, Buffer.alloc(5));
  assert.equal(own.status, 200);
  assert.equal(own.headers["access-control-allow-origin"], undefined);
});

test("pages of other origins may not", async () => {
  for (const other of ["https://evil.example.org", "null", "http://geo.example.org",
    `https://127.0.0.1:${server.port}`]) {
    const answer = await http({ headers: { origin: other, ...callHeaders } }, Buffer.alloc(5));
    assert.equal(answer.status, 403, other);
    assert.equal(answer.headers["access-control-allow-origin"], undefined);
    const preflight = await http({
      method: "OPTIONS", headers: { origin: other, "access-control-request-method": "POST" },
    });
    assert.equal(preflight.status, 403, other);
  }
  // What a form can send without asking first.
  for (const type of ["text/plain", "application/x-www-form-urlencoded", ""]) {
    const answer = await http({ headers: { "content-type": type } }, Buffer.alloc(5));
    assert.equal(answer.status, 415, type);
  }
});

test("a name that was pointed here is no host of the server", async () => {
  for (const [host, status] of [
    ["evil.example.org", 421], [`evil.example.org:${server.port}`, 421],
    ["geo.example.org", 200], ["localhost", 200], [`LOCALHOST:${server.port}`, 200],
    ["127.0.0.1", 200], ["[::1]:80", 200], ["[::1].evil.example.org", 421], ["[::1", 421],
    ["localhost:evil.example.org", 421], [":80", 421]]) {
    const answer = await http({ headers: { host, ...callHeaders } }, Buffer.alloc(5));
    assert.equal(answer.status, status, host);
    const page = await http({ method: "GET", path: "/", headers: { host } });
    assert.equal(page.status, status, host);
  }
});

test("the page is served, and nothing else", async () => {
  const page = await fetch(server.url);
  assert.equal(page.status, 200);
  assert.match(page.headers.get("content-type"), /^text\/html/);
  assert.match(page.headers.get("content-security-policy"), /default-src 'none'/);
  assert.equal(page.headers.get("x-content-type-options"), "nosniff");
  const text = await page.text();
  const again = await http({
    method: "GET", path: "/", headers: { "if-none-match": page.headers.get("etag") },
  });
  assert.equal(again.status, 304);
  assert.equal(again.text, "");
  for (const [, file] of text.matchAll(/(?:src|href)="\.?(\/[^"]+)"/g)) {
    const asset = await fetch(server.url + file);
    assert.equal(asset.status, 200, file);
    assert.ok((await asset.arrayBuffer()).byteLength > 0);
  }
  for (const path of ["/etc/passwd", "/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd",
    "/index.html/", "//index.html", "/metrics"]) {
    assert.equal((await http({ method: "GET", path })).status, 404, path);
  }
  assert.equal((await http({ method: "PUT", path: "/index.html" })).status, 405);
});

test("with a certificate the page is served over TLS", async () => {
  const folder = mkdtempSync(join(tmpdir(), "certificate-"));
  const [key, certificate] = ["key.pem", "cert.pem"].map((name) => join(folder, name));
  execFileSync("openssl", ["req", "-x509", "-newkey", "ec", "-pkeyopt",
    "ec_paramgen_curve:prime256v1", "-nodes", "-keyout", key, "-out", certificate,
    "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost"], { stdio: "ignore" });
  const secure = await startServer("--tls-cert", certificate, "--tls-key", key);
  try {
    const get = (options) => new Promise((resolve, reject) => {
      httpsRequest({ host: "localhost", port: secure.port, path: method, method: "POST",
        ca: readFileSync(certificate), headers: callHeaders, ...options }, resolve)
        .on("error", reject).end(Buffer.alloc(5));
    });
    const answer = await get();
    assert.equal(answer.statusCode, 200);
    const pieces = [];
    for await (const piece of answer) pieces.push(piece);
    assert.match(Buffer.concat(pieces).toString("latin1"), /grpc-status: 0/);
    await assert.rejects(get({ ca: undefined }), /self-signed/);
    const inClear = await fetch(secure.url).then((response) => response.status, () => "refused");
    assert.notEqual(inClear, 200);
  } finally {
    await secure.stop();
    rmSync(folder, { recursive: true });
  }
});

test("the server ends in order while browsers are connected", async () => {
  const other = await startServer("--drain-seconds", "0");
  const digest = await uploadGrid(other.url, bumpyGrid(60));
  const answers = [];
  const reading = (async () => {
    for await (const answer of connect(other.url).QuestionService.computeMatrix(
      longMatrix(digest))) answers.push(answer);
  })().catch(() => {});
  await until(() => answers.length > 0);
  assert.equal(await other.stop(), 3);  // requests had to be cancelled
  await reading;
});
