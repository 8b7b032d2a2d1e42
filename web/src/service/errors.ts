// What went wrong, in words for somebody who looks at the page.

import { Code, ConnectError } from "@connectrpc/connect";

export type ErrorKind = "cancelled" | "token" | "gone" | "forgotten" | "refused";

export function kindOf(error: unknown): ErrorKind {
  if (error instanceof DOMException && error.name === "AbortError") return "cancelled";
  // What fetch throws when nobody answers is a TypeError.
  if (error instanceof TypeError) return "gone";
  if (!(error instanceof ConnectError)) return "refused";
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
    default:
      // A fetch that failed, or a stream that broke off.
      return error.code === Code.Unknown ? "gone" : "refused";
  }
}

export function explain(error: unknown): string {
  switch (kindOf(error)) {
    case "cancelled":
      return "Stopped.";
    case "gone":
      return "The server does not answer.";
    case "forgotten":
      return "The server no longer has this mesh.";
    default:
      if (error instanceof ConnectError) return sentence(error.rawMessage);
      return sentence(error instanceof Error ? error.message : String(error));
  }
}

function sentence(text: string): string {
  const words = text.trim() || "It failed for an unknown reason";
  return words[0].toUpperCase() + words.slice(1) + (/[.!?]$/.test(words) ? "" : ".");
}
