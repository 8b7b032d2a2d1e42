// The length of each kept path, beside its end on the picture.

import type { Vector3 } from "three";
import type { Explorer } from "../explorer";
import type { Scene } from "../scene/scene";
import { byId } from "./elements";
import { formatNumber } from "./format";

/** From the end to the left and the middle of the text, in CSS pixels. */
const BESIDE = { x: 12, y: -12 };

interface Label {
  text: string;
  x: number;
  y: number;
}

export class PathLabels {
  private readonly box = byId("labels");
  private labels: Label[] = [];

  /** `isSeen` says whether nothing hides a point of the surface. */
  constructor(
    private readonly explorer: Explorer,
    private readonly scene: Scene,
    private readonly isSeen: (point: Vector3) => boolean,
  ) {}

  /** The paths or the view are others now. */
  update(): void {
    const ends = this.explorer.pathEnds().filter(({ point }) => this.isSeen(point));
    this.labels = ends.map(({ point, length }) => {
      const { x, y } = this.scene.pixelOf(point);
      return { text: formatNumber(length, 6), x: x + BESIDE.x, y: y + BESIDE.y };
    });
    this.box.replaceChildren(...this.labels.map(({ text, x, y }) => {
      const element = document.createElement("span");
      element.textContent = text;
      element.style.left = `${x}px`;
      element.style.top = `${y}px`;
      return element;
    }));
  }

  /** Writes them on a copy of the picture, which has `ratio` pixels in one of CSS. */
  drawOn(context: CanvasRenderingContext2D, ratio: number): void {
    const style = getComputedStyle(document.documentElement);
    context.font = `${13 * ratio}px system-ui, sans-serif`;
    context.textBaseline = "middle";
    context.lineJoin = "round";
    context.lineWidth = 4 * ratio;
    context.strokeStyle = style.getPropertyValue("--background");
    context.fillStyle = style.getPropertyValue("--text");
    for (const { text, x, y } of this.labels) {
      context.strokeText(text, ratio * x, ratio * y);
      context.fillText(text, ratio * x, ratio * y);
    }
  }
}
