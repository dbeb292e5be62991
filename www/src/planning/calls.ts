/**
 * Calls of a worker's functions, the page's side: a message there, what the function tells on its way, and one answer
 * or failure back.
 */
import type { Failure } from "./protocol";

/** `tell` is a function that takes what there is to tell. */
export type Functions = Record<string, (input: never, tell: never) => unknown>;

/** `context`: what a worker needs before its first function, the same in every call. */
export interface CallRequest {
  kind: "call";
  id: number;
  name: string;
  input: unknown;
  context: unknown;
}
export type CallReply = { kind: "call"; id: number } & ({ told: unknown } | { answer: unknown } | { error: Failure });

/** What a function threw, with its code, field, rule and line. */
export class CallError extends Error implements Failure {
  declare readonly code: string;
  declare readonly path: string;
  declare readonly template?: string;
  declare readonly values?: readonly string[];
  declare readonly line?: number;

  constructor(failure: Failure) {
    super(failure.message);
    Object.assign(this, failure);
  }
}

interface Waiting {
  resolve(answer: unknown): void;
  reject(error: Error): void;
  tell: ((told: never) => void) | undefined;
}

export class Calls<Jobs extends Functions> {
  private readonly waiting = new Map<number, Waiting>();
  private last = 0;

  constructor(
    private readonly worker: Worker,
    private readonly context: unknown = null,
  ) {
    worker.onmessage = ({ data }: MessageEvent<CallReply>) => {
      const call = this.waiting.get(data.id);
      if ("told" in data) return call?.tell?.(data.told as never);
      this.waiting.delete(data.id);
      if ("error" in data) call?.reject(new CallError(data.error));
      else call?.resolve(data.answer);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.fail(event.message || "the worker stopped");
    };
  }

  /** `tell` is given what the function has to say before its answer. */
  call<Name extends keyof Jobs & string>(
    name: Name,
    input: Parameters<Jobs[Name]>[0],
    transfer: Transferable[] = [],
    tell?: (told: never) => void,
  ): Promise<ReturnType<Jobs[Name]>> {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve: (answer) => resolve(answer as ReturnType<Jobs[Name]>), reject, tell });
      const request: CallRequest = { kind: "call", id, name, input, context: this.context };
      this.worker.postMessage(request, transfer);
    });
  }

  /** Gives up whatever runs. */
  stop(): void {
    this.worker.terminate();
    this.fail("stopped");
  }

  private fail(message: string): void {
    for (const { reject } of this.waiting.values()) reject(new CallError({ code: "internal", path: "", message }));
    this.waiting.clear();
  }
}
