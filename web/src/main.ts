// The page: wires the explorer, the server and the panel together.

import { Explorer } from "./explorer";
import { MeshChooser } from "./panel/mesh_chooser";
import { Notice } from "./panel/notice";
import { Panel } from "./panel/panel";
import { PathLabels } from "./panel/path_labels";
import { Recovery } from "./panel/recovery";
import { Theme } from "./panel/theme";
import { byId } from "./panel/elements";
import { NO_WEBGL, Scene } from "./scene/scene";
import type { SurfaceMesh } from "./surface/mesh";
import { Connection } from "./service/connection";
import { wireCanvas } from "./canvas_actions";
import { Address } from "./address";

const notice = new Notice();
const address = new Address((problem) => notice.error(problem));
const scene = openScene();
const theme = new Theme((dark, background) => scene.setBackground(background, dark));
const connection = new Connection(location.origin, address.token);
const recovery = new Recovery(connection, notice, (token) => address.keepToken(token));
const explorer: Explorer = new Explorer(scene, connection, {
  changed: () => {
    panel.update();
    labels.update();
    address.show(explorer);
    canvas.changed();
  },
  value: (distance, exact) => panel.value(distance, exact),
  failed: (error, again) => recovery.handle(error, again),
  told: (what) => notice.hint(what),
  lost: (mesh) => chooser.restore(mesh.digest),
});
const labels = new PathLabels(explorer, scene, (point) => canvas.isSeen(point));
scene.onLost = () => notice.error("The graphics processor is away. The picture comes back with it.");
scene.onRestored = () => notice.clear();
scene.onSurface = () => {
  labels.update();
  canvas.changed();
};
const panel = new Panel(explorer, scene, connection, notice, theme, labels);
const askAsAddressed = (mesh: SurfaceMesh, isChange: boolean) => {
  const { sources, paths, radius } = address.questionOn(mesh);
  void explorer.ask(sources, paths, radius, isChange);
  panel.chooseNext();
};
const open = (mesh: SurfaceMesh) => {
  const isAgain = explorer.mesh?.digest === mesh.digest;
  explorer.show(mesh);
  canvas.show(mesh);
  panel.show(mesh);
  if (!isAgain) askAsAddressed(mesh, false);
};
const chooser = new MeshChooser(connection, notice, recovery, scene.coarseFaces, open, (mesh, indices) => explorer.showCoarse(mesh, indices));
const canvas = wireCanvas(scene, explorer, panel);

void recovery.attempt(async () => {
  await panel.showCapabilities();
  await chooser.list();
});
if (address.mesh) chooser.openDigest(address.mesh);

// An address that is typed or pasted into the tab, or gone back to.
addEventListener("hashchange", () => {
  const { token } = connection;
  const isGood = address.read();
  if (address.token !== token) recovery.goOnWith(address.token);
  const { mesh } = explorer;
  if (!isGood) return;
  if (mesh && mesh.digest === address.mesh) askAsAddressed(mesh, true);
  else if (address.mesh) chooser.openDigest(address.mesh);
});

function openScene(): Scene {
  try {
    return new Scene(byId<HTMLCanvasElement>("picture"));
  } catch (error) {
    byId("welcome").hidden = true;
    notice.error(NO_WEBGL);
    throw error;
  }
}
