/** Says when a slot is too small for the car, and offers the size that fits. */
import messages from "../i18n/messages/slot-fit.json";
import { translator } from "../i18n/translator";
import { findSlot, resolve } from "../scene/model";
import { fitRows, misfitOf } from "../scene/slot-fit";
import type { Scene, Store } from "../store";

const say = translator("slotFit", messages);

/** Speaks of the first of these slots that is too small. */
export function sayMisfit(store: Store, ids: readonly string[]): void {
  const { scene, lang } = store.state,
    car = resolve(scene).vehicle;
  const misfit = ids
    .map((id) => findSlot(scene, id))
    .map((slot) => slot && misfitOf(slot, car))
    .find(Boolean);
  if (!misfit) return;
  const values = { ...misfit, n: ids.length };
  const text = say(
    lang,
    misfit.short > 0 && misfit.narrow > 0 ? "both" : misfit.short > 0 ? "short" : "narrow",
    values,
  );
  const run = (): void => store.edit(fitRows(store.state.scene, ids), { label: "fit" });
  store.set({ message: { tone: "warn", code: "slot-misfit", text, action: { name: say(lang, "fit", values), run } } });
}

const goalSlot = ({ goal }: Scene): string | null => ("slot" in goal ? goal.slot : null);

/** However the goal came into a slot, and whatever car is chosen while it is there. */
export function watchGoalSlot(store: Store): void {
  let known = store.state.scene;
  store.subscribe(({ scene, transient, reason }) => {
    if (transient || scene === known) return;
    const before = known,
      slot = goalSlot(scene);
    known = scene;
    const isEdited = !["open", "undo", "redo"].includes(reason);
    if (slot && isEdited && (slot !== goalSlot(before) || scene.vehicle !== before.vehicle)) sayMisfit(store, [slot]);
  });
}
