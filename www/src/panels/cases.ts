/** Where each planner shines and where it struggles, among the built-in scenes. */
import type { PlannerId } from "parkade";

type Text = readonly [en: string, zh: string];
interface Case { scene: string; question: Text }
export interface Cases { best: Case; worst: Case }

const one = (scene: string, en: string, zh: string): Case => ({ scene, question: [en, zh] });

export const CASES: readonly (readonly [PlannerId, Cases])[] = [
  ["four", { best: one("road-straight", "Is a straight road any harder than a ruler?", "笔直的道路会比直尺更难吗？"), worst: one("parallel", "How much longer is a way without diagonals?", "没有对角线，路会长多少？") }],
  ["eight", { best: one("road-narrow", "Do eight directions do where the way is straight?", "直路上八个方向就够了吗？"), worst: one("angled", "Two thousand cells for one bay, and can the car follow?", "为一个车位展开约两千格，车能跟上吗？") }],
  ["sixteen", { best: one("perpendicular", "How many cells do eight more headings save?", "多八个方向能省多少格？"), worst: one("reverse-in", "What if the goal lies behind a corner for every heading?", "若目标在每个方向上都隔着拐角呢？") }],
  ["twenty-four", { best: one("parallel", "Fewer than fifty cells for thirty metres?", "三十米不到五十格？"), worst: one("regular-60", "Do longer moves help between blocks?", "障碍之间更长的步子有用吗？") }],
  ["forty-eight", { best: one("parallel", "One per cent shorter: is it worth 48 moves?", "短百分之一，值得四十八种走法吗？"), worst: one("regular-60", "What do 48 moves cost where most are blocked?", "多数走法受阻时，四十八种走法代价如何？") }],
  ["sixteen-bidirectional", { best: one("reverse-in", "Do two searches meet sooner than one arrives?", "两端相遇是否早于一端到达？"), worst: one("trap-60", "What if both ends sit in a dead end?", "若两端都在死胡同里呢？") }],
  ["jump-point", { best: one("parallel", "Two expansions for thirty metres?", "三十米只展开两次？"), worst: one("regular-60", "What happens where every block forces a turn?", "每个障碍都迫使转向时会怎样？") }],
  ["any-angle", { best: one("P1", "Is the straight line found at once?", "能立刻找到直线吗？"), worst: one("trap-60", "Does sight help among dead ends?", "在死胡同之间，视线有用吗？") }],
  ["risk-field", { best: one("random-60", "Does the risk field pay in clutter?", "杂乱之中风险场划算吗？"), worst: one("narrow-gap", "What if its safety space is wider than the gap?", "若安全空间比缺口还宽呢？") }],
  ["risk-field-plus", { best: one("perpendicular", "One expansion: is the goal in sight?", "只展开一次：目标是否在视线内？"), worst: one("trap-60", "How far does a pull to the goal lead astray?", "朝目标的引力会把它带偏多远？") }],
  ["hybrid", { best: one("angled", "Is a slot left faster than it is found?", "离开车位是否比找到车位更快？"), worst: one("par-7.2", "How many gear changes fit 1.7 m of room?", "1.7 米余量需要多少次换挡？") }],
  ["hybrid-forward", { best: one("L3", "Is one curve enough in the open?", "空旷处一条曲线够吗？"), worst: one("perp-nose-3.2", "Ten thousand poses to find one slot?", "找到一个车位要上万个位姿？") }],
  ["hybrid-bidirectional", { best: one("reverse-in", "Do two trees park with less?", "两棵树停车更省吗？"), worst: one("par-7.2", "What if the second tree only costs?", "若第二棵树只是徒增开销？") }],
  ["hybrid-classic", { best: one("P1", "When is the first connection the best?", "何时首次连接就是最好？"), worst: one("regular-60", "What do steps of 3.1 m miss?", "3.1 米的步长会错过什么？") }],
  ["cost-map", { best: one("road-crossing", "Who keeps its distance and turns the least?", "谁保持距离且转弯最少？"), worst: one("reverse-in", "What does a road planner do in a car park?", "道路规划器在停车场会怎样？") }],
];
