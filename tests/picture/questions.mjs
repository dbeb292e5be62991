// Pictures and links of docs/questions.md: the search debugger answers six questions.
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("../../docs/public/questions/", import.meta.url));
const SIZE = { width: 1120, height: 900 };
/** Height of the toolbar, CSS pixels. */
const TOOLBAR = 48;

/** A floor of 12 by 8 cells with a wall between start and goal, and a car that hides hardly a cell. */
const WALL = {
  version: 1,
  map: { origin: [0, 0], width: 12, height: 8, resolution: 1 },
  obstacles: [
    {
      type: "cells",
      runs: [
        [7, 1, 1],
        [7, 2, 1],
        [7, 3, 1],
        [7, 4, 1],
        [4, 5, 4],
      ],
    },
  ],
  slots: [],
  vehicle: { wheelbase: 0.6, width: 0.5, rearToFront: 0.75, rearToBack: 0.15, maxSteer: 0.6 },
  start: { x: 1.5, y: 2.5, heading: 0 },
  goal: { x: 9.5, y: 3.5, heading: 0 },
};

/** The kind of a step in which two sides meet. */
const MEETS = 4;
/** Per question its words, its planner, its scene (none for the page's first), and the step that shows it. */
const QUESTIONS = [
  {
    name: "order",
    words: ["Why is this cell expanded before the others?", "为什么先展开这个栅格？"],
    planner: "eight",
    scene: WALL,
    shows: ({ step, tied }) => step > 8 && tied === 0,
  },
  {
    name: "ties",
    words: ["Where do ties go?", "f 相同时怎么办？"],
    planner: "eight",
    scene: WALL,
    shows: ({ step, tied }) => step > 4 && tied > 1,
  },
  {
    name: "estimates",
    words: ["Why does Manhattan fail with eight neighbours?", "为什么八邻域不能用曼哈顿估计？"],
    planner: "eight",
    scene: WALL,
    shows: ({ step }) => step === 4,
  },
  {
    name: "risk-field",
    words: ["What does the risk field skip here?", "风险场在这里跳过了什么？"],
    planner: "risk-field",
    scene: WALL,
    shows: ({ step }) => step === 2,
  },
  {
    name: "connection",
    words: ["Why did this connection fail?", "为什么这次连接失败？"],
    planner: "hybrid",
    scene: null,
    shows: ({ step, fails }) => step > 3 && fails,
  },
  {
    name: "meeting",
    words: ["Where did both sides meet?", "两侧在哪里相遇？"],
    planner: "sixteen-bidirectional",
    scene: WALL,
    shows: ({ kind }) => kind === MEETS,
  },
];

/** Photographs each question in a page of its own, with the part of the panel that answers it, and prints its links. */
export async function photographQuestions(browser, url) {
  for (const { name, words, planner, scene, shows } of QUESTIONS) {
    const page = await browser.newPage({ viewport: SIZE, colorScheme: "light", reducedMotion: "reduce" });
    await page.goto(url);
    const link = await page.evaluate(
      async ({ scene, planner }) => {
        const element = document.querySelector("parkade-playground");
        await element.settled();
        if (scene) element.sceneData = scene;
        element.store.set({ planners: [planner], focus: planner });
        await element.settled();
        return element.app.links.address(true);
      },
      { scene, planner },
    );
    await page.getByRole("button", { name: "Layers" }).click();
    await page.getByRole("button", { name: "Search debugger" }).click();
    const panel = page.locator("parkade-debugger");
    await panel.locator(".transport").waitFor();
    const steps = await panel.evaluate(({ session }) => {
      const { replay } = session;
      return Array.from({ length: replay.steps }, (_, step) => {
        replay.seek(replay.endOf(step));
        return { step, kind: replay.kindOf(step), tied: replay.ties(step).byF, fails: session.fails(step) };
      });
    });
    const event = await panel.evaluate(({ session }, step) => {
      session.seek(session.replay.endOf(step));
      return session.replay.at;
    }, steps.find(shows).step);
    // The risk field is asked once the walk rests.
    await page.waitForTimeout(600);
    if (name === "estimates") await panel.locator("dl .over").first().scrollIntoViewIfNeeded();
    await page.mouse.move(0, 0);
    const { height } = await page.locator("parkade-stage").boundingBox();
    await page.screenshot({ path: `${FOLDER}${name}.png`, clip: { x: 0, y: TOOLBAR, width: SIZE.width, height } });
    for (const question of words) console.log(`${name}: index.html${withTask(new URL(link).hash, question, event)}`);
    await page.close();
  }
}

/** A link that opens the debugger after so many events, with the question on a card. */
function withTask(hash, question, event) {
  const task = Buffer.from(JSON.stringify([question, 0, event, 0])).toString("base64url");
  return hash.includes("&v=") ? hash.replace("&v=", `&t=${task}&v=`) : `${hash}&t=${task}`;
}
