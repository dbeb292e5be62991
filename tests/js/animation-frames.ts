/** Node has no frames; those of tests follow the timers, which tests replace. */
globalThis.requestAnimationFrame = (run) => setTimeout(() => run(performance.now()), 16) as unknown as number;
