import DefaultTheme from "vitepress/theme-without-fonts";
import { nextTick } from "vue";
import "./figures.css";
import "./lessons.css";

interface Context {
  siteData: { value: { base: string } };
  router: { onAfterRouteChange?: (to: string) => void };
}

/** The figures' code comes only to pages that have figures. */
async function enliven(): Promise<void> {
  await nextTick();
  if (document.querySelector("figure[data-lab]")) (await import("../lessons/live")).enliven(document);
}

export default {
  extends: DefaultTheme,
  enhanceApp({ siteData, router }: Context): void {
    if (typeof document === "undefined") return;
    const script = document.createElement("script");
    script.type = "module";
    script.src = `${siteData.value.base}../parkade-playground.js`;
    document.head.append(script);
    router.onAfterRouteChange = () => void enliven();
  },
};
