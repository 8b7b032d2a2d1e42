// connect-web as a browser's page uses it, on the protocol's own descriptors.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { create, createFileRegistry, fromBinary, toBinary } from "@bufbuild/protobuf";
import { FileDescriptorSetSchema } from "@bufbuild/protobuf/wkt";
import { createClient } from "@connectrpc/connect";
import { createGrpcWebTransport } from "@connectrpc/connect-web";

import { need } from "./server.mjs";

const registry = loadRegistry();

function loadRegistry() {
  const folder = mkdtempSync(join(tmpdir(), "protos-"));
  const [protos, googleapis, protoc] =
      [need("PROTOS")[0], need("GOOGLEAPIS")[0], need("PROTOC")[0]];
  const out = join(folder, "set");
  execFileSync(protoc, [
    "-I", protos, "-I", googleapis, "--include_imports", "-o", out,
    ...readdirSync(join(protos, "geodesic/v1")).filter((name) => name.endsWith("_service.proto"))
      .map((name) => `geodesic/v1/${name}`),
    "google/rpc/error_details.proto"]);
  const set = fromBinary(FileDescriptorSetSchema, readFileSync(out));
  rmSync(folder, { recursive: true });
  return createFileRegistry(set);
}

/** The descriptor of a service of the protocol, e.g. "MeshService". */
export const service = (name) => registry.getService(`geodesic.v1.${name}`);
export const services =
    [...registry].filter((type) => type.kind === "service");
export const message = (name) => registry.getMessage(`geodesic.v1.${name}`);
/** Of google.rpc, for ConnectError.findDetails. */
export const detail = (name) => registry.getMessage(`google.rpc.${name}`);
/** A value of an enum: number("Algorithm", "HEAT"). */
export const number = (type, name) => registry.getEnum(`geodesic.v1.${type}`).values.find(
  (value) => value.localName === name).number;

/** A client for every service: clients.MeshService.getMesh(...). */
export function connect(url, options = {}) {
  const transport = createGrpcWebTransport({ baseUrl: url, ...options });
  return Object.fromEntries(
    services.map((type) => [type.name, createClient(type, transport)]));
}

/** A frame of gRPC-Web around a message's bytes. */
export function frame(bytes, flags = 0) {
  const header = Buffer.alloc(5);
  header.writeUInt8(flags, 0);
  header.writeUInt32BE(bytes.length, 1);
  return Buffer.concat([header, bytes]);
}

/** All frames of CreateMesh, one after the other. */
export function uploadFrames(header, bytes, chunkBytes = 1 << 18) {
  const schema = message("CreateMeshRequest");
  const parts = [{ part: { case: "header", value: header } }];
  for (let offset = 0; offset < bytes.length; offset += chunkBytes) {
    const data = bytes.subarray(offset, offset + chunkBytes);
    parts.push({ part: { case: "chunk", value: { offset: BigInt(offset), data } } });
  }
  return parts.map((part) => frame(toBinary(schema, create(schema, part))));
}

/**
 * CreateMesh with connect-web. It sends one message of its own a request, since
 * browsers cannot stream a body; the method is called as if it took one message,
 * and the body that is fetched holds all frames.
 */
export function upload(url, header, bytes, { headers, signal, chunkBytes } = {}) {
  const body = Buffer.concat(uploadFrames(header, bytes, chunkBytes));
  const transport = createGrpcWebTransport({
    baseUrl: url,
    fetch: (target, init) => fetch(target, { ...init, body }),
  });
  const method = { ...service("MeshService").method.createMesh, methodKind: "unary" };
  return transport
    .unary(method, signal, undefined, headers, create(message("CreateMeshRequest")))
    .then((response) => response.message);
}

/** Every message of a stream. */
export async function all(stream) {
  const messages = [];
  for await (const one of stream) messages.push(one);
  return messages;
}

const kinds = [, Float64Array, Float32Array, Uint32Array, BigUint64Array, Uint8Array];

/** What a complete answer has: `header`, `trailer`, and its arrays by name, flat. */
export async function read(stream) {
  let header, trailer;
  const pieces = [];
  for await (const answer of stream) {
    header ??= answer.header;
    trailer = answer.trailer;
    for (const { array, values } of answer.blocks) (pieces[array] ??= []).push(values);
  }
  assert.ok(trailer, "no trailer");
  return { header, trailer, ...Object.fromEntries(header.arrays.map(({ name, type }, i) =>
    [name, Array.from(new kinds[type](new Uint8Array(Buffer.concat(pieces[i] ?? [])).buffer), Number)])) };
}
