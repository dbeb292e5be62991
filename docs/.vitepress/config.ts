import { readFileSync } from "node:fs";
import { defineConfig } from "vitepress";
import { LESSONS } from "./lessons/contents";
import { lessons } from "./lessons/markdown";
import { said } from "./lessons/words";
import { papers as paperPages } from "./papers";
import { known, pages, searched, write } from "./planners";
import { reference } from "./reference";

const planners = await known();
const names = reference();
for (const [lang, root] of [
  ["en", ""],
  ["zh", "zh/"],
] as const) {
  write(`${root}planners`, await pages(lang));
  write(`${root}papers`, await paperPages(lang));
}
const formulasAndFigures = await lessons();
const course = (lang: "en" | "zh", root: string) => [
  ...LESSONS.map(({ id, title }) => ({ text: said(title, lang), link: `${root}/learn/${id}` })),
  { text: lang === "en" ? "Six questions to the debugger" : "向调试器提六个问题", link: `${root}/questions` },
];
const list = (lang: "en" | "zh", root: string) =>
  planners.map(({ id, title }) => ({ text: title[lang], link: `${root}/planners/${id}` }));
const papers = [
  { text: "Risk field, 2024", link: "/papers/risk-field" },
  { text: "Sixteen neighbours from both ends", link: "/papers/sixteen" },
  { text: "Parking by reverse search, 2025", link: "/papers/parking" },
  { text: "Roads, manuscript", link: "/papers/road" },
];
const papersInChinese = [
  { text: "行车风险场，2024", link: "/zh/papers/risk-field" },
  { text: "双向十六邻域", link: "/zh/papers/sixteen" },
  { text: "反向搜索泊车，2025", link: "/zh/papers/parking" },
  { text: "道路导航，手稿", link: "/zh/papers/road" },
];

const BASE = process.env["PARKADE_DOCS_BASE"] ?? "/docs/";

const SEARCH_IN_CHINESE = {
  button: { buttonText: "搜索", buttonAriaLabel: "搜索" },
  modal: {
    displayDetails: "显示详细列表",
    resetButtonTitle: "清除",
    backButtonTitle: "返回",
    noResultsText: "没有结果",
    footer: { selectText: "选择", navigateText: "移动", closeText: "关闭" },
  },
};

/** The site's version is the crate's. */
const version = /^version = "(.+)"$/m.exec(readFileSync(new URL("../../Cargo.toml", import.meta.url), "utf8"))![1]!;

/**
 * Terms of a text, for index and query alike. Chinese has no spaces between words: two neighbouring characters are a
 * term. The browser gets this function as text, so it uses nothing from outside.
 */
const tokenize = (text: string): string[] =>
  (text.match(/\p{Script=Han}+|[^\s\p{P}\p{S}\p{Script=Han}]+/gu) ?? []).flatMap((word) =>
    /\p{Script=Han}{2}/u.test(word) ? Array.from({ length: word.length - 1 }, (_, i) => word.slice(i, i + 2)) : [word],
  );

export default defineConfig({
  title: "Parkade",
  // The page around may lie anywhere; figures take the element from the folder above this one.
  base: BASE,
  head: [["link", { rel: "icon", href: "data:," }]],
  // Pages that nobody has asked for would weigh more than the one that is read.
  router: { prefetchLinks: false },
  // The bar's class for pages with a sidebar comes only with the scripts: without it here, the bar moves then.
  transformHtml: (code, _, { pageData: { frontmatter } }) =>
    frontmatter["layout"] === "home" ? code : code.replace('class="VPNavBar"', 'class="VPNavBar has-sidebar top"'),
  markdown: { config: formulasAndFigures },
  srcExclude: ["**/README.md", "zh/design.md"],
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag === "parkade-playground" } } },
  themeConfig: {
    search: {
      provider: "local",
      options: {
        locales: { zh: { translations: SEARCH_IN_CHINESE } },
        miniSearch: { options: { tokenize } },
        _render: (source, env, md) => md.render(searched(source), env),
      },
    },
    // Not every page is there in every language.
    i18nRouting: false,
  },
  locales: {
    root: {
      label: "English",
      lang: "en",
      description: "Vehicle path planners in WebAssembly",
      themeConfig: {
        nav: [
          { text: "Guide", link: "/guide" },
          { text: "Learn", link: "/learn/flood" },
          { text: "Planners", link: "/planners/hybrid" },
          { text: "API", link: "/api/js/" },
          { text: version, link: "/changelog" },
        ],
        sidebar: [
          {
            text: "Start",
            items: [
              { text: "First scene in five minutes", link: "/guide" },
              { text: "Embed it", link: "/embed" },
              { text: "Bundlers and servers", link: "/bundlers" },
              { text: "Command line", link: "/command" },
              { text: "Check a real lot", link: "/lots" },
              { text: "Check every bay in code", link: "/audit" },
              { text: "Python", link: "/python" },
              { text: "Many machines", link: "/machines" },
              { text: "Where it is tested", link: "/consumers" },
              { text: "Recipes", link: "/recipes" },
            ],
          },
          { text: "Learn", items: course("en", "") },
          {
            text: "Planners",
            items: [...list("en", ""), { text: "How tight can it be", link: "/planners/how-tight" }],
          },
          { text: "Papers", items: [...papers, { text: "What of them is here", link: "/papers/coverage" }] },
          {
            text: "Reference",
            items: [
              { text: "JavaScript", link: "/api/js/", collapsed: true, items: names },
              { text: "Rust", link: "/api/rust" },
              { text: "Changelog", link: "/changelog" },
            ],
          },
        ],
      },
    },
    zh: {
      label: "简体中文",
      lang: "zh-CN",
      link: "/zh/",
      description: "WebAssembly 车辆路径规划",
      themeConfig: {
        nav: [
          { text: "指南", link: "/zh/guide" },
          { text: "课程", link: "/zh/learn/flood" },
          { text: "规划器", link: "/zh/planners/hybrid" },
          { text: version, link: "/changelog" },
        ],
        sidebar: [
          {
            text: "开始",
            items: [
              { text: "五分钟第一个场景", link: "/zh/guide" },
              { text: "检查真实停车场", link: "/zh/lots" },
            ],
          },
          { text: "课程", items: course("zh", "/zh") },
          {
            text: "规划器",
            items: [...list("zh", "/zh"), { text: "能停进多窄的地方", link: "/zh/planners/how-tight" }],
          },
          { text: "论文", items: papersInChinese },
        ],
        outline: { label: "本页内容" },
        docFooter: { prev: "上一页", next: "下一页" },
        sidebarMenuLabel: "目录",
        returnToTopLabel: "回到顶部",
        langMenuLabel: "语言",
        darkModeSwitchLabel: "外观",
        lightModeSwitchTitle: "切换到浅色",
        darkModeSwitchTitle: "切换到深色",
        skipToContentLabel: "跳到正文",
      },
    },
  },
});
