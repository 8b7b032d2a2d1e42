// The cross that Shift and the arrow keys move over the picture, for those who
// have no mouse.

import { byId } from "./panel/elements";

const STEP_PIXELS = 12;

export interface ScreenPoint {
  /** Pixels from the left and the top of the window. */
  x: number;
  y: number;
}

export class Aim {
  private readonly cross = byId("aim");
  private readonly stage = byId("stage");
  private at: ScreenPoint | undefined;

  /** Where it is; undefined while it is hidden. */
  get point(): ScreenPoint | undefined {
    return this.at;
  }

  /** Shows it by so many steps from where it was; in the middle if it was hidden. */
  move(right: number, down: number): ScreenPoint {
    const box = this.stage.getBoundingClientRect();
    const { x, y } = this.at ?? { x: box.left + box.width / 2, y: box.top + box.height / 2 };
    const within = (value: number, low: number, size: number) => Math.min(Math.max(value, low), low + size - 1);
    this.at = {
      x: within(x + right * STEP_PIXELS, box.left, box.width),
      y: within(y + down * STEP_PIXELS, box.top, box.height),
    };
    this.cross.style.left = `${this.at.x - box.left}px`;
    this.cross.style.top = `${this.at.y - box.top}px`;
    this.cross.hidden = false;
    return this.at;
  }

  hide(): void {
    this.at = undefined;
    this.cross.hidden = true;
  }
}
