// What clicks, moves, drags and keys on the picture do.

import { Vector2, type Matrix4, type Vector3 } from "three";
import { Aim, type ScreenPoint } from "./aim";
import type { Explorer } from "./explorer";
import { byId } from "./panel/elements";
import type { Panel } from "./panel/panel";
import { isMeantForField, listenToPointer } from "./pointer";
import type { Scene } from "./scene/scene";
import type { SurfaceMesh } from "./surface/mesh";
import { Picker, type Hit } from "./surface/picking";
import type { Place } from "./surface/place";

const TURN_RADIANS = 0.12;
const ZOOM = 1.15;
/** Points of a drawn curve are at least so far apart. */
const CURVE_PIXELS = 8;
/** A press so near to a source takes hold of it. */
const GRAB_PIXELS = 12;
/** A turn of the wheel changes the radius by this share of the largest distance. */
const WHEEL_SHARE = 0.03;

/** Asked again about a cursor that rests when the picture has not changed for so long. */
const REST_MS = 150;

/** Points that are so far behind what is picked are seen, on the screen's scale. */
const PICK_ERROR = 2e-3;

export interface WiredCanvas {
  show(mesh: SurfaceMesh): void;
  /** Whether nothing hides a point of the surface. */
  isSeen(point: Vector3): boolean;
  /** The view or the field is another one: so is what is under a cursor that rests. */
  changed(): void;
}

/** What a drag does that begins at a source. */
interface Held {
  drag(place: Place, since: number): void;
  drop(): void;
  /** Takes back what the drag has done. */
  cancel(): void;
}

