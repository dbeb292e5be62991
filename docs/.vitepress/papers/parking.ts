/** The parking paper's page. */
import type { ParkingFigures } from "parkade";
import { figure, heading, list, table, text, type Block, type Lang } from "./blocks";
import parkingWords from "../../../www/src/i18n/messages/papers-parking.json";
import {
  cornersPicture,
  flowPicture,
  kinematicsPicture,
  separatingPicture,
  steeringPicture,
  volumesPicture,
} from "./drawings";
import { claims, fixed, words, type Measured } from "./measure";
import type { Page } from "./index";

/** Which rows and which figure each of the paper's tables has. */
const TABLES: readonly (readonly [number, readonly string[], readonly (keyof ParkingFigures)[]])[] = [
  [2, ["P0"], ["time", "changes", "nodes", "length"]],
  [3, ["P1", "P2", "P3", "P4"], ["time"]],
  [4, ["P1", "P2", "P3", "P4"], ["changes"]],
  [5, ["P1", "P2", "P3", "P4"], ["nodes"]],
  [6, ["P1", "P2", "P3", "P4"], ["length"]],
  [7, ["L0"], ["time", "changes", "nodes", "length"]],
  [8, ["L1", "L2", "L3", "L4"], ["time"]],
  [9, ["L1", "L2", "L3", "L4"], ["changes"]],
  [10, ["L1", "L2", "L3", "L4"], ["nodes"]],
  [11, ["L1", "L2", "L3", "L4"], ["length"]],
];
/** Rows that no figure of the paper shows. */
const PICTURED = ["P1", "P2", "P3", "P4", "L1", "L2", "L3", "L4"] as const;

/** Figures of the paper that show a scene: planners, caption, and what is printed, in both languages. */
const SCENE_FIGURES = [
  [
    "fig9",
    "P2",
    ["hybrid"],
    "Figure 9: search from the goal",
    "图 9：从终点反向搜索",
    "Printed: a sketch of a path of two parts, from the goal E to a node O by search and from O to the start S by a " +
      "Reeds–Shepp curve. Here a row whose search expands 134 poses before such a curve completes it; the layer " +
      '"Search tree" shows both parts.',
    "论文：两段路径的示意图，从终点 E 搜索至节点 O，再以 RS 曲线连至起点 S。此处为扩展 134 个位姿后由该曲线完成的一行；图层“搜索树”显示这两段。",
  ],
  [
    "fig11",
    "P0",
    ["hybrid-classic"],
    "Figure 11: traditional",
    "图 11：传统",
    "Printed: a path of 24.1 m with two gear changes, backing where it turns, in a lot of 25 m × 25 m. Here the " +
      "coarse and greedy planner needs 22.8 m and none, as no setting of the published program gives the printed path.",
    "论文：25 m × 25 m 场地中 24.1 m、换挡两次的路径，转角处有倒车。此处粗糙贪心规划器为 22.8 m、不换挡；公开程序的任何参数都得不到印刷的路径。",
  ],
  [
    "fig12",
    "park-free",
    ["hybrid"],
    "Figure 12: no obstacles",
    "图 12：无障碍",
    "Printed: a smooth path of 22.7 m into the slot, without stopping or backing. Here 22.77 m, without a gear " +
      "change as well.",
    "论文：22.7 m 的平滑入库路径，无停车与倒车。此处为 22.77 m，同样不换挡。",
  ],
  [
    "fig13",
    "park-fig13",
    ["hybrid"],
    "Figure 13: an obstacle",
    "图 13：有障碍",
    "Printed: the same with an obstacle in the way, around which the path bends. Its place is not printed. Here it " +
      "is 2 m × 2 m at (12, 9.5).",
    "论文：同一问题，路上有一障碍物，路径绕行。其位置未印出；此处为 (12, 9.5) 处 2 m × 2 m。",
  ],
  [
    "fig14",
    "L0",
    ["hybrid-classic"],
    "Figure 14: traditional, parallel",
    "图 14：传统，侧方",
    "Printed: a path of 46.0 m with three gear changes that goes over the same ground more than once in the slot. " +
      "Here 35.1 m with two.",
    "论文：46.0 m、换挡三次的路径，在车位内多次往复。此处为 35.1 m、换挡两次。",
  ],
  [
    "fig15",
    "L0",
    ["hybrid"],
    "Figure 15: improved, parallel",
    "图 15：改进，侧方",
    "Printed: 41.8 m with one gear change. Here 30 m without one: the printed path is far from the shortest.",
    "论文：41.8 m，换挡一次。此处为 30 m、不换挡：印刷的路径远非最短。",
  ],
] as const;
const DIGITS = { time: 2, changes: 0, nodes: 0, length: 1 } as const;

