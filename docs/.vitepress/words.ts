/** What each planner does, in a few sentences, and its formulas. */
interface Words {
  scene: string;
  en: string;
  zh: string;
  /** In TeX, a line each. */
  formulas: readonly string[];
  /** What the letters mean, where the chapter below does not say it. */
  letters?: readonly [en: string, zh: string];
}

const GRID = [
  String.raw`f(n) = g(n) + h(n)`,
  String.raw`h_{\text{manhattan}} = a + b \qquad h_{\text{euclid}} = \sqrt{a^2 + b^2}
   \qquad h_{\text{octile}} = (a - b) + \sqrt{2}\,b \qquad h_{\text{chebyshev}} = a`,
];
const HYBRID = [
  String.raw`x' = x + R\,(\sin(\theta + s/R) - \sin\theta)
   \qquad y' = y - R\,(\cos(\theta + s/R) - \cos\theta) \qquad \theta' = \theta + s/R`,
  String.raw`R_{\min} = \frac{\text{wheelbase}}{\tan(\text{maxSteer})}
   \qquad h = \max(h_{\text{Reeds–Shepp}},\; h_{\text{grid}})`,
];
const FIELD = [
  String.raw`F = k_1\,(t - n) + k_2 \left(\frac{1}{\rho} - \frac{1}{\rho_0}\right) \frac{1}{\rho^2}\,u
   \qquad \rho \le \rho_0`,
  String.raw`f = g + h \left(1 + \frac{d(n)}{d(s)}\right)`,
];

const CELLS = [
  "a is the larger and b the smaller of the distances in columns and rows. A straight step costs 1 000 000 " +
    "micro-cells, a diagonal one 1 414 214.",
  "a 与 b 分别是列距与行距中较大和较小者。直走一步代价 1 000 000 微栅格，斜走一步 1 414 214。",
] as const;
const ARC = [
  "s is an arc's length and R its radius. A path costs its length, reverse times `reverseCost`, and what gear " +
    "changes and steering cost.",
  "s 为弧长，R 为半径。路径代价为长度（倒车乘以 `reverseCost`）加上换挡与转向的代价。",
] as const;

