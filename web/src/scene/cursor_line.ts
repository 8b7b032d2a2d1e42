// The line at the cursor: one question at a time, the newest.

import { NewestOnly } from "../service/newest_only";
import type { SurfaceLine } from "../service/lines";
import type { SurfaceMesh } from "../surface/mesh";
import { PathLine } from "./path_line";
import type { Scene } from "./scene";

const COLOR = 0xffffff;

/** A request that takes longer gives way to a newer cursor. */
const PATIENCE_MS = 250;

/** Asks for the line; nothing if none leads there. */
type Ask = (signal: AbortSignal) => Promise<SurfaceLine | undefined>;

interface Aimed {
  mesh: SurfaceMesh;
  ask: Ask;
  /** When the cursor came there. */
  since: number;
}

export interface CursorLineActions {
  /** Its length has come; nothing if there is no line. */
  value(length: number | undefined): void;
  failed(error: unknown, again: () => void): void;
}

export class CursorLine {
  private readonly line: PathLine;
  private readonly newest = new NewestOnly(PATIENCE_MS);
  private aimed: Aimed | undefined;

  constructor(
    private readonly scene: Scene,
    private readonly actions: CursorLineActions,
  ) {
    this.line = new PathLine(COLOR, 3, scene.resolution);
    scene.overlay.add(this.line);
  }

  lead(mesh: SurfaceMesh, ask: Ask, since: number): void {
    const aimed = (this.aimed = { mesh, ask, since });
    this.newest.ask((signal) => this.draw(aimed, signal));
  }

  hide(): void {
    this.aimed = undefined;
    this.newest.stop();
    if (!this.line.visible) return;
    this.line.setPoints(new Float32Array());
    this.scene.redraw();
  }

  /** The first line that a browser draws may take it some tenths of a second. */
  warmUp(): void {
    this.line.setPoints(new Float32Array([-2, 0, 0, 2, 0, 0]));
  }

  private async draw({ mesh, ask, since }: Aimed, signal: AbortSignal): Promise<void> {
    try {
      const line = await ask(signal);
      if (this.aimed?.mesh !== mesh || signal.aborted) return;
      this.line.setPoints(line ? mesh.toScreen(line.positions) : new Float32Array());
      this.actions.value(line?.length);
      this.scene.draw();
      performance.measure("path under the cursor", { start: since, end: performance.now() });
    } catch (error) {
      this.actions.failed(error, () => {
        if (this.aimed) this.lead(this.aimed.mesh, this.aimed.ask, this.aimed.since);
      });
    }
  }
}
