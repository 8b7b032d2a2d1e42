// Two builds: the page that geodesicd serves (dist/) and, with --mode viewer, the
// single file that `geodesic field -o field.html` fills with a mesh and its
// answer (template/viewer.html).
import { readFileSync } from "node:fs";
import { defineConfig, type Plugin } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

/** Writes the licences of what is built in beside it. */
function licenses(): Plugin {
  const names = ["three", "three-mesh-bvh", "meshoptimizer", "@connectrpc/connect", "@connectrpc/connect-web", "@bufbuild/protobuf"];
  const text = (name: string) => {
    const folder = `node_modules/${name}`;
    const { version, license } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
    const terms = ["LICENSE", "LICENSE.md"].map((file) => {
      try {
        return readFileSync(`${folder}/${file}`, "utf8");
      } catch {
        return "";
      }
    });
    return `== ${name} ${version} (${license})\n\n${terms.join("") || "Its terms are at the end.\n"}`;
  };
  const apache = `== Apache License 2.0\n\n${readFileSync("../LICENSE", "utf8")}`;
  return {
    name: "licenses",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: "licenses.txt", source: [...names.map(text), apache].join("\n") });
    },
  };
}

export default defineConfig(({ mode }) => ({
  base: "./",
  plugins: mode === "viewer" ? [viteSingleFile()] : [licenses()],
  build: {
    target: "es2022",
    outDir: mode === "viewer" ? "template" : "dist",
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1200,
    rollupOptions: {
      input: mode === "viewer" ? "viewer.html" : "index.html",
      output: { entryFileNames: "page.js", assetFileNames: "page[extname]" },
    },
  },
}));