export const WORDS: Record<string, Words> = {
  four: {
    scene: "random-60",
    formulas: GRID,
    letters: CELLS,
    en:
      "A* over the four cells beside each cell. The simplest planner and the baseline for the others. Its paths " +
      "follow the grid, are longer than necessary, and have corners that no car can drive.",
    zh: "在上下左右四个相邻栅格上做 A* 搜索。它最简单，是其他规划器的参照：路径沿栅格走，比实际需要更长，且带有车辆无法行驶的直角。",
  },
  eight: {
    scene: "random-60",
    formulas: GRID,
    letters: CELLS,
    en:
      "A* over all eight cells around each cell. By default a diagonal step needs both cells beside it free, so " +
      "no path squeezes between two corners.",
    zh: "在周围八个相邻栅格上做 A* 搜索。默认情况下，斜向移动要求两侧栅格均空闲，路径不会从两个障碍物角点之间挤过。",
  },
  sixteen: {
    scene: "random-60",
    formulas: [...GRID, String.raw`\text{knight’s move: } \sqrt{5}`],
    letters: CELLS,
    en:
      "The eight directions and the knight's moves between them: more headings, shorter paths, fewer turns. A " +
      "long move is allowed when every cell on its line is free.",
    zh: "八个方向之外再加国际象棋“马步”：航向更多，路径更短，转弯更少。长步经过的每个栅格都必须空闲。",
  },
  "twenty-four": {
    scene: "random-60",
    formulas: GRID,
    letters: CELLS,
    en:
      "All moves within a window of 5 × 5 cells. Its paths cost the same as with sixteen neighbours on every map, " +
      "because each further move is two equal moves in a row. The planner is here to show that.",
    zh: "使用 5 × 5 窗口内的全部移动。其余移动都是两个相同移动的组合，因此在任何地图上代价都与十六邻域相同。",
  },
  "forty-eight": {
    scene: "random-60",
    formulas: GRID,
    letters: CELLS,
    en:
      "All moves within a window of 7 × 7 cells: sixteen more headings than sixteen neighbours, and paths about 1 " +
      "% shorter.",
    zh: "使用 7 × 7 窗口内的全部移动：比十六邻域多十六个航向，路径约短百分之一。",
  },
  "sixteen-bidirectional": {
    scene: "random-60",
    formulas: [...GRID, String.raw`\max(f_{\text{start}},\; f_{\text{goal}}) \ge \mu`],
    letters: CELLS,
    en:
      "Two searches, one from each end, that meet. Stopping at the first meeting is quick, but its paths are " +
      "slightly too long on many maps. Stopping when no shorter path can remain gives paths as short as one-way A*. " +
      "The paper's own rule, the same best node on both sides, misses the path on some maps.",
    zh: "从起点与终点同时搜索直至相遇。首次相遇即停止最快，但在许多地图上路径略长；直到不可能有更短连接才停止，则与单向 A* 一样短。论文自己的规则（两侧取到同一个最优节点）在个别地图上找不到路径。",
  },
  "jump-point": {
    scene: "random-60",
    formulas: GRID,
    letters: CELLS,
    en:
      "The cost of eight neighbours with far fewer nodes: it jumps along straight lines and stops only where an " +
      "obstacle forces a turn.",
    zh: "代价与八邻域相同，但节点少得多：沿直线跳跃，仅在障碍物迫使转向处停下。",
  },
  "any-angle": {
    scene: "random-60",
    formulas: [
      String.raw`g(m) = \begin{cases} g(p) + |p - m| & \text{if } p \text{, the parent of } n \text{, sees } m
       \\ g(n) + |n - m| & \text{otherwise} \end{cases}`,
    ],
    en:
      "Theta*: the parent of a cell is its grandparent wherever the two see each other. Paths run in any " +
      "direction and turn only at corners.",
    zh: "Theta*：若父节点的父节点可直视当前栅格，则直接相连，路径可取任意方向，仅在障碍角点处转弯。",
  },
  "risk-field": {
    scene: "random-60",
    formulas: FIELD,
    en:
      "A potential field pulls towards the goal and pushes away from obstacles. Its direction selects three of " +
      "eight neighbours at each cell. The other five are deferred, not dropped, so the search finds a path wherever " +
      "one exists. Pruning and tangent arcs make the path smooth.",
    zh: "势场把路径拉向目标、推离障碍；合力方向在每个栅格的八个邻居中选出三个。其余五个暂缓而不丢弃，因此只要存在路径就能找到。随后剪枝并用切线圆弧平滑。",
  },
  "risk-field-plus": {
    scene: "random-60",
    formulas: FIELD,
    en: "The risk field with this project's settings: shorter paths from fewer cells than with the paper's.",
    zh: "采用本项目参数的风险场：比论文参数展开更少栅格，路径更短。",
  },
  hybrid: {
    scene: "perpendicular",
    formulas: HYBRID,
    letters: ARC,
    en:
      "Arcs that the car can drive, searched from the goal: the slot is tight and the aisle wide, so the search " +
      "leaves the narrow part first. Reeds–Shepp curves connect to the start as soon as they are free of " +
      "collisions, and shortcuts straighten the path.\n\n[How tight can it be](/planners/how-tight) shows which " +
      "slots and corners it solves, and with how many gear changes.",
    zh:
      "用车辆可行驶的圆弧从目标反向搜索：车位狭窄、通道宽敞，因此先离开狭窄处。一旦无碰撞便用 Reeds–Shepp " +
      "曲线连接起点，并以捷径拉直多余的弯。\n\n[能停进多窄的地方](/zh/planners/how-tight)：哪些车位能停进，哪些直角弯能通过，需要换挡几次。",
  },
  "hybrid-forward": {
    scene: "perpendicular",
    formulas: HYBRID,
    letters: ARC,
    en:
      "Hybrid A*, searched from the start. Where the first level finds nothing, the searches that `hybrid` tries " +
      "then take over.",
    zh: "同一规划器，从起点正向搜索。第一级一无所获时，由 `hybrid` 随后尝试的各种搜索接手。",
  },
  "hybrid-bidirectional": {
    scene: "parallel",
    formulas: HYBRID,
    letters: ARC,
    en: "Hybrid A*, searched from both ends, for scenes where start and goal are both boxed in.",
    zh: "同一规划器，双向搜索：适用于起点与目标都很狭窄的情形。",
  },
  "hybrid-classic": {
    scene: "perpendicular",
    formulas: HYBRID,
    letters: ARC,
    en: "The traditional hybrid A* that the parking paper compares with, without this project's additions.",
    zh: "泊车论文用作对比的传统混合 A*，不含本项目的改进。",
  },
  "cost-map": {
    scene: "road-curve",
    formulas: [String.raw`c = 1 + c_{\text{clearance}} + c_{\text{lane}} + c_{\text{kerb}} + c_{\text{speed}}`],
    letters: [
      "The clearance beside the car is the distance of its middle less half its width.",
      "车旁净距为车辆中线的距离减去半个车宽。",
    ],
    en:
      "A* for roads. A cost map knows clearance, lanes, kerbs and speed limits; chords and curves that keep their " +
      "distance replace the cells of its path.",
    zh: "面向道路的 A*。代价地图考虑净空、车道、路缘与限速；找到的栅格路径再由保持距离的弦与曲线跟随。",
  },
  dijkstra: {
    scene: "random-60",
    formulas: ["f(n) = g(n)"],
    letters: CELLS,
    en:
      "Dijkstra's search: A* without an estimate. It expands every cell that is nearer to the start than the goal " +
      "is, and finds the cheapest path. It is here to compare with.",
    zh: "Dijkstra 搜索：没有估计值的 A*。它展开比目标更靠近起点的全部栅格，并找到代价最小的路径，用于对比。",
  },
  greedy: {
    scene: "random-60",
    formulas: ["f(n) = h(n)"],
    letters: CELLS,
    en:
      "Greedy best-first search: A* without the cost from the start. It expands few cells, and its path can be " +
      "far from the shortest. It is here to compare with.",
    zh: "贪婪最佳优先搜索：不计起点代价的 A*。展开的栅格很少，但路径可能远非最短，用于对比。",
  },
  rrt: {
    scene: "random-60",
    formulas: [
      String.raw`n = \arg\min_{v \in \text{tree}} |v - q|
       \qquad v_{\text{new}} = n + \text{step} \cdot \frac{q - n}{|q - n|}`,
    ],
    letters: [
      "q is a random cell, or the goal with probability `goalBias`; the line to the new cell must be free.",
      "q 是随机栅格，或以概率 `goalBias` 取终点；到新栅格的连线必须无障碍。",
    ],
    en:
      "A tree that grows towards random cells until it reaches the goal. The same seed gives the same path; the " +
      "path is neither short nor smooth. It is here to compare with.",
    zh: "一棵朝随机栅格生长、直到抵达目标的树。同一种子得到同一路径；路径既不短也不平滑，用于对比。",
  },
  genetic: {
    scene: "P4",
    formulas: [String.raw`\text{fitness} = \text{length} + 20\,(\text{blocked legs} + \text{blocked cells on them})`],
    letters: [
      "A candidate is the start, up to 48 cells and the goal, joined by straight legs. A parent is the fittest of " +
        "3. A child has the head of one and the tail of another.",
      "个体由起点、至多 48 个栅格与终点以直线相连。父代取 3 个中最优者，子代取一个的前段与另一个的后段。",
    ],
    en:
      "A genetic algorithm over paths of straight legs. It is slow, and in narrow places no candidate may be " +
      "free. It is here to compare with.",
    zh: "以折线路径为个体的遗传算法。速度慢，在狭窄处可能没有一个候选可行，用于对比。",
  },
};
