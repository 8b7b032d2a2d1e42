// Asks for lines on the surface: the one at the cursor, those that the user keeps,
// and those that an address named.

import { CursorLine } from "./scene/cursor_line";
import type { Scene } from "./scene/scene";
import type { Asking } from "./service/asking";
import { kindOf } from "./service/errors";
import { askLine, type PathQuestion, type SurfaceLine } from "./service/lines";
import type { LineQuestion, StraightLine } from "./surface/line_question";
import type { SurfaceMesh } from "./surface/mesh";

export interface LineEvents {
  /** The length of the line at the cursor: +infinity if no path leads there, nothing if none runs straight on. */
  value(length: number | undefined): void;
  /** There is no such line: why, in words. */
  told(what: string): void;
  /** The user keeps it. */
  kept(line: SurfaceLine): void;
  /** An address named it. */
  came(line: SurfaceLine): void;
}

export class Lines {
  /** Those that an address named and that have not come. */
  awaited: readonly LineQuestion[] = [];
  private readonly live: CursorLine;
  /** Told as the length where there is no line. */
  private unreached: number | undefined;

  constructor(
    scene: Scene,
    private readonly asking: Asking,
    private readonly events: LineEvents,
  ) {
    this.live = new CursorLine(scene, {
      value: (length) => events.value(length ?? this.unreached),
      failed: (error, again) => asking.report(error, again),
    });
  }

  /** Draws the line at the cursor; `since` is when the cursor came there. */
  lead(mesh: SurfaceMesh, question: PathQuestion | StraightLine, since: number): void {
    this.unreached = "target" in question ? Infinity : undefined;
    this.live.lead(mesh, (signal) => this.askLive(mesh, question, signal), since);
  }

  hide(): void {
    this.live.hide();
  }

  warmUp(): void {
    this.live.warmUp();
  }

  async keep(mesh: SurfaceMesh, question: PathQuestion | StraightLine): Promise<void> {
    const { signal } = this.asking;
    try {
      const line = await this.ask(mesh, question, signal);
      if (signal.aborted) return;
      if (!line) this.events.told("No path leads there.");
      // The second click of two leads from the source to itself.
      else if (line.length > 0) this.events.kept(line);
    } catch (error) {
      this.asking.reportAbout(mesh, error, () => this.keep(mesh, question));
    }
  }

  /** Asks for those that are awaited, one by one. */
  async fetch(mesh: SurfaceMesh, algorithm: PathQuestion["algorithm"], signal = this.asking.signal): Promise<void> {
    try {
      for (let next = this.awaited[0]; next && !signal.aborted; next = this.awaited[0]) {
        const question = "target" in next ? { sources: [next.from], target: next.target, algorithm } : next;
        const line = await this.ask(mesh, question, signal);
        if (next !== this.awaited[0]) continue;
        this.awaited = this.awaited.slice(1);
        if (line) this.events.came(line);
        else this.events.told("The address names a path between places that nothing connects.");
      }
    } catch (error) {
      this.asking.reportAbout(mesh, error, () => this.fetch(mesh, algorithm, signal));
    }
  }

  // Where no line runs straight on the cursor is soon elsewhere. Who lets go there is told why.
  private async askLive(mesh: SurfaceMesh, question: PathQuestion | StraightLine, signal: AbortSignal): Promise<SurfaceLine | undefined> {
    try {
      return await this.ask(mesh, question, signal);
    } catch (error) {
      if ("direction" in question && kindOf(error) === "refused") return undefined;
      throw error;
    }
  }

  private ask(mesh: SurfaceMesh, question: PathQuestion | StraightLine, signal: AbortSignal): Promise<SurfaceLine | undefined> {
    return this.asking.answerTo(mesh, () => askLine(this.asking.connection, mesh.digest, question, signal));
  }
}
