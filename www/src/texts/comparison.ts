/** Words of the road manuscript's comparison and sensitivity, for the page and for documents. */
import type { Lang } from "../i18n/index";
import { words } from "../i18n/words";
import type { Chart } from "../picture/small-multiples";
import type { Compared, ComparedClaim, Sample, Span, Swept } from "../planning/comparison";
import { MEASURED, SWEPT } from "../planning/comparison";

export const say = words({
  scene: ["Scene", "场景"],
  planner: ["Planner", "规划器"],
  found: ["Paths found", "找到路径"],
  collide: ["Collide", "碰撞"],
  length: ["Length, m", "长度，m"],
  turning: ["Turning, °", "转角，°"],
  clearance: ["Least clearance, m", "最小净距，m"],
  hits: ["Hits of 1000", "千次碰撞"],
  expanded: ["Expansions", "扩展数"],
  lane: ["Off the lane, m", "偏离车道，m"],
  bending: ["Change of curvature, 1/m", "曲率变化，1/m"],
  alpha: ["Lane α", "车道 α"],
  beta: ["Kerb β", "路缘 β"],
  factor: ["K, m", "K，m"],
  epsilon: ["ε, m", "ε，m"],
  decay: ["Decay B, 1/m", "衰减 B，1/m"],
  margin: ["Margin, m", "余量，m"],
  threshold: ["Pruning share", "剪枝比例"],
  resolution: ["Cell size, ×", "格边长，×"],
  yes: ["holds", "成立"],
  partly: ["holds in part", "部分成立"],
  no: ["does not hold", "不成立"],
  RRT: [
    "Against RRT: the path is better and takes less time.",
    "与 RRT 相比：路径更优，计算时间更短。",
  ],
  Dijkstra: [
    "Against Dijkstra's search: less time, and the path is as good.",
    "与 Dijkstra 相比：计算时间更短，路径质量相当。",
  ],
  genetic: [
    "Against a genetic algorithm: less time, and the result is more stable.",
    "与遗传算法相比：计算时间更短，结果更稳定。",
  ],
  RRTFound: [
    "RRT's median path over {seeds} seeds is longer, or there is none, in {longer} of {scenes} scenes; where it finds least, {least} of {seeds} seeds have a path. Time is not judged.",
    "在 {scenes} 个场景中的 {longer} 个，RRT 在 {seeds} 个种子上的中位路径更长或没有路径；最差的场景中 {seeds} 个种子仅 {least} 个找到路径。不判定时间。",
  ],
  DijkstraFound: [
    "Fewer cells are expanded in {fewer} of {scenes} scenes; the path is at most 3 % longer in {alike}. Time is not judged.",
    "在 {scenes} 个场景中的 {fewer} 个扩展栅格更少；其中 {alike} 个的路径至多长 3 %。不判定时间。",
  ],
  geneticFound: [
    "Over {seeds} seeds the genetic algorithm's length varies, or a path is missing, in {varied} of {scenes} scenes; ours is the same each time. Time is not judged.",
    "在 {scenes} 个场景中的 {varied} 个，遗传算法在 {seeds} 个种子上的长度不一或找不到路径；本方法每次相同。不判定时间。",
  ],
});

export const claimOf = (lang: Lang, { id }: ComparedClaim): string => say(lang, id);
export const foundOf = (lang: Lang, { id, found }: ComparedClaim): string => say(lang, `${id}Found`, found);

/** A median, and the ends of the range where they differ. */
export function spanText(span: Span | null, digits: number, write: (value: number, digits: number) => string): string {
  if (!span) return "–";
  const [median, least, most] = span.map((value) => write(value, digits)) as [string, string, string];
  return least === most ? median : `${median} (${least}–${most})`;
}

/** The columns of the comparison besides scene and planner. */
export const COLUMNS = ["found", "collide", "length", "turning", "clearance", "hits", "expanded"] as const;

export function cellOf(
  one: Compared,
  column: (typeof COLUMNS)[number],
  write: (value: number, digits: number) => string,
): string {
  switch (column) {
    case "found":
      return one.asked === 1 ? String(one.found) : `${one.found} / ${one.asked}`;
    case "collide":
      return String(one.collide);
    case "length":
      return spanText(one.length, 1, write);
    case "turning":
      return spanText(one.turning, 0, write);
    case "clearance":
      return spanText(one.clearance, 2, write);
    case "hits":
      return one.hits === null ? "–" : String(one.hits);
    case "expanded":
      return spanText(one.expanded, 0, write);
  }
}

/** The default of each setting that is swept. */
const DEFAULTS: Record<Swept, number> = {
  alpha: 0.3,
  beta: 0.5,
  factor: 0.8,
  epsilon: 0.2,
  decay: 1.5,
  margin: 0.8,
  threshold: 0.8,
  resolution: 1,
};

/** A row of charts a setting, a column a figure, a line a scene. */
export function chartsOf(
  lang: Lang,
  sweeps: readonly { swept: Swept; scene: string; samples: readonly Sample[] }[],
): Chart[] {
  return (Object.keys(SWEPT) as Swept[]).flatMap((swept) =>
    MEASURED.map((figure) => ({
      row: say(lang, swept),
      column: say(lang, figure),
      mark: DEFAULTS[swept],
      lines: sweeps
        .filter((one) => one.swept === swept)
        .map(({ scene, samples }) => ({
          name: scene,
          points: samples.map(({ value, figures }) => [value, figures[figure]] as const),
        })),
    })),
  );
}
