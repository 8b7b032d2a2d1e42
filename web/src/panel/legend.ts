// What the picture shows, in words: beside it on the page, and on pictures that are saved.

import type { Explorer } from "../explorer";
import type { FieldView } from "../scene/field_view";
import { chooseIsolines } from "../scene/isoline_scale";
import type { Scene } from "../scene/scene";
import type { SurfaceMesh } from "../surface/mesh";
import { isStraight } from "../service/lines";
import { sourcesWords } from "../surface/place_words";
import { PREVIEW_WORDS } from "../surface/preview";
import { byId } from "./elements";
import { countText, formatCount, formatNumber } from "./format";
import type { Methods } from "./methods";

const UNIT = "in the unit of the file";

/** Where the first line begins, and how large it is, in CSS pixels. */
const LEFT = 20;
const TOP = 12;
const LINE_HEIGHT = 17;
const FONT = "12px system-ui, sans-serif";

export class Legend {
  private readonly box = byId("legend");
  private lines: string[] = [];

  constructor(
    private readonly explorer: Explorer,
    private readonly scene: Scene,
    private readonly methods: Methods,
  ) {}

  /** The picture is another one. */
  update(): void {
    const { mesh, field, paths } = this.explorer;
    this.lines = mesh && field ? this.describe(mesh, field) : [];
    const straight = paths.filter(isStraight).length;
    const shortest = paths.length - straight;
    if (mesh && shortest) this.lines.push(`orange: ${countText(shortest, "exact shortest path")}, with the length`);
    if (mesh && straight) this.lines.push(`pink: ${countText(straight, "line")} straight on, with the length`);
    this.box.textContent = this.lines.join("\n");
  }

  /** Writes it on a copy of the picture, which has `ratio` pixels in one of CSS. */
  drawOn(context: CanvasRenderingContext2D, ratio: number): void {
    context.save();
    context.scale(ratio, ratio);
    const style = getComputedStyle(document.documentElement);
    context.font = FONT;
    context.textBaseline = "top";
    context.lineJoin = "round";
    context.lineWidth = 4;
    context.strokeStyle = style.getPropertyValue("--background");
    context.fillStyle = style.getPropertyValue("--text");
    const width = context.canvas.width / ratio - 2 * LEFT;
    this.lines.flatMap((line) => wrap(context, line, width)).forEach((line, i) => {
      context.strokeText(line, LEFT, TOP + i * LINE_HEIGHT);
      context.fillText(line, LEFT, TOP + i * LINE_HEIGHT);
    });
    context.restore();
  }

  private describe(mesh: SurfaceMesh, field: FieldView): string[] {
    const from = sourcesWords(mesh, this.explorer.fields.sources);
    const method = this.methods.nameOf(this.explorer.fields.algorithm);
    const lines: string[] = [];
    switch (field.painted) {
      case "distances":
        lines.push(`${mesh.name}: distance from ${from}`, `${this.accuracy(field)} (${method}), ${UNIT}`);
        break;
      case "cells":
        lines.push(`${mesh.name}: colours tell which source is nearest, darker is farther: ${from}`, `${this.accuracy(field)} (${method})`);
        break;
      case "difference":
        lines.push(...this.describeDifference(mesh, field, method, from));
        break;
    }
    const { step } = chooseIsolines(field.largest);
    if (this.scene.material.uniforms.showLines.value && step > 0) {
      lines.push(`lines: ${field.painted === "difference" ? `distances of ${method}` : "distances"}, every ${formatNumber(step, 6)}`);
    }
    const { radius } = this.explorer;
    if (radius !== undefined) lines.push(`up to ${formatNumber(radius, 4)}; what is farther is grey`);
    return lines;
  }

  private describeDifference(mesh: SurfaceMesh, field: FieldView, method: string, from: string): string[] {
    const { difference } = field;
    if (!difference) return [];
    const { against } = this.explorer.fields;
    const other = this.methods.nameOf(against);
    const [low, high] = difference.range.map((value) => formatNumber(value, 3));
    const kind = this.methods.isApproximate(against) ? "approximate" : "exact";
    const lines = [
      `${mesh.name}: how far ${other} (${kind}) is from ${method} (${this.accuracy(field)}), without sign, ${UNIT}`,
      `${other} − ${method} is from ${low} to ${high}`,
      `both: distance from ${from}`,
    ];
    if (difference.oneSided) lines.push(`grey: ${formatCount(difference.oneSided)} of the vertices have a distance in one of them only`);
    return lines;
  }

  private accuracy(field: FieldView): string {
    if (field.isPreview) return PREVIEW_WORDS;
    return this.explorer.summary ? "exact" : "exact, still on its way: grey is not known yet";
  }
}

function wrap(context: CanvasRenderingContext2D, text: string, width: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(" ")) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && context.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
