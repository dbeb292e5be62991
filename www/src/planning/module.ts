import wasmUrl from "../../../pkg/parkade_bg.wasm?url";

type Api = typeof import("./engine");

/** The planners' functions, ready to be called, and their compiled module for the workers. */
export interface Engine { api: Api; module: WebAssembly.Module }

let loading: Promise<Engine> | null = null;

/** Loads and compiles the planners once, however many playgrounds there are. */
export function loadEngine(): Promise<Engine> {
  loading ??= load().catch((error: unknown) => {
    loading = null;
    throw error;
  });
  return loading;
}

async function load(): Promise<Engine> {
  const [api, module] = await Promise.all([import("./engine"), compile()]);
  await api.init({ wasm: module });
  return { api, module };
}

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(wasmUrl, import.meta.url));
  if (!response.ok) throw new Error(`the server answered ${response.status} for the planners' module.`);
  const isWasm = response.headers.get("content-type")?.startsWith("application/wasm") ?? false;
  return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
