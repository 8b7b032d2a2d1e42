// Sends a mesh file, unless the server knows it.

import { create, fromBinary, toBinary } from "@bufbuild/protobuf";
import { Code, ConnectError } from "@connectrpc/connect";
import { encodeEnvelope } from "@connectrpc/connect/protocol";
import {
  trailerFlag,
  trailerParse,
  validateResponse,
  validateTrailer,
} from "@connectrpc/connect/protocol-grpc-web";
import { MeshFormat } from "../../generated/geodesic/v1/mesh_pb";
import {
  CreateMeshRequestSchema,
  CreateMeshResponseSchema,
  MeshService,
  UploadHeaderSchema,
  type CreateMeshRequest,
} from "../../generated/geodesic/v1/mesh_service_pb";
import { about, type Connection } from "./connection";

/** Endings that are not named like their format. */
const OTHER_ENDINGS: Record<string, MeshFormat> = { glb: MeshFormat.GLTF };

const FORMATS: Record<string, MeshFormat> = {
  ...Object.fromEntries(
    Object.entries(MeshFormat)
      .filter(([, format]) => typeof format === "number" && format !== MeshFormat.UNSPECIFIED && format !== MeshFormat.ARRAYS)
      .map(([name, format]) => [name.toLowerCase(), format as MeshFormat])),
  ...OTHER_ENDINGS,
};

/** Of files that can be read, each with its dot. */
export const ENDINGS = Object.keys(FORMATS).map((ending) => `.${ending}`);

const CHUNK_BYTES = 512 * 1024;

/** The format that a file's name tells; throws if it is none of the server's. */
export function formatOf(name: string): MeshFormat {
  const ending = name.toLowerCase().replace(/\.gz$/, "").split(".").pop() ?? "";
  const format = FORMATS[ending];
  if (format === undefined) {
    throw new Error(`Meshes are files in ${ENDINGS.join(", ")}, or these with .gz; ${name} is none.`);
  }
  return format;
}

/** Which boundary edges the server joins when it reads a file. */
export interface Joining {
  /** None. */
  keepSeams: boolean;
  /** Those whose ends are so near, in the unit of the file; within the file's rounding if it is not set. */
  weldDistance?: number;
}

/**
 * The digest of the file's mesh. `progress` gets shares from 0 to 1; `digest`, where it is
 * known, leads to the server of this mesh behind a balancer.
 */
export async function uploadMesh(
  connection: Connection,
  file: File,
  joining: Joining,
  progress: (share: number) => void,
  signal: AbortSignal,
  digest = "",
): Promise<string> {
  const reading = { format: formatOf(file.name), ...joining };
  const data = new Uint8Array(await file.arrayBuffer());
  const known = await knownMesh(connection, reading, data, signal, digest);
  return known ?? send(connection, reading, data, progress, signal, digest);
}

/** How a file is to be read. */
interface Reading extends Joining {
  format: MeshFormat;
}

async function knownMesh(
  connection: Connection,
  reading: Reading,
  data: Uint8Array<ArrayBuffer>,
  signal: AbortSignal,
  digest: string,
): Promise<string | undefined> {
  // Browsers hash on secure pages only: https and this machine.
  if (!globalThis.crypto?.subtle) return undefined;
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", data));
  const sha256 = Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
  const answer = await connection.meshes.findMissingMeshes(
    { files: [{ ...reading, sha256 }] },
    about(digest || sha256, signal),
  );
  return answer.knownFiles[0]?.meshDigest;
}

// Browsers' fetch has neither client streams nor the progress of an upload, so
// all messages go as the frames of one XMLHttpRequest.
async function send(
  connection: Connection,
  reading: Reading,
  data: Uint8Array<ArrayBuffer>,
  progress: (share: number) => void,
  signal: AbortSignal,
  digest: string,
): Promise<string> {
  const body = new Blob([...frames(reading, data)] as BlobPart[], { type: "application/grpc-web+proto" });
  const answer = await post(connection, body, progress, signal, digest);
  const message = readAnswer(answer);
  return fromBinary(CreateMeshResponseSchema, message).mesh?.digest ?? "";
}

function* frames(reading: Reading, data: Uint8Array): Generator<Uint8Array> {
  const frame = (part: CreateMeshRequest["part"]) =>
    encodeEnvelope(0, toBinary(CreateMeshRequestSchema, create(CreateMeshRequestSchema, { part })));
  yield frame({
    case: "header",
    value: create(UploadHeaderSchema, { ...reading, sizeBytes: BigInt(data.length) }),
  });
  for (let offset = 0; offset < data.length; offset += CHUNK_BYTES) {
    const chunk = data.subarray(offset, offset + CHUNK_BYTES);
    yield frame({
      case: "chunk",
      value: { $typeName: "geodesic.v1.UploadChunk", offset: BigInt(offset), data: chunk },
    });
  }
}

function post(
  connection: Connection,
  body: Blob,
  progress: (share: number) => void,
  signal: AbortSignal,
  digest: string,
): Promise<XMLHttpRequest> {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open("POST", `${connection.baseUrl}/${MeshService.typeName}/CreateMesh`);
    request.responseType = "arraybuffer";
    request.setRequestHeader("content-type", "application/grpc-web+proto");
    request.setRequestHeader("x-grpc-web", "1");
    if (connection.token) request.setRequestHeader("authorization", `Bearer ${connection.token}`);
    if (digest) request.setRequestHeader("geo-mesh-digest", digest);
    request.upload.onprogress = (event) => progress(event.loaded / Math.max(event.total, 1));
    request.onload = () => resolve(request);
    request.onerror = () => reject(new ConnectError("the upload broke off", Code.Unavailable));
    request.onabort = () => reject(new ConnectError("stopped", Code.Canceled));
    signal.addEventListener("abort", () => request.abort());
    request.send(body);
  });
}

// The one message of the answer; throws what its trailer says.
function readAnswer(request: XMLHttpRequest): Uint8Array {
  const headers = new Headers();
  for (const line of request.getAllResponseHeaders().trim().split(/[\r\n]+/)) {
    const colon = line.indexOf(":");
    if (colon > 0) headers.append(line.slice(0, colon), line.slice(colon + 1).trim());
  }
  const { headerError } = validateResponse(request.status, headers);
  if (headerError) throw headerError;
  const bytes = new Uint8Array(request.response as ArrayBuffer);
  const view = new DataView(bytes.buffer);
  let message: Uint8Array | undefined;
  let ended = false;
  for (let at = 0; at + 5 <= bytes.length; ) {
    const flags = bytes[at];
    const size = view.getUint32(at + 1);
    const data = bytes.subarray(at + 5, at + 5 + size);
    at += 5 + size;
    if (flags & trailerFlag) {
      validateTrailer(trailerParse(data), headers);
      ended = true;
    } else {
      message = data;
    }
  }
  if (!ended || !message) throw new ConnectError("the answer broke off", Code.Unavailable);
  return message;
}
