/** What each planner does, in a few sentences, and its formulas. */
interface Words {
  scene: string;
  en: string;
  zh: string;
  formulas: string;
}

const GRID =
  "f(n) = g(n) + h(n)\ng: micro-cells, 1 000 000 straight, 1 414 214 diagonal\nh: manhattan a + b · euclid √(a² + b²) · octile (a − b) + √2·b · chebyshev a      a ≥ b: distances in cells";
const HYBRID =
  "x' = x + R·(sin(θ + s/R) − sin θ),  y' = y − R·(cos(θ + s/R) − cos θ),  θ' = θ + s/R      s: arc length, R: turning radius\nR_min = wheelbase / tan(maxSteer)\nh = max(Reeds–Shepp length, way over the grid)\ncost = length · (reverseCost behind) + gear changes + steering";
const FIELD =
  "F = k1·(t − n) + k2·(1/ρ − 1/ρ0)/ρ² away from the nearest blocked cell, ρ ≤ ρ0\nf = g + h·(1 + d(n)/d(s))";

export const WORDS: Record<string, Words> = {
  four: {
    scene: "random-60",
    formulas: GRID,
    en: "A* over the four cells beside each cell. The simplest planner and the baseline for the others. Its paths follow the grid, are longer than necessary, and have corners that no car can drive.",
    zh: "在上下左右四个相邻栅格上做 A* 搜索。它最简单，是其他规划器的参照：路径沿栅格走，比实际需要更长，且带有车辆无法行驶的直角。",
  },
  eight: {
    scene: "random-60",
    formulas: GRID,
    en: "A* over all eight cells around each cell. By default a diagonal step needs both cells beside it free, so no path squeezes between two corners.",
    zh: "在周围八个相邻栅格上做 A* 搜索。默认情况下，斜向移动要求两侧栅格均空闲，路径不会从两个障碍物角点之间挤过。",
  },
  sixteen: {
    scene: "random-60",
    formulas: `${GRID}\nknight's move: √5 cells`,
    en: "The eight directions and the knight's moves between them: more headings, shorter paths, fewer turns. A long move is allowed when every cell on its line is free.",
    zh: "八个方向之外再加国际象棋“马步”：航向更多，路径更短，转弯更少。长步经过的每个栅格都必须空闲。",
  },
  "twenty-four": {
    scene: "random-60",
    formulas: `${GRID}\n5 × 5 window`,
    en: "All moves within a window of 5 × 5 cells. Its paths cost the same as with sixteen neighbours on every map, because each further move is two equal moves in a row. The planner is here to show that.",
    zh: "使用 5 × 5 窗口内的全部移动。其余移动都是两个相同移动的组合，因此在任何地图上代价都与十六邻域相同。",
  },
  "forty-eight": {
    scene: "random-60",
    formulas: `${GRID}\n7 × 7 window, 32 headings`,
    en: "All moves within a window of 7 × 7 cells: sixteen more headings than sixteen neighbours, and paths about 1 % shorter.",
    zh: "使用 7 × 7 窗口内的全部移动：比十六邻域多十六个航向，路径约短百分之一。",
  },
  "sixteen-bidirectional": {
    scene: "random-60",
    formulas: `${GRID}\nstop "nba": until max(f_start, f_goal) ≥ the best connection`,
    en: "Two searches, one from each end, that meet. Stopping at the first meeting is quick, but its paths are slightly too long on many maps. Stopping when no shorter path can remain gives paths as short as one-way A*. The paper's own rule, the same best node on both sides, misses the path on some maps.",
    zh: "从起点与终点同时搜索直至相遇。首次相遇即停止最快，但在许多地图上路径略长；直到不可能有更短连接才停止，则与单向 A* 一样短。论文自己的规则（两侧取到同一个最优节点）在个别地图上找不到路径。",
  },
  "jump-point": {
    scene: "random-60",
    formulas: GRID,
    en: "The cost of eight neighbours with far fewer nodes: it jumps along straight lines and stops only where an obstacle forces a turn.",
    zh: "代价与八邻域相同，但节点少得多：沿直线跳跃，仅在障碍物迫使转向处停下。",
  },
  "any-angle": {
    scene: "random-60",
    formulas: "if parent(n) sees m:  g(m) = g(parent(n)) + |parent(n) − m|\nelse               g(m) = g(n) + |n − m|",
    en: "Theta*: the parent of a cell is its grandparent wherever the two see each other. Paths run in any direction and turn only at corners.",
    zh: "Theta*：若父节点的父节点可直视当前栅格，则直接相连，路径可取任意方向，仅在障碍角点处转弯。",
  },
  "risk-field": {
    scene: "random-60",
    formulas: FIELD,
    en: "A potential field pulls towards the goal and pushes away from obstacles. Its direction selects three of eight neighbours at each cell. The other five are deferred, not dropped, so the search finds a path wherever one exists. Pruning and tangent arcs make the path smooth.",
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
    en: "Arcs that the car can drive, searched from the goal: the slot is tight and the aisle wide, so the search leaves the narrow part first. Reeds–Shepp curves connect to the start as soon as they are free of collisions, and shortcuts straighten the path.\n\n[How tight can it be](/planners/how-tight) shows which slots and corners it solves, and with how many gear changes.",
    zh: "用车辆可行驶的圆弧从目标反向搜索：车位狭窄、通道宽敞，因此先离开狭窄处。一旦无碰撞便用 Reeds–Shepp 曲线连接起点，并以捷径拉直多余的弯。\n\n[能停进多窄的地方](/zh/planners/how-tight)：哪些车位能停进，哪些直角弯能通过，需要换挡几次。",
  },
  "hybrid-forward": {
    scene: "perpendicular",
    formulas: HYBRID,
    en: "Hybrid A*, searched from the start. Where the first level finds nothing, the searches that `hybrid` tries then take over.",
    zh: "同一规划器，从起点正向搜索。第一级一无所获时，由 `hybrid` 随后尝试的各种搜索接手。",
  },
  "hybrid-bidirectional": {
    scene: "parallel",
    formulas: HYBRID,
    en: "Hybrid A*, searched from both ends, for scenes where start and goal are both boxed in.",
    zh: "同一规划器，双向搜索：适用于起点与目标都很狭窄的情形。",
  },
  "hybrid-classic": {
    scene: "perpendicular",
    formulas: HYBRID,
    en: "The traditional hybrid A* that the parking paper compares with, without this project's additions.",
    zh: "泊车论文用作对比的传统混合 A*，不含本项目的改进。",
  },
  "cost-map": {
    scene: "road-curve",
    formulas:
      "cost of a metre = 1 + clearance + lane + kerb + speed terms\nside clearance = distance of the car's middle − width / 2",
    en: "A* for roads. A cost map knows clearance, lanes, kerbs and speed limits; chords and curves that keep their distance replace the cells of its path.",
    zh: "面向道路的 A*。代价地图考虑净空、车道、路缘与限速；找到的栅格路径再由保持距离的弦与曲线跟随。",
  },
  dijkstra: {
    scene: "random-60",
    formulas: "f(n) = g(n)\ng: micro-cells, 1 000 000 straight, 1 414 214 diagonal",
    en: "Dijkstra's search: A* without an estimate. It expands every cell that is nearer to the start than the goal is, and finds the cheapest path. It is here to compare with.",
    zh: "Dijkstra 搜索：没有估计值的 A*。它展开比目标更靠近起点的全部栅格，并找到代价最小的路径，用于对比。",
  },
  greedy: {
    scene: "random-60",
    formulas: "f(n) = h(n)\nh: straight distance to the goal",
    en: "Greedy best-first search: A* without the cost from the start. It expands few cells, and its path can be far from the shortest. It is here to compare with.",
    zh: "贪婪最佳优先搜索：不计起点代价的 A*。展开的栅格很少，但路径可能远非最短，用于对比。",
  },
  rrt: {
    scene: "random-60",
    formulas:
      "q: a random cell, or the goal with probability goalBias\nn: the cell of the tree nearest to q\nnew cell: step cells from n towards q, where the line is free",
    en: "A tree that grows towards random cells until it reaches the goal. The same seed gives the same path; the path is neither short nor smooth. It is here to compare with.",
    zh: "一棵朝随机栅格生长、直到抵达目标的树。同一种子得到同一路径；路径既不短也不平滑，用于对比。",
  },
  genetic: {
    scene: "P4",
    formulas:
      "candidate: start, up to 16 cells, goal, joined by straight legs\nfitness = length + 20 · (blocked legs + blocked cells on them)\nparent: the fittest of 3 · child: head of one, tail of another, changed with probability mutation",
    en: "A genetic algorithm over paths of straight legs. It is slow, and in narrow places no candidate may be free. It is here to compare with.",
    zh: "以折线路径为个体的遗传算法。速度慢，在狭窄处可能没有一个候选可行，用于对比。",
  },
};
