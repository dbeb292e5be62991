import { init } from "parkade";
import wasmUrl from "../../../pkg/parkade_bg.wasm?url";

let compiled: Promise<WebAssembly.Module> | null = null;

/** The planners' module: loaded and compiled once, shared by the page and every worker. */
export function loadModule(): Promise<WebAssembly.Module> {
  compiled ??= load().catch((error: unknown) => {
    compiled = null;
    throw error;
  });
  return compiled;
}

async function load(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(wasmUrl, import.meta.url));
  if (!response.ok) throw new Error(`the server answered ${response.status} for the planners' module.`);
  const isWasm = response.headers.get("content-type")?.startsWith("application/wasm") ?? false;
  const module = isWasm
    ? await WebAssembly.compileStreaming(response)
    : await WebAssembly.compile(await response.arrayBuffer());
  await init({ wasm: module });
  return module;
}
