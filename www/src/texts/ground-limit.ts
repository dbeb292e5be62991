/** The limit that stops a side of the ground, in words. */
import "../i18n/later";
import { number, translate, type MessageKey, type Values } from "../i18n/index";
import { LEAST, MOST_CELLS, type Room } from "../scene/ground";
import type { State } from "../store";
import { thingName } from "./status";

/** Why a side goes no further inward, or outward. */
export function stopText(state: State, { inner: { id } }: Room, inward: boolean): string {
  const { lang, scene } = state,
    say = (key: string, values?: Values): string => translate(lang, `ground.${key}` as MessageKey, values);
  if (!inward) return say("most", { most: MOST_CELLS, metres: number(lang, MOST_CELLS * scene.map.resolution, 1) });
  if (id === null) return say("least", { least: LEAST });
  if (id === "start" || id === "goal") return say("pose", { pose: say(id) });
  const place = (list: readonly { id?: string }[] = []): number => list.findIndex((one) => one.id === id),
    index = place(scene.obstacles),
    slot = place(scene.slots);
  return say("thing", {
    thing:
      index >= 0
        ? thingName(state, { index, obstacle: id })
        : slot >= 0
          ? say("slot", { n: slot + 1 })
          : say(place(scene.moving) >= 0 ? "moving" : "cost"),
  });
}
