/** Pages of the two grid papers. */
import type { PaperTable } from "parkade";
import { figure, heading, list, table, text, type Block, type Lang } from "./blocks";
import { expansionPicture, flowPicture, regionsPicture } from "./drawings";
import { claims, fixed, words, type Measured } from "./measure";
import type { Page } from "./index";

const FIGURES = ["four", "eight", "risk-field"];
/** Figure 8 has regular maps, figure 9 random ones. */
const sceneOf = (row: string): string => `fig${row.startsWith("random") ? 9 : 8}-${row.split("-")[1]}`;
/** What the printed column "path length" may mean. */
const READINGS = ["lengthRaw", "lengthPruned", "lengthDp", "lengthSmoothed"] as const;

export function riskField(lang: Lang, { seeds, columns, grid, incomplete }: Measured): Page {
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
    const scene = sceneOf(id);
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
          `Straight line ${fixed(straight)} cells. Scene: \`${scene}\`. Taken literally the risk field finds no path ` +
            `on ${incomplete[id]!.length} of 200 maps (seeds ${incomplete[id]!.slice(0, 6).join(", ")}${
              incomplete[id]!.length > 6 ? ", …" : ""
            }).`,
          `直线距离 ${fixed(straight)} 格。场景：\`${scene}\`。照字面执行时，200 张地图中有 ${incomplete[id]!.length} 张找不到路径（种子 ${incomplete[
            id
          ]!.slice(0, 6).join("、")}${incomplete[id]!.length > 6 ? " 等" : ""}）。`,
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
        draws: "spaces",
        caption: t(
          `Figure ${scene[3]}, ${size} × ${size}, with safety space`,
          `图 ${scene[3]}，${size} × ${size}，含安全空间`,
        ),
        printed: t(
          "Printed: the map with a blue circle at the start, a red one at the goal, black circles at the points " +
            "that pruning keeps, the path in blue, what smoothing changes in green. Here the same, with the paths " +
            "of four (dotted) and eight neighbours (dashed), the necessary safety space in orange and the redundant " +
            "one in violet. The map is ours: the paper's is not published.",
          "论文：地图上蓝圈为起点，红圈为终点，黑圈为剔除冗余点后保留的点，蓝线为路径，绿色为平滑的部分。此处相同，另有四邻域（点线）与八邻域（虚线）路径，橙色为必要安全空间，紫色为冗余安全空间。" +
            "论文未公布地图，此图为本项目生成。",
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
          `Hu et al. 2024 pick three of eight directions per cell by a potential field. Their maps are not ` +
            `published: each row here is ${seeds} seeded maps of the same kind and size, each figure a median; ` +
            `\`cargo xtask paper grid\` takes 200 and adds spreads and times.`,
          `Hu 等（2024）用势场在八个方向中选三个。论文未公布地图：此处每行为 ${seeds} 张同类同尺寸的种子地图，数值为中位数；\`cargo xtask paper grid\` 使用 200 ` +
            `张，并给出分布与时间。`,
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
                "开放列表为空：没有路径",
                "取 f 最小者，放入关闭列表",
                "是目标：沿父节点回溯，结束",
                "邻格：越界、障碍、已关闭则跳过",
                "g 更小则更新父节点并放入开放列表",
              ]
            : [
                "start goes into the open list",
                "open list empty: there is no path",
                "take the smallest f and close it",
                "is it the goal: follow the parents back, end",
                "neighbours: skip outside, blocked, closed",
                "cheaper g: new parent, into the open list",
              ],
          { first: 1, last: 5 },
        ),
        caption: t("Figure 2: A*, as the timeline steps through it", "图 2：A* 流程，时间轴逐步播放"),
        printed: t(
          "Printed: a flow chart of A* in the usual form. Here the same steps in the order in which this search " +
            "takes them; on the page the timeline shows each on the map.",
          "论文：常见形式的 A* 流程图。此处为相同步骤，按本搜索的执行顺序排列；页面时间轴在地图上逐步显示。",
        ),
      }),
      figure({
        id: "fig1",
        scene: "fig9-30",
        planners: ["risk-field"],
        draws: "spaces",
        caption: t(
          "Figure 1: necessary (orange) and redundant safety space (violet)",
          "图 1：必要安全空间（橙）与冗余安全空间（紫）",
        ),
        printed: t(
          "Printed: (a) obstacles grown by the car's body, drawn as a yellow box; (b) narrow passages and traps " +
            "filled. Here both on one map, as the planner takes them: half the car's width and a margin of 0.2 " +
            "cells, passages of fewer than two cells and pockets with a mouth of up to five.",
          "论文：(a) 按车身（黄色方框）膨胀障碍物；(b) 填补狭窄通道与陷阱。此处二者在同一地图上，即规划器实际所用：半个车宽加 0.2 格余量，窄于两格的通道，以及开口不超过五格的陷阱。",
        ),
      }),
      figure({
        id: "potential",
        scene: "fig8-30",
        planners: ["risk-field"],
        draws: "potential",
        caption: t("Equations 4 and 6: lines of equal potential U", "式 4 与式 6：等势线 U"),
        printed: t(
          "The paper prints the formulas without a picture. Lines stand evenly in the square root of U; they bend " +
            "around obstacles.",
          "论文只有公式，没有插图。等势线按 U 的平方根等间隔绘制，在障碍物附近弯曲。",
        ),
      }),
      figure({
        id: "fig3",
        scene: "",
        planners: [],
        svg: regionsPicture(),
        caption: t(
          "Figure 3: regions of the force's direction, oblique (1 to 8) and straight (A to D)",
          "图 3：合力方向的区域，斜向（1–8）与横纵向（A–D）",
        ),
        printed: t(
          "Printed: the numbered directions around a cell for both modes. Here the sectors of tables 1 and 2 with " +
            "the slopes that divide them; hovering over a cell on the page draws its own.",
          "论文：两种模式下某格周围编号的方向。此处为表 1、表 2 的扇区及其分界斜率；页面上悬停某格时绘出该格的区域。",
        ),
      }),
      figure({
        id: "fig4",
        scene: "",
        planners: [],
        svg: expansionPicture(),
        caption: t(
          "Figure 4: cells that are tried around the black one in regions 1, 2 and A; + marks the extension",
          "图 4：区域 1、2 与 A 中黑格周围尝试扩展的格子；+ 为增扩的格子",
        ),
        printed: t(
          "Printed: four panels, of which (c) extends the three cells of a region by a further diagonal one and (d) " +
            "by a further straight one. Here what the planner answers for cells in the open: with region 1 both " +
            "diagonals of the three are extended.",
          "论文：四幅小图，其中 (c) 在区域的三个格子之外再扩展一个对角格，(d) 再扩展一个横纵向格。此处为规划器对空旷处格子的实际回答：区域 1 的三个格子中有两个对角格，均被增扩。",
        ),
      }),
      ...(
        [
          [
            "fig5",
            "pruned",
            "Figure 5: cells (blue) and what pruning keeps (dashed, circles)",
            "图 5：栅格路径（蓝）与剪枝后保留的点（虚线、圆圈）",
            "Printed: a path before and after redundant points are removed, side by side. Here both on one map.",
            "论文：剔除冗余点前后的路径并排。此处绘于同一地图。",
          ],
          [
            "fig6",
            "tangents",
            "Figure 6: a corner's tangent circle with the letters of steps 1 to 6",
            "图 6：一个拐点的切点圆，字母同步骤 1–6",
            "Printed: S at the end of the shorter segment, the perpendicular there meets the bisector in P, the " +
              "circle around P touches the longer segment in Q; S moves to S2 where it does not. Here the same " +
              "construction at a corner of figure 5, with S2 where two corners share a segment.",
            "论文：S 为较短线段的端点，其垂线与角平分线交于 P，以 P 为圆心的圆与较长线段交于 Q；否则 S 移至 S2。此处为图 5 中一个拐点的同一作图；两个拐点共用一条线段时取 S2。",
          ],
          [
            "fig7",
            "smoothed",
            "Figure 7: the pruned path (blue) and its arcs (green)",
            "图 7：剪枝后的路径（蓝）与圆弧（绿）",
            "Printed: a path before and after smoothing. Here both on one map, tangent points marked.",
            "论文：平滑前后的路径。此处绘于同一地图，并标出切点。",
          ],
        ] as const
      ).map(([id, draws, en, zh, printed, printedZh]) =>
        figure({
          id,
          scene: "fig8-30",
          planners: ["risk-field"],
          draws,
          caption: t(en, zh),
          printed: t(printed, printedZh),
        }),
      ),
      heading(2, t("Tables 3 and 4, figures 8 and 9", "表 3 与表 4，图 8 与图 9")),
      heading(3, t("Which length is printed", "印刷的是哪种长度")),
      text(
        t(
          "The paper does not say whether its lengths are those of the cells, of the pruned path or of the smoothed " +
            "one. Rows on which each reading is the nearest to the printed length; rows whose printed length cannot " +
            "be are left out.",
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
    text(t(`One of these maps: \`${sceneOf(id)}\`.`, `其中一张地图：\`${sceneOf(id)}\`。`)),
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
          `A* that may move to sixteen neighbours, searched from start and goal at once. The paper prints no maps ` +
            `and no figures, so what can be held against it is which planner does better: medians ` +
            `over ${seeds} seeded maps of each kind, and its claims.`,
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
