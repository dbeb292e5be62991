// @ts-check
// What every engine does: plans each question, and says which answers are others than expected.

/**
 * @param {typeof import("../../pkg/index.js")} api ready to be called
 * @param {string} questions a JSON object a line: planner, scene, settings, answer
 * @returns {{ asked: number, different: string[] }}
 */
export function ask({ Planner }, questions) {
  const lines = questions.trimEnd().split("\n");
  const different = [];
  for (const [number, line] of lines.entries()) {
    const { planner, scene, settings, answer } = JSON.parse(line);
    let ours;
    try {
      const ready = new Planner(planner, scene, settings);
      ours = ready.plan().hash;
      ready.free();
    } catch (error) {
      ours = error instanceof Error ? error.message : String(error);
    }
    if (ours !== answer) different.push(`line ${number + 1}: ${planner} on ${scene.name ?? "a random map"}: ${ours}, natively ${answer}`);
  }
  return { asked: lines.length, different };
}
