// A proxy between the browser and the server, as people put one there.

import { once } from "node:events";
import { createServer, request } from "node:http";

/**
 * Passes on what comes to `url`, with the Host that the server is called by; answers
 * 413 to bodies of more than `maxBytes`.
 */
export async function startProxy(server, maxBytes = Infinity) {
  const proxy = createServer((asked, answer) => {
    if (Number(asked.headers["content-length"] ?? 0) > maxBytes) {
      asked.resume().on("end", () => answer.writeHead(413).end());
      return;
    }
    const headers = { ...asked.headers, host: `127.0.0.1:${server.port}` };
    const passed = request(server.url + asked.url, { method: asked.method, headers }, (answered) => {
      answer.writeHead(answered.statusCode, answered.headers);
      answered.pipe(answer);
    });
    asked.pipe(passed);
  });
  proxy.listen(0, "127.0.0.1");
  await once(proxy, "listening");
  return {
    url: `http://127.0.0.1:${proxy.address().port}`,
    stop: () => {
      proxy.closeAllConnections();
      proxy.close();
    },
  };
}
