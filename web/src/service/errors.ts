// What went wrong, in words for somebody who looks at the page.

import { Code, ConnectError } from "@connectrpc/connect";

export type ErrorKind = "cancelled" | "token" | "gone" | "forgotten" | "full" | "refused";

export function kindOf(error: unknown): ErrorKind {
  if (error instanceof DOMException && error.name === "AbortError") return "cancelled";
  // What fetch throws when nobody answers is a TypeError.
  if (error instanceof TypeError) return "gone";
  if (!(error instanceof ConnectError) || isRefusedUnread(error)) return "refused";
  switch (error.code) {
    case Code.Canceled:
      return "cancelled";
    case Code.Unauthenticated:
    case Code.PermissionDenied:
      return "token";
    case Code.Unavailable:
      return "gone";
    case Code.NotFound:
      return "forgotten";
    case Code.ResourceExhausted:
      return retryAfter(error) === undefined ? "refused" : "full";
    default:
      // A fetch that failed, or a stream that broke off.
      return error.code === Code.Unknown ? "gone" : "refused";
  }
}

/** In how many milliseconds a server that is full may be asked again; nothing if that is no use. */
export function retryAfter(error: unknown): number | undefined {
  const text = error instanceof ConnectError ? error.metadata.get("grpc-retry-pushback-ms") : null;
  return text !== null && /^\d+$/.test(text) ? Number(text) : undefined;
}

export function explain(error: unknown): string {
  switch (kindOf(error)) {
    case "cancelled":
      return "Stopped.";
    case "gone":
      return "The server does not answer.";
    case "forgotten":
      return "The server has lost this mesh.";
    default:
      if (error instanceof ConnectError) return sentence(reasonOf(error.rawMessage));
      return sentence(error instanceof Error ? error.message : String(error));
  }
}

// Whether a proxy, or the server's door, has refused a question without reading it:
// then there is but the status of HTTP, which Connect puts into the message. Asked
// again it would be refused again, but for 429: too much at a time.
function isRefusedUnread(error: ConnectError): boolean {
  return /^HTTP 4\d\d$/.test(error.rawMessage) && error.rawMessage !== "HTTP 429";
}

function reasonOf(message: string): string {
  switch (message) {
    case "HTTP 403":
      return `The server answers no page of ${location.origin}: its flag --web-allow-origin must name this address.`;
    case "HTTP 413":
      return "The server, or a proxy before it, refuses files of this size.";
    default:
      return message;
  }
}

function sentence(text: string): string {
  const words = text.trim() || "It failed for an unknown reason";
  return words[0].toUpperCase() + words.slice(1) + (/[.!?]$/.test(words) ? "" : ".");
}
