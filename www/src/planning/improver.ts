/** Better paths than hybrid's first: looked for while a scene rests, and put in its place as they are found. */
import type { HybridPlan, HybridPlannerId, Plan, PlannerId } from "parkade";
import { followGoals } from "./follow-goals";
import { limitsOn } from "../scene/speed-limits";
import { forPlanners } from "../scene/large-scene";
import { isCheckingBays, type PanelResult, type Scene, type State, type Store } from "../store";
import { drivesCar } from "../styles/planner-style";
import type { Driven } from "./choices-of";
import { chosenOf, isProven } from "./chosen";
import { Helper } from "./job-client";
import type { Engine } from "./engine-loader";
import { keysOf } from "../scene/records";

/** A scene rests for so long before more is asked for, where nothing is preferred. */
const REST_MS = 400;
/** A plan that takes longer is not bettered by itself. */
const LONG_MS = 1500;
/** Many playgrounds may stand in a document: one that nobody has touched asks for no more. */
export const isPage = (): boolean => document.querySelector("parkade-playground[permalink]") !== null;

interface App {
  readonly store: Store;
  readonly planning: object | null;
  complete(): Promise<Engine>;
}
interface Question {
  scene: Scene;
  planner: PlannerId;
  prefer: State["prefer"][PlannerId];
  waiting: State["waiting"];
}

const following = new WeakSet<Store>();

/** Has what is shown follow the store: the goal of a set that is taken, and better paths. */
export function follow(app: App): void {
  if (following.has(app.store)) return;
  following.add(app.store);
  followGoals(app.store);
  new Improver(app).start();
}

/** State that decides which paths are shown or requested. */
const WATCHED = [
  "scene",
  "transient",
  "waiting",
  "results",
  "prefer",
  "planners",
  "hidden",
  "complete",
  "canUndo",
  "hover",
  "playback",
  "bays",
] as const;

