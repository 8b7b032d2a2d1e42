// One mesh with its answer, in a file that needs no server: turns, zooms, and
// reads distances and vertices under the cursor.

import { Matrix4, Vector3 } from "three";
import { readEmbedded } from "./embedded";
import { byId, onClick } from "./panel/elements";
import { formatCount, formatNumber } from "./panel/format";
import { ScaleBar } from "./panel/scale_bar";
import { Theme } from "./panel/theme";
import { listenToPointer } from "./pointer";
import { Dots } from "./scene/dots";
import { FieldView } from "./scene/field_view";
import { NO_WEBGL, Scene } from "./scene/scene";
import { SurfaceMesh } from "./surface/mesh";
import { Picker } from "./surface/picking";

function show(): void {
  const answer = readEmbedded(byId("answer").textContent ?? "");
  const canvas = byId<HTMLCanvasElement>("picture");
  const scene = openScene(canvas);
  const theme = new Theme((dark, background) => scene.setBackground(background, dark));
  onClick("theme", () => theme.toggle());
  const mesh = new SurfaceMesh(answer.arrays, answer.digest, answer.name);
  const sources = mesh.toScreen(answer.sources);
  const reference = new Vector3(...(sources.length ? sources.subarray(0, 3) : [0, 0, 0]));
  const field = new FieldView(mesh, scene.material, reference, sources.length > 0);
  field.setAll(answer.distances);
  scene.show(mesh);
  const dots = new Dots(15, scene);
  scene.overlay.add(dots);
  dots.setDots(
    Array.from({ length: sources.length / 3 }, (_, i) => ({ point: sources.subarray(3 * i, 3 * i + 3), fill: [1, 1, 1] })),
  );
  const scale = new ScaleBar(byId("scale"));
  scale.show(field.largest);
  document.title = `${answer.name} - geodesic`;
  byId("mesh-name").textContent = answer.name;
  byId("mesh-size").textContent =
    `${formatCount(mesh.faceCount)} faces, farthest ${formatNumber(field.largest, 8)}`;

  const picker = new Picker(mesh);
  const value = byId("value");
  const view = new Matrix4(); // in which the value was read
  const hide = () => {
    value.hidden = true;
    scale.point(undefined);
  };
  listenToPointer(canvas, {
    move: (at) => {
      const hit = picker.pick(scene.pointerAt(at.x, at.y), scene.camera);
      if (!hit) {
        hide();
        return;
      }
      view.copy(scene.camera.matrixWorld);
      const { face, weights } = hit.place;
      const vertex = mesh.cornersOf(face)[weights.indexOf(Math.max(...weights))];
      const distance = field.at(face, weights);
      value.textContent =
        `${distance === Infinity ? "not reached" : `≈ ${formatNumber(distance, 5)}`}\n` +
        `vertex ${vertex}: ${formatNumber(answer.distances[vertex], 10)}`;
      value.style.setProperty("--x", `${at.x}px`);
      value.style.setProperty("--y", `${at.y}px`);
      value.hidden = false;
      scale.point(distance);
    },
    leave: hide,
    click: () => undefined,
    drawsCurve: () => false,
    grabs: () => false,
    drag: () => undefined,
    dropped: () => undefined,
    draw: () => undefined,
    drawn: () => undefined,
    wheel: () => undefined,
    setTurning: () => undefined,
  });
  scene.onSurface = () => {
    if (!scene.camera.matrixWorld.equals(view)) hide();
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "t") theme.toggle();
    if (event.key === "l") scene.lookAtAll();
  });
}

function openScene(canvas: HTMLCanvasElement): Scene {
  try {
    return new Scene(canvas);
  } catch (error) {
    byId("mesh-size").textContent = NO_WEBGL;
    throw error;
  }
}

show();
