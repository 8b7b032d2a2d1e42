// The scale beside the picture: colours from 0 to the greatest distance, or
// difference, the numbers at thick isolines, and a mark at the value under the cursor.

import { cssColor } from "../scene/colormap";
import { scaleLabels } from "../scene/isoline_scale";

export class ScaleBar {
  private readonly ticks = document.createElement("div");
  private readonly mark = document.createElement("div");
  private largest = 0;

  constructor(private readonly element: HTMLElement) {
    const bar = document.createElement("canvas");
    bar.className = "scale-colors";
    bar.width = 1;
    bar.height = 128;
    const context = bar.getContext("2d");
    for (let y = 0; context && y < 128; y++) {
      context.fillStyle = cssColor(1 - y / 127);
      context.fillRect(0, y, 1, 1);
    }
    this.ticks.className = "scale-ticks";
    this.mark.className = "scale-mark";
    this.mark.hidden = true;
    this.element.append(bar, this.ticks, this.mark);
  }

  /** Nothing if there is no largest value. */
  show(largest: number): void {
    this.largest = largest;
    this.element.hidden = !(largest > 0);
    this.ticks.replaceChildren(
      ...scaleLabels(largest).map(({ at, text }) => {
        const tick = document.createElement("span");
        tick.textContent = text;
        tick.style.bottom = `${(100 * at) / largest}%`;
        return tick;
      }),
    );
  }

  /** Marks a value; nothing takes the mark away. */
  point(value: number | undefined): void {
    const shown = value !== undefined && Number.isFinite(value) && this.largest > 0;
    this.mark.hidden = !shown;
    if (shown) this.mark.style.bottom = `${Math.min((100 * value) / this.largest, 100)}%`;
  }
}
