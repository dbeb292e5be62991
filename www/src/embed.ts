/**
 * The bare frame: `embed.html#s=<scene>&layout=single&controls=minimal`. Its attributes are the element's, the scene is
 * a share link's. It talks with the page around it by messages of the form `{ type: "parkade:<name>", … }`.
 */
import { ParkadePlayground } from "./element/loader";
import { ATTRIBUTES, EVENTS, METHODS, SETTABLE } from "./element/public-api";
import { messageOf } from "./i18n/said";
import { fieldsOf } from "./scene/records";

const wanted = new URLSearchParams(location.hash.slice(1));
/** Whom to talk to: the page around, or those that it names; messages of others are not heard. */
const origins = new Set((wanted.get("origins") ?? referrer()).split(",").filter(Boolean));
const element = new ParkadePlayground();

for (const name of [...ATTRIBUTES, "reveal", "poster", "alt"]) {
  const value = wanted.get(name);
  // Scripts and modules from wherever a link says would be somebody else's program in this page.
  if (value !== null && !["worker-url", "wasm-url", "src"].includes(name)) element.setAttribute(name, value);
}
element.setAttribute("loading", wanted.get("loading") ?? "eager");
for (const name of EVENTS)
  element.addEventListener(name, ({ detail }: CustomEventInit) =>
    tell({ type: `parkade:${name}`, ...portable(detail) }),
  );
addEventListener("message", (event) => void hear(event));
new ResizeObserver(() => tellHeight()).observe(element);
document.body.append(element);
// Out of sight a frame is not laid out by itself.
tellHeight();

const link = wanted.get("s");
if (link !== null) void element.openLink(link).catch(complain);

/** The page that holds this frame, as far as it says who it is. */
function referrer(): string {
  return document.referrer ? new URL(document.referrer).origin : "";
}

function tell(message: { type: string; [key: string]: unknown }): void {
  if (parent === window) return;
  for (const origin of origins) parent.postMessage(message, origin);
}

/** Scenes, plans and figures are plain data; what is not stays here. */
function portable(detail: unknown): Record<string, unknown> {
  return structuredClone(fieldsOf(detail));
}

/** As high as its width asks for: the frame takes this height when the page around sets it. */
function tellHeight(): void {
  const width = element.clientWidth;
  if (width > 0) tell({ type: "parkade:height", height: Math.max(280, Math.round((width * 7) / 12)) });
}

interface Asked {
  type?: unknown;
  id?: unknown;
  args?: unknown;
  value?: unknown;
}

async function hear({ origin, data, source }: MessageEvent<Asked | null>): Promise<void> {
  if (source !== parent || !origins.has(origin) || typeof data?.type !== "string" || !data.type.startsWith("parkade:"))
    return;
  const name = data.type.slice("parkade:".length),
    { id } = data;
  try {
    tell({ type: "parkade:reply", id, result: await answer(name, data) });
  } catch (error) {
    tell({ type: "parkade:reply", id, error: messageOf(error) });
  }
}

function answer(name: string, { args, value }: Asked): unknown {
  const methods: readonly string[] = [...METHODS, "dismissPoster"],
    settable: readonly string[] = SETTABLE;
  if (methods.includes(name))
    return Reflect.apply(Reflect.get(element, name), element, Array.isArray(args) ? args : []);
  if (settable.includes(name)) return void Reflect.set(element, name, value);
  throw new Error(`there is no parkade:${name}`);
}

function complain(error: unknown): void {
  tell({ type: "parkade:error", code: "error.link", message: messageOf(error) });
}
