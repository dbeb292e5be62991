/** Commands that edit: they come with the drawing tools. */
import {
  duplicateSelected,
  flipEntry,
  removeSelected,
  selectAll,
  setRadius,
  setWeight,
  toggleLock,
  turn,
} from "../tools/edit-keys";
import type { Store } from "../store";
import type { Command } from "./command";

/** The tool in force shows its preview again after the change. */
const by =
  (change: (store: Store) => boolean): Command["run"] =>
  ({ controller }) =>
    controller.edit(change);

export const EDITING = {
  remove: { keys: ["Delete", "Backspace"], title: "keys.delete", icon: "trash", run: by(removeSelected) },
  duplicate: { keys: ["Mod+D"], title: "keys.duplicate", icon: "copy", run: by(duplicateSelected) },
  selectAll: { keys: ["Mod+A"], title: "keys.all", icon: "select", run: by(selectAll) },
  turnLeft: { keys: ["Mod+ArrowLeft"], title: "keys.turn", run: by((store) => turn(store, 5)) },
  turnRight: { keys: ["Mod+ArrowRight"], title: "keys.turn", run: by((store) => turn(store, -5)) },
  turnLeftALittle: { keys: ["Mod+Shift+ArrowLeft"], title: "keys.turnLittle", run: by((store) => turn(store, 1)) },
  turnRightALittle: { keys: ["Mod+Shift+ArrowRight"], title: "keys.turnLittle", run: by((store) => turn(store, -1)) },
  flip: { keys: ["X"], title: "keys.flip", icon: "flip", run: by(flipEntry) },
  lock: { keys: ["Q"], title: "keys.lock", run: by(toggleLock) },
  smallerBrush: { keys: ["["], title: "keys.radius", run: by((store) => setRadius(store, -1)) },
  largerBrush: { keys: ["]"], title: "keys.radius", run: by((store) => setRadius(store, 1)) },
  lowerCost: { keys: ["{"], title: "keys.weight", run: by((store) => setWeight(store, -1)) },
  higherCost: { keys: ["}"], title: "keys.weight", run: by((store) => setWeight(store, 1)) },
} satisfies Record<string, Command>;
