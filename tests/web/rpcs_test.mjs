// Every RPC through connect-web, a client that shares nothing with ours but the
// protocol, and the real server; Euclid on a planar grid is the oracle.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { after, before, test } from "node:test";

import { all, connect, doubles, number, numbers32, parts, service, services, upload } from "./client.mjs";
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
  const read = Buffer.concat([
    ...parts(answers, "vertices").map((chunk) => chunk.positions),
    ...parts(answers, "faces").map((chunk) => chunk.indices)]);
  assert.ok(read.equals(bytes));
});

test("ComputeField, at once and progressively", async () => {
  const request = { meshDigest: digest, sources: [from(0)] };
  const answers = await all(clients.FieldService.computeField(request));
  assertClose(doubles(parts(answers, "chunk").map((chunk) => chunk.distances)), euclid(0));
  assert.equal(answers.at(-1).part.case, "trailer");

  const settled = parts(
    await all(clients.FieldService.computeField({ ...request, progressive: true })), "settled");
  const values = new Array(grid.positions.length);
  const found = doubles(settled.map((chunk) => chunk.distances));
  numbers32(settled.map((chunk) => chunk.vertices)).forEach((v, i) => { values[v] = found[i]; });
  assertClose(values, euclid(0));
});

test("ComputeField, approximately", async () => {
  const [{ part }] = await all(clients.FieldService.computeField(
    { meshDigest: digest, sources: [from(0)], algorithm: number("Algorithm", "HEAT") }));
  assert.equal(part.case, "header");
  assert.ok(part.value.approximation);
});

test("ComputeLogMap keeps distances", async () => {
  const answers = await all(clients.FieldService.computeLogMap(
    { meshDigest: digest, source: vertex(60) }));
  const flat = doubles(parts(answers, "chunk").map((chunk) => chunk.coordinates));
  const lengths = grid.positions.map((_, i) => Math.hypot(flat[2 * i], flat[2 * i + 1]));
  assertClose(lengths, euclid(60));
});

test("SampleFarthestPoints begins with the far corner", async () => {
  const answers = await all(clients.FieldService.sampleFarthestPoints(
    { meshDigest: digest, sources: [from(0)], count: 3n }));
  const samples = parts(answers, "samples").flatMap((chunk) => chunk.samples);
  assert.equal(samples.length, 3);
  assert.equal(samples[0].vertex, BigInt(last));
  assertClose([samples[0].distance], [Math.SQRT2]);
});

test("ComputePaths", async () => {
  const answers = await all(clients.PathService.computePaths(
    { meshDigest: digest, sources: [from(0)], targets: [vertex(last)] }));
  const [path] = parts(answers, "path");
  assertClose([path.length], [Math.SQRT2]);
});

test("ComputeIsolines are circles", async () => {
  const answers = await all(clients.PathService.computeIsolines(
    { meshDigest: digest, sources: [from(0)], levels: [0.5] }));
  const lines = parts(answers, "isoline");
  assert.ok(lines.length > 0);
  for (const line of lines) {
    const positions = doubles([line.piece.positions]);
    for (let i = 0; i < positions.length; i += 3) {
      assertClose([Math.hypot(positions[i], positions[i + 1])], [0.5]);
    }
  }
});

test("ComputeMatrix and FindNearest", async () => {
  const rows = [0, 7, 60];
  const answers = await all(clients.MatrixService.computeMatrix(
    { meshDigest: digest, sources: rows.map(from) }));
  assertClose(doubles(parts(answers, "chunk").map((chunk) => chunk.values)),
    rows.flatMap(euclid));
  const nearest = parts(await all(clients.MatrixService.findNearest({
    meshDigest: digest, sources: [from(0)], targets: [vertex(last), vertex(1)], count: 1n,
  })), "chunk");
  assert.deepEqual(numbers32(nearest.map((chunk) => chunk.targets)), [1]);
});

test("ComputePairs", async () => {
  const answers = await all(clients.PairService.computePairs(
    { meshDigest: digest, vertexPairs: [0, last, 1, 0] }));
  assertClose(doubles(parts(answers, "chunk").map((chunk) => chunk.distances)),
    [Math.SQRT2, 0.1]);
});

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
