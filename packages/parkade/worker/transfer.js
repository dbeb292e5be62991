// @ts-check

/** @type {typeof import("./transfer.js").transferables} */
export function transferables(plan, layers = {}) {
  const arrays = [
    plan.path,
    plan.directions,
    plan.curvatures,
    plan.clearances,
    plan.rawPath,
    plan.check.hitPoses,
    plan.trace?.kind === "cells" ? plan.trace.cells : plan.trace?.arcs,
    ...Object.values(layers).map((layer) => layer?.data),
  ];
  const others = ("alternatives" in plan && plan.alternatives) || [];
  const buffers = arrays.flatMap((array) => (array ? [/** @type {ArrayBuffer} */ (array.buffer)] : []));
  // A buffer that is named twice cannot move.
  return [...new Set([...buffers, ...others.flatMap((one) => transferables(one))])];
}
