import { defineConfig } from "vitepress";
import { known } from "./planners";

const planners = await known();
const list = (lang: "en" | "zh", root: string) => planners.map(({ id, title }) => ({ text: title[lang], link: `${root}/planners/${id}` }));
const papers = [
  { text: "Risk field, 2024", link: "/papers/risk-field" },
  { text: "Sixteen neighbours from both ends", link: "/papers/sixteen" },
  { text: "Parking by reverse search, 2025", link: "/papers/parking" },
  { text: "Roads, manuscript", link: "/papers/road" },
];

const BASE = process.env["PARKADE_DOCS_BASE"] ?? "/docs/";

export default defineConfig({
  title: "Parkade",
  // The page around may lie anywhere; figures take the element from the folder above this one.
  base: BASE,
  head: [["link", { rel: "icon", href: "data:," }]],
  srcExclude: ["**/README.md", "zh/design.md"],
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag === "parkade-playground" } } },
  themeConfig: {
    search: { provider: "local" },
    // Not every page is there in every language.
    i18nRouting: false,
  },
  locales: {
    root: {
      label: "English", lang: "en",
      description: "Vehicle path planners in WebAssembly",
      themeConfig: {
        nav: [{ text: "Guide", link: "/guide" }, { text: "Planners", link: "/planners/hybrid" }, { text: "API", link: "/api/reference" }],
        sidebar: [
          { text: "Start", items: [{ text: "First scene in five minutes", link: "/guide" }, { text: "Embed it", link: "/embed" }, { text: "The command", link: "/command" }, { text: "Many machines", link: "/machines" }] },
          { text: "Planners", items: list("en", "") },
          { text: "Papers", items: papers },
          { text: "Reference", items: [{ text: "JavaScript", link: "/api/reference" }, { text: "Rust", link: "/api/rust" }] },
        ],
      },
    },
    zh: {
      label: "简体中文", lang: "zh-CN", link: "/zh/",
      description: "WebAssembly 车辆路径规划",
      themeConfig: {
        nav: [{ text: "指南", link: "/zh/guide" }, { text: "规划器", link: "/zh/planners/hybrid" }],
        sidebar: [{ text: "开始", items: [{ text: "五分钟第一个场景", link: "/zh/guide" }] }, { text: "规划器", items: list("zh", "/zh") }],
      },
    },
  },
});
