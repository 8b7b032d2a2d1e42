// One browser and one server for the tests of a file.

import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before } from "node:test";

import { launch, openPage } from "./browser.mjs";
import { temporaryFolder } from "./folder.mjs";
import { sphereObj } from "./meshes.mjs";
import { startServer } from "./server.mjs";

export const SPHERE = sphereObj(24);

export let browser;
export let server;
before(async () => {
  browser = await launch();
  server = await startServer();
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

/** A page that shows the sphere. */
export function sphere(t, options) {
  return shows(t, "sphere.obj", SPHERE, options);
}

/** A page that shows a mesh. */
export async function shows(t, name, mesh, options) {
  const viewer = await openPage(browser, server.url, options);
  t.after(() => viewer.close());
  await viewer.drop(name, mesh);
  await viewer.shown(name);
  return viewer;
}

/** What the command says of a question that the page wrote down. */
export function ask(server, t, mesh, commandLine, name = "sphere.obj") {
  const folder = temporaryFolder(t);
  writeFileSync(join(folder, name), mesh);
  const [, command, ...words] = commandLine.split(" ");
  return JSON.parse(execFileSync(
    process.env.GEODESIC,
    ["--server", `127.0.0.1:${server.grpcPort}`, "--json", command, ...words.slice(0, words.indexOf("-o"))],
    { cwd: folder, encoding: "utf8" }));
}
