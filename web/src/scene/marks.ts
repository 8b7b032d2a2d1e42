// What stands on the surface beside the field: sources and curves, kept paths and
// straight lines with their ends, samples.

import { Vector3 } from "three";
import { isSource, type Placed } from "../placed";
import { isStraight, type SurfaceLine } from "../service/lines";
import type { SurfaceMesh } from "../surface/mesh";
import type { Place } from "../surface/place";
import { CELL_COLORS } from "./colormap";
import { Dots, type Dot } from "./dots";
import { PathLine } from "./path_line";
import type { Scene } from "./scene";

const PATH_COLOR = 0xff8c42;
const STRAIGHT_COLOR = 0xff7ac6;
export const CURVE_COLOR = 0x8fd3ff;
const WHITE = [1, 1, 1];
const SAMPLE_FILL = [0.55, 0.83, 1];
const PATH_FILL = [1, 0.55, 0.26];
const STRAIGHT_FILL = [1, 0.48, 0.78];

export class Marks {
  /** By the path or the curve that they show. */
  private readonly lines = new Map<object, PathLine>();
  private readonly dots: Dots;
  private readonly samples: Dots;

  constructor(private readonly scene: Scene) {
    this.dots = new Dots(15, scene);
    this.samples = new Dots(10, scene);
    scene.overlay.add(this.samples, this.dots);
  }

  /** `inCells`: sources have the colours of their cells. */
  show(mesh: SurfaceMesh, { sources, paths, samples }: Placed, inCells: boolean): void {
    this.dropLinesBut(new Set<object>([...paths, ...sources]));
    for (const path of paths) this.addLine(mesh, path, isStraight(path) ? STRAIGHT_COLOR : PATH_COLOR, path.positions);
    const dots: Dot[] = [];
    const add = (point: Vector3, fill: readonly number[]) => dots.push({ point: point.toArray(), fill });
    sources.forEach((source, i) => {
      if ("curve" in source) {
        this.addLine(mesh, source, CURVE_COLOR, new Float64Array(source.curve.flatMap((place) => mesh.positionOf(place))));
      } else {
        add(onScreen(mesh, source), inCells ? CELL_COLORS[i % CELL_COLORS.length].map((byte) => byte / 255) : WHITE);
      }
    });
    for (const path of paths) {
      const fill = isStraight(path) ? STRAIGHT_FILL : PATH_FILL;
      const { from } = path.question;
      if (!isSource(from, sources)) add(onScreen(mesh, from), fill);
      add(endOnScreen(mesh, path), fill);
    }
    this.dots.setDots(dots);
    this.samples.setDots(
      samples.map(({ vertex }) => ({ point: onScreen(mesh, { kind: "vertex", vertex }).toArray(), fill: SAMPLE_FILL })));
  }

  /** One dot in the middle: the first that a browser draws may take it some tenths of a second. */
  warmUp(): void {
    this.dots.setDots([{ point: [0, 0, 0], fill: WHITE }]);
  }

  private addLine(mesh: SurfaceMesh, owner: object, color: number, positions: Float64Array): void {
    if (this.lines.has(owner)) return;
    const line = new PathLine(color, 3, this.scene.resolution);
    line.setPoints(mesh.toScreen(positions));
    this.lines.set(owner, line);
    this.scene.overlay.add(line);
  }

  private dropLinesBut(kept: ReadonlySet<object>): void {
    for (const [owner, line] of this.lines) {
      if (kept.has(owner)) continue;
      this.scene.overlay.remove(line);
      line.dispose();
      this.lines.delete(owner);
    }
  }
}

/** Where a place is on the screen's scale. */
export function onScreen(mesh: SurfaceMesh, place: Place): Vector3 {
  return new Vector3(...mesh.toScreen(new Float64Array(mesh.positionOf(place))));
}

/** Where a line ends on the screen's scale. */
export function endOnScreen(mesh: SurfaceMesh, { positions }: SurfaceLine): Vector3 {
  return new Vector3(...mesh.toScreen(positions.slice(-3)));
}
