#!/usr/bin/env node
// @ts-check
// The command `parkade`.
import { reason } from "./refusal.js";
import { answer } from "./run.js";

// A reader that has seen enough, as `head`, is no error.
process.stdout.on("error", (error) => {
  const isClosed = /** @type {NodeJS.ErrnoException} */ (error).code === "EPIPE";
  if (!isClosed) process.stderr.write(`parkade: standard output: ${reason(error)}\n`);
  process.exit(isClosed ? 0 : 2);
});

process.exitCode = await answer(process.argv.slice(2));
