// The path under the cursor: one question at a time, the newest.

import { NewestOnly } from "../service/newest_only";
import type { SurfacePath } from "../service/questions";
import type { SurfaceMesh } from "../surface/mesh";
import type { Place } from "../surface/place";
import { PathLine } from "./path_line";
import type { Scene } from "./scene";

const COLOR = 0xffffff;

/** A request that takes longer gives way to a newer cursor. */
const PATIENCE_MS = 250;

interface Aimed {
  mesh: SurfaceMesh;
  target: Place;
  /** When the cursor came there. */
  since: number;
}

export interface CursorPathActions {
  /** The path to `target`; nothing if none leads there. */
  ask(mesh: SurfaceMesh, target: Place, signal: AbortSignal): Promise<SurfacePath | undefined>;
  /** Its length has come. */
  value(distance: number): void;
  failed(error: unknown, again: () => void): void;
}

export class CursorPath {
  private readonly line: PathLine;
  private readonly newest = new NewestOnly(PATIENCE_MS);
  private aimed: Aimed | undefined;

  constructor(
    private readonly scene: Scene,
    private readonly actions: CursorPathActions,
  ) {
    this.line = new PathLine(COLOR, 3, scene.resolution);
    scene.overlay.add(this.line);
  }

  lead(mesh: SurfaceMesh, target: Place, since: number): void {
    const aimed = (this.aimed = { mesh, target, since });
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

  private async draw({ mesh, target, since }: Aimed, signal: AbortSignal): Promise<void> {
    try {
      const path = await this.actions.ask(mesh, target, signal);
      if (this.aimed?.mesh !== mesh || signal.aborted) return;
      this.line.setPoints(path ? mesh.toScreen(path.positions) : new Float32Array());
      this.actions.value(path?.distance ?? Infinity);
      this.scene.draw();
      performance.measure("path under the cursor", { start: since, end: performance.now() });
    } catch (error) {
      this.actions.failed(error, () => {
        if (this.aimed) this.lead(this.aimed.mesh, this.aimed.target, this.aimed.since);
      });
    }
  }
}