export function wireCanvas(scene: Scene, explorer: Explorer, panel: Panel): WiredCanvas {
  const canvas = byId<HTMLCanvasElement>("picture");
  let picker: Picker | undefined;
  let sketch: { place: Place; point: Vector3 }[] = [];
  let lastDrawn = { x: 0, y: 0 };
  let held: Held | undefined;
  let cursor: ScreenPoint | undefined;
  const aim = new Aim();
  // What there was when the place under the cursor was looked for.
  let seen: { field: unknown; summary: unknown; view: Matrix4 } | undefined;
  let rest: ReturnType<typeof setTimeout> | undefined;
  const pick = (at: ScreenPoint): Hit | undefined =>
    picker?.pick(scene.pointerAt(at.x, at.y), scene.camera);

  const isSeen = (point: Vector3): boolean => {
    const { camera } = scene;
    const { x, y } = point.clone().project(camera);
    const hit = picker?.pick(new Vector2(x, y), camera);
    const isBefore = hit && hit.point.distanceTo(camera.position) < point.distanceTo(camera.position) - PICK_ERROR;
    return !isBefore;
  };

  const sourceAt = (at: ScreenPoint): number => {
    const box = canvas.getBoundingClientRect();
    return explorer.sourcesOnScreen().findIndex((point) => {
      if (!point) return false;
      const pixel = scene.pixelOf(point);
      const isNear = Math.hypot(box.left + pixel.x - at.x, box.top + pixel.y - at.y) < GRAB_PIXELS;
      return isNear && isSeen(point);
    });
  };

  const hover = (at: ScreenPoint, since: number) => {
    seen = { field: explorer.field, summary: explorer.summary, view: scene.camera.matrixWorld.clone() };
    canvas.classList.toggle("grab", sourceAt(at) >= 0);
    explorer.hover(pick(at)?.place, since);
  };

  const moveTo = (at: ScreenPoint, since: number) => {
    cursor = at;
    panel.pointer(at);
    hover(at, since);
  };

  const click = (at: ScreenPoint, shift: boolean) => {
    const place = pick(at)?.place;
    if (!place) return;
    if (shift) void explorer.setSources([...explorer.sources, place]);
    else if (panel.tool === "path" && explorer.sources.length) void explorer.keepPath(place);
    else void explorer.setSources([place]);
    if (explorer.sources.length === 1 && panel.tool === "source") panel.choose("path");
  };

  const moving = (number: number): Held => {
    // Told apart from other drags.
    const gesture = {};
    return {
      drag: (place) => explorer.moveSource(number, place, gesture),
      drop: () => explorer.dropSource(),
      cancel: () => explorer.cancel(gesture),
    };
  };

  const straightFrom = (number: number): Held | undefined => {
    const from = explorer.sources[number];
    if (explorer.straightLength === undefined || "curve" in from) return undefined;
    let last: Place | undefined;
    return {
      drag: (place, since) => {
        last = place;
        explorer.leadStraight(from, place, since);
      },
      drop: () => {
        if (last) void explorer.keepStraight(from, last);
      },
      cancel: () => explorer.hover(undefined, 0),
    };
  };

  const pointer = listenToPointer(canvas, {
    move: (at) => {
      aim.hide();
      moveTo(at, at.since);
    },
    leave: () => {
      if (aim.point) return;
      cursor = undefined;
      explorer.hover(undefined, 0);
    },
    click: (at) => {
      aim.hide();
      click(at, at.shift);
    },
    drawsCurve: (alt) => {
      sketch = [];
      held = undefined;
      return explorer.mesh !== undefined && (alt || panel.tool === "curve");
    },
    grabs: (at) => {
      const number = sourceAt(at);
      held = number < 0 ? undefined : panel.tool === "straight" ? straightFrom(number) : moving(number);
      return held !== undefined;
    },
    drag: (at) => {
      const place = pick(at)?.place;
      if (place) held?.drag(place, at.since);
      panel.pointer(at);
    },
    dropped: () => held?.drop(),
    draw: (at) => {
      if (sketch.length && Math.hypot(at.x - lastDrawn.x, at.y - lastDrawn.y) < CURVE_PIXELS) return;
      const hit = pick(at);
      if (!hit) return;
      lastDrawn = at;
      sketch.push(hit);
      explorer.drawSketch(sketch.map(({ point }) => point));
    },
    drawn: () => {
      void explorer.addCurve(sketch.map(({ place }) => place), panel.tool === "curve");
      sketch = [];
    },
    wheel: (steps) => {
      const largest = explorer.field?.largest ?? 0;
      if (largest > 0) panel.setRadius((explorer.radius ?? largest) - steps * WHEEL_SHARE * largest);
    },
    setTurning: (enabled) => scene.setTurning(enabled),
  });

  const moveAim = (right: number, down: number) => moveTo(aim.move(right, down), performance.now());
  const clickAim = (shift: boolean) => {
    if (aim.point) click(aim.point, shift);
    else moveAim(0, 0);
  };
  // Ends the drag or the curve under way, or else what the next click would do.
  const stop = () => {
    if (pointer.cancel()) {
      sketch = [];
      explorer.drawSketch([]);
      held?.cancel();
      return;
    }
    if (aim.point) {
      aim.hide();
      cursor = undefined;
      explorer.hover(undefined, 0);
    }
    if (panel.tool === "curve" || panel.tool === "straight") panel.chooseNext();
  };
  const keys: Record<string, () => void> = {
    ArrowLeft: () => scene.turn(TURN_RADIANS, 0, 1),
    ArrowRight: () => scene.turn(-TURN_RADIANS, 0, 1),
    ArrowUp: () => scene.turn(0, TURN_RADIANS, 1),
    ArrowDown: () => scene.turn(0, -TURN_RADIANS, 1),
    "+": () => scene.turn(0, 0, 1 / ZOOM),
    "-": () => scene.turn(0, 0, ZOOM),
    Backspace: () => explorer.removeLast(),
    Escape: stop,
    s: () => panel.choose("source"),
    p: () => panel.choose("path"),
    c: () => panel.choose("curve"),
    d: () => panel.choose("straight"),
    i: () => panel.toggleIsolines(),
    t: () => panel.toggleTheme(),
    l: () => scene.lookAtAll(),
    "?": () => panel.help(),
    Enter: () => clickAim(false),
    "Shift+ArrowLeft": () => moveAim(-1, 0),
    "Shift+ArrowRight": () => moveAim(1, 0),
    "Shift+ArrowUp": () => moveAim(0, -1),
    "Shift+ArrowDown": () => moveAim(0, 1),
    "Shift+Enter": () => clickAim(true),
    "Control+z": () => panel.undo(),
    "Control+Shift+z": () => panel.redo(),
    "Control+y": () => panel.redo(),
  };
  document.addEventListener("keydown", (event) => {
    if (isMeantForField(event) || document.querySelector("dialog[open]")) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const hasControl = event.ctrlKey || event.metaKey;
    const held = (hasControl ? "Control+" : "") + (event.shiftKey ? "Shift+" : "");
    // Signs such as ? need Shift on some keyboards.
    const action = keys[held + key] ?? (hasControl ? undefined : keys[key]);
    if (!action) return;
    event.preventDefault();
    action();
  });
  return {
    show: (mesh) => (picker = new Picker(mesh)),
    isSeen,
    changed: () => {
      if (!cursor || !seen) return;
      const hasTurned = !scene.camera.matrixWorld.equals(seen.view);
      if (!hasTurned && seen.field === explorer.field && seen.summary === explorer.summary) return;
      if (hasTurned) explorer.hover(undefined, 0);
      clearTimeout(rest);
      rest = setTimeout(() => {
        // A field that is on its way will be told of when it is there.
        if (cursor && !explorer.fields.isWaiting) hover(cursor, performance.now());
      }, REST_MS);
    },
  };
}
