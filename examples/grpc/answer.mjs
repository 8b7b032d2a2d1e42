// The answer to any question of a server, in the repository's folder with
// @grpc/grpc-js and @grpc/proto-loader; and the reason that an error has for programs.

import grpc from "@grpc/grpc-js";
import { loadSync } from "@grpc/proto-loader";
import protobuf from "protobufjs";

const { QuestionService } = grpc.loadPackageDefinition(loadSync(
    "geodesic/v1/question_service.proto",
    { includeDirs: ["proto"], longs: Number, defaults: true })).geodesic.v1;

const types = [, Float64Array, Float32Array, Uint32Array, BigUint64Array, Uint8Array];

/** The arrays of an answer by name, flat. */
export async function read(call) {
  try {
    let arrays, complete;
    for await (const { header, blocks, trailer } of call) {
      if (header) arrays = header.arrays.map((info) => ({ ...info, pieces: [] }));
      for (const { array, values } of blocks) arrays[array].pieces.push(values);
      complete = trailer;
    }
    if (!complete) throw new Error("the stream ended without a trailer");
    return Object.fromEntries(arrays.filter(({ type }) => types[type]).map(
        ({ name, type, pieces }) =>
            [name, new types[type](new Uint8Array(Buffer.concat(pieces)).buffer)]));
  } finally {
    call.cancel();  // also when the loop was left early
  }
}

export async function distancesFrom(client, meshDigest, vertex) {
  const question = { meshDigest, sources: [{ vertex }] };
  const deadline = Date.now() + 60_000;
  return (await read(client.computeField(question, { deadline }))).distance;
}

const rpc = protobuf.parse(`syntax = "proto3";
  message Any { string type_url = 1; bytes value = 2; }
  message Status { repeated Any details = 3; }
  message ErrorInfo { string reason = 1; }`).root;

export function reasonOf(error) {
  const [bytes] = error.metadata?.get("grpc-status-details-bin") ?? [];
  const details = bytes ? rpc.lookupType("Status").decode(bytes).details : [];
  const info = details.find((any) => any.typeUrl.endsWith("/google.rpc.ErrorInfo"));
  return info && rpc.lookupType("ErrorInfo").decode(info.value).reason;
}

const client = new QuestionService("127.0.0.1:50051", grpc.credentials.createInsecure());
