export default {
  title: "Parking",
  url: "https://example.org",
  baseUrl: "/",
  // `dist/` of the repository, copied to `static/parkade/`.
  scripts: [{ src: "/parkade/parkade-playground.js", type: "module" }],
  presets: [["classic", { docs: { routeBasePath: "/" }, blog: false, theme: { customCss: "./src/css/custom.css" } }]],
};
