import { words } from "../i18n/words";
import { ROWS } from "./papers-rows-words";

export const say = words({
  ...ROWS,
  progress: ["{done} of {of} rows, {workers} workers", "{done} / {of} 行，{workers} 个工作线程"],
  cancelled: ["Cancelled. {done} {done|row was|rows were} measured.", "已取消。已测量 {done} 行。"],
  table: ["table {table}", "表 {table}"],
  tables: ["tables {first} to {last}", "表 {first}–{last}"],
  across: ["perpendicular slot", "垂直车位"],
  along: ["parallel slot", "侧方车位"],
  traditional: ["traditional", "传统"],
  "hybrid-forward": ["from the start", "从起点搜索"],
  hybrid: ["from the goal", "从终点搜索"],
  "hybrid-bidirectional": ["from both ends", "双向搜索"],
  "hybrid-classic": ["coarse and greedy", "粗糙贪心"],
  changes: ["Gear changes", "换挡次数"],
  nodes: ["Nodes", "节点"],
  time: ["Driving time, s", "行驶时间，s"],
  exact: ["Length, not rounded, m", "未取整长度，m"],
  clearance: ["Min clearance, m", "最小净距，m"],
  expanded: ["Expanded states", "扩展状态"],
  milliseconds: ["Planning, ms", "规划时间，ms"],
  impossible: ["below {bound}", "短于 {bound}"],
  bound: ["Without obstacles this car's shortest path is {bound} m.", "即使没有障碍物，该车的最短路径也有 {bound} m。"],
  reach: [
    "Promised: ≤ {length} m, ≤ {changes} {changes|gear change|gear changes}",
    "承诺：≤ {length} m，换挡 ≤ {changes} 次",
  ],
  saved: ["Driving time saved", "节省的行驶时间"],
  rows: ["Rows", "行"],
  abstract: ["abstract", "摘要"],
  ofRows: ["its rows", "各行平均"],
  ours: ["here, against from the start", "本地，相对从起点搜索"],
  overClassic: ["here, against coarse and greedy", "本地，相对粗糙贪心"],
  searched: ["Searched, from the start and from the goal", "搜索量：从起点与从终点"],
  share: ["Share", "占比"],
  sameNote: [
    "Here “from the start” is the same planner with the same shortcuts: its paths are as short, but it takes longer. “Coarse and greedy” reproduces the paper's program.",
    "此处从起点搜索使用同一规划器（含捷径优化），路径同样短，只是更慢；“粗糙贪心”相当于论文所用的程序。",
  ],
  P0: [
    "The printed path is the shortest one without obstacles: the car's front crosses the slot's end by 0.09 m. Figure 12 has no obstacles.",
    "印刷值是无障碍最短路径，车头会穿过车位底边 0.09 m；图 12 没有障碍。",
  ],
  P1: [
    "The printed times are 1.0 and 0.9 s longer than the lengths at 2 m/s. The start touches a wall, so no margin is kept.",
    "印刷时间比 2 m/s 的行驶时间长 1.0 与 0.9 s。起点贴墙，因此不留余量。",
  ],
  P2: [
    "The goal is printed as (−7.5, −π/2) for (−7, 5, −π/2). The paper's program drops the first 3.1 m: 22.2 m.",
    "终点 (−7, 5, −π/2) 印成 (−7.5, −π/2)。论文程序漏掉前 3.1 m：实为 22.2 m。",
  ],
  P3: ["The goal is printed as (−2.5, −π/2) for (−2, 5, −π/2).", "终点 (−2, 5, −π/2) 印成 (−2.5, −π/2)。"],
  P4: ["The improved time is printed 0.5 s shorter than the length at 2 m/s.", "改进时间比 2 m/s 的行驶时间短 0.5 s。"],
  L0: [
    "L0 starts 4 m from L1, but its printed path is 13.5 m longer: far from the shortest.",
    "与 L1 仅差 4 m 却长 13.5 m：印刷路径远非最短。",
  ],
  L3: [
    "The straight line is 26.18 m long. Two omitted pieces of 3.1 m, or a start at x = 9, would explain 20.2 m.",
    "直线距离为 26.18 m。漏掉两段 3.1 m，或起点 x = 9，可以解释 20.2 m。",
  ],
  L4: [
    "The shortest path without obstacles has 1.6 m of clearance here. The printed path is 29 % longer.",
    "此处无障碍最短路径可行，四周有 1.6 m：印刷路径长 29 %。",
  ],
});
