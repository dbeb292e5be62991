/** A teacher's task in a link: its text, and how the page opens with it. Behind the scene as `&t=…`. */

export interface Task {
  text: string;
  /** True if the planners' answers are hidden until somebody asks for them. */
  hidden: boolean;
  /** Events of the search debugger that are done; null where it stays closed. */
  step: number | null;
  /** True for large type, to be read from afar. */
  large: boolean;
}

export const MARK = "&t=";
/** Characters of a task's text. */
export const LONGEST_TASK = 400;
const MOST_EVENTS = 50_000_000;

export function encodeTask({ text, hidden, step, large }: Task): string {
  const bytes = new TextEncoder().encode(
    JSON.stringify([text.slice(0, LONGEST_TASK), Number(hidden), step, Number(large)]),
  );
  return btoa(String.fromCharCode(...bytes))
    .replaceAll("+", "-")
    .replaceAll("/", "_")
    .replaceAll("=", "");
}

const isStep = (value: unknown): value is number =>
  typeof value === "number" && Number.isInteger(value) && value >= 0 && value <= MOST_EVENTS;

/** The task of an address; null where there is none, or none that makes sense. */
export function taskIn(hash: string): Task | null {
  const text = hash.split(MARK)[1]?.split("&", 1)[0];
  if (!text) return null;
  try {
    const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(binary, (c) => c.charCodeAt(0));
    const [task, hidden, step, large]: unknown[] = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
    if (typeof task !== "string" || task.length > LONGEST_TASK || !(step === null || isStep(step))) return null;
    return { text: task, hidden: hidden === 1, step, large: large === 1 };
  } catch {
    return null;
  }
}

/** An address with a task in the place of the one that it has. */
export function withTask(href: string, task: Task): string {
  const bare = href.replace(/&t=[^&]*/, ""),
    view = bare.indexOf("&v=");
  const mark = MARK + encodeTask(task);
  return view < 0 ? bare + mark : bare.slice(0, view) + mark + bare.slice(view);
}
