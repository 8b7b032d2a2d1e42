// The clients of the server that sent this page, and the token they show it.

import { createClient, type CallOptions, type Client, type Interceptor } from "@connectrpc/connect";
import { createGrpcWebTransport } from "@connectrpc/connect-web";
import { CapabilitiesService } from "../../generated/geodesic/v1/capabilities_service_pb";
import { MeshService } from "../../generated/geodesic/v1/mesh_service_pb";
import { QuestionService } from "../../generated/geodesic/v1/question_service_pb";

export class Connection {
  readonly capabilities: Client<typeof CapabilitiesService>;
  readonly meshes: Client<typeof MeshService>;
  readonly questions: Client<typeof QuestionService>;

  /** `token` may be empty: then none is sent. */
  constructor(
    readonly baseUrl: string,
    public token: string,
  ) {
    const authorize: Interceptor = (next) => (request) => {
      if (this.token) request.header.set("authorization", `Bearer ${this.token}`);
      return next(request);
    };
    const transport = createGrpcWebTransport({ baseUrl, interceptors: [authorize] });
    this.capabilities = createClient(CapabilitiesService, transport);
    this.meshes = createClient(MeshService, transport);
    this.questions = createClient(QuestionService, transport);
  }
}

/** Options of a call about one mesh, by which a balancer finds the server that has it. */
export function about(digest: string, signal: AbortSignal): CallOptions {
  return { signal, headers: { "geo-mesh-digest": digest } };
}
