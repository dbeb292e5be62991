// @ts-check
// What a command line is answered, in the process that asks.
import { readFile } from "node:fs/promises";
import { parseArgs } from "node:util";
import { isMainThread } from "node:worker_threads";
import { ParkadeError, init, version } from "../node.js";
import { COMMANDS, HELP } from "./commands.js";
import { seconds } from "./input.js";
import { Refused, explained, meant } from "./refusal.js";

/** @typedef {import("./commands.js").Options} Options */

/** The module of this process's commands. @type {Promise<WebAssembly.Module> | undefined} */
let module;

/**
 * Runs a command line, says what is wrong, and gives the exit code.
 * @param {string[]} args
 * @returns {Promise<number>}
 */
export async function answer(args) {
  try {
    return await run(args);
  } catch (error) {
    const isKnown = error instanceof Refused || (error instanceof ParkadeError && error.code !== "internal"),
      { message, stack } = error instanceof Error ? error : { message: String(error), stack: undefined };
    const words = !isKnown ? (stack ?? message) : error instanceof ParkadeError ? explained(error) : message;
    process.stderr.write(`parkade: ${words}\n`);
    return isKnown ? 2 : 3;
  }
}

/** @param {string[]} args @returns {Promise<number>} */
async function run([name = "", ...rest]) {
  if (name === "" || ["help", "--help", "-h"].includes(name)) {
    (name === "" ? process.stderr : process.stdout).write(HELP);
    return name === "" ? 2 : 0;
  }
  module ??= readFile(new URL("../parkade_bg.wasm", import.meta.url)).then((bytes) => WebAssembly.compile(bytes));
  const compiled = await module;
  await init({ wasm: compiled });
  if (["version", "--version", "-v"].includes(name)) {
    process.stdout.write(`${version()}\n`);
    return 0;
  }
  const command = Object.hasOwn(COMMANDS, name) ? COMMANDS[name] : undefined;
  if (command === undefined)
    throw new Refused(
      `unknown command \`${name}\`${meant(name, Object.keys(COMMANDS)) || "; `parkade --help` lists all commands"}`,
    );
  const { positionals, values } = parsed(name, rest, command.options);
  if (values["help"]) {
    process.stdout.write(command.about);
    return 0;
  }
  const { timeout } = /** @type {{ timeout?: string }} */ (values),
    limit = seconds(timeout);
  // Threads of `batch` are ended one by one.
  if (limit !== undefined && isMainThread && name !== "batch")
    return (await import("./timeout.js")).within([name, ...rest], limit);
  return (await command.load())(positionals, values, compiled);
}

/** @param {string} command @param {string[]} args @param {Options} options */
function parsed(command, args, options) {
  try {
    return parseArgs({ args, options: { ...options, help: { type: "boolean", short: "h" } }, allowPositionals: true });
  } catch (error) {
    const [message = ""] = (error instanceof Error ? error.message : String(error)).split(". "),
      [, unknown, name = ""] = /^(Unknown option )?.*?'(?:-\w, )?(--?[\w-]*)/.exec(message) ?? [];
    if (unknown !== undefined)
      throw new Refused(
        `${name}: there is no such option${
          meant(name.slice(2), Object.keys(options ?? {}), "--") ||
          `; \`parkade ${command} --help\` lists those there are`
        }`,
      );
    if (message.includes("does not take")) throw new Refused(`${name}: takes no value`);
    throw new Refused(`${name}: needs a value; one that begins with a dash is written ${name}=-…`);
  }
}
