/** Somebody else's trajectory: judged by the referee in each scene, and driven beside ours until it is removed. */
import messages from "../i18n/messages/guest.json";
import { translator } from "../i18n/translator";
import { Helper } from "../planning/job-client";
import { forPlanners } from "../scene/large-scene";
import type { Scene } from "../store";
import { sentence, type App } from "./app";
import { apart, withField } from "./refusals";

const say = translator("guest", messages);

/** Bytes; a million rows of eight numbers have more, and are too many for a canvas. */
const LARGEST = 20_000_000;
const MEGABYTE = 1_000_000;

/** True of a CSV whose first line has names: a parking case has numbers alone. */
export const isTrajectory = async (file: File): Promise<boolean> =>
  /\.csv$/i.test(file.name) && /^\ufeff?\s*[a-z_"]/i.test(await file.slice(0, 200).text());

const turns = new WeakMap<App, number>();

/** Judges a file in the present scene and shows it; a file that is none changes nothing. */
export async function openTrajectory(app: App, file: File): Promise<void> {
  const { lang } = app.store.state,
    { name, size } = file;
  if (size > LARGEST) {
    const reason = sentence(say(lang, "large", { most: LARGEST / MEGABYTE, size: (size / MEGABYTE).toFixed(1) }));
    return app.store.set({ message: { tone: "err", text: say(lang, "bad", { name, reason }) } });
  }
  await judge(app, name, await file.text(), true);
}

async function judge(app: App, name: string, text: string, isNew: boolean): Promise<void> {
  const turn = (turns.get(app) ?? 0) + 1,
    { scene } = app.store.state;
  turns.set(app, turn);
  let helper: Helper | undefined;
  try {
    const engine = await app.complete();
    helper = new Helper(engine);
    const answer = await helper.call("judge", { scene: forPlanners(scene, engine.api.packRuns), text });
    if (turns.get(app) !== turn) return;
    app.store.set({ guest: { name, text, scene, ...answer } });
    if (isNew) app.store.set({ message: { tone: answer.verdict.passes ? "info" : "warn", text: verdictOf(app) } });
  } catch (error) {
    if (turns.get(app) === turn) app.store.set({ message: { tone: "err", text: complaint(app, name, error) } });
  } finally {
    helper?.stop();
  }
}

/** The verdict in a sentence. */
function verdictOf({ store: { state } }: App): string {
  const { lang, guest } = state,
    { passes, attained, keepsLimits, touchingFrames, uncertified, duration } = guest!.verdict;
  if (passes) return say(lang, "passes", { name: guest!.name, seconds: duration.toFixed(1) });
  const why = [
    ...(touchingFrames > 0 ? [say(lang, "contact", { n: touchingFrames })] : []),
    ...(touchingFrames === 0 && uncertified > 0 ? [say(lang, "uncertified", { n: uncertified })] : []),
    ...(attained ? [] : [say(lang, "goal")]),
    ...(keepsLimits ? [] : [say(lang, "limits")]),
  ];
  return say(lang, "fails", { name: guest!.name, why: why.join(say(lang, "and")) });
}

function complaint({ store: { state } }: App, name: string, error: unknown): string {
  const { path, rule } = apart(error),
    [, line, column] = /^(\d+):(\d+)$/.exec(path) ?? [];
  if (line && column) return say(state.lang, "place", { name, line, column, reason: rule });
  return say(state.lang, "bad", { name, reason: withField(path, rule) });
}

/** Takes the trajectory away; one that is being judged does not come. */
export function removeTrajectory(app: App): void {
  turns.set(app, (turns.get(app) ?? 0) + 1);
  app.store.set({ guest: null });
}

/** Another scene opens without it; an edit of the scene has it judged again. */
export function followGuest(app: App): void {
  app.store.subscribe((state, previous) => {
    const { guest, scene, transient, opened } = state;
    if (!guest) return;
    if (opened !== previous.opened) removeTrajectory(app);
    else if (!transient && (scene !== previous.scene || previous.transient) && differs(scene, guest.scene))
      void judge(app, guest.name, guest.text, false);
  });
}

/** True if the verdict may be another. */
const differs = (a: Scene, b: Scene): boolean =>
  (["map", "obstacles", "slots", "vehicle", "start", "goal"] as const).some((key) => a[key] !== b[key]);