class Improver {
  /** Paths found for each scene, by planner and waiting rule. */
  private readonly found = new WeakMap<Scene, Map<string, readonly Driven[]>>();
  /** The choice that replaces a planner's first answer. */
  private readonly shown = new WeakMap<Plan, Driven>();
  private question: Question | null = null;
  /** The best answer to the question so far. */
  private better: Driven | null = null;
  private helper: Helper | null = null;
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly app: App) {}

  private get state(): State {
    return this.app.store.state;
  }

  start(): void {
    this.app.store.derive((state, previous) => {
      const { question } = this;
      if (question && (isCheckingBays(state) || !isAsked(question, state))) this.giveUp();
      if (WATCHED.some((key) => state[key] !== previous[key])) this.follow();
    });
    this.follow();
  }

  /** Shows what is known of the present scene, and sees whether there is more to ask. */
  private follow(): void {
    const { state } = this,
      { choices: old = {} } = state;
    const choices: NonNullable<State["choices"]> = {};
    for (const planner of state.planners) {
      const known = this.known(planner);
      if (!known || !isGood(state, planner)) continue;
      choices[planner] = known;
      this.show(planner, chosenOf(known, state.prefer[planner]));
    }
    if (this.better && this.question && isGood(state, this.question.planner))
      this.show(this.question.planner, this.better);
    const ids = keysOf({ ...old, ...choices });
    if (ids.some((planner) => old[planner] !== choices[planner])) this.app.store.gather({ choices });
    this.tell();
    clearTimeout(this.rest);
    const next = this.question ? undefined : this.next();
    if (next) this.rest = setTimeout(() => this.begin(), state.prefer[next] ? 0 : REST_MS);
  }

  private begin(): void {
    const planner = this.question ? undefined : this.next();
    if (planner) void this.search(planner);
  }

  private known(planner: PlannerId): readonly Driven[] | undefined {
    const { scene, waiting, transient } = this.state;
    return transient ? undefined : this.found.get(scene)?.get(keyOf(planner, waiting));
  }

  /** A planner whose answer rests and has not been asked for more; the one in front first. */
  private next(): PlannerId | undefined {
    const { state } = this;
    const isOccupied = state.transient || state.playback.playing || isCheckingBays(state);
    if (!this.app.planning || !state.complete || isOccupied || document.hidden) return undefined;
    const isAlive = state.canUndo || state.hover !== null || isPage();
    const isQuick = (planner: PlannerId): boolean =>
      isAlive && (state.results[planner]?.time?.total ?? LONG_MS) < LONG_MS;
    return [state.focus, ...state.planners].find(
      (planner) =>
        state.planners.includes(planner) &&
        !state.hidden.has(planner) &&
        isGood(state, planner) &&
        !this.known(planner) &&
        (state.prefer[planner] || isQuick(planner)),
    );
  }

  private async search(planner: PlannerId): Promise<void> {
    const {
        scene,
        waiting,
        prefer: { [planner]: prefer },
      } = this.state,
      question: Question = { scene, planner, prefer, waiting };
    this.question = question;
    let choices: readonly Driven[] = [];
    try {
      this.tell();
      const engine = await this.app.complete();
      if (this.question !== question) return;
      this.helper = new Helper(engine);
      const asked = {
        planner: planner as HybridPlannerId,
        scene: forPlanners(scene, engine.api.packRuns),
        prefer,
        waiting,
        limits: limitsOn(scene),
      };
      choices = await this.helper.call("improve", asked, [], (better: Driven) => {
        if (this.question !== question) return;
        this.better = better;
        this.follow();
      });
    } catch {
      // The panel has the first answer, and says what is wrong with the scene.
    }
    if (this.question !== question) return;
    const known = this.found.get(scene) ?? new Map<string, readonly Driven[]>();
    this.found.set(scene, known.set(keyOf(planner, waiting), choices));
    this.giveUp();
    this.follow();
  }

  private giveUp(): void {
    this.helper?.stop();
    this.helper = this.question = this.better = null;
    this.tell();
  }

  /** Says for which planner better paths are looked for, while there may be some. */
  private tell(): void {
    const { question, state } = this,
      plan = question && state.results[question.planner]?.plan;
    const improving = question && plan && !isProven(plan as HybridPlan, question.prefer) ? question.planner : undefined;
    if (improving !== state.improving) this.app.store.gather({ improving });
  }

  /**
   * Puts a path in the place of a planner's first answer, whose search, time and work stay in sight; not under a car
   * that drives.
   */
  private show(planner: PlannerId, choice: Driven | undefined): void {
    const { results, playback } = this.state,
      result = results[planner];
    if (!choice || !result?.plan || playback.playing || this.shown.get(result.plan) === choice) return;
    const before = this.shown.get(result.plan)?.plan ?? result.plan;
    if (samePath(before, choice.plan)) return void this.shown.set(result.plan, choice);
    const { trace, stats, goal } = result.plan as HybridPlan,
      plan: HybridPlan = { ...(goal && { goal }), ...choice.plan, trace, stats };
    this.shown.set(plan, choice);
    const patch: PanelResult = {
      ...result,
      ordinary: (result.chosen && result.ordinary) ?? result.plan,
      plan,
      chosen: plan,
      lastGood: plan,
      drive: choice.drive,
    };
    this.app.store.gather({ results: { ...results, [planner]: patch } });
  }
}

const keyOf = (planner: PlannerId, waiting: State["waiting"]): string => `${planner} ${waiting}`;

/** True if a question still is the one to answer. */
const isAsked = ({ scene, planner, prefer, waiting }: Question, state: State): boolean =>
  state.scene === scene &&
  !state.transient &&
  state.waiting === waiting &&
  state.prefer[planner] === prefer &&
  state.planners.includes(planner) &&
  !state.hidden.has(planner);

/** True if a planner's answer is one that may be bettered. */
function isGood({ results }: State, planner: PlannerId): boolean {
  const result = results[planner];
  return (
    drivesCar(planner) && result?.status === "done" && result.plan?.outcome === "found" && result.plan.check.drivable
  );
}

const samePath = ({ path: a }: Plan, { path: b }: Plan): boolean =>
  a.length === b.length && a.every((value, at) => value === b[at]);
