/** A worker of the complete module for one long job after another. */
import type { Run } from "../scene/cells";
import type { Scenario } from "../scene/scenario";
import { rememberPacked } from "../scene/large-scene";
import type { JobName, JobReply, JobRequest, Jobs, Moved } from "./job-worker";
import type { Engine } from "./engine-loader";
import type { Failure } from "./protocol";

/** An error thrown by a job, with its code and field. */
export class JobError extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

interface Waiting {
  resolve(answer: unknown): void;
  reject(error: Error): void;
  tell: ((told: never) => void) | undefined;
}

export class Helper {
  private readonly worker: Worker;
  private readonly waiting = new Map<number, Waiting>();
  private last = 0;

  constructor(private readonly engine: Engine) {
    this.worker = new Worker(engine.script, { type: "module", name: "parkade jobs" });
    this.worker.onmessage = ({ data }: MessageEvent<JobReply>) => {
      const job = this.waiting.get(data.id);
      if ("told" in data) return job?.tell?.(data.told as never);
      this.waiting.delete(data.id);
      if ("error" in data) job?.reject(new JobError(data.error));
      else job?.resolve(data.answer);
    };
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.fail(event.message || "the worker stopped");
    };
  }

  /** `tell` is given what the job has to say before its answer. */
  call<Name extends JobName>(
    name: Name,
    input: Parameters<Jobs[Name]>[0],
    transfer: Transferable[] = [],
    tell?: (told: never) => void,
  ): Promise<ReturnType<Jobs[Name]>> {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve: (answer) => resolve(answer as ReturnType<Jobs[Name]>), reject, tell });
      const request: JobRequest = { kind: "job", id, module: this.engine.module, name, input };
      this.worker.postMessage(request, transfer);
    });
  }

  /** Gives up whatever runs. */
  stop(): void {
    this.worker.terminate();
    this.fail("stopped");
  }

  private fail(message: string): void {
    for (const { reject } of this.waiting.values()) reject(new JobError({ code: "internal", path: "", message }));
    this.waiting.clear();
  }
}

/** Runs made at once; more would hold up the page. */
const SLICE = 15_000;

/** Puts the cells that travelled apart back into their scenes. */
export async function joined({ cells }: Moved<unknown>, scenes: readonly Scenario[]): Promise<Scenario[]> {
  const whole = [...scenes];
  for (const { scene, obstacle, numbers, text } of cells) {
    const runs: Run[] = [];
    for (let i = 0; i < numbers.length; i += 3) {
      runs.push([numbers[i]!, numbers[i + 1]!, numbers[i + 2]!]);
      if (runs.length % SLICE === 0) await new Promise((done) => setTimeout(done));
    }
    rememberPacked(runs, text);
    const { obstacles = [], ...rest } = whole[scene]!;
    whole[scene] = {
      ...rest,
      obstacles: obstacles.map((one, i) => (i === obstacle && one.type === "cells" ? { ...one, runs } : one)),
    };
  }
  return whole;
}
