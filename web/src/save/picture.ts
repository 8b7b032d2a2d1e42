// The picture as it is on the screen, with its scale, the lengths of paths, and what it shows.

import { cssColor } from "../scene/colormap";
import type { Legend } from "../panel/legend";
import type { PathLabels } from "../panel/path_labels";
import type { FieldView } from "../scene/field_view";
import { scaleLabels } from "../scene/isoline_scale";
import type { Scene } from "../scene/scene";

export function drawPicture(scene: Scene, field: FieldView | undefined, labels: PathLabels, legend: Legend): Promise<Blob> {
  const picture = scene.takePicture();
  const context = picture.getContext("2d");
  if (context && field && field.scaleEnd > 0) drawScale(context, field, picture.height);
  for (const text of [labels, legend]) if (context) text.drawOn(context, scene.pixelRatio.value);
  return new Promise((resolve, reject) =>
    picture.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("The picture could not be made."))), "image/png"),
  );
}

function drawScale(context: CanvasRenderingContext2D, field: FieldView, height: number): void {
  const unit = height / 700;
  const bar = { left: 24 * unit, top: 0.28 * height, width: 14 * unit, height: 0.44 * height };
  for (let y = 0; y < bar.height; y++) {
    context.fillStyle = cssColor(1 - y / bar.height);
    context.fillRect(bar.left, bar.top + y, bar.width, 1);
  }
  context.font = `${13 * unit}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--text");
  for (const { at, text } of scaleLabels(field.scaleEnd)) {
    const y = bar.top + bar.height * (1 - at / field.scaleEnd);
    context.fillText(text, bar.left + bar.width + 8 * unit, y);
  }
}
