/** The road manuscript's page. */
import type { RoadTable } from "parkade";
import { figure, heading, list, table, text, type Block, type Lang } from "./blocks";
import roadWords from "../../../www/src/i18n/messages/papers-road.json";
import { layersPicture } from "./drawings";
import { comparison, comparisonBlocks } from "./comparison";
import { claims, fixed, words, type Measured } from "./measure";
import type { Page } from "./index";

type Line = RoadTable["lines"][number];
type Printed = keyof RoadTable["row"]["printed"];

export function road(lang: Lang, { road: all, verdicts }: Measured): Page {
  const t = words(lang),
    title = t("Roads, manuscript", "道路导航，手稿"),
    cars = all.filter(({ row }) => !row.ship),
    ships = all.filter(({ row }) => row.ship);
  const TABLES: readonly (readonly [Printed, string, string, (line: Line, of: RoadTable) => string])[] = [
    ["length", "path length, m", "路径长度，m", ({ metrics }) => fixed(metrics.middleLength, 1)],
    ["turns", "turning points", "转折点", ({ metrics }) => String(metrics.turnsPruned)],
    [
      "safety",
      "safety distance, m (ours: least clearance of the body)",
      "安全距离，m（本地：车身最小净距）",
      ({ metrics }) => fixed(metrics.bodyClearanceMin),
    ],
    ["time", "time, s", "时间，s", ({ milliseconds }) => fixed(milliseconds / 1000, 3)],
    ["memory", "memory, MB", "内存，MB", ({ metrics }) => fixed(metrics.bytes / 1e6, 1)],
    ["collisions", "collisions of 1000 drives", "千次行驶的碰撞数", ({ risk }) => String(risk.hits)],
  ];
  const compared = ([key, en, zh, of]: (typeof TABLES)[number]): Block[] => [
    heading(3, t(en[0]!.toUpperCase() + en.slice(1), zh)),
    table(
      [
        t("scene", "场景"),
        t("plain A*, printed", "普通 A*，论文"),
        t("improved, printed", "改进，论文"),
        t("plain A*, ours", "普通 A*，本地"),
        t("improved, ours", "改进，本地"),
        t("literal, ours", "照字面，本地"),
      ],
      [...cars, ...ships].map((one) => {
        const [plain, improved] = one.lines,
          printed = one.row.printed[key];
        return [
          `\`${one.row.scene}\``,
          printed[0],
          printed[1],
          ...[plain!, improved!, one.lines.at(-1)!].map((line) => of(line, one)),
        ];
      }),
    ),
  ];
  const at = lang === "zh" ? 1 : 0,
    flags = Object.entries(roadWords).filter(([key]) => /^papersRoad\.flag\d/.test(key));
  return {
    id: "road",
    title,
    blocks: [
      heading(1, title),
      text(
        t(
          "A* for roads with a cost map that knows clearance, lanes, kerbs and limits, compared with plain A*. The " +
            "manuscript's distances are a ship's; its scenes are built here to the size of roads, and again ten " +
            "times as large with the ship of its appendix B.",
          "面向道路的 A*，代价地图包含净距、车道、路缘与限速，并与普通 A* 比较。手稿的距离属于船舶；此处按道路尺寸构建场景，并以附录 B 的船放大十倍再做一次。",
        ),
      ),
      heading(2, t("What it claims", "论断")),
      claims(lang, verdicts.road),
      heading(2, t("Figures", "插图")),
      figure({
        id: "road-fig1",
        scene: "",
        planners: [],
        svg: layersPicture(
          lang === "zh"
            ? [
                ["输入层", "地图数据", "起点终点", "车辆参数", "配置参数"],
                ["预处理层", "坐标变换", "栅格化", "障碍物检测", "边界处理"],
                ["核心算法层", "代价地图生成", "A* 搜索", "路径修剪", "路径平滑"],
                ["输出层", "平滑路径", "路径信息", "性能指标", "可视化数据"],
              ]
            : [
                ["Input", "map", "start and goal", "vehicle", "settings"],
                ["Preparation", "coordinates", "cells", "obstacles", "borders"],
                ["Core", "cost map", "A* search", "pruning", "smoothing"],
                ["Output", "smooth path", "path's figures", "performance", "data to draw"],
              ],
        ),
        caption: t("Figure 1: the system in four layers", "图 1：系统的四层架构"),
        printed: t(
          "Printed: the only figure of the manuscript, four layers of boxes joined by arrows: input, preparation, " +
            "core, output. Here the same boxes with their words; its scenes have no picture.",
          "论文：手稿唯一的插图，输入、预处理、核心算法、输出四层方框，以箭头相连。此处方框与文字相同；其场景没有插图。",
        ),
      }),
      ...["road-straight", "road-curve", "road-crossing", "road-narrow"].map((scene, i) =>
        figure({
          id: scene,
          scene,
          planners: ["eight", "cost-map"],
          caption: t(`S${i + 1}: eight neighbours and the cost map`, `S${i + 1}：八邻域与代价地图`),
        }),
      ),
      ...ships.map(({ row: { id, scene } }) =>
        figure({
          id: scene,
          scene,
          planners: ["eight", "cost-map"],
          caption: t(
            `${id.slice(0, 2)}, ten times as large, with the ship of appendix B: eight neighbours and the cost map`,
            `${id.slice(0, 2)}，放大十倍，附录 B 的船：八邻域与代价地图`,
          ),
        }),
      ),
      heading(2, t("Its tables, printed and ours", "论文的表与本地结果")),
      ...TABLES.flatMap(compared),
      ...comparisonBlocks(lang, comparison()),
      heading(2, t("What its numbers cannot be", "数据的矛盾")),
      list(flags.map(([, both]) => both[at]!)),
    ],
  };
}
