// In the pages of the hosts: waits for the playground, looks at its place, presses the host's switch of themes, follows
// a link to a scene of the page's own, and posts what it saw. `frame.html` opens each page at a width.
const asked = new URLSearchParams(parent.location.search);
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const until = async (what, look, ms = 30_000) => {
  for (const end = Date.now() + ms; Date.now() < end; await wait(50)) {
    const found = look();
    if (found) return found;
  }
  throw new Error(`no ${what} after ${ms} ms`);
};

let shifts = 0;
if (PerformanceObserver.supportedEntryTypes.includes("layout-shift"))
  new PerformanceObserver((list) => {
    for (const entry of list.getEntries()) if (!entry.hadRecentInput) shifts += entry.value;
  }).observe({ type: "layout-shift", buffered: true });

/** The place that a playground takes, and where it leaves what follows. */
function placeOf(element) {
  const { top, height } = element.getBoundingClientRect(),
    next = (element.nextElementSibling ?? element.parentElement.nextElementSibling)?.getBoundingClientRect();
  return [height, next ? next.top - top : 0];
}

const dark = (text) => {
  const [r, g, b, a = 1] = (text.match(/[\d.]+/g) ?? []).map(Number);
  return a < 0.5 || r === undefined ? null : 0.2126 * r + 0.7152 * g + 0.0722 * b < 110;
};
/** True if the host is dark, by what it is painted with. */
const isHostDark = () => {
  for (let node = document.querySelector("parkade-playground").parentElement; node; node = node.parentElement) {
    const found = dark(getComputedStyle(node).backgroundColor);
    if (found !== null) return found;
  }
  return false;
};

async function planned(element) {
  element.scrollIntoView({ block: "center" });
  await until("ready playground", () => element.ready);
  await element.ready;
  return Object.values(element.results).map((plan) => plan?.outcome);
}

async function look() {
  const element = await until("playground", () => document.querySelector("parkade-playground"));
  const before = placeOf(element);
  const outcomes = await planned(element);
  await wait(300);
  const box = element.getBoundingClientRect(),
    parentBox = element.parentElement.getBoundingClientRect();
  const report = {
    outcomes,
    name: element.sceneData.name,
    moved: Math.max(...placeOf(element).map((length, i) => Math.abs(length - before[i]))),
    shifts,
    overflow: Math.max(0, box.right - parentBox.right, box.right - document.documentElement.clientWidth),
    themes: [],
  };
  for (const selector of (asked.get("switch") ?? "").split("|").filter(Boolean)) {
    const button = await until(selector, () =>
      [...document.querySelectorAll(selector)].find((one) => one.offsetParent),
    );
    if (button instanceof HTMLSelectElement) {
      button.selectedIndex = (button.selectedIndex + 1) % button.options.length;
      button.dispatchEvent(new Event("change", { bubbles: true }));
    } else button.click();
    await wait(600);
    report.themes.push([isHostDark(), getComputedStyle(element).colorScheme === "dark"]);
  }
  return report;
}

/** Follows the link; where the host loads pages whole, the next page's probe goes on. */
async function follow(report) {
  const link = await until("link", () =>
    [...document.querySelectorAll("a")].find((one) => /\/own(\.html|\/)?$/.test(one.pathname)),
  );
  const before = document.querySelector("parkade-playground");
  parent.carried = report;
  link.click();
  return own(report, before);
}

async function own(report, before) {
  const element = await until("scene of the page's own", () => {
    const found = document.querySelector("parkade-playground");
    return found && found !== before && found.querySelector("[slot=scene]") ? found : null;
  });
  const outcomes = await planned(element);
  return { ...report, own: [element.sceneData.name, ...outcomes] };
}

const post = (report) =>
  fetch("/__report", { method: "POST", body: JSON.stringify({ of: asked.get("of"), ...report }) });
if (parent !== window)
  (parent.carried
  ? own(parent.carried)
  : asked.has("direct")
    ? own({})
    : look().then((report) => (asked.has("follow") ? follow(report) : report))
).then(
    post,
    (error) => post({ error: String(error) }),
  );
