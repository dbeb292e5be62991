/** Imported by a worker's script, it makes the worker one of `createPool`. */
export {};
