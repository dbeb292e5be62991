// The widget in real notebooks: JupyterLab and marimo, each started, opened in a browser and used.
//   node tests/notebooks/notebooks.mjs ENVIRONMENT [PICTURES]
// ENVIRONMENT is a Python environment with jupyterlab, marimo and the wheel.
import { spawn } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "@playwright/test";
import { launchOptions } from "../e2e/browser.js";

const [environment = "", pictures = ""] = process.argv.slice(2);
const programs = resolve(environment, process.platform === "win32" ? "Scripts" : "bin");
const folder = mkdtempSync(join(tmpdir(), "parkade-notebooks-"));
if (pictures) mkdirSync(pictures, { recursive: true });

/** Starts a server in the folder; the answer ends it. */
async function started(program, args, address) {
  const child = spawn(join(programs, program), args, {
    cwd: folder,
    env: { ...process.env, HOME: folder, JUPYTER_CONFIG_DIR: join(folder, "config"), XDG_CONFIG_HOME: folder },
    stdio: ["ignore", "pipe", "pipe"],
  });
  let said = "";
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (text) => (said += text));
  const ended = new Promise((done) => child.once("exit", done));
  for (let tries = 0; ; tries++) {
    if (
      await fetch(address)
        .then((answer) => answer.ok)
        .catch(() => false)
    )
      break;
    if (tries > 120 || child.exitCode !== null) throw new Error(`${program} did not start: ${said}`);
    await new Promise((done) => setTimeout(done, 500));
  }
  return async () => {
    child.kill();
    await ended;
  };
}

/** Drags the car at the start eastward, as a hand does. */
async function dragged(page, metres) {
  const playground = page.locator("parkade-playground").first(),
    scale = 20;
  await playground.evaluate((element, scale) => {
    const { x, y } = element.sceneData.start;
    element.camera = { x, y, scale };
  }, scale);
  const { x, y, width, height } = await playground.locator("canvas").first().boundingBox();
  const from = [x + width / 2, y + height / 2];
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + metres * scale, from[1], { steps: 8 });
  await page.mouse.up();
  await playground.evaluate((element) => element.settled());
}

const equal = (found, expected, what) => {
  if (JSON.stringify(found) !== JSON.stringify(expected))
    throw new Error(`${what}: expected ${JSON.stringify(expected)}, got ${JSON.stringify(found)}`);
  console.log(`ok  ${what}`);
};

async function picture(page, name) {
  if (pictures) await page.screenshot({ path: join(pictures, `${name}.png`) });
}

async function lab(browser) {
  copyFileSync(new URL("playground.ipynb", import.meta.url), join(folder, "playground.ipynb"));
  const address = "http://127.0.0.1:4731";
  const stop = await started(
    "jupyter-lab",
    [
      "--no-browser",
      "--port=4731",
      "--ip=127.0.0.1",
      "--allow-root",
      "--IdentityProvider.token=",
      `--ServerApp.root_dir=${folder}`,
    ],
    `${address}/api`,
  );
  const page = await browser.newPage({ viewport: { width: 1300, height: 950 } });
  page.on("pageerror", (error) => console.log("page error:", error.message));
  page.on("console", (m) => m.type() === "error" && console.log("console:", m.text().slice(0, 300)));
  try {
    await page.goto(`${address}/lab/tree/playground.ipynb`);
    await page.locator(".jp-NotebookPanel .jp-CodeCell").first().waitFor();
    await page.getByText("Python 3 (ipykernel) | Idle").waitFor({ timeout: 60_000 });
    const cells = page.locator(".jp-CodeCell");
    const answer = async (at) => {
      await cells.nth(at).locator(".jp-InputArea-editor").click();
      await page.keyboard.press("Control+Enter");
      await page.waitForFunction(
        (at) => /\d/.test(document.querySelectorAll(".jp-CodeCell .jp-InputPrompt")[at].textContent),
        at,
      );
      return (await cells.nth(at).locator(".jp-OutputArea-output").allInnerTexts()).join("\n").trim();
    };
    await answer(0);
    const playground = page.locator("parkade-playground");
    await playground.waitFor({ timeout: 60_000 });
    await playground.evaluate((element) => element.settled());
    await picture(page, "jupyterlab");
    await dragged(page, 2);
    await picture(page, "jupyterlab-dragged");
    const both = "{'eight': True, 'hybrid': True}";
    const moved = Number(await answer(2));
    equal(Math.abs(moved - 2) < 0.3, true, `JupyterLab: a drag by 2 m moves the kernel's car by ${moved} m`);
    equal(await answer(1), both, "JupyterLab: the page's hashes are the kernel's");
    await answer(3);
    await page.waitForFunction(() => document.querySelector("parkade-playground").sceneData.name === "parallel");
    await playground.evaluate((element) => element.settled());
    equal(await answer(4), both, "JupyterLab: an assigned scene is drawn, planned and told");
    equal(
      (await answer(5)).includes('got "seden"; did you mean sedan?'),
      true,
      "JupyterLab: a wrong scene is refused in words",
    );
  } finally {
    await picture(page, "jupyterlab-end");
    await page.close();
    await stop();
  }
}

async function marimo(browser) {
  copyFileSync(new URL("playground.py", import.meta.url), join(folder, "playground.py"));
  const address = "http://127.0.0.1:4732";
  const stop = await started(
    "marimo",
    [
      "--yes",
      "edit",
      "--headless",
      "--no-token",
      "--host=127.0.0.1",
      "--port=4732",
      "--skip-update-check",
      "playground.py",
    ],
    `${address}/health`,
  );
  const page = await browser.newPage({ viewport: { width: 1300, height: 1000 } });
  try {
    await page.goto(address);
    await page.locator(".marimo-cell").first().waitFor();
    await page.keyboard.press("Control+Shift+R");
    const playground = page.locator("parkade-playground");
    await playground.waitFor({ timeout: 90_000 });
    await playground.evaluate((element) => element.settled());
    const same = (start) => page.getByText(`start at ${start}; same: {'eight': True, 'hybrid': True}`).waitFor();
    await same("-7.12");
    await picture(page, "marimo");
    console.log("ok  marimo: the page's hashes are the kernel's");
    await dragged(page, 2);
    await same("-5.12");
    console.log("ok  marimo: a drag runs the cells that depend on it, with the same hashes");
    await page.getByRole("button", { name: "parallel" }).click();
    await same("20.00");
    console.log("ok  marimo: an assigned scene is drawn, planned and told");
    await picture(page, "marimo-end");
  } finally {
    await picture(page, "marimo-last");
    await page.close();
    await stop();
  }
}

const browser = await chromium.launch(launchOptions());
try {
  await lab(browser);
  await marimo(browser);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
