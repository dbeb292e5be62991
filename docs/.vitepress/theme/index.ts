import DefaultTheme from "vitepress/theme";
import "./figures.css";

export default {
  extends: DefaultTheme,
  enhanceApp({ siteData }: { siteData: { value: { base: string } } }): void {
    if (typeof document === "undefined") return;
    const script = document.createElement("script");
    script.type = "module";
    script.src = `${siteData.value.base}../parkade-playground.js`;
    document.head.append(script);
  },
};
