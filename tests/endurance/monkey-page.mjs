// Random clicks, keys, touches and texts on a page, by a seed.
import { pick } from "./damage.mjs";

const KEYS = [
  ..."bwrpclomegvhstxnqkdfjuiyaz0123456789[]+-,.?/",
  "Escape",
  "Escape",
  "Enter",
  "Enter",
  " ",
  "Tab",
  "Shift+Tab",
  "Delete",
  "Backspace",
  "ArrowLeft",
  "ArrowRight",
  "ArrowUp",
  "ArrowDown",
  "Shift+ArrowUp",
  "Home",
  "End",
  "PageDown",
  "Control+z",
  "Control+z",
  "Control+Shift+z",
  "Control+y",
  "Control+a",
  "Control+c",
  "Control+v",
  "Control+x",
  "Control+d",
  "F2",
];
const TEXTS = ["0", "-1", "1e9", "abc", "", "3.5", "99999", "NaN", "12:30", "<b>", "0.000001", "４", "a".repeat(300)];
/** Words that no page shows to anybody. */
const SLIPS = /\bNaN\b|\bundefined\b|\[object |\bInfinity\b/;
const PATIENCE_MS = 60_000;
const REMEMBERED = 25;

/**
 * Until `enough(actions)`: what was done, and every complaint with what was done before it. `frame` is where the
 * playground is.
 */
export async function monkey(page, next, { touch = false, frame, enough }) {
  const found = { actions: 0, complaints: [], slowest: 0, usable: false },
    done = [];
  const complain = (text) => found.complaints.push({ text, action: found.actions, before: done.slice(-REMEMBERED) });
  page.on("console", (message) => {
    if (message.type() === "error") complain(message.text());
  });
  page.on("pageerror", (error) => complain(error.stack ?? error.message));
  page.on("crash", () => complain("the page crashed"));
  page.on("dialog", (dialog) => void dialog.dismiss().catch(() => undefined));
  page.on("filechooser", () => undefined);
  page.on("popup", (popup) => void popup.close().catch(() => undefined));
  const home = page.url(),
    hands = touch ? await fingersOf(page, next) : mouseOf(page, next);
  const actions = [
    ...hands,
    ...keysOf(page, next),
    ...widgetsOf(page, frame, next, touch),
    ...surroundings(page, next),
  ];
  const total = actions.reduce((sum, [weight]) => sum + weight, 0);
  while (!enough(found.actions)) {
    let at = next(total);
    const [, name, act] = actions.find(([weight]) => (at -= weight) < 0);
    try {
      done.push(`${name} ${(await act()) ?? ""}`);
    } catch (error) {
      if (page.isClosed()) throw error;
      // An element may be gone before it is pressed.
      done.push(`${name} failed: ${String(error).split("\n")[0]}`);
    }
    found.actions++;
    if (new URL(page.url()).pathname !== new URL(home).pathname) await page.goto(home);
    if (found.actions % 100 === 0) {
      const state = await stateOf(frame());
      found.slowest = Math.max(found.slowest, state.longest);
      if (state.slip) complain(`the page says "${state.slip}"`);
      if (state.broken) complain(state.broken);
    }
  }
  found.usable = await usable(frame());
  return found;
}

const placeOf = (page, next) => {
  const { width, height } = page.viewportSize();
  return [next(width), next(height)];
};

function mouseOf(page, next) {
  const { mouse } = page,
    place = () => placeOf(page, next);
  const drag = async (button) => {
    const from = place(),
      to = place();
    await mouse.move(...from);
    await mouse.down({ button });
    await mouse.move(...to, { steps: 1 + next(6) });
    if (next(8) === 0) await page.keyboard.press(pick(next, ["Escape", "Control+z", "Delete", "w", "2"]));
    await mouse.up({ button });
    return `${from} → ${to} ${button}`;
  };
  return [
    [
      14,
      "click",
      async () => {
        const at = place();
        await mouse.click(...at);
        return at;
      },
    ],
    [
      4,
      "double click",
      async () => {
        const at = place();
        await mouse.dblclick(...at);
        return at;
      },
    ],
    [
      7,
      "right click",
      async () => {
        const at = place();
        await mouse.click(...at, { button: "right" });
        return at;
      },
    ],
    [16, "drag", () => drag("left")],
    [3, "right drag", () => drag("right")],
    [2, "middle drag", () => drag("middle")],
    [
      5,
      "move",
      async () => {
        const at = place();
        await mouse.move(...at, { steps: 3 });
        return at;
      },
    ],
    [
      6,
      "wheel",
      async () => {
        const by = next(1200) - 600;
        await mouse.wheel(0, by);
        return by;
      },
    ],
  ];
}

/** One finger or two, in steps, sometimes resting, sometimes lost. */
async function fingersOf(page, next) {
  const session = await page.context().newCDPSession(page),
    place = () => placeOf(page, next);
  const send = (type, points) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const pause = (ms) => new Promise((done) => setTimeout(done, ms));
  const stroke = async (fingers) => {
    const from = Array.from({ length: fingers }, place),
      to = Array.from({ length: fingers }, place),
      steps = 1 + next(6);
    await send("touchStart", from);
    if (next(6) === 0) await pause(650);
    for (let i = 1; i <= steps; i++)
      await send(
        "touchMove",
        from.map(([x, y], f) => [x + ((to[f][0] - x) * i) / steps, y + ((to[f][1] - y) * i) / steps]),
      );
    await send(next(12) ? "touchEnd" : "touchCancel", []);
    return `${from.join(" ")} → ${to.join(" ")}`;
  };
  const tap = async () => {
    const at = place();
    await send("touchStart", [at]);
    await send("touchEnd", []);
    return at;
  };
  return [
    [18, "tap", tap],
    [
      4,
      "double tap",
      async () => {
        const at = await tap();
        await tap();
        return at;
      },
    ],
    [
      5,
      "rest",
      async () => {
        const at = place();
        await send("touchStart", [at]);
        await pause(650);
        await send("touchEnd", []);
        return at;
      },
    ],
    [18, "swipe", () => stroke(1)],
    [8, "pinch", () => stroke(2)],
    [2, "three fingers", () => stroke(3)],
  ];
}

function keysOf(page, next) {
  return [
    [
      18,
      "key",
      async () => {
        const key = pick(next, KEYS);
        await page.keyboard.press(key);
        return key;
      },
    ],
    [
      3,
      "keys",
      async () => {
        const keys = Array.from({ length: 4 }, () => pick(next, KEYS));
        for (const key of keys) await page.keyboard.press(key);
        return keys;
      },
    ],
  ];
}

/** Buttons, fields, lists and sliders, wherever they are. */
function widgetsOf(page, frame, next, touch) {
  const use = async () => {
    const widget = await frame().evaluate(useWidget, [next(1 << 30), next(1 << 30)]);
    if (!widget) return "none";
    const owner = frame() === page.mainFrame() ? { x: 0, y: 0 } : await page.locator("iframe").boundingBox();
    const x = owner.x + widget.x,
      y = owner.y + widget.y;
    if (widget.kind === "press") await (touch ? page.touchscreen.tap(x, y) : page.mouse.click(x, y));
    if (widget.kind === "type") {
      const text = pick(next, TEXTS);
      await page.keyboard.type(text);
      await page.keyboard.press(pick(next, ["Enter", "Tab", "Escape"]));
      return `${widget.name} "${text.slice(0, 20)}"`;
    }
    return widget.name;
  };
  return [[26, "widget", use]];
}

/**
 * Runs in the page: chooses something to use; sets lists and sliders itself, as no mouse opens a list without a window.
 */
function useWidget([choice, value]) {
  const all = [];
  const visit = (root) => {
    for (const element of root.querySelectorAll("*")) {
      if (element.matches("button:enabled, select, input:not([type=file]), [role=separator], summary, textarea"))
        all.push(element);
      if (element.shadowRoot) visit(element.shadowRoot);
    }
  };
  visit(document);
  const shown = all.filter((element) => {
    const { x, y, width, height } = element.getBoundingClientRect();
    return width > 0 && height > 0 && x >= 0 && y >= 0 && x < innerWidth && y < innerHeight;
  });
  const element = shown[choice % shown.length];
  if (!element) return null;
  const { x, y, width, height } = element.getBoundingClientRect();
  const name = `${element.getRootNode().host?.localName ?? ""} ${element.localName} ${
    element.getAttribute("aria-label") ?? element.textContent?.trim().slice(0, 30) ?? ""
  }`;
  const tell = (kind) => ({ kind, name, x: x + width / 2, y: y + height / 2 });
  const changed = () => {
    for (const type of ["input", "change"]) element.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  };
  if (element.localName === "select") {
    element.selectedIndex = value % Math.max(1, element.options.length);
    changed();
    return tell("set");
  }
  if (element.type === "range" || element.type === "color") {
    element.value =
      element.type === "color"
        ? "#123456"
        : String(Number(element.min) + ((value % 1001) / 1000) * (Number(element.max) - Number(element.min)));
    changed();
    return tell("set");
  }
  if (element.matches("input:not([type=checkbox]):not([type=radio]), textarea")) {
    element.focus();
    element.select?.();
    return tell("type");
  }
  return tell("press");
}

/** The window's size, colours, a reload, the way back. */
function surroundings(page, next) {
  const { width, height } = page.viewportSize();
  return [
    [
      1,
      "resize",
      async () => {
        const size = {
          width: Math.max(320, Math.round(width * (0.5 + next(60) / 100))),
          height: Math.max(300, Math.round(height * (0.5 + next(60) / 100))),
        };
        await page.setViewportSize(size);
        return JSON.stringify(size);
      },
    ],
    [1, "own size", () => page.setViewportSize({ width, height })],
    [
      1,
      "colours",
      async () => {
        const colorScheme = pick(next, ["light", "dark"]);
        await page.emulateMedia({ colorScheme });
        return colorScheme;
      },
    ],
    [
      1,
      "reload or back",
      async () => {
        const way = next(6);
        await (way === 0 ? page.reload() : way === 1 ? page.goBack({ timeout: 3000 }) : null);
        return way;
      },
    ],
  ];
}

const stateOf = (frame) =>
  frame.evaluate(async (slips) => {
    await customElements.whenDefined("parkade-playground");
    const element = document.querySelector("parkade-playground"),
      { state } = (element.store ? element : await element.load()).store;
    const texts = [];
    const visit = (root) => {
      for (const one of root.querySelectorAll("*")) {
        if (["STYLE", "SCRIPT", "TEXTAREA"].includes(one.tagName)) continue;
        for (const node of one.childNodes) if (node.nodeType === Node.TEXT_NODE) texts.push(node.data);
        if (one.shadowRoot) visit(one.shadowRoot);
      }
    };
    visit(document);
    const { fraction } = state.playback,
      { camera } = state;
    const broken = !(fraction >= 0 && fraction <= 1)
      ? `playhead ${fraction}`
      : camera && ![camera.x, camera.y, camera.scale].every(Number.isFinite)
        ? `camera ${JSON.stringify(camera)}`
        : "";
    return { longest: window.longestTurn(), slip: texts.find((text) => new RegExp(slips).test(text)) ?? "", broken };
  }, SLIPS.source);

/** True if a preset opens and is planned after all that. */
const usable = (frame) =>
  frame.evaluate(async (patience) => {
    const element = document.querySelector("parkade-playground"),
      inner = element.store ? element : await element.load();
    await inner.app.complete();
    inner.store.set({ planners: ["four", "eight", "risk-field", "hybrid"], focus: "hybrid" });
    inner.app.openPreset("perpendicular");
    const settled = await Promise.race([
      inner.settled().then(() => true),
      new Promise((done) => setTimeout(() => done(false), patience)),
    ]);
    return settled && Object.values(inner.results).filter((plan) => plan?.outcome === "found").length === 4;
  }, PATIENCE_MS);
