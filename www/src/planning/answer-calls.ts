/**
 * Calls of a worker's functions, the worker's side. It imports nothing that the page runs: a worker would load the page
 * with it.
 */
import type { CallReply, CallRequest, Functions } from "./calls";
import { failureOf } from "./failure";

/** The worker's own scope; the page's libraries know a window. */
declare const self: {
  onmessage: ((event: MessageEvent<CallRequest>) => void) | null;
  postMessage(reply: CallReply, transfer: Transferable[]): void;
};

/**
 * Answers calls, and leaves other messages to who listened before. `prepare` is given each call's context;
 * `moved` says which buffers of an answer need not be copied.
 */
export function answerCalls<Jobs extends Functions>(
  jobs: Jobs,
  prepare: (context: never) => Promise<void> = () => Promise.resolve(),
  moved: (answer: unknown) => Transferable[] = () => [],
): void {
  const before = self.onmessage;
  const answer = async ({ id, name, input, context }: CallRequest): Promise<void> => {
    const reply = { kind: "call", id } as const;
    try {
      await prepare(context as never);
      const tell = (told: unknown): void => self.postMessage({ ...reply, told }, []);
      const got = jobs[name]!(input as never, tell as never);
      self.postMessage({ ...reply, answer: got }, moved(got));
    } catch (error) {
      self.postMessage({ ...reply, error: failureOf(error) }, []);
    }
  };
  self.onmessage = (event) => (event.data.kind === "call" ? void answer(event.data) : before?.call(self, event));
}
