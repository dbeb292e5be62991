import { expect, test } from "vitest";
import { init, packRuns, planners, scenario, scenarios, sceneGeometry, toSVG, unpackRuns } from "parkade";
import { check, faultOfAttribute, keepsRule, RULES, ValueError } from "../../www/src/app/schema";
import { decodeHistory, encodeHistory } from "../../www/src/app/history";
import { decodeView } from "../../www/src/app/view-link";
import { decodeScene, encodeScene } from "../../www/src/scene/link";
import { checkedScene } from "../../www/src/scene/foreign";
import { ensureIds } from "../../www/src/scene/model";
import { initialState, type Scene } from "../../www/src/store";
import { cameraLimits, limited } from "../../www/src/view/camera";
import {
  damagedMessage,
  damagedScene,
  damagedStore,
  damagedView,
  pick,
  sceneText,
  shortForm,
} from "../endurance/damage.mjs";
import { random } from "../endurance/random.mjs";

/** More of them, with another seed: `PARKADE_DAMAGED=100000:7 vitest run tests/js/damaged.test.ts`. */
const [count = "1600", seed = "20261123"] = (process.env["PARKADE_DAMAGED"] ?? "").split(":").filter(Boolean);
const HOURS = 36_000_000,
  EACH = Math.ceil(Number(count) / 4);
/** A decoder that takes longer than this would be felt. */
const LONGEST_MS = 2000;

await init();
const scenes = scenarios().map(({ id }) => ensureIds(scenario(id)));
const known = { planners: planners(), map: scenes[0]!.map };
const playback = { ...initialState().playback };

const checked = (scene: Scene): Scene => checkedScene(scene, { sceneGeometry, packRuns, unpackRuns });

/** Takes `EACH` damaged things; counts what is refused by an error with words, and what is taken. */
async function tally(
  name: string,
  make: (next: (below: number) => number) => unknown,
  take: (made: never) => unknown,
  inWords = true,
): Promise<void> {
  const next = random(Number(seed));
  const counts = { taken: 0, refused: 0 };
  let slowest = 0;
  for (let i = 0; i < EACH; i++) {
    const made = await make(next),
      from = performance.now();
    try {
      await take(made as never);
      counts.taken++;
    } catch (error) {
      const what = `${name} ${i}: ${JSON.stringify(made)?.slice(0, 4000)}\n${String((error as Error).stack)}`;
      expect(error, what).toBeInstanceOf(Error);
      // The engine's and the language's own mistakes are nobody's sentence; JSON's complaint is caught where it arises.
      if (inWords)
        expect((error as Error).name, what).not.toMatch(/^(TypeError|ReferenceError|RuntimeError|InternalError)$/);
      expect((error as { code?: string }).code, what).not.toBe("internal");
      counts.refused++;
    }
    slowest = Math.max(slowest, performance.now() - from);
  }
  if (process.env["PARKADE_DAMAGED"]) {
    console.log(`${name}: ${counts.refused} refused, ${counts.taken} taken, slowest ${slowest.toFixed(0)} ms`);
    expect(slowest).toBeLessThan(LONGEST_MS);
  }
  expect(counts.refused).toBeGreaterThan(EACH / 20);
  expect(counts.taken + counts.refused).toBe(EACH);
  expect(Object.keys(Object.prototype)).toEqual([]);
}

const texts = await Promise.all(
  scenes
    .filter(({ map }) => map.width * map.height < 200_000)
    .map(async (scene) => {
      const text = await encodeScene(scene);
      return { scene, text, short: await shortForm(text) };
    }),
);

test(
  "scene parts of links are refused in words, or are scenes that can be drawn",
  async () => {
    await tally(
      "links' scenes",
      (next) => {
        const { text, short } = pick(next, texts);
        return damagedScene(next, text, short);
      },
      async (link: string) => {
        const scene = checked(await decodeScene(link));
        toSVG(scene, [], { width: 300, height: 200 });
      },
    );
  },
  HOURS,
);

test(
  "view parts of links are refused in words, or are views within the bounds",
  async () => {
    const ids = planners().map(({ id }) => id);
    await tally(
      "links' views",
      (next) =>
        damagedView(
          next,
          pick(next, [
            "0~hybrid~four.eight.risk-field.hybrid~4mf~0~10000",
            "1~any-angle~eight.any-angle.hybrid~2bf~2~3750~1250~925~3150",
          ]),
        ),
      (view: string) => {
        const looks = decodeView(view, known, playback);
        expect(looks.planners.every((id) => ids.includes(id))).toBe(true);
        expect(looks.playback.fraction >= 0 && looks.playback.fraction <= 1).toBe(true);
        expect(limited(looks.camera, known.map)).toBe(looks.camera);
      },
    );
  },
  HOURS,
);

