import starlight from "@astrojs/starlight";
import { defineConfig } from "astro/config";

export default defineConfig({
  integrations: [
    starlight({
      title: "Parking",
      // `dist/` of the repository, copied to `public/parkade/`.
      head: [{ tag: "script", attrs: { type: "module", src: "/parkade/parkade-playground.js" } }],
      customCss: ["./src/styles/parkade.css"],
    }),
  ],
});
