// The real server, with its door for browsers on a free port.

import { execFileSync, spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { createReadStream, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { once } from "node:events";

/** Starts geodesicd with these flags; `stop()` ends it and returns its code. */
export function startServer(...flags) {
  return startServerOn(0, ...flags);
}

/** The same with its door for browsers on this port. */
export async function startServerOn(webPort, ...flags) {
  const folder = mkdtempSync(join(tmpdir(), "geodesicd-"));
  // Named pipes: reading one waits for the server.
  const portFiles = ["port", "web-port"].map((name) => join(folder, name));
  execFileSync("mkfifo", portFiles);
  const [program] = need("GEODESICD");
  const child = spawn(
    program,
    ["--listen", "127.0.0.1:0", "--port-file", portFiles[0],
      "--web", `127.0.0.1:${webPort}`, "--web-port-file", portFiles[1], ...flags],
    { stdio: ["ignore", "ignore", "pipe"] });
  const log = [];
  createInterface({ input: child.stderr }).on("line", (line) => log.push(line));
  const ended = once(child, "exit").then(([code]) => {
    rmSync(folder, { recursive: true });
    return code;
  });
  const failed = ended.then(() => { throw new Error(log.join("\n")); });
  failed.catch(() => {});
  // Both at once: the server waits for the readers, in an order of its own.
  const ports = await Promise.all(portFiles.map(async (file) => {
    const line = createInterface({ input: createReadStream(file) });
    return Number((await Promise.race([once(line, "line"), failed]))[0]);
  }));
  return {
    process: child,
    grpcPort: ports[0],
    port: ports[1],
    url: `http://127.0.0.1:${ports[1]}`,
    log,
    stop: () => {
      child.kill("SIGTERM");
      return ended;
    },
  };
}

/** The words of an environment variable that the caller sets. */
export function need(name) {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set`);
  return value.split(" ");
}

/** A file of tokens, {name: [token, scopes]}, and a function that removes it. */
export function writeTokens(tokens, quotas = {}) {
  const folder = mkdtempSync(join(tmpdir(), "tokens-"));
  const path = join(folder, "tokens.json");
  writeFileSync(path, JSON.stringify({
    tokens: Object.entries(tokens).map(([name, [token, scopes]]) => ({
      name, scopes, sha256: createHash("sha256").update(token).digest("hex"),
    })),
    quotas,
  }));
  return { path, remove: () => rmSync(folder, { recursive: true }) };
}

/** Waits until `condition()` holds. */
export async function until(condition, seconds = 60) {
  const end = Date.now() + 1000 * seconds;
  while (!(await condition())) {
    if (Date.now() > end) throw new Error(`not within ${seconds} s: ${condition}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}
