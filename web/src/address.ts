// The part of the page's address after #: a token to begin with, and which mesh
// and sources are shown, so that the address can be kept or passed on.

import type { Explorer } from "./explorer";
import type { SurfaceMesh } from "./surface/mesh";
import { commandText, parsePlace, type Place, type Source } from "./surface/place";

const TOKEN_KEY = "geodesic.token";

/** What can stand in the header that shows it. */
const TOKEN = /^[!-~]{1,4096}$/;
const DIGEST = /^[0-9a-f]{64}$/;

export class Address {
  /** The mesh's digest, or empty. */
  mesh = "";
  token = "";
  private sources: string[] = [];

  /** `wrong` is told what is wrong with it, in words. */
  constructor(private readonly wrong: (problem: string) => void) {
    this.read();
  }

  /** Takes over what the address says now; whether nothing is wrong with it. */
  read(): boolean {
    const parts = new URLSearchParams(location.hash.slice(1));
    const mesh = parts.get("mesh") ?? "";
    const token = parts.get("token");
    this.mesh = DIGEST.test(mesh) ? mesh : "";
    this.sources = parts.getAll("source");
    let problem: string | undefined;
    if (mesh && !this.mesh) problem = "The address names no mesh: a mesh has 64 digits and letters from a to f.";
    if (token && TOKEN.test(token)) this.keepToken(token);
    else if (token) problem = "The token in the address is none: it has letters, digits and signs only.";
    this.token = sessionStorage.getItem(TOKEN_KEY) ?? "";
    if (token !== null) {
      // Addresses are shown, kept and passed on; tokens should not be.
      parts.delete("token");
      history.replaceState(null, "", `#${parts}`);
    }
    if (problem) this.wrong(problem);
    return !problem;
  }

  /** Until this tab is closed. */
  keepToken(token: string): void {
    sessionStorage.setItem(TOKEN_KEY, token);
  }

  /** The sources that the address named, if it named this mesh. */
  sourcesOn(mesh: SurfaceMesh): Source[] {
    if (mesh.digest !== this.mesh) return [];
    const named = this.sources.splice(0);
    const places = named.map(parsePlace).filter((place) => place !== undefined && mesh.holds(place)) as Place[];
    if (places.length < named.length) this.wrong("The address names a source that is no place of this mesh.");
    return places;
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
