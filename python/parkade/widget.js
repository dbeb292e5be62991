// @ts-check
// The playground in a notebook: its files come from the kernel once per page, its scene is the widget's.

/** Files of the playground, compressed, and how they are served. */
const FILES = { worker: "text/javascript", module: "application/wasm", playground: "text/javascript" };
/** How long a drag may go on before the kernel hears of it, milliseconds. */
const PAUSE = 150;

/**
 * @typedef {{ get(name: string): any, set(name: string, value: unknown): void, save_changes(): void,
 *   send(content: unknown): void, on(name: string, listener: (...args: any[]) => void): void,
 *   off(name: string, listener: (...args: any[]) => void): void }} Model
 */
/**
 * @typedef {HTMLElement & { sceneData: unknown, setScene(scene: unknown): Promise<void>,
 *   results: Record<string, any> }} Playground
 */

/** @param {Model} model */
function askedFor(model) {
  return new Promise((done, fail) => {
    const listener = async (/** @type {any} */ content, /** @type {DataView[]} */ buffers) => {
      if (content?.kind !== "files") return;
      model.off("msg:custom", listener);
      try {
        done(await Promise.all(buffers.map((buffer, i) => served(buffer, content.names[i]))));
      } catch (error) {
        fail(error);
      }
    };
    model.on("msg:custom", listener);
    model.send({ kind: "files", names: Object.keys(FILES) });
  });
}

/** @param {DataView | ArrayBuffer} buffer @param {keyof typeof FILES} name */
async function served(buffer, name) {
  const stream = new Blob([buffer]).stream().pipeThrough(new DecompressionStream("gzip"));
  const content = await new Response(stream).arrayBuffer();
  return URL.createObjectURL(new Blob([content], { type: FILES[name] }));
}

/** Defines the element once, however many widgets there are. @param {Model} model */
function defined(model) {
  const page = /** @type {any} */ (globalThis);
  page.parkadeLoading ??= askedFor(model)
    .then(([worker, module, playground]) => {
      page.parkadeAddresses = { worker, module };
      return import(/* @vite-ignore */ playground);
    })
    .catch((error) => {
      page.parkadeLoading = undefined;
      throw error;
    });
  return page.parkadeLoading;
}

/** What the kernel is told of a plan. @param {any} plan */
const outline = ({ outcome, reason, hash, metrics, check }) => ({
  outcome,
  reason,
  hash,
  metrics,
  verdict: check.verdict,
  drivable: check.drivable,
});

// The notebooks own `layout`.
const ATTRIBUTES = ["planners", "view", "controls", "theme", "lang"];

/** @param {{ model: Model, el: HTMLElement }} context */
async function render({ model, el }) {
  const note = document.createElement("p");
  note.setAttribute("role", "status");
  note.textContent = "Loading the playground …";
  el.append(note);
  try {
    await defined(model);
  } catch (error) {
    note.textContent = `The playground could not be loaded: ${error instanceof Error ? error.message : error}`;
    return;
  }
  note.remove();
  const playground = /** @type {Playground} */ (document.createElement("parkade-playground"));
  const write = (/** @type {string} */ name) => {
    const value = model.get(name);
    const text = Array.isArray(value) ? value.join(" ") : String(value ?? "");
    const attribute = name === "view" ? "layout" : name;
    if (text) playground.setAttribute(attribute, text);
    else playground.removeAttribute(attribute);
  };
  for (const name of ATTRIBUTES) write(name);
  playground.setAttribute("editable", "");
  playground.setAttribute("loading", "eager");
  playground.style.cssText = "width: 100%; aspect-ratio: auto;";
  const size = () => playground.style.setProperty("height", `${model.get("height")}px`);
  size();
  el.append(playground);
  return joined(model, playground, write, size);
}

/**
 * Ties the element to the model; the answer unties them.
 * @param {Model} model @param {Playground} playground @param {(name: string) => void} write @param {() => void} size
 */
function joined(model, playground, write, size) {
  /** The scene that both have, as text: what comes back is no change. */
  let shared = "";
  let timer = 0;
  /** @param {unknown} scene */
  const told = (scene) => {
    const text = JSON.stringify(scene);
    if (text === shared) return;
    shared = text;
    model.set("scene", scene);
    model.save_changes();
  };
  const onScene = () => {
    const scene = model.get("scene"),
      text = JSON.stringify(scene);
    if (text === shared) return;
    shared = text;
    clearTimeout(timer);
    // A refused scene is told by the element, and by the kernel before it came here.
    playground.setScene(scene).catch(() => undefined);
  };
  const onChange = (/** @type {any} */ { detail }) => {
    clearTimeout(timer);
    if (detail.reason === "set" || detail.reason === "open") shared = JSON.stringify(detail.scene);
    else timer = setTimeout(told, detail.transient ? PAUSE : 0, detail.scene);
  };
  const onResults = (/** @type {any} */ { detail }) => {
    const plans = Object.entries(detail.results).filter(([, result]) => result?.hash ?? result?.plan);
    model.set("results", Object.fromEntries(plans.map(([id, result]) => [id, outline(result.plan ?? result)])));
    model.save_changes();
  };
  playground.addEventListener("scene-change", onChange);
  playground.addEventListener("plan-complete", onResults);
  /** @type {[string, () => void][]} */
  const listeners = [
    ["change:scene", onScene],
    ["change:height", size],
    ...ATTRIBUTES.map((name) => /** @type {[string, () => void]} */ ([`change:${name}`, () => write(name)])),
  ];
  for (const [name, listener] of listeners) model.on(name, listener);
  onScene();
  return () => {
    clearTimeout(timer);
    for (const [name, listener] of listeners) model.off(name, listener);
    playground.remove();
  };
}

export default { render };
