/** Texts shared by the tables of the parking paper and of the road manuscript. */
export const ROWS = {
  figure: ["Figure", "指标"],
  printedHead: ["Printed", "印刷"],
  oursHead: ["Measured here", "本地测量"],
  improved: ["improved", "改进"],
  length: ["Length, m", "长度，m"],
  verdict: ["Check", "校验"],
  kept: ["kept", "达到"],
  broken: ["missed", "未达到"],
  ok: ["drivable", "可行驶"],
  "arrives-turned": ["arrives turned", "朝向不符"],
  "too-tight": ["too tight", "转弯过急"],
  collides: ["collides", "碰撞"],
  none: ["no path", "无路径"],
} as const;
