// The question on the screen, for the command `geodesic` and for Python.

import type { PathEnds } from "../placed";
import { commandText, pythonText, sourceText, type Source } from "../surface/place";

export interface AskedQuestion {
  /** The mesh's file or digest. */
  mesh: string;
  /** The server that knows the digest; nothing for a file. */
  server?: string;
  sources: readonly Source[];
  radius?: number;
  /** As the command spells it; nothing for the server's choice. */
  algorithm?: string;
  /** The paths that were kept. */
  paths: readonly PathEnds[];
}

export function commandLines(question: AskedQuestion): string {
  const from = question.sources.map((source) =>
    "curve" in source ? `--curve '${sourceText(source)}'` : `--source ${sourceText(source)}`,
  );
  const geodesic = question.server ? `geodesic --server ${question.server}` : "geodesic";
  const mesh = quoted(question.mesh);
  const method = question.algorithm ? [`--algorithm ${question.algorithm}`] : [];
  const radius = question.radius === undefined ? [] : [`--radius ${question.radius}`];
  const lines = from.length ? [[geodesic, "field", mesh, ...from, ...radius, ...method, "-o field.npy"]] : [];
  // One command for each source that paths start at.
  const targets = new Map<string, string[]>();
  for (const { from, target } of question.paths) {
    const source = `--source ${commandText(from)}`;
    targets.set(source, [...(targets.get(source) ?? []), `--target ${commandText(target)}`]);
  }
  [...targets].forEach(([source, to], i) => {
    lines.push([geodesic, "path", mesh, source, ...to, ...method, `-o paths${i ? `-${i + 1}` : ""}.obj`]);
  });
  return lines.map((words) => words.join(" ")).join("\n");
}

export function pythonLines(question: AskedQuestion): string {
  const sources = question.sources.map((source) =>
    "curve" in source ? `geodesic.Curve([${source.curve.map(pythonText).join(", ")}])` : pythonText(source),
  );
  const from = sources.length === 1 ? sources[0] : `[${sources.join(", ")}]`;
  const radius = question.radius === undefined ? "" : `, radius=${question.radius}`;
  const method = question.algorithm ? `, algorithm="${question.algorithm}"` : "";
  const lines = [
    "import geodesic",
    "",
    question.server
      ? `mesh = geodesic.connect(${JSON.stringify(question.server)}).open(${JSON.stringify(question.mesh)})`
      : `mesh = geodesic.Mesh(${JSON.stringify(question.mesh)})`,
  ];
  if (sources.length) lines.push(`d = mesh.distances(${from}${radius}${method})`);
  const paths = question.paths.map(({ from, target }) => `mesh.path(${pythonText(from)}, ${pythonText(target)}${method})`);
  if (paths.length === 1) lines.push(`path = ${paths[0]}`);
  if (paths.length > 1) lines.push("paths = [", ...paths.map((path) => `    ${path},`), "]");
  return lines.join("\n");
}

function quoted(name: string): string {
  // Not an option.
  const text = name.startsWith("-") ? `./${name}` : name;
  return /^[\w./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}
