// The part of the page's address after #: a token to begin with, and which mesh,
// sources, paths and radius are shown, so that the address can be kept or passed on.

import type { Explorer } from "./explorer";
import { lineText, parseLine, type LineQuestion } from "./surface/line_question";
import type { SurfaceMesh } from "./surface/mesh";
import { parseSource, sourceText, type Source } from "./surface/place";

const TOKEN_KEY = "geodesic.token";

/** What can stand in the header that shows it. */
const TOKEN = /^[!-~]{1,4096}$/;
/** Browsers drop changes of the address that come more often than some twenty times a second. */
const PAUSE_MS = 100;

const DIGEST = /^[0-9a-f]{64}$/;

export class Address {
  /** The mesh's digest, or empty. */
  mesh = "";
  token = "";
  private sources: string[] = [];
  private paths: string[] = [];
  private radius: string | null = null;
  /** The mesh that `show` was last called with. */
  private shown: string | undefined;
  /** What will be written when there was none for long enough. */
  private wanted: string | undefined;
  private pause: ReturnType<typeof setTimeout> | undefined;

  /** `wrong` is told what is wrong with it, in words. */
  constructor(private readonly wrong: (problem: string) => void) {
    this.read();
  }

  /** Takes over what the address says now; whether nothing is wrong with it. */
  read(): boolean {
    this.wanted = undefined;
    const parts = new URLSearchParams(location.hash.slice(1));
    const mesh = parts.get("mesh") ?? "";
    const token = parts.get("token");
    this.mesh = DIGEST.test(mesh) ? mesh : "";
    this.sources = parts.getAll("source");
    this.paths = parts.getAll("path");
    this.radius = parts.get("radius");
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

  /** What the address asked, once, if it named this mesh. */
  questionOn(mesh: SurfaceMesh): { sources: Source[]; paths: LineQuestion[]; radius?: number } {
    if (mesh.digest !== this.mesh) return { sources: [], paths: [] };
    const holds = (source: Source | undefined) => source !== undefined && mesh.holdsSource(source);
    const named = this.sources.splice(0);
    const sources = named.map(parseSource).filter(holds) as Source[];
    if (sources.length < named.length) this.wrong("The address names a source that is no place of this mesh.");
    const namedPaths = this.paths.splice(0);
    const paths = namedPaths.map(parseLine).filter((line) => line !== undefined && mesh.holdsLine(line)) as LineQuestion[];
    if (paths.length < namedPaths.length) this.wrong("The address names a path that is none of this mesh.");
    const radius = this.radius === null ? undefined : parseFloat(this.radius);
    this.radius = null;
    if (radius === undefined || (Number.isFinite(radius) && radius >= 0)) return { sources, paths, radius };
    this.wrong("The address names a radius that is no length.");
    return { sources, paths };
  }

  show({ mesh, sources, paths, awaitedPaths, radius }: Explorer): void {
    if (!mesh) return;
    const parts = new URLSearchParams({ mesh: mesh.digest });
    for (const source of sources) parts.append("source", sourceText(source));
    for (const line of [...paths.map(({ question }) => question), ...awaitedPaths]) parts.append("path", lineText(line));
    if (radius !== undefined) parts.set("radius", String(radius));
    // The browser's Back leads to the mesh before, with all that was asked about it.
    if (this.shown !== undefined && this.shown !== mesh.digest) {
      this.write();
      const { hash } = location;
      if (new URLSearchParams(hash.slice(1)).get("mesh") !== mesh.digest) history.pushState(null, "", hash);
    }
    this.shown = mesh.digest;
    this.wanted = `#${parts}`;
    if (this.pause === undefined) this.write();
  }

  private write(): void {
    const { wanted } = this;
    clearTimeout(this.pause);
    this.pause = this.wanted = undefined;
    if (wanted === undefined || wanted === location.hash) return;
    history.replaceState(null, "", wanted);
    this.pause = setTimeout(() => this.write(), PAUSE_MS);
  }
}
