// What the server joined when it read the mesh, and the choice to read the file
// with other joints.

import type { Joining } from "../service/upload";
import { byId, onClick } from "./elements";

export class Seams {
  private readonly notes = byId("mesh-notes");
  private readonly row = byId("joining");
  private readonly choice = byId<HTMLSelectElement>("join");
  private readonly distance = byId<HTMLInputElement>("join-distance");

  /** `chosen` is to read the file of the mesh that is shown anew. */
  constructor(chosen: (joining: Joining) => void) {
    this.choice.addEventListener("change", () => this.showDistance());
    onClick("join-again", () => {
      if (this.choice.value !== "distance") chosen({ keepSeams: this.choice.value === "none" });
      else if (this.distance.reportValidity()) chosen({ keepSeams: false, weldDistance: this.distance.valueAsNumber });
    });
  }

  /** `joining` is how the file of the mesh was read; nothing if the page has no file. */
  show(notes: readonly string[], joining: Joining | undefined): void {
    this.notes.hidden = notes.length === 0;
    this.notes.replaceChildren(
      ...notes.map((note) => {
        const item = document.createElement("li");
        item.textContent = note;
        return item;
      }),
    );
    this.row.hidden = !joining;
    this.choice.value = joining?.keepSeams ? "none" : joining?.weldDistance === undefined ? "rounding" : "distance";
    if (joining?.weldDistance !== undefined) this.distance.value = String(joining.weldDistance);
    this.showDistance();
  }

  private showDistance(): void {
    this.distance.hidden = this.choice.value !== "distance";
  }
}

/** In words, for a mesh that was not read as files are at first; else nothing. */
export function joiningWords({ keepSeams, weldDistance }: Joining): string {
  if (keepSeams) return "nothing joined";
  return weldDistance === undefined ? "" : `joined within ${weldDistance}`;
}
