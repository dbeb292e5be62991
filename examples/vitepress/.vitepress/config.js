import { defineConfig } from "vitepress";

export default defineConfig({
  title: "Parking",
  // Not a component of Vue's.
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag === "parkade-playground" } } },
  // `dist/` of the repository, copied to `public/parkade/`.
  head: [["script", { type: "module", src: "/parkade/parkade-playground.js" }]],
  themeConfig: {
    nav: [
      { text: "Parking", link: "/" },
      { text: "A scene of one's own", link: "/own" },
    ],
  },
});
