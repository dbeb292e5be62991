// Damaged links, messages and stored states by a seeded generator: for the tests of `tests/js` and for a page in a
// browser.

/** Numbers beyond every bound, and things that are no numbers. */
const NUMERALS = [
  "0",
  "-1",
  "-0",
  "1e22",
  "1e308",
  "-1e30",
  "1e-300",
  "NaN",
  "Infinity",
  "2147483648",
  "9007199254740993",
  "0x10",
  "1e",
  "--1",
  "",
  " ",
  "null",
  "constructor",
  "__proto__",
  "toString",
];
const VALUES = [
  0,
  -0,
  -1,
  0.5,
  1e9,
  1e22,
  1e308,
  -1e308,
  5e-324,
  NaN,
  Infinity,
  -Infinity,
  2 ** 31,
  2 ** 53 + 2,
  null,
  undefined,
  true,
  "",
  "x",
  "1e9",
  "constructor",
  "__proto__",
  [],
  {},
  [[]],
  [null],
  { x: 1 },
  { x: NaN, y: 1e308, scale: -1 },
  "x".repeat(5000),
  Array.from({ length: 300 }, (_, i) => i),
  JSON.parse('{"__proto__":{"polluted":1},"constructor":{"prototype":{"polluted":1}}}'),
];
const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_~.%&#={}[]":,';

/** One of a list. */
export const pick = (next, list) => list[next(list.length)];

/** A fresh one: what is damaged may be damaged again. */
const anything = (next) => structuredClone(pick(next, VALUES));

/** The text with one to three letters or stretches replaced, cut out, doubled or added. */
export function damagedText(next, text) {
  let out = text;
  for (let n = 1 + next(3); n > 0; n--) {
    const at = next(out.length + 1),
      end = at + next(12);
    const middle = [pick(next, LETTERS), "", out.slice(at, end).repeat(2), pick(next, NUMERALS)][next(4)];
    out = out.slice(0, at) + middle + out.slice(next(2) ? end : at);
  }
  return out;
}

/** A copy of plain data with one to three fields, at any depth, replaced, removed, doubled or scaled. */
export function damagedData(next, data) {
  const copy = structuredClone(data);
  for (let n = 1 + next(3); n > 0; n--) damageOnce(next, copy);
  return copy;
}

function damageOnce(next, root) {
  for (let at = root; ; ) {
    const keys = Object.keys(at);
    if (keys.length === 0) return;
    const key = pick(next, keys),
      inner = at[key];
    if (typeof inner === "object" && inner !== null && next(5) > 0) {
      at = inner;
      continue;
    }
    const kind = next(6);
    if (kind === 0) delete at[key];
    else if (kind === 1 && Array.isArray(at)) at.push(structuredClone(inner));
    else if (kind === 2 && typeof inner === "number") at[key] = inner * pick(next, [-1, 0, 10, 1000, 1e-9, 1e9]);
    else if (kind === 3 && !Array.isArray(at))
      Object.defineProperty(at, pick(next, ["constructor", "__proto__", "zzz", "0"]), {
        value: anything(next),
        enumerable: true,
        configurable: true,
        writable: true,
      });
    else at[key] = anything(next);
    return;
  }
}

/** What stands in a link for a scene's short form. */
export async function sceneText(short) {
  const stream = new Blob([JSON.stringify(short) ?? ""]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return `1${btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** The short form in a link's text. */
export async function shortForm(text) {
  const binary = atob(text.slice(1).replaceAll("-", "+").replaceAll("_", "/"));
  const stream = new Blob([Uint8Array.from(binary, (letter) => letter.charCodeAt(0))])
    .stream()
    .pipeThrough(new DecompressionStream("deflate-raw"));
  return JSON.parse(await new Response(stream).text());
}

/** A link's scene part: damaged as text, which seldom inflates, or as what is inside. */
export const damagedScene = async (next, text, short) =>
  next(4) === 0 ? damagedText(next, text) : sceneText(damagedData(next, short));

/** A link's view part. */
export function damagedView(next, view) {
  if (next(3) === 0) return damagedText(next, view);
  const fields = view.split("~");
  for (let n = 1 + next(2); n > 0; n--) {
    const at = next(fields.length);
    fields[at] =
      at === 2 && next(2) ? `${fields[2]}.${pick(next, [...NUMERALS, "hybrid", "four"])}` : pick(next, NUMERALS);
  }
  return fields.join("~");
}

/** A message to a frame, without its id. `scene` and `link` are sound ones. */
export function damagedMessage(next, scene, link) {
  const camera = { x: 10, y: 8, scale: 20 },
    params = { hybrid: { reverseCost: 2, maxExpansions: 5000 }, four: {} };
  const sound = [
    { type: "camera", value: camera },
    { type: "playhead", value: 0.5 },
    { type: "params", value: params },
    { type: "sceneData", value: scene },
    { type: "setScene", args: [scene] },
    { type: "openLink", args: [link] },
    { type: "seek", args: [0.5, { base: "search" }] },
    { type: "toBlob", args: [{ type: "image/png" }] },
    {
      type: pick(next, [
        "undo",
        "redo",
        "fit",
        "play",
        "pause",
        "cancel",
        "getScene",
        "shareURL",
        "reset",
        "toSVG",
        "toCSV",
        "plan",
      ]),
      args: [],
    },
  ];
  const message = pick(next, sound);
  if (next(20) === 0)
    return { ...message, type: pick(next, ["constructor", "__proto__", "store", "app", "", "x".repeat(999)]) };
  const field = "value" in message ? "value" : "args",
    given = message[field];
  if (message.type === "openLink" && next(2)) return { ...message, args: [damagedText(next, link)] };
  const isData = typeof given === "object" && Object.keys(given).length > 0;
  return { ...message, [field]: isData && next(4) ? damagedData(next, given) : anything(next) };
}

/** What a browser may have kept: which store, under which key, and what. `kept` are sound texts by key. */
export function damagedStore(next, kept) {
  const [area, key, text] = pick(next, kept);
  const data = next(3) && /^[[{]/.test(text) ? JSON.stringify(damagedData(next, JSON.parse(text))) : undefined;
  return [area, key, data ?? (next(3) ? damagedText(next, text) : pick(next, NUMERALS))];
}
