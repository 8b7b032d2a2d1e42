// Asks about the mesh that is shown, again where the server has lost it, and tells
// what fails.

import type { SurfaceMesh } from "../surface/mesh";
import { askRestoring } from "./ask_restoring";
import type { Connection } from "./connection";
import { kindOf } from "./errors";

export interface AskingEvents {
  /** A question failed; `again` asks it anew, if it still matters by then. */
  failed(error: unknown, again: () => void): void;
  /** The server has lost the mesh: whether it has it again. */
  lost(mesh: SurfaceMesh): Promise<boolean>;
}

export class Asking {
  private shown: SurfaceMesh | undefined;
  private abort = new AbortController();

  constructor(
    readonly connection: Connection,
    private readonly events: AskingEvents,
  ) {}

  /** Another mesh is shown: what was asked about the one before ends. */
  show(mesh: SurfaceMesh): void {
    this.abort.abort();
    this.abort = new AbortController();
    this.shown = mesh;
  }

  /** Of what is asked about the mesh, whatever the sources. */
  get signal(): AbortSignal {
    return this.abort.signal;
  }

  answerTo<T>(mesh: SurfaceMesh, question: () => Promise<T>): Promise<T> {
    return askRestoring(question, () => this.events.lost(mesh));
  }

  /** The work is done again only while the mesh is shown. */
  reportAbout(mesh: SurfaceMesh, error: unknown, work: () => Promise<void>): void {
    this.report(error, () => {
      if (mesh === this.shown) void work();
    });
  }

  report(error: unknown, again: () => void): void {
    if (kindOf(error) !== "cancelled") this.events.failed(error, again);
  }
}
