// How finely the surface is drawn: coarsely while the picture changes, as a
// browser without a fast graphics processor needs it, and with all faces and
// smooth edges when it is still.

import type { SurfaceMesh } from "../surface/mesh";

/** Meshes of more faces have a coarse list. */
export const DRAWN_WHOLE = 300_000;

/** The coarse list has about so many faces; fewer where there is no graphics processor. */
const COARSE_FACES = 150_000;
const COARSE_FACES_IN_SOFTWARE = 60_000;

/** Meshes of more faces are not drawn whole even when the picture is still. */
const STILL_FACES = 4_000_000;

/** The same where there is no graphics processor: a million faces take seconds, which nothing can cut short. */
const STILL_FACES_IN_SOFTWARE = 500_000;
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** The picture is still when it has not changed for so long. */
const STILL_MS = 300;

export class Detail {
  private changing = true;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly inSoftware: boolean;

  /** `still` is called when the picture should be drawn again, finely. `renderer` draws it: its name. */
  constructor(
    renderer: string,
    private readonly still: () => void,
  ) {
    this.inSoftware = SOFTWARE.test(renderer);
  }

  /** How many faces the coarse list of a large mesh should have. */
  get coarseFaces(): number {
    return this.inSoftware ? COARSE_FACES_IN_SOFTWARE : COARSE_FACES;
  }

  /** Whether all faces are drawn when the picture is still. */
  mayBeWhole(mesh: SurfaceMesh): boolean {
    return mesh.faceCount <= (this.inSoftware ? STILL_FACES_IN_SOFTWARE : STILL_FACES);
  }

  /** The picture changes. */
  change(): void {
    this.changing = true;
    clearTimeout(this.timer);
  }

  /** Whether to draw the coarse list, now that the picture is drawn. */
  isCoarse(mesh: SurfaceMesh): boolean {
    return mesh.coarse !== undefined && (this.changing || !this.mayBeWhole(mesh));
  }

  /** Whether edges may be rough, now that the picture is drawn: smooth ones take twice the time in software. */
  get isDraft(): boolean {
    return this.inSoftware && this.changing;
  }

  /** For tests, which wait for "whole" or "always coarse". */
  name(mesh: SurfaceMesh): string {
    if (mesh.awaitsCoarse) return "coming";
    const isCoarse = this.isCoarse(mesh);
    if (isCoarse && this.mayBeWhole(mesh)) return "coarse";
    return this.isDraft ? "draft" : isCoarse ? "always coarse" : "whole";
  }

  /** The picture was drawn; `more` says whether it is about to change again. */
  drawn(mesh: SurfaceMesh, more: boolean): void {
    clearTimeout(this.timer);
    const mayBeFiner = this.isDraft || (this.isCoarse(mesh) && this.mayBeWhole(mesh));
    if (!mayBeFiner || more) return;
    this.timer = setTimeout(() => {
      this.settle();
      this.still();
    }, STILL_MS);
  }

  /** The picture is still, from the next one on. */
  settle(): void {
    clearTimeout(this.timer);
    this.changing = false;
  }
}

/** Whether all faces are in a picture that is saved. */
export function isSavedWhole(mesh: SurfaceMesh): boolean {
  return mesh.faceCount <= STILL_FACES;
}
