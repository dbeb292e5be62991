/** The words of the figures themselves; tasks and answers stand in the lessons. */
export type Lang = "en" | "zh";
export type Text = readonly [en: string, zh: string];
export const said = (text: Text, lang: Lang): string => text[lang === "zh" ? 1 : 0];

export const WORDS = {
  todo: ["Try it: the answer appears when you have done it.", "动手试试：完成后会显示答案。"],
  done: ["Done", "完成"],
  reset: ["Start over", "重来"],
  search: ["Search", "搜索"],
  of: ["{0} of {1} cells", "第 {0} / {1} 个栅格"],
  cells: ["{0} cells expanded", "扩展 {0} 个栅格"],
  length: ["path {0}", "路径 {0}"],
  noPath: ["no path", "无路径"],
  cell: ["Cell {0}: g {1} + h {2} = f {3}", "栅格 {0}：g {1} + h {2} = f {3}"],
  wall: ["Cell {0} is a wall", "栅格 {0} 是障碍"],
  unreachable: ["Cell {0} cannot be reached", "栅格 {0} 不可到达"],
  grid: [
    "Map of {0} × {1} cells. Drag on empty cells to draw walls, on walls to erase them, and S or G to move them. " +
      "Keys: the arrows move the cursor, Space draws or erases, S and G move the ends here, Enter picks the cell.",
    "{0} × {1} 栅格地图。在空格上拖动可画障碍，在障碍上拖动可擦除，S 与 G 可拖动。键盘：方向键移动光标，空格画或擦，S、G 把端点移到此处，回车选取栅格。",
  ],
  failed: ["The planners could not be loaded. Reload the page to try again.", "规划器未能加载，请刷新页面重试。"],
  region: ["region {0}, direction {1}", "区域 {0}，方向 {1}"],
  force: ["force ({0}, {1})", "合力（{0}，{1}）"],
  cars: [
    "A car on a map in metres. Drag it to move it, its nose to turn it. Keys: the arrows move it, [ and ] turn it, " +
      "Enter takes the other car.",
    "以米为单位的地图上的车辆。拖动可移动，拖动车头可转向。键盘：方向键移动，[ 与 ] 转向，回车换另一辆车。",
  ],
  driven: ["{0} m, gear changes: {1}", "{0} m，换挡 {1} 次"],
  clearance: ["clearance {0} m", "净距 {0} m"],
  poses: ["{0} expanded", "扩展 {0} 个"],
  curve: ["curve {0} of {1}:", "第 {0} / {1} 条曲线："],
  drives: ["{0} of {1} simulated drives hit something", "{1} 次模拟行驶中有 {0} 次碰撞"],
  distance: ["clearance, m", "净距，m"],
  cost: ["cost", "代价"],
  overlaps: ["the body hits something", "车身碰到障碍"],
  radius: ["turning radius {0} m", "转弯半径 {0} m"],
  raw: ["Cells", "栅格路径"],
  pruned: ["Pruned", "剪枝"],
  arcs: ["Arcs", "圆弧"],
  corners: ["{0} corners, {1} arcs, {2} sharp", "{0} 个拐点，{1} 段圆弧，{2} 个尖角"],
} satisfies Record<string, Text>;

export function word(key: keyof typeof WORDS, lang: Lang, ...values: (string | number)[]): string {
  return values.reduce<string>((text, value, i) => text.replace(`{${i}}`, String(value)), said(WORDS[key], lang));
}
