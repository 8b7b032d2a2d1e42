// A line on the surface: a light core in a dark casing, which shows on every
// colour; faint where something hides it.

import { Color, GreaterDepth, Group, LessEqualDepth, type Vector2 } from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";

interface Layer {
  color: number | string;
  width: number;
  opacity: number;
  hidden: boolean;
}

export class PathLine extends Group {
  private geometry = new LineGeometry();
  private readonly passes: Line2[];

  /** `width` is in CSS pixels. */
  constructor(color: number | string, width: number, resolution: Vector2) {
    super();
    const layers: Layer[] = [
      { color, width: 0.75 * width, opacity: 0.32, hidden: true },
      { color: 0x101018, width: 1.9 * width, opacity: 0.85, hidden: false },
      { color, width, opacity: 1, hidden: false },
    ];
    this.passes = layers.map((layer, order) => {
      const material = new LineMaterial({
        color: new Color(layer.color),
        linewidth: layer.width,
        transparent: true,
        opacity: layer.opacity,
        depthWrite: false,
        depthFunc: layer.hidden ? GreaterDepth : LessEqualDepth,
      });
      material.resolution = resolution;
      const line = new Line2(this.geometry, material);
      line.renderOrder = 10 + order;
      line.frustumCulled = false;
      return line;
    });
    this.add(...this.passes);
    this.visible = false;
  }

  /** x y z of each point, on the screen's scale. */
  setPoints(points: Float32Array): void {
    this.geometry.dispose();
    this.geometry = new LineGeometry();
    this.visible = points.length >= 6;
    if (this.visible) this.geometry.setPositions(points);
    for (const layer of this.passes) layer.geometry = this.geometry;
  }

  dispose(): void {
    this.geometry.dispose();
    for (const layer of this.passes) layer.material.dispose();
  }
}
