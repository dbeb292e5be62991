// `dist/` of the repository, copied to `src/parkade/`, comes out beside the chapters.
const loader = document.createElement("script");
loader.type = "module";
loader.src = new URL(
  `${typeof path_to_root === "string" ? path_to_root : ""}parkade/parkade-playground.js`,
  document.baseURI,
).href;
document.head.append(loader);
