// The part of the page's address after #: a token to begin with, and which mesh
// and sources are shown, so that the address can be kept or passed on.

import type { Explorer } from "./explorer";
import type { SurfaceMesh } from "./surface/mesh";
import { commandText, parsePlace, type Source } from "./surface/place";

const TOKEN_KEY = "geodesic.token";

export class Address {
  /** The mesh's digest, or empty. */
  readonly mesh: string;
  readonly token: string;
  private readonly sources: string[];

  constructor() {
    const parts = new URLSearchParams(location.hash.slice(1));
    this.mesh = parts.get("mesh") ?? "";
    this.sources = parts.getAll("source");
    const token = parts.get("token");
    if (token) this.keepToken(token);
    this.token = sessionStorage.getItem(TOKEN_KEY) ?? "";
    if (token) {
      // Addresses are shown, kept and passed on; tokens should not be.
      parts.delete("token");
      history.replaceState(null, "", `#${parts}`);
    }
  }

  /** Until this tab is closed. */
  keepToken(token: string): void {
    sessionStorage.setItem(TOKEN_KEY, token);
  }

  /** The sources that the address named, if it named this mesh. */
  sourcesOn(mesh: SurfaceMesh): Source[] {
    if (mesh.digest !== this.mesh) return [];
    const places = this.sources.splice(0).map(parsePlace);
    return places.filter((place) => place !== undefined).filter((place) => mesh.holds(place));
  }

  show(explorer: Explorer): void {
    if (!explorer.mesh) return;
    const parts = new URLSearchParams({ mesh: explorer.mesh.digest });
    for (const source of explorer.sources) {
      if (!("curve" in source)) parts.append("source", commandText(source));
    }
    history.replaceState(null, "", `#${parts}`);
  }
}
