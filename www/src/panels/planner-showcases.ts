/** Built-in scenes on which each planner shines, and on which it struggles. */
import type { PlannerId, ScenarioInfo } from "parkade";
import { number, type Lang } from "../i18n/index";
import { words } from "../i18n/words";

type Text = readonly [en: string, zh: string];
interface Case {
  scene: string;
  question: Text;
}
export interface Cases {
  best: Case;
  worst: Case;
}

const one = (scene: string, en: string, zh: string): Case => ({ scene, question: [en, zh] });

/** A best case hits nothing, or its question says that the car may not fit; tests/js/cases.test.ts holds what is asserted. */
export const CASES: readonly (readonly [PlannerId, Cases])[] = [
  [
    "four",
    {
      best: one("road-straight", "Are four directions enough on a straight road?", "直路上四个方向就够了吗？"),
      worst: one("parallel", "How much longer is a path without diagonals?", "没有对角线，路径会长多少？"),
    },
  ],
  [
    "eight",
    {
      best: one("road-straight", "Do eight directions gain anything on a straight road?", "直路上八个方向更有利吗？"),
      worst: one("P0", "A thousand cells for one turn: can the car follow?", "一个转弯扩展上千格：车能跟上吗？"),
    },
  ],
  [
    "sixteen",
    {
      best: one("L4", "A tenth of the cells of eight neighbours?", "只用八邻域十分之一的格子？"),
      worst: one(
        "reverse-in",
        "Over 500 cells for one slot: what blocks the long moves?",
        "一个车位要 500 多格：什么挡住了长步？",
      ),
    },
  ],
  [
    "twenty-four",
    {
      best: one("L4", "Fewer than fifty cells for nineteen metres?", "十九米不到五十格？"),
      worst: one("regular-60", "Do longer moves help between blocks?", "障碍之间更长的步子有用吗？"),
    },
  ],
  [
    "forty-eight",
    {
      best: one("L4", "Less than 1 % shorter: is it worth 48 moves?", "短不到 1 %：值得 48 种走法吗？"),
      worst: one("regular-60", "What do 48 moves cost where most are blocked?", "多数走法受阻时，48 种走法代价如何？"),
    },
  ],
  [
    "sixteen-bidirectional",
    {
      best: one(
        "reverse-in",
        "Two searches meet in half the cells, but does the car fit their path?",
        "两端相遇只需一半格子，但车能沿此路径通过吗？",
      ),
      worst: one("trap-60", "What if both ends sit in a dead end?", "若两端都在死胡同里呢？"),
    },
  ],
  [
    "jump-point",
    {
      best: one("L4", "Two expansions for twenty metres?", "二十米只扩展两次？"),
      worst: one("regular-60", "What happens where every block forces a turn?", "每个障碍都迫使转向时会怎样？"),
    },
  ],
  [
    "any-angle",
    {
      best: one("P3", "Is its path the straight line?", "它的路径就是直线吗？"),
      worst: one("trap-60", "Does line of sight help among dead ends?", "在死胡同之间，视线检查有用吗？"),
    },
  ],
  [
    "risk-field",
    {
      best: one("P4", "A twentieth of the cells that eight neighbours take?", "只用八邻域二十分之一的格子？"),
      worst: one("narrow-gap", "What if its safety space is wider than the gap?", "若安全空间比缺口还宽呢？"),
    },
  ],
  [
    "risk-field-plus",
    {
      best: one("P4", "One expansion: is the goal in sight?", "只扩展一次：目标是否在视线内？"),
      worst: one(
        "trap-60",
        "How many cells does the pull to the goal waste in dead ends?",
        "朝目标的引力在死胡同里多费多少格？",
      ),
    },
  ],
  [
    "hybrid",
    {
      best: one("angled", "Fewer than 100 poses for an angled slot?", "驶入斜列车位不到 100 个位姿？"),
      worst: one("par-7.2", "How many gear changes fit 1.7 m of room?", "1.7 米余量需要多少次换挡？"),
    },
  ],
  [
    "hybrid-forward",
    {
      best: one("L3", "Is one curve enough in the open?", "空旷处一条曲线够吗？"),
      worst: one("perp-nose-3.2", "Ten thousand poses to find one slot?", "找到一个车位要上万个位姿？"),
    },
  ],
  [
    "hybrid-bidirectional",
    {
      best: one(
        "perp-nose-3.2",
        "A few poses where a search from the start takes ten thousand?",
        "从起点搜索要上万个位姿之处，它只需几个？",
      ),
      worst: one("par-7.2", "Does a second tree only cost more here?", "第二棵树在此只是徒增开销吗？"),
    },
  ],
  [
    "hybrid-classic",
    {
      best: one("L3", "Is the first analytic expansion already the path?", "首次解析扩展就是路径吗？"),
      worst: one("regular-60", "What do steps of 3.1 m miss?", "3.1 米的步长会错过什么？"),
    },
  ],
  [
    "cost-map",
    {
      best: one("road-crossing", "Who keeps its distance and turns the least?", "谁保持距离且转弯最少？"),
      worst: one("reverse-in", "What does a road planner do in a car park?", "道路规划器在停车场会怎样？"),
    },
  ],
];

/** Of each row of the parking paper, as printed: traditional length and gear changes, then improved; metres. */
export const PRINTED: Readonly<Record<string, readonly [number, number, number, number]>> = {
  P0: [24.1, 2, 22.7, 1],
  P1: [26.2, 2, 24.6, 1],
  P2: [21.2, 2, 19.1, 1],
  P3: [25.5, 2, 23.2, 0],
  P4: [28.4, 2, 27.3, 1],
  L0: [46, 3, 41.8, 1],
  L1: [37.9, 4, 28.3, 2],
  L2: [29.4, 3, 26.1, 1],
  L3: [26.7, 3, 20.2, 1],
  L4: [31.3, 4, 25, 1],
};

/** Rows of the paper whose start touches the boundary. */
const AGAINST: readonly string[] = ["P1"];

const say = words({
  printed: [
    "Printed: {a} m, {m} gear {m|change|changes}; improved {b} m, {n}. Here?",
    "论文：{a} m，换挡 {m} 次；改进后 {b} m，{n} 次。此处呢？",
  ],
  against: ["The car touches the wall at the start.", "车辆在起点紧贴墙边。"],
});

/** Caption of a gallery card. */
export function captionOf({ id, question }: Pick<ScenarioInfo, "id" | "question">, lang: Lang): string {
  const [a, m, b, n] = PRINTED[id] ?? [];
  if (a === undefined || b === undefined) return question[lang];
  const row = say(lang, "printed", { a: number(lang, a, 1), m: m!, b: number(lang, b, 1), n: n! });
  return AGAINST.includes(id) ? `${row} ${say(lang, "against")}` : row;
}
