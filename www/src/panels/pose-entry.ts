/** A field in the place of a pose's label: three numbers, metres and degrees. */
import type { Pose } from "parkade";
import type { App } from "../app/app";
import messages from "../i18n/messages/pose-entry.json";
import { translator } from "../i18n/translator";
import { movePose, resolve } from "../scene/model";
import type { PoseRequest } from "../view/pose-label";

const say = translator("poseEntry", messages);

const DEGREES = 180 / Math.PI;

/** Two numbers, or three; null for anything else. */
export function poseFromText(text: string, before: Pose): Pose | null {
  const numbers =
    text
      .replaceAll("\u2212", "-")
      .match(/[+-]?(\d+\.?\d*|\.\d+)/g)
      ?.map(Number) ?? [];
  const [x, y, heading] = numbers;
  if (x === undefined || y === undefined || numbers.length > 3) return null;
  return { x, y, heading: heading === undefined ? before.heading : heading / DEGREES };
}

export function openPoseEntry(app: App, root: ShadowRoot, { which, box }: PoseRequest): void {
  const { state } = app.store,
    pose = resolve(state.scene)[which];
  const input = document.createElement("input");
  input.className = "pose";
  input.value = `${pose.x.toFixed(2)} ${pose.y.toFixed(2)} ${(pose.heading * DEGREES).toFixed(1)}`;
  input.spellcheck = false;
  input.setAttribute("aria-label", say(state.lang, which));
  input.title = say(state.lang, which);
  input.style.left = `${box.minX}px`;
  input.style.top = `${box.minY}px`;
  const written = input.value;
  let open = true;
  const close = (): void => {
    open = false;
    input.remove();
    root.querySelector("canvas")?.focus();
  };
  const apply = (): void => {
    if (!open) return;
    const next = poseFromText(input.value, pose);
    if (!next) {
      input.setAttribute("aria-invalid", "true");
      app.store.set({ message: { tone: "warn", text: say(app.store.state.lang, "refused") } });
      return;
    }
    if (input.value !== written) app.store.edit(movePose(app.store.state.scene, which, next), { label: which });
    close();
  };
  input.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key === "Enter") apply();
    else if (event.key === "Escape") close();
  });
  input.addEventListener("blur", () => {
    if (open && poseFromText(input.value, pose)) apply();
    else if (open) close();
  });
  root.append(input);
  input.select();
  input.focus();
}
