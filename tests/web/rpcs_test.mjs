// Every RPC through connect-web, a client that shares nothing with ours but the
// protocol, and the real server; Euclid on a planar grid is the oracle.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { after, before, test } from "node:test";

import { all, connect, number, read, service, services, upload } from "./client.mjs";
import { asArrays, distance, planarGrid } from "./grid.mjs";
import { startServer } from "./server.mjs";

// The rounding of sums of a dozen lengths near 1.
const TOLERANCE = 1e-10;

const grid = planarGrid(10);
const { header, bytes } = asArrays(grid);
const last = grid.positions.length - 1;
const vertex = (number) => ({ place: { case: "vertex", value: BigInt(number) } });
const from = (number) => ({ ...vertex(number), offset: 0 });

let server, clients, digest;
const called = new Set();

before(async () => {
  server = await startServer();
  const count = (next) => (request) => {
    called.add(request.method.localName);
    return next(request);
  };
  clients = connect(server.url, { interceptors: [count] });
  const created = await upload(server.url, header, bytes, { chunkBytes: 4096 });
  called.add("createMesh");
  digest = created.mesh.digest;
});
after(() => server.stop());

function assertClose(actual, expected) {
  assert.equal(actual.length, expected.length);
  actual.forEach((value, i) => assert.ok(
    Math.abs(value - expected[i]) <= TOLERANCE, `${i}: ${value}, not ${expected[i]}`));
}
const euclid = (a) => grid.positions.map((b) => distance(grid.positions[a], b));

test("CreateMesh names the mesh by its content", async () => {
  const counts = Buffer.alloc(16);
  counts.writeBigUInt64LE(header.vertexCount, 0);
  counts.writeBigUInt64LE(header.faceCount, 8);
  const expected = createHash("sha256")
    .update("geodesic.mesh.v1\n").update(counts).update(bytes).digest("hex");
  assert.equal(digest, expected);
  const again = await upload(server.url, header, bytes);
  assert.equal(again.alreadyResident, true);
});

test("GetCapabilities", async () => {
  const answer = await clients.CapabilitiesService.getCapabilities({});
  assert.ok(answer.limits.maxFaces > 0n);
  assert.ok(answer.algorithms.some((algorithm) => algorithm.name === "mmp"));
});

test("FindMissingMeshes, GetMesh, ListMeshes", async () => {
  const absent = "0".repeat(64);
  const missing = await clients.MeshService.findMissingMeshes({ meshDigests: [digest, absent] });
  assert.deepEqual(missing.missingMeshDigests, [absent]);
  const { mesh } = await clients.MeshService.getMesh({ digest });
  assert.equal(mesh.faceCount, header.faceCount);
  const { meshes } = await clients.MeshService.listMeshes({});
  assert.deepEqual(meshes.map((one) => one.digest), [digest]);
});

test("ReadMesh gives the arrays back", async () => {
  const answers = await all(clients.MeshService.readMesh({ digest }));
  const parts = (kind) => answers.map(({ part }) => part).filter((part) => part.case === kind);
  assert.ok(Buffer.concat([
    ...parts("vertices").map((part) => part.value.positions),
    ...parts("faces").map((part) => part.value.indices)]).equals(bytes));
});

test("ComputeField, at once and progressively", async () => {
  const request = { meshDigest: digest, sources: [from(0)] };
  assertClose((await read(clients.QuestionService.computeField(request))).distance, euclid(0));

  const found = await read(clients.QuestionService.computeField({ ...request, progressive: true }));
  const values = new Array(grid.positions.length);
  found.settled_vertex.forEach((v, i) => { values[v] = found.settled_distance[i]; });
  assertClose(values, euclid(0));
});

test("ComputeField, approximately", async () => {
  const { header } = await read(clients.QuestionService.computeField(
    { meshDigest: digest, sources: [from(0)], algorithm: number("Algorithm", "HEAT") }));
  assert.ok(header.approximation);
});

const rows = [0, 7, 60];
const lengths = (points, size) => Array.from({ length: points.length / size }, (_, i) =>
  Math.hypot(...points.slice(size * i, size * (i + 1))));

// The other questions: what is asked, and numbers of the answer.
for (const [name, request, part, expected] of [
  ["computeLogMap", { source: vertex(60) },
    ({ coordinates }) => lengths(coordinates, 2), euclid(60)],
  ["sampleFarthestPoints", { sources: [from(0)], count: 3n },
    (found) => [found.vertex.length, found.vertex[0], found.distance[0]],
    [3, last, Math.SQRT2]],
  ["computePaths", { sources: [from(0)], targets: [vertex(last)] },
    ({ length }) => length, [Math.SQRT2]],
  ["computeIsolines", { sources: [from(0)], levels: [0.5] },
    ({ position }) => [Math.min(...lengths(position, 3)), Math.max(...lengths(position, 3))],
    [0.5, 0.5]],
  ["computeMatrix", { sources: rows.map(from) },
    ({ distance }) => distance, rows.flatMap(euclid)],
  ["findNearest", { sources: [from(0)], targets: [vertex(last), vertex(1)], count: 1n },
    ({ target }) => target, [1]],
  ["computePairs", { vertexPairs: [0, last, 1, 0] },
    ({ distance }) => distance, [Math.SQRT2, 0.1]],
  // To where the grid ends.
  ["traceLines", { vertexSources: [0], vectors: [2, 1, 0], lengths: [Infinity] },
    ({ end, length, position }) => [...end, ...length, ...position.slice(-3)],
    [1, Math.sqrt(1.25), 1, 0.5, 0]],
]) {
  test(name, async () => assertClose(part(await read(
    clients.QuestionService[name]({ meshDigest: digest, ...request }))), expected));
}

test("DeleteMesh", async () => {
  const other = asArrays(planarGrid(3));
  const { mesh } = await upload(server.url, other.header, other.bytes);
  await clients.MeshService.deleteMesh({ digest: mesh.digest });
  const { meshes } = await clients.MeshService.listMeshes({});
  assert.deepEqual(meshes.map((one) => one.digest), [digest]);
});

test("no RPC was left out", () => {
  const names = services.flatMap((type) => type.methods.map((method) => method.localName));
  assert.ok(service("MeshService").method.createMesh);
  assert.deepEqual(names.filter((name) => !called.has(name)), []);
});
