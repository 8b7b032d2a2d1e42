// A field from a server, in the repository's folder with @grpc/grpc-js and
// @grpc/proto-loader; and the reason that an error has for programs.

import grpc from "@grpc/grpc-js";
import { loadSync } from "@grpc/proto-loader";
import protobuf from "protobufjs";

const { FieldService } = grpc.loadPackageDefinition(loadSync(
    "geodesic/v1/field_service.proto",
    { includeDirs: ["proto"], longs: Number })).geodesic.v1;

export async function distancesFrom(client, meshDigest, vertex) {
  const call = client.computeField({ meshDigest, sources: [{ vertex }] },
                                   { deadline: Date.now() + 60_000 });
  try {
    let distances, complete;
    for await (const { header, chunk, trailer } of call) {
      if (header) distances = new Float64Array(header.vertexCount);
      if (chunk) new Uint8Array(distances.buffer).set(chunk.distances, 8 * chunk.offset);
      if (trailer) complete = true;
    }
    if (!complete) throw new Error("the stream ended without a trailer");
    return distances;
  } finally {
    call.cancel();  // also when the loop was left early
  }
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

const client = new FieldService("127.0.0.1:50051", grpc.credentials.createInsecure());
