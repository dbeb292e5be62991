import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { init, scenario, scenarios, sceneGeometry } from "parkade";
import { decodeHistory, encodeHistory } from "../../www/src/app/history";
import { pack, unpack } from "../../www/src/scene/link-codec";
import { ensureIds } from "../../www/src/scene/model";
import { createStore, type History, type Scene } from "../../www/src/store";

await init();
const scenes = scenarios().map(({ id }) => ensureIds(scenario(id)));
const checked = (scene: Scene): Scene => {
  sceneGeometry(scene);
  return ensureIds(scene);
};
const HASH = "#s=1abc";
const decode = (text: string | null): History => {
  const { hash, ...history } = decodeHistory(text!, checked);
  expect(hash).toBe(HASH);
  return history;
};

/** A drawing of many steps: every edit moves the start or adds an obstacle. */
function drawn(steps: number, undone: number): History {
  const store = createStore({ scene: scenes[0]! });
  for (let i = 0; i < steps; i++) {
    const { scene } = store.state;
    const wall = {
      type: "rectangle" as const,
      id: `r${i}`,
      center: [5 + i / 100, 5] as [number, number],
      size: [1, 1] as [number, number],
      heading: 0,
    };
    store.edit(
      i % 2
        ? { ...scene, start: { ...scene.start, x: scene.start.x + 0.001 } }
        : { ...scene, obstacles: [...(scene.obstacles ?? []), wall] },
    );
  }
  for (let i = 0; i < undone; i++) store.undo();
  return store.history;
}

describe("a history", () => {
  it("comes back with every scene to the last digit, and with the parts that they shared", () => {
    const before = drawn(40, 7),
      after = decode(encodeHistory(before, HASH));
    expect(after).toEqual(before);
    expect(after.past[3]!.map).toBe(after.scene.map);
    expect(after.past[2]!.obstacles).toBe(after.past[1]!.obstacles);
    const store = createStore({});
    store.restore(after);
    expect([store.state.canUndo, store.state.canRedo]).toEqual([true, true]);
    for (let i = 0; i < 33; i++) store.undo();
    expect(store.state.scene).toEqual(scenes[0]);
    expect(store.state.canUndo).toBe(false);
    for (let i = 0; i < 40; i++) store.redo();
    expect(store.state.scene).toEqual(before.future[0]);
  });

  it("of every preset's scene comes back", () => {
    for (const scene of scenes)
      expect(decode(encodeHistory({ past: [scene], scene, future: [] }, HASH)).scene).toEqual(scene);
  });

  it("keeps the nearest steps where not all fit, and nothing where the scene does not", () => {
    const cells = (rows: number): Scene => ({
      ...scenes[0]!,
      map: { ...scenes[0]!.map, width: 2000, height: 2000 },
      obstacles: [{ type: "cells", id: "k", runs: Array.from({ length: rows }, (_, y) => [2, y % 2000, 3]) }],
    });
    const past = Array.from({ length: 300 }, (_, i) => cells(1000 + i)),
      text = encodeHistory({ past, scene: cells(10), future: [cells(5)] }, HASH);
    expect(text!.length).toBeLessThan(1_000_100);
    const kept = decode(text);
    expect(kept.past.length).toBeGreaterThan(50);
    expect(kept.past.length).toBeLessThan(300);
    expect(kept.past.at(-1)).toEqual(past.at(-1));
    expect(encodeHistory({ past, scene: cells(200_000), future: [] }, HASH)).toBeNull();
  });

  it("whose place is no number is refused", () => {
    const text = encodeHistory(drawn(3, 1), HASH)!;
    for (const at of ['"constructor"', "9", "-1", "0.5", "null", '"1"'])
      expect(() => decodeHistory(text.replace('"at":2', `"at":${at}`), checked), at).toThrow(
        "at: must name one of 4 scenes",
      );
  });

  it("that is damaged is refused, or is a history of scenes that can be planned", () => {
    const text = encodeHistory(drawn(6, 2), HASH)!;
    const letters = '0123456789.,:{}[]"-eEn\\ ';
    const damage = fc.tuple(
      fc.nat(text.length - 1),
      fc.nat(12),
      fc.string({ unit: fc.constantFrom(...letters), maxLength: 3 }),
    );
    let taken = 0,
      refused = 0;
    fc.assert(
      fc.property(fc.array(damage, { minLength: 1, maxLength: 3 }), (all) => {
        const bad = all.reduce((now, [at, cut, more]) => now.slice(0, at) + more + now.slice(at + cut), text);
        try {
          const { past, scene, future } = decodeHistory(bad, checked);
          for (const one of [...past, scene, ...future]) sceneGeometry(one);
          taken++;
        } catch (error) {
          expect(error).toBeInstanceOf(Error);
          refused++;
        }
      }),
      { numRuns: 2000, seed: 20261123 },
    );
    expect(taken + refused).toBe(2000);
    expect(refused).toBeGreaterThan(500);
  });
});

describe("a link's short form", () => {
  it("of what a link opens is the same again, for every preset", () => {
    for (const scene of scenes) {
      const short = pack(scene);
      expect(pack(ensureIds(unpack(structuredClone(short), ensureIds)))).toEqual(short);
    }
  });
});
