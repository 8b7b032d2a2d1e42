// The question on the screen, for the command `geodesic` and for Python.

import type { LineQuestion, PathEnds, StraightLine } from "../surface/line_question";
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
  /** The paths and lines that were kept. */
  lines: readonly LineQuestion[];
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
  const { paths, straight } = partsOf(question.lines);
  for (const { from, target } of paths) {
    const source = `--source ${commandText(from)}`;
    targets.set(source, [...(targets.get(source) ?? []), `--target ${commandText(target)}`]);
  }
  [...targets].forEach(([source, to], i) => {
    lines.push([geodesic, "path", mesh, source, ...to, ...method, `-o ${numbered("paths", i)}.obj`]);
  });
  straight.forEach(({ from, direction, length }, i) => {
    const line = [`--source ${commandText(from)}`, `--direction ${direction.join(",")}`, `--length ${length}`];
    lines.push([geodesic, "trace", mesh, ...line, `-o ${numbered("line", i)}.obj`]);
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
  const { paths, straight } = partsOf(question.lines);
  const calls = paths.map(({ from, target }) => `mesh.path(${pythonText(from)}, ${pythonText(target)}${method})`);
  lines.push(...assigned("path", calls));
  lines.push(...assigned("line", straight.map(({ from, direction, length }) =>
    `mesh.trace(${pythonText(from)}, direction=[${direction.join(", ")}], length=${length})`)));
  return lines.join("\n");
}

// Shortest paths, and lines that run straight on.
function partsOf(lines: readonly LineQuestion[]): { paths: PathEnds[]; straight: StraightLine[] } {
  return {
    paths: lines.filter((line) => "target" in line),
    straight: lines.filter((line) => "direction" in line),
  };
}

// "paths", "paths-2" and so on: no file is written twice.
function numbered(name: string, i: number): string {
  return i ? `${name}-${i + 1}` : name;
}

// One value by its name, several as a list.
function assigned(name: string, calls: string[]): string[] {
  if (calls.length < 2) return calls.map((call) => `${name} = ${call}`);
  return [`${name}s = [`, ...calls.map((call) => `    ${call},`), "]"];
}

function quoted(name: string): string {
  // Not an option.
  const text = name.startsWith("-") ? `./${name}` : name;
  return /^[\w./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}
