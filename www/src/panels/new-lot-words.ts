/** The words of the form for a new lot. */
import type { Lang } from "../i18n/index";
import { words } from "../i18n/words";
import { LIMITS, type LotFault, type NumberField } from "../scene/lot";

export const say = words({
  title: ["New lot", "新建停车场"],
  ground: ["Ground", "场地"],
  bays: ["Bays", "车位"],
  obstacles: ["Obstacles", "障碍"],
  vehicle: ["Vehicle", "车辆"],
  width: ["Width", "宽度"],
  depth: ["Depth", "深度"],
  kind: ["Kind", "类型"],
  perpendicular: ["Perpendicular", "垂直"],
  parallel: ["Parallel", "平行"],
  angled: ["Angled", "斜列"],
  angle: ["Angle", "角度"],
  count: ["Bays in a row", "每排车位"],
  bayWidth: ["Bay width", "车位宽"],
  bayLength: ["Bay length", "车位长"],
  sides: ["Rows", "排列"],
  one: ["One side", "单侧"],
  both: ["Both sides", "双侧"],
  aisles: ["Aisles", "通道数"],
  aisle: ["Aisle width", "通道宽"],
  parked: ["Parked cars", "停放车辆"],
  every: ["Column every", "立柱间隔"],
  column: ["Column size", "立柱边长"],
  wall: ["Rear wall", "排后墙厚"],
  entrance: ["Entrance", "入口"],
  left: ["Left", "左"],
  right: ["Right", "右"],
  bottom: ["Bottom", "下"],
  top: ["Top", "上"],
  entry: ["Parks", "停入方式"],
  "reverse-in": ["Reverse-in", "倒车入库"],
  "head-in": ["Head-in", "车头入库"],
  car: ["Car", "车型"],
  sedan: ["Sedan", "轿车"],
  paper: ["Paper", "论文"],
  own: ["Own", "自定"],
  carLength: ["Length", "车长"],
  carWidth: ["Car width", "车宽"],
  wheelbase: ["Wheelbase", "轴距"],
  radius: ["Turning radius", "转弯半径"],
  auto: ["Back to automatic", "恢复自动"],
  groundIs: ["{width} × {depth} m", "{width} × {depth} m"],
  baysAre: ["{n} {kind}, {width} × {length} m", "{n} 个{kind}，{width} × {length} m"],
  parkedCars: ["{n} parked {n|car|cars}", "停放 {n} 辆"],
  walls: ["walls", "有墙"],
  columns: ["columns", "有立柱"],
  carIs: ["{car}, {length} × {width} m", "{car}，{length} × {width} m"],
  lot: ["Lot and planned path", "停车场与规划路径"],
  open: ["Open", "打开"],
  cancel: ["Cancel", "取消"],
  close: ["Close", "关闭"],
  planning: ["Planning into bay {bay} …", "正在规划驶入 {bay} 号车位 …"],
  reaches: ["Into bay {bay}: {length} m, {n} gear {n|change|changes}", "驶入 {bay} 号车位：{length} m，换挡 {n} 次"],
  noWay: ["The car cannot get into bay {bay}. A wider aisle or longer bays help.", "车辆无法驶入 {bay} 号车位。可加宽通道或加长车位。"],
  failed: ["The preview could not be planned: {reason}", "无法规划预览：{reason}"],
  limits: ["{field} must be between {least} and {most}.", "{field}须在 {least} 与 {most} 之间。"],
  least: ["{field} must be at least {least} m here.", "{field}在此至少为 {least} m。"],
  shorter: ["Wheelbase must be shorter than the car, {least} m.", "轴距须小于车长 {least} m。"],
  free: ["Parked cars fill every bay. Leave one free for the goal.", "车位全部停满，请为目标留出一个。"],
  groundWidth: ["Width of the ground must be at least {least} m for these rows. Widen it, or take fewer bays.", "按此排列，场地宽度至少为 {least} m。请加宽场地或减少车位。"],
  groundDepth: ["Depth of the ground must be at least {least} m for these rows. Deepen it, or take fewer aisles.", "按此排列，场地深度至少为 {least} m。请加深场地或减少通道。"],
});

/** What to change, in one sentence. */
export function faultText(lang: Lang, { field, rule, least }: LotFault): string {
  const most = field in LIMITS ? LIMITS[field as NumberField][1] : least;
  if (rule === "least" && field === "width") return say(lang, "groundWidth", { least });
  if (rule === "least" && field === "depth") return say(lang, "groundDepth", { least });
  return say(lang, rule, { field: say(lang, field as NumberField), least, most });
}
