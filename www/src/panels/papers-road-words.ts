import { words } from "../i18n/words";
import { ROWS } from "./papers-rows-words";

export const say = words({
  ...ROWS,
  progress: ["{done} of {of} scenes, {workers} workers", "{done} / {of} 个场景，{workers} 个工作线程"],
  cancelled: ["Cancelled. {done} {done|scene was|scenes were} measured.", "已取消。已测量 {done} 个场景。"],
  S1: ["S1, single-lane straight", "S1，单车道直路"],
  S2: ["S2, two-way curve", "S2，双向弯道"],
  S3: ["S3, urban crossroad", "S3，城市路口"],
  S4: ["S4, narrow road with obstacles", "S4，窄路障碍"],
  ship: ["ten times as large, with the ship of its appendix B", "放大十倍，使用附录 B 的船"],
  plain: ["plain A*", "普通 A*"],
  inverse: ["K/(d+ε)", "K/(d+ε)"],
  exponential: ["A·exp(−B·d)", "A·exp(−B·d)"],
  paper: ["paper costs, inverse", "论文代价，反比"],
  paperExponential: ["paper costs, exponential", "论文代价，指数"],
  literal: ["taken literally", "按原文实现"],
  turns: ["Turning points", "转折点"],
  curvatureVariation: ["Curvature variation, 1/m", "曲率变化，1/m"],
  curvature: ["Max curvature, 1/m", "最大曲率，1/m"],
  clearanceMean: ["Body clearance, mean, m", "车身净距均值，m"],
  clearanceCapped: ["Body clearance, capped mean, m", "车身净距截断均值，m"],
  clearanceLeast: ["Body clearance, min, m", "车身净距最小值，m"],
  sideLeast: ["Centre clearance minus half the width, m", "中心净距减半车宽，m"],
  hits: ["Collisions in 1,000 drives (disc)", "千次碰撞数（圆盘）"],
  lane: ["Offset from lane centre, mean / max, m", "偏离车道中心，均值 / 最大，m"],
  laneLeft: ["Left of the lanes, % of the way", "越过车道左侧的路程，%"],
  memory: ["Memory, MB", "内存，MB"],
  bytesPerCell: ["Bytes per cell", "每格字节"],
  time: ["Time, ms", "时间，ms"],
  meanTip: ["Each sample is capped at 1.2 m; 5 m at either end are excluded.", "每处最多计 1.2 m，不含两端各 5 m"],
  promised: ["Promised: {sign} {bound}", "承诺：{sign} {bound}"],
  impossible: ["impossible", "不可能"],
  safetyFlag: [
    "In a 3.5 m lane nothing is farther than 1.75 m from the centre.",
    "3.5 m 车道内，任一点距中心不超过 1.75 m。",
  ],
  lengthFlag: ["The road is {length} m long.", "道路全长仅 {length} m。"],
  fellBack: ["chords", "折线"],
  fellBackTip: ["No smoothed curve met the limits, so the chords were kept.", "没有满足限制的平滑曲线，保留折线。"],
  literalNote: [
    "The manuscript's method lets the spline deviate by 1 m from its points, more than the 0.8 m beside the car, and its chords only need line of sight. So the path leaves the road or cuts through obstacles. The spline is FITPACK's, as splprep fits it.",
    "论文方法允许样条偏离少数点一米，超过车旁仅有的 0.8 m；弦只需互相可见，因此驶出道路或穿过障碍。样条与 splprep（FITPACK）一致。",
  ],
  flags: ["Contradictions in the manuscript's figures", "论文数据的矛盾"],
  flag0: [
    "Safety distances of 5 to 60 m are impossible in lanes of 3.25 to 3.5 m, whose centre has at most 1.75 m. The table comes from the ship version (safety distance 17 m, cells of 5 m).",
    "3.25–3.5 m 车道内不可能有 5–60 m 安全距离（中心最多 1.75 m）：表格来自船舶版本（安全距离 17 m，栅格 5 m）。",
  ],
  flag1: [
    "S4's lengths of 680.5 and 712.3 m exceed the road of 500 m by 36 to 42 %; S2's 850 and 865 m exceed 800 m.",
    "S4 路径 680.5 / 712.3 m 比 500 m 道路长 36–42 %；S2 的 850 / 865 m 超过 800 m。",
  ],
  flag2: [
    "The abstract claims a mean clearance of 0.8 to 1.2 m, the text 5 to 17 m (+240 %); both cannot hold.",
    "摘要称平均间距 0.8–1.2 m，正文称 5→17 m（+240 %），不能同时成立。",
  ],
  flag3: [
    "A best grid of 3 to 8 m (4.5.2, appendix B) contradicts 0.5 m (4.2.2); sections 4.4, 5 and 6 still mention ships, channels and open sea.",
    "最佳栅格 3–8 m（4.5.2、附录 B）与 0.5 m（4.2.2）矛盾；4.4、5、6 节仍有船舶、航道、海域字样。",
  ],
  flag4: [
    "Curvature variation has no table, only claims: −75 to −85 % in the abstract, about −80 % in section 5.",
    "曲率变化没有表格，只有论断：摘要 −75 至 −85 %，第 5 节约 −80 %。",
  ],
  flag5: [
    "The cost is added per entered cell, whatever the step's length, so its factor cancels: 500 to 8000 give lengths within 1 cm on every scene.",
    "代价按格累加而不计步长，系数因此约去：500 至 8000 在所有场景长度相同（误差 1 cm）。",
  ],
  flag6: [
    "splprep(s = number of points) permits a root mean square deviation of 1 m, more than the 0.8 m beside the car. It fails on S1's two points (two more are put between them here) and leaves S2's road: see the row “taken literally”.",
    "splprep(s=点数) 允许均方偏差 1 m，超过车旁 0.8 m；S1 仅两点会报错（此处在其间补两点），S2 则驶出道路，见“按原文实现”一行。",
  ],
  flag7: ["100 smoothed points on a path of 1000 m are 10 m apart.", "1000 m 路径上 100 个平滑点相距 10 m。"],
  flag8: [
    "The distance transform is attributed to Felzenszwalb and Huttenlocher, but the named library uses another algorithm; both are exact.",
    "距离变换署名 Felzenszwalb–Huttenlocher，所用库实为另一算法；两者都精确。",
  ],
  flag9: [
    "The size and distribution of the Monte Carlo perturbation are not given.",
    "未给出蒙特卡洛扰动的大小与分布。",
  ],
  flag10: [
    "α, β, γ and their formulas are not given; the pruning threshold “auto” is not defined, and the printed code has none.",
    "未给出 α、β、γ 及其公式；剪枝阈值 auto 未定义，印刷代码也没有阈值。",
  ],
});

export const FLAGS = [
  "flag0",
  "flag1",
  "flag2",
  "flag3",
  "flag4",
  "flag5",
  "flag6",
  "flag7",
  "flag8",
  "flag9",
  "flag10",
] as const;
