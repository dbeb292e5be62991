/** Pages of the two grid papers. */
import type { PaperTable } from "parkade";
import { figure, heading, list, table, text, type Block, type Lang } from "./blocks";
import { flowPicture } from "./figures";
import { claims, fixed, words, type Measured } from "./measure";
import type { Page } from "./index";

const FIGURES = ["four", "eight", "risk-field"];
/** What the printed column "path length" may mean. */
const READINGS = ["lengthRaw", "lengthPruned", "lengthDp", "lengthSmoothed"] as const;

export function riskField(lang: Lang, { seeds, columns, grid, stranded }: Measured): Page {
  const t = words(lang),
    nodes = columns.indexOf("generated"),
    length = columns.indexOf("lengthPruned");
  const title = t("Risk field, 2024", "行车风险场，2024");
  const readingNames = [
    t("cells", "栅格路径"),
    t("pruned", "剪枝后"),
    t("shortest over the cells", "沿栅格最短"),
    t("smoothed", "平滑后"),
  ];
  const closest = (planner: string): (string | number)[] => [
    planner,
    ...READINGS.map(
      (name) =>
        grid.tables.flatMap(({ lines }) => lines).filter((line) => line.planner === planner && line.closest === name)
          .length,
    ),
  ];
  const row = ({ row: { id, table: number, size }, straight, lines }: PaperTable): Block[] => {
    const scene = `fig${id.startsWith("random") ? 9 : 8}-${size}`;
    return [
      heading(
        3,
        t(
          `Table ${number}: ${id.startsWith("random") ? "random" : "regular"}, ${size} × ${size} cells`,
          `表 ${number}：${id.startsWith("random") ? "随机" : "规则"}障碍，${size} × ${size} 格`,
        ),
      ),
      text(
        t(
          `Straight line ${fixed(straight)} cells. Scene: \`${scene}\`. Taken literally the risk field is stranded on ${stranded[id]!.length} of 200 maps (seeds ${stranded[id]!.slice(0, 6).join(", ")}${stranded[id]!.length > 6 ? ", …" : ""}).`,
          `直线距离 ${fixed(straight)} 格。场景：\`${scene}\`。照字面执行时，200 张地图中有 ${stranded[id]!.length} 张找不到路径（种子 ${stranded[id]!.slice(0, 6).join("、")}${stranded[id]!.length > 6 ? " 等" : ""}）。`,
        ),
      ),
      table(
        [
          t("planner", "规划器"),
          t("nodes, printed", "节点，论文"),
          t("nodes, ours", "节点，本地"),
          t("length, printed", "长度，论文"),
          t("length, ours", "长度，本地"),
        ],
        lines.map((line) => [
          line.planner,
          line.printedNodes ?? "–",
          fixed(line.figures[nodes]?.median, 0),
          line.printedLength === null
            ? "–"
            : `${line.printedLength}${line.impossible ? t(" (shorter than the straight line)", "（短于直线）") : ""}`,
          fixed(line.figures[length]?.median),
        ]),
      ),
      table(
        [t("length of", "长度"), t("printed", "论文"), ...readingNames],
        lines
          .filter(({ printedLength }) => printedLength !== null)
          .map((line) => [
            line.planner,
            line.printedLength!,
            ...READINGS.map((name) => {
              const median = line.figures[columns.indexOf(name)]!.median,
                percent = (median / line.printedLength! - 1) * 100,
                cell = `${fixed(median)} (${percent < 0 ? "−" : "+"}${fixed(Math.abs(percent), 1)} %)`;
              return line.closest === name ? `${cell} ←` : cell;
            }),
          ]),
      ),
      figure({
        id: scene,
        scene,
        planners: FIGURES,
        caption: t(
          `Figure ${scene[3]}, ${size} × ${size}, with safety space`,
          `图 ${scene[3]}，${size} × ${size}，含安全空间`,
        ),
      }),
    ];
  };
  return {
    id: "risk-field",
    title,
    blocks: [
      heading(1, title),
      text(
        t(
          `Hu et al. 2024 pick three of eight directions per cell by a potential field. Their maps are not published: each row here is ${seeds} seeded maps of the same kind and size, each figure a median; \`cargo xtask paper grid\` takes 200 and adds spreads and times.`,
          `Hu 等（2024）用势场在八个方向中选三个。论文未公布地图：此处每行为 ${seeds} 张同类同尺寸的种子地图，数值为中位数；\`cargo xtask paper grid\` 使用 200 张，并给出分布与时间。`,
        ),
      ),
      heading(2, t("What it claims", "论断")),
      claims(
        lang,
        grid.claims.filter(({ id }) => id.startsWith("H")),
      ),
      heading(2, t("Figures", "插图")),
      figure({
        id: "fig2",
        scene: "",
        planners: [],
        svg: flowPicture(
          lang === "zh"
            ? [
                "起点放入开放列表",
                "取 f 最小者，关闭",
                "到达目标：沿父节点回溯",
                "邻格：越界、障碍、已关闭则跳过",
                "g 更小则更新父节点并放入开放列表",
              ]
            : [
                "start goes into the open list",
                "take the smallest f and close it",
                "at the goal: follow the parents back",
                "neighbours: skip outside, blocked, closed",
                "cheaper g: new parent, into the open list",
              ],
        ),
        caption: t("Figure 2: A*, as the timeline steps through it", "图 2：A* 流程，时间轴逐步播放"),
      }),
      figure({
        id: "potential",
        scene: "fig8-30",
        planners: ["risk-field"],
        draws: "potential",
        caption: t("Equations 4 and 6: lines of equal potential U", "式 4 与式 6：等势线 U"),
      }),
      figure({
        id: "stages",
        scene: "fig8-30",
        planners: ["risk-field"],
        draws: "stages",
        caption: t(
          "Figures 5 to 7: cells (grey), what pruning keeps (dashed, circles), tangent circles with their points, arcs (green)",
          "图 5–7：栅格路径（灰）、剪枝后保留的点（虚线、圆圈）、切圆与切点、圆弧（绿）",
        ),
      }),
      heading(2, t("Tables 3 and 4, figures 8 and 9", "表 3 与表 4，图 8 与图 9")),
      heading(3, t("Which length is printed", "印刷的是哪种长度")),
      text(
        t(
          "The paper does not say whether its lengths are those of the cells, of the pruned path or of the smoothed one. Rows on which each reading is the nearest to the printed length; rows whose printed length cannot be are left out.",
          "论文没有说明长度是栅格路径、剪枝路径还是平滑路径的长度。下表为各种含义最接近印刷值的行数；印刷值不可能的行除外。",
        ),
      ),
      table([t("planner", "规划器"), ...readingNames], FIGURES.map(closest)),
      ...grid.tables.flatMap(row),
    ],
  };
}

