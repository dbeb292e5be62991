// @ts-check
// Errors, and the state of the one wasm module behind the API.

export class ParkadeError extends Error {
  name = "ParkadeError";

  /**
   * @param {string} message
   * @param {import("./index.js").ErrorCode} code
   * @param {string} [path]
   * @param {ErrorOptions} [options]
   */
  constructor(message, code, path = "", options) {
    super(message, options);
    this.code = code;
    this.path = path;
  }
}

/** @type {"not loaded" | "ready" | "stopped"} */
let state = "not loaded";

/** @type {Promise<void> | undefined} */
let loading;

/**
 * Makes `init` from a way to load the module.
 * @param {(wasm: unknown) => Promise<unknown>} load
 * @returns {typeof import("./index.js").init}
 */
export function initializer(load) {
  /** @type {unknown} */
  let source;
  return function init(options) {
    const wasm = options?.wasm;
    // A compiled module is another object in each worker that it is sent to.
    if (loading && (wasm ?? source) !== source && !(wasm instanceof WebAssembly.Module)) {
      return Promise.reject(mismatch(wasm, "wasm", "as in the first `init`"));
    }
    loading ??= load((source = wasm)).then(
      () => {
        state = "ready";
      },
      (cause) => {
        loading = undefined;
        const message = `cannot load the wasm module: ${describe(cause)}`;
        const given = wasm !== undefined;
        throw new ParkadeError(message, given ? "bad-input" : "internal", given ? "wasm" : "", { cause });
      },
    );
    return loading;
  };
}

/**
 * Calls into the module; whatever goes wrong there leaves as a ParkadeError.
 * @template T
 * @param {() => T} run
 * @returns {T}
 */
export function call(run) {
  if (state === "not loaded") {
    throw new ParkadeError("the wasm module is not loaded: `await init()` first", "not-initialised");
  }
  if (state === "stopped") {
    throw new ParkadeError("stopped by an earlier internal error: use a new worker or process", "internal");
  }
  try {
    return run();
  } catch (error) {
    throw converted(error);
  }
}

/** True if the module can still be called: a trap leaves its memory in an unknown state. */
export function isRunning() {
  return state === "ready";
}

/** @param {unknown} error */
function converted(error) {
  if (error instanceof ParkadeError) return error;
  if (error instanceof Error && error.name === "ParkadeError") {
    const { code, path, template, values } = /** @type {import("./index.js").ParkadeError} */ (error);
    // A value may be a whole scene; a number is said as it is natively.
    return said(new ParkadeError(error.message.replace(/(, got [^\d-].{99}).+/s, "$1…"), code, path), template, values);
  }
  if (error instanceof WebAssembly.RuntimeError) state = "stopped";
  return new ParkadeError(`internal error: ${describe(error)}`, "internal", "", { cause: error });
}

/**
 * The error with what its message is made of.
 * @param {ParkadeError} error
 * @param {string | undefined} template
 * @param {readonly string[] | undefined} values
 */
export const said = (error, template, values) => Object.assign(error, { template, values });

/** @param {unknown} error */
function describe(error) {
  return error instanceof Error ? error.message : shown(error);
}

/**
 * The error of a value of another kind than the rule asks for.
 * @param {unknown} value
 * @param {string} path
 * @param {string} rule
 * @param {string} [got] what it is
 * @param {import("./index.js").ErrorCode} [code]
 */
export function mismatch(value, path, rule, got = shown(value), code = "bad-input") {
  const template = `must be ${rule}, got `;
  return said(new ParkadeError(`${path}: ${template}${got}`, code, path), `${template}{}`, [got]);
}

/**
 * wasm-bindgen does not check what it takes for a string.
 * @param {unknown} value
 * @param {string} path
 */
export function text(value, path) {
  if (typeof value === "string") return value;
  throw mismatch(value, path, "a string");
}

/**
 * Neither does it check numbers: big integers, for one, do not become any.
 * @param {unknown} value
 * @param {string} path
 */
export function number(value, path) {
  if (typeof value === "number") return value;
  throw mismatch(value, path, "a number");
}

/**
 * @template T
 * @param {T} value
 * @param {string} path
 * @param {import("./index.js").ErrorCode} [code]
 * @returns {T & object}
 */
export function object(value, path, code) {
  if (typeof value === "object" && value !== null && !Array.isArray(value)) return value;
  throw mismatch(value, path, "an object", shown(value), code);
}

/**
 * Fields that may be left out.
 * @template T
 * @param {T} value
 * @param {string} [path]
 * @param {import("./index.js").ErrorCode} [code]
 */
export const optional = (value, path = "options", code) => object(value ?? /** @type {T & object} */ ({}), path, code);

/**
 * A value in a message, cut where it is long.
 * @param {unknown} value
 */
export function shown(value) {
  try {
    const text = typeof value === "number" ? `${value}` : JSON.stringify(value);
    return text.length > 60 ? `${text.slice(0, 60)}…` : text;
  } catch {
    // Functions, big integers and cycles have no JSON.
    return typeof value;
  }
}

/**
 * The typed array itself, or an array's numbers in one; never another number than the given one.
 * @template {Float64Array | Int8Array | Uint32Array} T
 * @param {{ new (values: number[]): T, name: string }} Numbers
 * @param {unknown} values
 * @param {string} path
 */
export function numbers(Numbers, values, path) {
  if (values instanceof Numbers) return values;
  if (!Array.isArray(values)) {
    throw mismatch(values, path, "an array of numbers");
  }
  const typed = new Numbers(values.map((value) => (typeof value === "number" ? value : Number.NaN)));
  const changed = typed.findIndex((value, index) => value !== values[index] && !Number.isNaN(values[index]));
  if (changed >= 0) {
    const at = `${path}[${changed}]`;
    const whole = Numbers.name === "Int8Array" ? "1 or -1" : "a whole number from 0 to 4294967295";
    throw mismatch(values[changed], at, Numbers.name === "Float64Array" ? "a number" : whole);
  }
  return typed;
}

/**
 * Numbers of which some are not there: NaN or, from JSON, null.
 * @param {unknown} values
 * @param {string} path
 */
export function measures(values, path) {
  return numbers(
    Float64Array,
    Array.isArray(values) ? Array.from(values, (value) => value ?? Number.NaN) : values,
    path,
  );
}
