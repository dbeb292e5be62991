/** Tasks in links. */
import { describe, expect, it } from "vitest";
import { encodeTask, LONGEST_TASK, taskIn, withTask, type Task } from "../../www/src/app/task-link";

const TASK: Task = { text: "Why is (12, 7) next? 为什么？", hidden: true, step: 1234, large: false };

describe("a task in a link", () => {
  it("is read as it was written, with and without a view", () => {
    for (const task of [TASK, { ...TASK, hidden: false, step: null, large: true }, { ...TASK, step: 0 }])
      for (const href of ["https://x.test/#s=1abc", "https://x.test/#s=1abc&v=0~four~four~1~0~0"]) {
        const link = withTask(href, task);
        expect(taskIn(link)).toEqual(task);
        expect(link.replace(/&t=[^&]*/, "")).toBe(href);
        expect(taskIn(withTask(link, TASK))).toEqual(TASK);
      }
  });

  it("that is damaged, too long or none is no task", () => {
    const whole = `#s=1abc&t=${encodeTask(TASK)}`;
    for (const hash of ["", "#s=1abc", whole.slice(0, -3), "#s=1abc&t=%", "#s=1abc&t=W10"])
      expect(taskIn(hash)).toBeNull();
    const wrong = [
      ["x".repeat(LONGEST_TASK + 1), 0, null, 0],
      ["x", 0, -1, 0],
      ["x", 0, 1.5, 0],
      ["x", 0, "1", 0],
      [1, 0, null, 0],
    ];
    for (const one of wrong) expect(taskIn(`#s=1abc&t=${btoa(JSON.stringify(one)).replaceAll("=", "")}`)).toBeNull();
  });
});