export function sixteen(lang: Lang, { seeds, columns, grid }: Measured): Page {
  const t = words(lang),
    shown = ["generated", "lengthRaw", "turns", "turnAngleDeg", "clearanceMean", "clearanceMin"].map((name) =>
      columns.indexOf(name),
    );
  const digits = [0, 2, 0, 0, 2, 2];
  const planners = [
    "dijkstra",
    "greedy",
    "four",
    "eight",
    "sixteen",
    "twenty-four",
    "forty-eight",
    "sixteen-bidirectional",
    "sixteen-nba",
  ];
  const title = t("Sixteen neighbours from both ends", "双向十六邻域");
  const row = ({ row: { id, size }, lines }: PaperTable): Block[] => [
    heading(3, t(`${id}: ${size} × ${size} cells`, `${id}：${size} × ${size} 格`)),
    table(
      [
        t("planner", "规划器"),
        t("nodes", "节点"),
        t("length, cells", "长度，格"),
        t("turns", "转弯"),
        t("turning, °", "转角，°"),
        t("clearance, mean, cells", "平均间距，格"),
        t("clearance, least", "最小间距"),
      ],
      planners
        .flatMap((planner) => lines.filter((line) => line.planner === planner))
        .map((line) => [line.planner, ...shown.map((at, i) => fixed(line.figures[at]?.median, digits[i]))]),
    ),
  ];
  return {
    id: "sixteen",
    title,
    blocks: [
      heading(1, title),
      text(
        t(
          `A* that may move to sixteen neighbours, searched from start and goal at once. The paper prints no maps and no figures, so what can be held against it is which planner does better: medians over ${seeds} seeded maps of each kind, and its claims.`,
          `可移动到十六个邻格的 A*，并从起点与终点同时搜索。论文没有给出地图与数据，只能比较规划器的优劣：每类 ${seeds} 张种子地图的中位数，以及论断的判定。`,
        ),
      ),
      heading(2, t("What it claims", "论断")),
      claims(
        lang,
        grid.claims.filter(({ id }) => id.startsWith("Y")),
      ),
      list([
        t(
          "Judged by counted work; `cargo xtask paper grid` prints times beside it.",
          "按计数的工作量判定；`cargo xtask paper grid` 另附时间。",
        ),
      ]),
      figure({
        id: "sixteen",
        scene: "random-60",
        planners: ["eight", "sixteen", "sixteen-bidirectional"],
        caption: t("Eight and sixteen neighbours, one way and from both ends", "八邻域、十六邻域，单向与双向"),
      }),
      heading(2, t("On seeded maps", "种子地图")),
      ...grid.tables.flatMap(row),
    ],
  };
}
