/** Where each planner shines and where it struggles, among the built-in scenes. */
import type { PlannerId } from "parkade";

type Text = readonly [en: string, zh: string];
interface Case { scene: string; question: Text }
export interface Cases { best: Case; worst: Case }

const one = (scene: string, en: string, zh: string): Case => ({ scene, question: [en, zh] });

/** A best case hits nothing, or its question says that the car may not fit; tests/js/cases.test.ts holds what is asserted. */
export const CASES: readonly (readonly [PlannerId, Cases])[] = [
  ["four", { best: one("road-straight", "Is a straight road any harder than a ruler?", "笔直的道路会比直尺更难吗？"), worst: one("parallel", "How much longer is a way without diagonals?", "没有对角线，路会长多少？") }],
  ["eight", { best: one("road-straight", "Do eight directions do where the road is straight?", "直路上八个方向就够了吗？"), worst: one("P0", "A thousand cells for one turn, and can the car follow?", "一个转弯展开上千格，车能跟上吗？") }],
  ["sixteen", { best: one("L4", "How many cells do eight more headings save?", "多八个方向能省多少格？"), worst: one("reverse-in", "What if the goal lies behind a corner for every heading?", "若目标在每个方向上都隔着拐角呢？") }],
  ["twenty-four", { best: one("L4", "Fewer than fifty cells for nineteen metres?", "十九米不到五十格？"), worst: one("regular-60", "Do longer moves help between blocks?", "障碍之间更长的步子有用吗？") }],
  ["forty-eight", { best: one("L4", "Less than one per cent shorter: is it worth 48 moves?", "短不到百分之一，值得四十八种走法吗？"), worst: one("regular-60", "What do 48 moves cost where most are blocked?", "多数走法受阻时，四十八种走法代价如何？") }],
  ["sixteen-bidirectional", { best: one("reverse-in", "Two searches meet in half the cells, but does the car fit their path?", "两端相遇只需一半格子，但车能沿此路径通过吗？"), worst: one("trap-60", "What if both ends sit in a dead end?", "若两端都在死胡同里呢？") }],
  ["jump-point", { best: one("L4", "Two expansions for twenty metres?", "二十米只展开两次？"), worst: one("regular-60", "What happens where every block forces a turn?", "每个障碍都迫使转向时会怎样？") }],
  ["any-angle", { best: one("P3", "Is its path the straight line?", "它的路径就是直线吗？"), worst: one("trap-60", "Does sight help among dead ends?", "在死胡同之间，视线有用吗？") }],
  ["risk-field", { best: one("P4", "A twentieth of the cells that eight neighbours take?", "只用八邻域二十分之一的格子？"), worst: one("narrow-gap", "What if its safety space is wider than the gap?", "若安全空间比缺口还宽呢？") }],
  ["risk-field-plus", { best: one("P4", "One expansion: is the goal in sight?", "只展开一次：目标是否在视线内？"), worst: one("trap-60", "How far does a pull to the goal lead astray?", "朝目标的引力会把它带偏多远？") }],
  ["hybrid", { best: one("angled", "Is a slot left faster than it is found?", "离开车位是否比找到车位更快？"), worst: one("par-7.2", "How many gear changes fit 1.7 m of room?", "1.7 米余量需要多少次换挡？") }],
  ["hybrid-forward", { best: one("L3", "Is one curve enough in the open?", "空旷处一条曲线够吗？"), worst: one("perp-nose-3.2", "Ten thousand poses to find one slot?", "找到一个车位要上万个位姿？") }],
  ["hybrid-bidirectional", { best: one("perp-nose-3.2", "A few poses where a search from the start takes ten thousand?", "从起点搜索要上万个位姿之处，它只需几个？"), worst: one("par-7.2", "What if the second tree only costs?", "若第二棵树只是徒增开销？") }],
  ["hybrid-classic", { best: one("L3", "When is the first connection the best?", "何时首次连接就是最好？"), worst: one("regular-60", "What do steps of 3.1 m miss?", "3.1 米的步长会错过什么？") }],
  ["cost-map", { best: one("road-crossing", "Who keeps its distance and turns the least?", "谁保持距离且转弯最少？"), worst: one("reverse-in", "What does a road planner do in a car park?", "道路规划器在停车场会怎样？") }],
];

/** Of each row of the parking paper, as printed: traditional length and gear changes, then improved; metres. */
export const PRINTED: Readonly<Record<string, readonly [number, number, number, number]>> = {
  P0: [24.1, 2, 22.7, 1], P1: [26.2, 2, 24.6, 1], P2: [21.2, 2, 19.1, 1], P3: [25.5, 2, 23.2, 0], P4: [28.4, 2, 27.3, 1],
  L0: [46, 3, 41.8, 1], L1: [37.9, 4, 28.3, 2], L2: [29.4, 3, 26.1, 1], L3: [26.7, 3, 20.2, 1], L4: [31.3, 4, 25, 1],
};
