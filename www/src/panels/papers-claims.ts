/** The claims of the grid papers in the page's language; the package has them in English. */
import type { PaperClaim } from "parkade";
import type { Lang } from "../i18n/index";

/** Per claim: the text, what was found in English with {} for each figure, and the same in Chinese. */
const CHINESE: Record<string, readonly [text: string, found: string, said: string]> = {
  H1: [
    "改进的规划器访问的节点为八邻域的 0.41 至 0.46。",
    "generates {} of plain eight neighbours', {} of theirs under the same weight", "生成数为普通八邻域的 {}，为同权重八邻域的 {}",
  ],
  H2: ["改进的规划器访问的节点为四邻域的 0.36 至 0.49。", "generates {}", "生成数之比为 {}"],
  H3: ["其路径最多比八邻域长 0.6 %。", "{} after pruning", "剪枝后为 {}"],
  Y1: [
    "十六邻域的路径比八邻域更短、更平滑，但耗时明显更多。",
    "length {}, turning {}, time {}", "长度 {}，转角 {}，时间 {}",
  ],
  Y2: [
    "24 与 48 邻域并不更平滑，略短，但慢得多。",
    "24: length {}, time {}; 48: length {}, turning {}, time {} of sixteen's", "与十六邻域之比：24 邻域长度 {}，时间 {}；48 邻域长度 {}，转角 {}，时间 {}",
  ],
  Y3: [
    "十六邻域双向搜索保持路径质量，且耗时最少。",
    "length {} of sixteen's in the median, {} at worst; turning {}, time {}", "与十六邻域之比：长度中位数 {}，最差 {}；转角 {}，时间 {}",
  ],
  Y4: [
    "普通双向搜索在找不到公共最优节点时可能失败或陷入循环。",
    "ours stops at the first cell that both sides have closed: a path on all {} maps", "本实现在双方都已关闭的第一个栅格停止：全部 {} 张地图都有路径",
  ],
};

const FIGURES = "(\\d+(?:\\.\\d+)?(?: to \\d+\\.\\d+)?|not measured|not judged)";

const figure = (text: string): string => ({ "not measured": "未测量", "not judged": "未判定" })[text] ?? text.replace(" to ", " 至 ");

export function claimIn(lang: Lang, claim: PaperClaim): { text: string; found: string } {
  const chinese = lang === "zh" ? CHINESE[claim.id] : undefined;
  if (!chinese) return claim;
  const [text, english, said] = chinese;
  const figures = new RegExp(`^${english.split("{}").join(FIGURES)}$`).exec(claim.found)?.slice(1);
  return { text, found: figures ? figures.reduce((sentence, one) => sentence.replace("{}", figure(one)), said) : claim.found };
}
