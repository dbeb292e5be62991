/** Section 4.4.2 and the sensitivity of 4.5 and 5.2.2 of the road manuscript. */
import { collisionRisk, driveEnvelope, Planner, scenario } from "../../../pkg/node.js";
import { bandPicture } from "../../../www/src/picture/band";
import { smallMultiples } from "../../../www/src/picture/small-multiples";
import {
  changes,
  COMPARED,
  compare,
  envelope,
  judged,
  PRINTED_CHANGES,
  sweep,
  SWEPT,
  SWEPT_SCENES,
  type Compared,
  type ComparedClaim,
  type Engine,
  type Sample,
  type Swept,
} from "../../../www/src/planning/comparison";
import { cellOf, chartsOf, claimOf, COLUMNS, foundOf, say } from "../../../www/src/texts/comparison";
import { figure, heading, list, table, text, type Block, type Lang } from "./blocks";
import { fixed, words } from "./measure";

const ENGINE: Engine = { Planner, scenario, collisionRisk, driveEnvelope };

export interface Comparison {
  compared: Compared[];
  claims: ComparedClaim[];
  sweeps: { swept: Swept; scene: string; samples: Sample[] }[];
  bands: { scene: string; band: Float64Array }[];
}

let kept: Comparison | null = null;

/** Planned once; the same for both languages. */
export function comparison(): Comparison {
  if (kept) return kept;
  const compared = [COMPARED.grid, COMPARED.road].flatMap(({ scenes, planners }) =>
    scenes.flatMap((scene) => planners.map((planner) => compare(ENGINE, scene, planner))),
  );
  const sweeps = (Object.keys(SWEPT) as Swept[]).flatMap((swept) =>
    SWEPT_SCENES.map((scene) => ({ swept, scene, samples: sweep(ENGINE, scene, swept) })),
  );
  const bands = SWEPT_SCENES.map((scene) => ({ scene, band: envelope(ENGINE, scene) }));
  return (kept = { compared, claims: judged(compared), sweeps, bands });
}

export function comparisonBlocks(lang: Lang, { compared, claims, sweeps, bands }: Comparison): Block[] {
  const t = words(lang);
  return [
    heading(2, t("Against other algorithms (4.4.2)", "与其他算法对比（4.4.2）")),
    text(
      t(
        "The manuscript compares in words and prints no figure. Here each algorithm plans the same scenes with half " +
          "the car's width kept free; RRT and the genetic algorithm with five seeds each: the median, and in " +
          "brackets the least and the largest. Every path goes through the independent check, which looks at all of " +
          "it; the hits of 1000 drives leave out 5 m at either end.",
        "手稿仅以文字比较，没有数据。此处各算法规划相同的场景，均保留半个车宽；RRT 与遗传算法各用五个种子，给出中位数，括号内为最小与最大值。每条路径都经过覆盖全程的独立校验；千次行驶的碰撞不计两端各 5 m。",
      ),
    ),
    table(
      [t("claim", "论断"), t("verdict", "判定"), t("found here", "本地结果")],
      claims.map((one) => [claimOf(lang, one), say(lang, one.holds), foundOf(lang, one)]),
    ),
    table(
      [say(lang, "scene"), say(lang, "planner"), ...COLUMNS.map((column) => say(lang, column))],
      compared.map((one) => [`\`${one.scene}\``, one.planner, ...COLUMNS.map((column) => cellOf(one, column, fixed))]),
    ),
    figure({
      id: "compared-road",
      scene: "road-narrow",
      planners: ["cost-map", "dijkstra", "rrt", "genetic"],
      caption: t("S4: the cost map, Dijkstra, RRT, a genetic algorithm", "S4：代价地图、Dijkstra、RRT、遗传算法"),
    }),
    figure({
      id: "compared-grid",
      scene: "fig8-60",
      planners: ["risk-field", "dijkstra", "rrt", "genetic"],
      caption: t(
        "Regular obstacles, 60 × 60: the risk field, Dijkstra, RRT, a genetic algorithm",
        "规则障碍 60 × 60：风险场、Dijkstra、RRT、遗传算法",
      ),
    }),
    heading(2, t("Sensitivity (4.5, 5.2.2)", "参数敏感性（4.5、5.2.2）")),
    text(
      t(
        "One setting of the cost map at a time. Its best ranges, K from 4000 to 6000 and ε from 0.5 to 2, are in " +
          "units that the manuscript does not name and fit no formula of it in metres, so its percentages are what " +
          "can be held against ours.",
        "每次只改变代价地图的一个参数。手稿给出的最优范围（K 为 4000–6000，ε 为 0.5–2）单位不明，与其以米为单位的公式不符，因此只能比较百分比。",
      ),
    ),
    changeTable(lang, sweeps),
    figure({
      id: "sensitivity",
      scene: "",
      planners: [],
      svg: smallMultiples(chartsOf(lang, sweeps), t("Sensitivity of the cost map", "代价地图的参数敏感性")),
      caption: t(
        "A row a setting, a column a figure, a line a scene; the dashed upright is the default",
        "每行一个参数，每列一个指标，每条线一个场景；竖虚线为默认值",
      ),
    }),
    heading(2, t("The band of 1000 drives", "一千次行驶的包络")),
    ...bands.map(({ scene, band }) =>
      figure({
        id: `band-${scene}`,
        scene: "",
        planners: [],
        svg: bandPicture(scenario(scene), band, scene, 10),
        caption: t(
          `${scene}: in all drives with random offsets the car's middle stays in the dark band, its body in the ` +
            `light one; grey is beside the road or an obstacle; ten times as large across as along`,
          `${scene}：在随机偏离路径的所有行驶中，车辆中心在深色带内，车身在浅色带内；灰色为路外或障碍物；横向比例为纵向的十倍`,
        ),
      }),
    ),
    list([say(lang, "experts")]),
  ];
}

function changeTable(lang: Lang, sweeps: Comparison["sweeps"]): Block {
  const t = words(lang),
    signed = (value: number): string => `${value > 0 ? "+" : ""}${fixed(value, 1)} %`;
  return table(
    [
      t("setting", "参数"),
      t("changed by, printed", "变化，论文"),
      t("effect, printed", "影响，论文"),
      t("measured by", "衡量指标"),
      ...SWEPT_SCENES.map((scene) => `\`${scene}\``),
    ],
    PRINTED_CHANGES.map((printed) => [
      say(lang, printed.swept),
      `±${printed.printed[0]} %`,
      `±${printed.printed[1]} %`,
      say(lang, printed.figure),
      ...SWEPT_SCENES.map((scene) => {
        const one = sweeps.find((it) => it.swept === printed.swept && it.scene === scene),
          both = one && changes(one.samples, printed);
        return both ? both.map(signed).join(" / ") : "–";
      }),
    ]),
  );
}
