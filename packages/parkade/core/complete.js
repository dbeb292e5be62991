// @ts-check
// `core` has nothing beyond `api.js`.
export {};
