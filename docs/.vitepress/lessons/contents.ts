/** The lessons in their order. */
import type { Text } from "./words";

export const LESSONS: readonly { id: string; title: Text }[] = [
  { id: "flood", title: ["1. From flood to A*", "1. 从泛洪到 A*"] },
  { id: "neighbours", title: ["2. Neighbours and estimates", "2. 邻域与估计值"] },
  { id: "both-ends", title: ["3. From both ends", "3. 双向搜索"] },
  { id: "risk-field", title: ["4. The risk field", "4. 风险场"] },
  { id: "rounding", title: ["5. Pruning and rounding", "5. 剪枝与圆角"] },
  { id: "car", title: ["6. A car is not a point", "6. 车不是一个点"] },
  { id: "hybrid", title: ["7. Hybrid A*", "7. 混合 A*"] },
  { id: "roads", title: ["8. Roads", "8. 道路"] },
];