test("null in a scene from outside is as good as absent, at any depth, but for settings", () => {
  const scene = scenes[0]! as unknown as Record<string, unknown>,
    text = packRuns([
      [3, 4, 5],
      [3, 5, 2],
    ]);
  const nulls = {
    ...scene,
    obstacles: null,
    costs: null,
    moving: null,
    map: { ...known.map, boundary: null },
    planners: { hybrid: { minRadius: null } },
  };
  const { boundary: _, ...map } = known.map;
  expect(checked(nulls as unknown as Scene)).toEqual({
    ...scene,
    obstacles: [],
    map,
    planners: { hybrid: { minRadius: null } },
    costs: undefined,
    moving: undefined,
  });
  const packed = {
    ...scene,
    obstacles: [{ type: "cells", runs: text, id: "k" }],
    costs: [{ runs: text, weight: 3, id: "c" }],
  };
  expect(checked(packed as unknown as Scene)).toMatchObject({
    obstacles: [
      {
        runs: [
          [3, 4, 5],
          [3, 5, 2],
        ],
      },
    ],
    costs: [
      {
        runs: [
          [3, 4, 5],
          [3, 5, 2],
        ],
      },
    ],
  });
  expect(checked(scenes[0]!)).toBe(scenes[0]);
});

test(
  "a scene of more than a page can draw is refused before anything is made of it, also where a link of a few " +
    "kilobytes holds it",
  async () => {
    const scene = scenes[0]!,
      many = <T>(count: number, one: T): T[] => Array.from({ length: count }, () => one);
    const box = {
      type: "rectangle" as const,
      id: "box",
      center: [1, 1] as [number, number],
      size: [1, 1] as [number, number],
    };
    const wall = { type: "wall" as const, id: "wall", points: many(2000, [1, 1] as [number, number]), thickness: 0.1 };
    expect(() => checked({ ...scene, obstacles: many(2001, box) })).toThrow("must be at most 2000 objects, got");
    expect(() => checked({ ...scene, obstacles: many(26, wall) })).toThrow(
      "points: must be at most 50000 points, got 52000",
    );
    expect(() => checked({ ...scene, name: "x".repeat(201) })).toThrow("name: must be at most 200 characters, got 201");
    expect(() => checked({ ...scene, obstacles: [{ ...box, id: "x".repeat(1e6) }] })).toThrow(
      "id: must be at most 200 characters, got 1000000",
    );
    for (const [short, told] of [
      [{ o: many(1_000_000, ["r", "", [1, 0, 1, 1, 0]]) }, "damaged or cut off"],
      [{ o: [["k", "", many(200_000, 1)]] }, "more cells than a link can"],
      [{ o: many(50_000, ["r", "", [1, 0, 1, 1, 0]]) }, "at most 2000 objects"],
    ] as const) {
      const link = await sceneText({ ...texts[0]!.short, ...short });
      expect(link.length).toBeLessThan(100_000);
      await expect(decodeScene(link).then(checked)).rejects.toThrow(told);
    }
  },
);

test(
  "values in messages and attributes are refused by field, value and rule, or keep their rules",
  async () => {
    const { scene, text } = texts[0]!,
      { x } = cameraLimits(known.map);
    const rules = {
      camera: RULES.camera(known),
      playhead: RULES.playhead(),
      seek: RULES.playhead(),
      params: RULES.params(known),
    };
    await tally(
      "messages' values",
      (next) => damagedMessage(next, scene, `#s=${text}`),
      async ({ type, value, args }: { type: string; value?: unknown; args?: unknown[] }) => {
        const given = args ? (Array.isArray(args) ? args[0] : undefined) : value;
        if (type === "setScene" || type === "sceneData") return checked(given as Scene);
        if (type === "openLink")
          return checked(await decodeScene(check<string>(given, RULES.link(), "openLink").replace("#s=", "")));
        for (const name of ["layout", "speed", "theme", "layers", "wheel", "controls", "budget-ms"])
          expect(
            faultOfAttribute(name, String(given ?? "")) ?? new ValueError({ field: "", value: 0, rule: "boolean" }),
          ).toBeInstanceOf(ValueError);
        if (!Object.hasOwn(rules, type)) return null;
        const fine = check<unknown>(given, rules[type as keyof typeof rules], type);
        if (type === "camera" && fine !== null)
          expect((fine as { x: number }).x >= x[0] && (fine as { x: number }).x <= x[1]).toBe(true);
        return fine;
      },
    );
  },
  HOURS,
);

test(
  "stored states are dropped, or are what the page can open",
  async () => {
    const [first, second] = scenes as [Scene, Scene];
    const history = encodeHistory(
      { past: [first, { ...first, name: "Other" }], scene: second, future: [first] },
      "#s=1a",
    )!;
    const kept = [
      ["session", "parkade.history", history],
      ["session", "parkade.history", history],
      ["local", "parkade.tab.x", JSON.stringify({ at: 1, scene: first })],
      ["local", "parkade.theme", "dark"],
      ["local", "parkade.lang", "zh"],
      ["local", "parkade.pane.side", "280"],
      ["local", "parkade.hint.drag", "seen"],
    ];
    await tally(
      "stored states",
      (next) => damagedStore(next, kept),
      ([, key, text]: [string, string, string]) => {
        if (key === "parkade.history") return decodeHistory(text, checked);
        if (key === "parkade.tab.x") return checked((JSON.parse(text) as { scene: Scene } | null)?.scene as Scene);
        if (!keepsRule(key, text)) throw new RangeError(`${key}: breaks its rule`);
        return text;
        // What is damaged here is dropped without a word.
      },
      false,
    );
  },
  HOURS,
);