export function parking(lang: Lang, { parking: rows, verdicts, volumes }: Measured): Page {
  const t = words(lang),
    at = lang === "zh" ? 1 : 0,
    title = t("Parking by reverse search, 2025", "反向搜索泊车，2025");
  const names = {
    time: t("driving time, s", "行驶时间，s"),
    changes: t("gear changes", "换挡次数"),
    nodes: t("nodes", "节点"),
    length: t("length, m", "长度，m"),
  };
  const compared = ([number, ids, figures]: (typeof TABLES)[number]): Block[] => [
    heading(
      3,
      t(
        `Table ${number}: ${figures.map((one) => names[one]).join(", ")}`,
        `表 ${number}：${figures.map((one) => names[one]).join("、")}`,
      ),
    ),
    table(
      [
        t("scene", "场景"),
        ...(figures.length > 1 ? [t("figure", "指标")] : []),
        t("traditional, printed", "传统，论文"),
        t("improved, printed", "改进，论文"),
        "`hybrid-forward`",
        "`hybrid`",
        "`hybrid-classic`",
      ],
      ids.flatMap((id) => {
        const { row, lines, impossible, bound } = rows.find((one) => one.row.id === id)!;
        return figures.map((key) => {
          const flag = (at: 0 | 1): string =>
            key === "length" && impossible[at] ? t(` † < ${fixed(bound)}`, ` † < ${fixed(bound)}`) : "";
          const shown = (value: number): string => fixed(value, DIGITS[key]);
          return [
            `\`${id}\``,
            ...(figures.length > 1 ? [names[key]] : []),
            shown(row.traditional[key]) + flag(0),
            shown(row.improved[key]) + flag(1),
            ...[0, 1, 3].map((at) => shown(lines[at]![key])),
          ];
        });
      }),
    ),
  ];
  const saved = verdicts.saved!;
  return {
    id: "parking",
    title,
    blocks: [
      heading(1, title),
      text(
        t(
          "The paper searches from the slot outwards and compares itself with the traditional hybrid A*. Its ten " +
            "questions, P perpendicular and L parallel, are built-in scenes of these names; lengths, nodes and " +
            'times are rounded as the paper\'s are. Its "search time" is the driving time at 2 m/s.',
          "论文从车位向外搜索，并与传统混合 A* 比较。十个问题（P 垂直、L 侧方）都是内置场景；长度、节点与时间按论文方式取整。论文的“搜索时间”实为以 2 m/s 行驶的时间。",
        ),
      ),
      heading(2, t("What it claims", "论断")),
      claims(lang, verdicts.parking),
      heading(3, t("Driving time saved", "节省的行驶时间")),
      table(
        [
          t("rows", "行"),
          t("abstract", "摘要"),
          t("its rows", "各行平均"),
          t("against `hybrid-forward`", "相对 `hybrid-forward`"),
          t("against `hybrid-classic`", "相对 `hybrid-classic`"),
        ],
        saved.map((one, i) => [
          i === 0 ? "P1–P4" : "L1–L4",
          ...[one.said, one.printed, one.overForward, one.overClassic].map((value) => `${fixed(value)} %`),
        ]),
      ),
      heading(3, t("Poses expanded, from the start and from the goal", "扩展的位姿：从起点与从终点")),
      table(
        [t("scene", "场景"), "`hybrid-forward`", "`hybrid`"],
        rows.map(({ row: { id }, lines }) => [`\`${id}\``, lines[0]!.expanded, lines[1]!.expanded]),
      ),
      heading(3, t("The traditional column", "传统一列")),
      text(
        t(
          "`cargo xtask paper settings` tries 2304 combinations of the published program's settings on all ten " +
            "rows. None has the printed gear changes (two to four) in more than one row; only L1 comes out as " +
            "printed (37.8 for 37.9 m, four changes). So the column is not what that program answers at any of " +
            "these settings.",
          "`cargo xtask paper settings` 在全部十行上尝试公开程序的 2304 种参数组合。没有一种组合能在多于一行上得到论文的换挡次数（2–4 次）；只有 L1 与论文相符（37.8 m 对 " +
            "37.9 m，四次换挡）。因此该列并非该程序在这些参数下的结果。",
        ),
      ),
      heading(2, t("Figures", "插图")),
      figure({
        id: "fig2-kinematics",
        scene: "",
        planners: [],
        svg: kinematicsPicture(),
        caption: t("Figure 2: the car's kinematics", "图 2：车辆运动学模型"),
        printed: t(
          "Printed: the bicycle model with the middles of both axles, the heading φ, the wheelbase L and the " +
            "steering angle δf, to the right and so negative. Here the same, with the turning circle of radius R = " +
            "L / tan δf to which both wheels are tangents.",
          "论文：自行车模型，标出前后轴中心、航向角 φ、轴距 L 与等效前轮转角 δf（向右为负）。此处相同，另绘出半径 R = L / tan δf 的转弯圆，两轮均与其相切。",
        ),
      }),
      figure({
        id: "fig3-corners",
        scene: "",
        planners: [],
        svg: cornersPicture(),
        caption: t("Figure 3: the corners of the body", "图 3：车身定点图"),
        printed: t(
          "Printed: the body's corners A to D at the heading θ. Here the same with the lengths of equation 10, " +
            "which offsets A from the front axle by mistake: L + Lf is the way from the rear axle.",
          "论文：航向角为 θ 时车身的四个顶点 A 至 D。此处相同，并标出式 10 的各长度；式 10 误以前轴为起点，L + Lf 实为自后轴起的距离。",
        ),
      }),
      figure({
        id: "fig4-volumes",
        scene: "",
        planners: [],
        svg: volumesPicture(),
        caption: t(
          "Figures 4 and 5: box along the axes (dashed), turned box (solid), ball (dotted)",
          "图 4 与图 5：轴对齐包围盒（虚线）、定向包围盒（实线）、球（点线）",
        ),
        printed: t(
          "Printed: the three volumes as solids, each around an object, then side by side around a car. Here all " +
            "around one car that stands at 25°; the page turns it by hand. The table adds what the paper does not " +
            "measure: each volume's speed and wrong answers.",
          "论文：三种包围盒各自包裹物体的立体示意，以及围绕车辆的并排对比。此处同时围绕一辆朝向 25° 的车，页面上可手动转动。下表补充论文未测量的内容：各自的速度与误判。",
        ),
      }),
      table(
        [
          t("scene", "场景"),
          t("volume", "包围盒"),
          t("false alarms of free poses", "误报占可通行位姿"),
          t("wholly behind a line", "完全在线外"),
          t("area, bodies", "面积，车身倍数"),
          t("µs a pose", "µs/位姿"),
        ],
        volumes.flatMap(({ scene, poses, collisions, volumes: all }) =>
          all.map((one) => [
            scene,
            one.volume.toUpperCase(),
            `${fixed((100 * one.falseAlarms) / (poses - collisions), 1)} %`,
            one.missed,
            fixed(one.area),
            fixed(one.micros, 3),
          ]),
        ),
      ),
      figure({
        id: "fig6-separating",
        scene: "",
        planners: [],
        svg: separatingPicture(),
        caption: t(
          "Figure 6: a body and an obstacle's line on one axis: apart (left), they meet (right)",
          "图 6：车身与障碍物线在一条轴上的投影：分离（左），相交（右）",
        ),
        printed: t(
          "Printed: a simplified sketch of the car's rectangle and the lines around the slot, which are all " +
            "obstacles but for its entrance. Here one line and its normal, on which the body's projection (blue) " +
            "does or does not hold the line's (dot); the body's own two axes are tried in the same way.",
          "论文：车辆矩形与车位四周边框线的简化示意，除入口外边框均为障碍物。此处为一条线及其法线：车身在法线上的投影（蓝）是否包含该线的投影（圆点）；车身自己的两条轴同样检验。",
        ),
      }),
      figure({
        id: "fig7-steering",
        scene: "",
        planners: [],
        svg: steeringPicture(),
        caption: t(
          "Figure 7: five steering angles in each gear, forward blue, back orange",
          "图 7：每个挡位五个转角，前进为蓝，后退为橙",
        ),
        printed: t(
          "Printed: a car's node with five arcs forward and five back, the wheel's range divided evenly. Here the " +
            "same with the paper's turning radius of 5.408 m; `hybrid` has as many with its setting `steerSamples` " +
            "at 2.",
          "论文：车辆节点向前、向后各五条弧，转角均分。此处相同，转弯半径为论文的 5.408 m；`hybrid` 的参数 `steerSamples` 取 2 时即为五个方向。",
        ),
      }),
      figure({
        id: "fig8",
        scene: "perpendicular",
        planners: ["eight", "hybrid"],
        caption: t("Figure 8: A* and hybrid A*", "图 8：A* 与混合 A*"),
        printed: t(
          "Printed: the nodes that A* expands at cell centres beside those of hybrid A* at the ends of arcs. Here " +
            "the paths of both in one scene: eight neighbours turn on the spot and collide, hybrid A* drives into " +
            'the slot; the layer "Search tree" draws their nodes.',
          "论文：A* 在格心扩展的节点与混合 A* 在弧端扩展的节点对比。此处为同一场景中两者的路径：八邻域原地转向并碰撞，混合 A* 驶入车位；图层“搜索树”绘出节点。",
        ),
      }),
      figure({
        id: "fig10",
        scene: "",
        planners: [],
        svg: flowPicture(
          lang === "zh"
            ? [
                "步骤 1–2：两棵树，各有开放集与关闭集",
                "步骤 3：较小的开放集扩展代价最小的节点",
                "步骤 4：另一棵树在此格已有关闭节点？",
                "步骤 5：比较两条经过此格的路径，取更便宜者",
                "步骤 6：在另一开放集中则合并两条链",
                "此处：以 Reeds–Shepp 曲线连接两个位姿",
              ]
            : [
                "steps 1 and 2: two trees, an open and a closed set each",
                "step 3: the smaller open set expands its cheapest node",
                "step 4: has the other tree closed this cell?",
                "step 5: keep the cheaper of both ways through it",
                "step 6: in the other open set: join both chains",
                "here: a Reeds–Shepp curve joins the two poses",
              ],
          { first: 1, last: 4 },
        ),
        caption: t("Figure 10, as `hybrid-bidirectional` does it", "图 10，即 `hybrid-bidirectional` 的做法"),
        printed: t(
          "Printed: a flow chart with the open and closed sets of both trees. Here its six steps, and the one that " +
            "is different: two nodes in one cell are joined by a Reeds–Shepp curve, for no car jumps between them.",
          "论文：含两棵树开放集与关闭集的流程图。此处为其六个步骤，以及不同之处：同格的两个节点以 Reeds–Shepp 曲线连接，因为车辆不能在其间跳跃。",
        ),
      }),
      ...SCENE_FIGURES.map(([id, scene, planners, en, zh, printed, printedZh]) =>
        figure({ id, scene, planners, caption: t(en, zh), printed: t(printed, printedZh) }),
      ),
      figure({
        id: "fig16",
        scene: "fig16-wait",
        planners: ["hybrid"],
        draws: "marks",
        caption: t(
          "Figure 16: the box sets off at A, is at B when the car stops at W, at C when it goes on, and ends at D; " +
            "the car drives from S to E",
          "图 16：障碍物自 A 出发，车在 W 停下时位于 B，车继续行驶时位于 C，止于 D；车自 S 至 E",
        ),
        printed: t(
          "Printed: a box of 5 m × 1 m moves along y = 15 from x = −20 to 5 at 2 m/s; the path of figure 14 crosses " +
            "it, so the car waits at W while the box passes from B to C. Here the same box, letters and speeds, and " +
            "a strip of their times. Our path of 30 m in `fig16` is behind the box before it comes and waits for " +
            "nothing, so `fig16-wait` adds a barrier that leads the way through the box's strip.",
          "论文：5 m × 1 m 的障碍物以 2 m/s 沿 y = 15 从 x = −20 移至 5；图 14 的路径与其相交，车在 W 处等待障碍物从 B 移至 " +
            "C。此处障碍物、字母与速度相同，并附时间条。本实现在 `fig16` 中 30 m 的路径在障碍物到来之前已经通过，无需等待，因此 `fig16-wait` 增设一道隔栏，使路径穿过障碍物的行进带。",
        ),
      }),
      heading(3, t("Paths of the other rows", "其余各行的路径")),
      ...PICTURED.map((id) =>
        figure({
          id,
          scene: id,
          planners: ["hybrid-classic", "hybrid"],
          caption: t(`${id}: coarse and greedy, and from the goal`, `${id}：粗糙贪心，与从终点搜索`),
        }),
      ),
      heading(2, t("Tables 2 to 11", "表 2–表 11")),
      text(
        t(
          "† below the shortest path without obstacles, which no car of that turning radius can drive.",
          "† 短于无障碍最短路径，该转弯半径的车辆无法行驶。",
        ),
      ),
      ...TABLES.flatMap(compared),
      heading(2, t("What is wrong with the printed rows", "论文各行的问题")),
      list(
        rows
          .filter(({ row }) => row.note)
          .map(({ row: { id } }) => `\`${id}\`: ${parkingWords[`papersParking.${id}` as "papersParking.P0"][at]!}`),
      ),
    ],
  };
}
