/** What the planners' pages are made of: the package's own words, settings and units, and DESIGN.md. */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import type { ParameterInfo, PlannerInfo } from "parkade";
import { init, planners } from "../../pkg/node.js";
import { WORDS } from "./words";

export type Lang = "en" | "zh";

export async function known(): Promise<PlannerInfo[]> {
  await init();
  const infos = planners();
  const without = infos.filter(({ id }) => !(id in WORDS)).map(({ id }) => id);
  if (without.length > 0) throw new Error(`docs/.vitepress/words.ts says nothing of ${without.join(", ")}`);
  return infos;
}

const TEXT = {
  en: {
    figure: "Drag a car or draw a wall: the planner replans.",
    parameters: "Settings",
    name: "Name",
    unit: "Unit",
    range: "Range",
    default: "Default",
    why: "What it does",
    paper: "After",
    use: "In code",
    formulas: "Formulas and choices",
    drawn: "Scene and path",
  },
  zh: {
    figure: "拖动车辆、画一堵墙，路径随即重新规划。",
    parameters: "参数",
    name: "名称",
    unit: "单位",
    range: "范围",
    default: "默认",
    why: "作用",
    paper: "出处",
    use: "代码",
    formulas: "公式",
    drawn: "场景与路径",
  },
};

export interface Page {
  params: { id: string; title: string };
  content: string;
}

export async function pages(lang: Lang): Promise<Page[]> {
  const seen = new Set<string>();
  return (await known()).map((info) => {
    const text = chapter(info.id, lang),
      isShared = seen.has(text);
    seen.add(text);
    return {
      params: { id: info.id, title: info.title[lang] },
      content: page(info, lang, isShared ? `${SHARED[0]}\n\n${text}\n\n${SHARED[1]}` : text),
    };
  });
}

/** Around a chapter that stands on an earlier page, too: the search finds it there. */
const SHARED = ["<!-- shared -->", "<!-- end of shared -->"] as const;

/** A page as the search reads it. */
export const searched = (content: string): string =>
  content.replace(new RegExp(`${SHARED[0]}[^]*?${SHARED[1]}`, "g"), "");

/** Writes pages into a folder of the documentation, anew with every build: the search reads files only. */
export function write(folder: string, all: readonly Page[]): void {
  const into = new URL(`../${folder}/`, import.meta.url);
  mkdirSync(into, { recursive: true });
  for (const { params, content } of all)
    writeFileSync(new URL(`${params.id}.md`, into), `---\ntitle: ${JSON.stringify(params.title)}\n---\n\n${content}`);
}

function page(info: PlannerInfo, lang: Lang, chapterText: string): string {
  const words = WORDS[info.id]!,
    t = TEXT[lang];
  return (
    `# ${info.title[lang]}

\`${info.id}\` · ${t.paper}: ${info.paper}

${words[lang]}

<parkade-playground scene="${words.scene}" planners="${info.id}" layout="single" controls="minimal" editable ` +
    `lang="${lang}" alt="${t.drawn}"></parkade-playground>

*${t.figure}*

## ${t.formulas}

${words.formulas.map((one) => `$$\n${one}\n$$`).join("\n\n")}

${words.letters?.[lang === "zh" ? 1 : 0] ?? ""}

${chapterText}

## ${t.use}

\`\`\`js
import { init, Planner, scenario } from "parkade";

await init();
const planner = new Planner("${info.id}", scenario("${words.scene}"));
const plan = planner.plan();
console.log(plan.outcome, plan.metrics.length.toFixed(2));
planner.free();
\`\`\`

## ${t.parameters}

| ${t.name} | ${t.unit} | ${t.range} | ${t.default} | ${t.why} |
| --- | --- | --- | --- | --- |
${info.parameters.map((one) => row(one, lang)).join("\n")}
`
  );
}

function row({ name, unit, min, max, choices, default: value, title, doc }: ParameterInfo, lang: Lang): string {
  const range = choices
    ? choices.map((one) => `\`${one}\``).join(" ")
    : min !== undefined || max !== undefined
      ? `${min ?? ""} … ${max ?? ""}`
      : "";
  return `| \`${name}\` | ${unit} | ${range} | \`${JSON.stringify(value)}\` | ${escaped(
    `${title[lang]}. ${doc[lang]}`,
  )} |`;
}

const escaped = (text: string): string => text.replaceAll("|", "\\|").replaceAll("<", "&lt;").replaceAll("{", "&#123;");

const DESIGN = { en: "../../DESIGN.md", zh: "../zh/design.md" };

/** A planner's chapter, which names it in its heading, one level down. */
export function chapter(id: string, lang: Lang): string {
  const text = readFileSync(new URL(DESIGN[lang], import.meta.url), "utf8");
  const part = text.split(/^## /m).find((one) => one.slice(0, one.indexOf("\n")).includes(`\`${id}\``));
  if (!part) throw new Error(`${DESIGN[lang]} has no chapter on ${id}`);
  return part.slice(part.indexOf("\n")).replaceAll("<", "&lt;").replaceAll("{{", "{ {").trim();
}
