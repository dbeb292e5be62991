import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin, type UserConfig } from "vite";
import base from "./vite.config";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/**
 * A notebook has no folder to fetch from: the page is one script, the workers' is another, and the module comes as
 * bytes. What the page would name by an address, `globalThis.parkadeAddresses` names.
 */
const CHANGES: Record<string, [from: string, to: string][]> = {
  "www/src/element/loader.ts": [
    [
      `import(
      /* @vite-ignore */ new URL(EMBEDDED, import.meta.url).href
    )`,
      'import("./embedded")',
    ],
  ],
  "www/src/planning/engine-complete.ts": [["import.meta.url", "globalThis.parkadeAddresses?.worker"]],
  "www/src/planning/engine-core.ts": [["import.meta.url", "globalThis.parkadeAddresses?.worker"]],
  "www/src/planning/engine-loader.ts": [
    [
      'import coreUrl from "../../../pkg/core/parkade_bg.wasm?url";',
      "const coreUrl = globalThis.parkadeAddresses.module;",
    ],
    ['import completeUrl from "../../../pkg/parkade_bg.wasm?url";', "const completeUrl = coreUrl;"],
    ['import("./engine-core")', 'import("./engine-complete")'],
  ],
  // What `init` is given stands in its place.
  "pkg/parkade.js": [["new URL('parkade_bg.wasm', import.meta.url)", "globalThis.parkadeAddresses?.module"]],
};

const byAddress: Plugin = {
  name: "by-address",
  enforce: "pre",
  transform(code, id) {
    const changes = Object.entries(CHANGES).find(([file]) => id.endsWith(`/${file}`))?.[1];
    return changes?.reduce((text, [from, to]) => {
      if (text.split(from).length !== 2) this.error(`${id} has not once: ${from}`);
      return text.replace(from, () => to);
    }, code);
  },
};

/** Other languages' words come with the script, where no file can be fetched. */
const assetsWithin: Plugin = {
  name: "assets-within",
  generateBundle(_, bundle) {
    for (const [file, asset] of Object.entries(bundle)) {
      if (asset.type !== "asset") continue;
      const address = `data:application/json;base64,${Buffer.from(asset.source).toString("base64")}`;
      for (const chunk of Object.values(bundle))
        if (chunk.type === "chunk") chunk.code = chunk.code.replaceAll(`/${file}`, address);
      delete bundle[file];
    }
  },
};

/** Of the page's own plugins those that change sources. */
const kept = ["messages", "squeeze-templates"];
const plugins = ((base as UserConfig).plugins as Plugin[]).filter(({ name }) => kept.includes(name));

export default defineConfig(({ mode }) => ({
  plugins: [byAddress, ...plugins, assetsWithin],
  publicDir: false,
  root: here("www"),
  resolve: (base as UserConfig).resolve!,
  build: {
    outDir: here("python/parkade/static"),
    emptyOutDir: false,
    target: "es2022",
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    modulePreload: false,
    rolldownOptions: {
      input: mode === "worker" ? here("www/src/planning/engine-complete.ts") : here("www/src/element/loader.ts"),
      preserveEntrySignatures: "allow-extension",
      output: { entryFileNames: mode === "worker" ? "worker.js" : "playground.js", codeSplitting: false },
    },
  },
}));
