// @ts-check
// What every engine does: plans each question, makes a trajectory of a car's path, and says which answers are others
// than expected.

/**
 * @param {typeof import("../../pkg/index.js")} api ready to be called
 * @param {string} questions a JSON object a line: planner, scene, settings, answer and, of what is made of a car's
 * path, trajectory and encounter
 * @returns {{ asked: number, different: string[] }}
 */
export function ask({ Planner, optimise, stopWaitGo }, questions) {
  const lines = questions.trimEnd().split("\n");
  const different = [];
  let asked = 0;
  for (const [number, line] of lines.entries()) {
    const { planner, scene, settings, ...answers } = JSON.parse(line);
    const ours = /** @type {Record<string, string>} */ ({});
    let asking = "answer";
    try {
      const ready = new Planner(planner, scene, settings);
      const plan = ready.plan();
      ours[asking] = plan.hash;
      ready.free();
      if (answers.trajectory !== undefined) {
        asking = "trajectory";
        const driven = optimise(scene, plan);
        ours[asking] = driven.hash;
        if (answers.encounter !== undefined) {
          asking = "encounter";
          ours[asking] = stopWaitGo(scene, driven).hash;
        }
      }
    } catch (error) {
      ours[asking] = error instanceof Error ? error.message : String(error);
    }
    for (const [field, answer] of Object.entries(answers)) {
      asked++;
      if (ours[field] !== answer)
        different.push(
          `line ${number + 1}: ${planner} on ${scene.name ?? "a random map"}: ` +
            `${field} ${ours[field]}, natively ${answer}`,
        );
    }
  }
  return { asked, different };
}
