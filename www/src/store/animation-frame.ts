/** Work that is left to the next frame, so that it is done once for all that happens until then. */

const due: (() => void)[] = [];

/** Does a work once in the next frame, before all other where it is `first`; what it asks for is done in that frame. */
export function inNextFrame(work: () => void, first = false): void {
  if (!due.includes(work) && due[first ? "unshift" : "push"](work) === 1) requestAnimationFrame(workOff);
}

function workOff(): void {
  try {
    for (let work = due.shift(); work; work = due.shift()) work();
  } finally {
    // A work that fails keeps no other from being done.
    if (due.length > 0) requestAnimationFrame(workOff);
  }
}
