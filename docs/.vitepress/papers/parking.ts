/** The parking paper's page. */
import type { ParkingFigures } from "parkade";
import { figure, heading, list, table, text, type Block, type Lang } from "./blocks";
import { flowPicture, volumesPicture } from "./figures";
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
const DIGITS = { time: 2, changes: 0, nodes: 0, length: 1 } as const;

export function parking(lang: Lang, { parking: rows, verdicts, volumes }: Measured): Page {
  const t = words(lang),
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
          'The paper searches from the slot outwards and compares itself with the traditional hybrid A*. Its ten questions, P perpendicular and L parallel, are built-in scenes of these names; lengths, nodes and times are rounded as the paper\'s are. Its "search time" is the driving time at 2 m/s.',
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
          "`cargo xtask paper settings` tries 2304 combinations of the published program's settings on all ten rows. None has the printed gear changes (two to four) in more than one row; only L1 comes out as printed (37.8 for 37.9 m, four changes). So the column is not what that program answers at any of these settings.",
          "`cargo xtask paper settings` 在全部十行上尝试公开程序的 2304 种参数组合。没有一种组合能在多于一行上得到论文的换挡次数（2–4 次）；只有 L1 与论文相符（37.8 m 对 37.9 m，四次换挡）。因此该列并非该程序在这些参数下的结果。",
        ),
      ),
      heading(2, t("Figures", "插图")),
      figure({
        id: "fig4",
        scene: "",
        planners: [],
        svg: volumesPicture(),
        caption: t(
          "Figures 4 and 5: box along the axes (dashed), turned box (solid), ball (dotted)",
          "图 4 与图 5：轴对齐包围盒（虚线）、定向包围盒（实线）、球（点线）",
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
        ),
        caption: t("Figure 10, as `hybrid-bidirectional` does it", "图 10，即 `hybrid-bidirectional` 的做法"),
      }),
      ...(
        [
          ["fig11", "P0", ["hybrid-classic"], "Figure 11: traditional", "图 11：传统"],
          ["fig12", "park-free", ["hybrid"], "Figure 12: no obstacles", "图 12：无障碍"],
          ["fig13", "park-fig13", ["hybrid"], "Figure 13: an obstacle", "图 13：有障碍"],
          ["fig14", "L0", ["hybrid-classic"], "Figure 14: traditional, parallel", "图 14：传统，侧方"],
          ["fig15", "L0", ["hybrid"], "Figure 15: improved, parallel", "图 15：改进，侧方"],
        ] as const
      ).map(([id, scene, planners, en, zh]) => figure({ id, scene, planners, caption: t(en, zh) })),
      figure({
        id: "fig16",
        scene: "fig16-wait",
        planners: ["hybrid"],
        draws: "marks",
        caption: t(
          "Figure 16: the box sets off at A, is at B when the car stops at W, at C when it goes on, and ends at D; the car drives from S to E",
          "图 16：障碍物自 A 出发，车在 W 停下时位于 B，车继续行驶时位于 C，止于 D；车自 S 至 E",
        ),
      }),
      heading(2, t("Tables 2 to 11", "表 2–表 11")),
      text(
        t(
          "† below the shortest path without obstacles, which no car of that turning radius can drive.",
          "† 短于无障碍最短路径，该转弯半径的车辆无法行驶。",
        ),
      ),
      ...TABLES.flatMap(compared),
      heading(2, t("What is wrong with the printed rows", "论文各行的问题")),
      list(rows.filter(({ row }) => row.note).map(({ row: { id, note } }) => `${id}: ${note}`)),
    ],
  };
}
