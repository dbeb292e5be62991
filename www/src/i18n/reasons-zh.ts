/** Chinese for the reasons that the planners, importers and links give: a catalogue by their English templates. `{}` is a value. */
type Entry = readonly [en: string, zh: string];

const ENTRIES: readonly Entry[] = [
  ["must be an object", "须为对象"],
  ["must be an array", "须为数组"],
  ["must be a string", "须为字符串"],
  ["must be text", "须为文本"],
  ["must be text in UTF-8", "须为 UTF-8 文本"],
  ["must be a number", "须为数值"],
  ["must be a finite number", "须为有限数值"],
  ["must be finite, within ±{} m", "须为有限值且在 ±{} m 以内"],
  ["must be a whole number", "须为整数"],
  ["must be a whole number from {}", "须为不小于 {} 的整数"],
  ["must be a whole number from {} to {}", "须为 {} 到 {} 的整数"],
  ["must be true or false", "须为 true 或 false"],
  ["must be given", "不可缺少"],
  ["must be positive, at most {}", "须为正数且不超过 {}"],
  ["must be positive", "须为正数"],
  ["must be between {} and {}", "须在 {} 与 {} 之间"],
  ["must be below {}", "须小于 {}"],
  ["must be {} to {} each, one at least", "两个方向各须为 {} 到 {}，且至少有一条车道"],
  ["must be at least {} and less than π/2", "须不小于 {} 且小于 π/2"],
  ["must be at least {} for {} s", "时长 {1} s 时须不小于 {0}"],
  ["must be at most {} m wide and high where a car is to drive", "有车辆行驶时，宽与高均不得超过 {} m"],
  ["must be at most {} m long", "长度不得超过 {} m"],
  ["must be at most {}, less than a full circle", "不得超过 {}，且小于整圆"],
  ["must be one of {}", "须为下列之一：{}"],
  ["must be one per pose ({})", "须与位姿数一致（{}）"],
  ["must be x, y, heading for each pose", "每个位姿须含 x、y、heading"],
  ["must be unique, {} is {} too", "不得重复：{} 与 {} 相同"],
  ["must be a number of cells or {}", "须为格数或 {}"],
  ["must be the id of a slot", "须为已有车位的 id"],
  ["must be inside the map", "须在地图之内"],
  ["must be about {}", "须约为 {}"],
  ["must be blocked or free", "须为 blocked 或 free"],
  ["must be empty for {}, for which all free cells cost the same", "对 {} 须为空：该规划器的所有空闲格代价相同"],
  ["must be driven within {} s, takes {} s", "须在 {} s 内驶完，实际需要 {} s"],
  ["must be a scene with its version, or hold lots", "须为带版本号的场景或停车场集合"],
  ["must be a run inside a row", "须为一行之内的连续格段"],
  ["must be a digit of Base64", "须为 Base64 字符"],
  ["must be left out: {}", "不应给出：{}"],
  ["must be the only {} file", "只能有一个 {} 文件"],
  ["must be the end, after {} rows", "在 {} 行之后应结束"],
  ["must be the end, after {} questions", "在 {} 个查询之后应结束"],
  ["must be {} cells", "须为 {} 格"],
  ["must be 0 for maps without questions", "不含查询的地图须为 0"],
  ["must be {} without the complete module", "未加载完整模块时须为 {}"],
  ["must be plain data", "须为普通数据"],
  ["must be {} with {} neighbours", "{1} 邻域时须为 {0}"],
  ["must be {} to {} m", "须为 {} 到 {} m"],
  ["must be {} to {} s", "须为 {} 到 {} s"],
  ["must be {} to {}", "须为 {} 到 {}"],
  ["must be {} or {}", "须为 {} 或 {}"],
  ["must be {}", "须为 {}"],
  ["must begin with {}", "开头须为 {}"],
  ["must belong to {}", "须属于 {}"],
  ["must come after the map's {}", "须位于地图的 {} 之后"],
  ["must come with its picture {}; there are others", "须与图片 {} 一同打开；现有的是其他图片"],
  ["must come with its picture {} as a {} file", "须与图片 {}（{} 格式）一同打开"],
  ["must come with its picture {}", "须与图片 {} 一同打开"],
  ["must come with the .map file that it names", "须与其指定的 .map 文件一同打开"],
  ["must come with the .yaml file that describes it", "须与描述它的 .yaml 文件一同打开"],
  ["must differ from the corner before it", "不得与前一个角点重合"],
  ["must differ from the point before it", "不得与前一个点重合"],
  ["must drive at most {} m together", "合计行驶不得超过 {} m"],
  ["must enclose an area", "须围成一个区域"],
  ["must end a number of at most {} bits", "数值不得超过 {} 位二进制"],
  ["must end after {} numbers, the last corner", "在第 {} 个数（最后一个角点）之后应结束"],
  ["must end in {}", "文件名须以下列之一结尾：{}"],
  ["must end the file, which may have {} bytes and has {}", "文件不得超过 {} 字节，实际有 {} 字节"],
  ["must end with a whole run", "末尾须为完整的格段"],
  ["must give a map with a way through", "须生成有通路的地图"],
  ["must have a free cell", "须有空闲格"],
  ["must have a path on every map", "在每张地图上都须有路径"],
  ["must have at most {} bytes", "不得超过 {} 字节"],
  ["must have at most {} cells a side, has {} × {} when turned upright", "每边不得超过 {} 格，转正后为 {} × {}"],
  ["must have no corners, turns on the spot at {}", "不得有折角，在 {} 处原地转向"],
  ["must have poses; a plan without a path cannot be driven", "须有位姿；没有路径的规划无法行驶"],
  ["must have poses; there is nothing to measure", "须有位姿；没有可测量的内容"],
  ["must have {} to {} points", "须有 {} 到 {} 个点"],
  ["must have {} figures per map", "每张地图须有 {} 个数值"],
  ["must have {} characters", "须有 {} 个字符"],
  ["must have {} fields", "须有 {} 个字段"],
  ["must have {} items", "须有 {} 项"],
  ["must hold a file", "须包含文件"],
  ["must hold a question", "须包含查询"],
  ["must hold {} × {} values, only {} bytes are left", "须有 {} × {} 个值，只剩 {} 字节"],
  ["must leave room to keep the limits of the way", "须留有余地以遵守路段限速"],
  ["must lie on the {} × {} map", "须在 {} × {} 的地图之内"],
  ["must not cross itself: edges {} and {} meet", "不得自相交：第 {} 条边与第 {} 条边相交"],
  ["must say its resolution", "须给出分辨率"],
  ["must turn less or have longer ways beside it: the middle's radius is {} m, half the road {} m wide", "须减小转角或加长两侧路段：中心线半径 {} m，半幅路宽 {} m"],
  ["must turn no tighter than {} 1/m, turns {}", "曲率不得超过 {} 1/m，实际为 {}"],
  ["must turn no tighter", "转弯不得更急"],
  ["{} at line {} column {}", "JSON 语法错误，第 {1} 行第 {2} 列"],
  ["no option of importScene; there are {}", "importScene 没有此选项；可用选项：{}"],
  ["no setting of {}", "{} 没有此设置"],
  ["no planner {}; there are {}", "没有规划器 {}；可用：{}"],
  ["no scene {}; there are {}", "没有场景 {}；可用：{}"],
  ["This link was made by a version this page does not read", "此链接由本页不支持的版本生成"],
  ["This link is damaged or cut off", "此链接已损坏或不完整"],
  ["This link is damaged: {}", "此链接已损坏或不完整"],
  ["This link holds more cells than a link can", "此链接包含的栅格数超过链接允许的上限"],
  ["This link holds no scene", "此链接中没有场景"],
  ["This is not a scene: the file is not JSON", "这不是场景文件：内容不是 JSON"],
  ["This is not a scene: an object is expected", "这不是场景：应为对象"],
  ["This scene has a version this page does not read; {} is expected", "本页不支持此场景的版本；应为 {}"],
  ["This scene has no map: origin, width, height and resolution are expected", "此场景没有地图：应有 origin、width、height、resolution"],
  ["This scene has no start pose: x, y and heading are expected", "此场景没有起点位姿：应有 x、y、heading"],
  ["This scene has no goal: a pose or a slot is expected", "此场景没有目标：应为位姿或车位"],
  ["This scene's {} are not a list", "此场景的 {} 不是列表"],
  ["this drawing holds no scene; only those saved here do", "此矢量图中没有场景；只有在此处保存的才有"],
  ["the server answered {} for the planners' module", "请求规划器模块时服务器返回 {}"],
  ["{}: the server answered {}", "{}：服务器返回 {}"],
  ["This browser gives no 2D canvas", "此浏览器不支持二维画布"],
  ["Failed to fetch{}", "网络请求失败"],
  ["Load failed", "网络请求失败"],
  ["The source image could not be decoded", "图片无法解码"],
];
/** Values that are words themselves. */
const VALUES: Readonly<Record<string, string>> = {
  "the end of the file": "文件结尾", "its own resolution": "自带分辨率", "the file says its own": "文件中已有",
  "only random maps have it": "仅随机地图有此项", "a .yaml file says its own": ".yaml 文件中已有", "a number": "数值",
  "a whole number": "整数", "nothing": "空",
};

const PATTERNS = ENTRIES.map(([en, zh]) =>
  [new RegExp(`^${en.split("{}").map((part) => part.replace(/[.*+?^$()[\]{}|\\]/g, "\\$&")).join("(.*?)")}$`), zh] as const);

/** A reason in Chinese; what the catalogue does not have stays as it is. */
export function chineseReason(text: string): string {
  const [, path = "", rest = text] = /^([\w.[\]]+: )?(.*)$/s.exec(text) ?? [];
  const [, body = rest, got] = /^(.*?)(?:, got (.*?))?[.]?$/s.exec(rest) ?? [];
  const said = sentenceOf(body);
  if (said === undefined) return path && text !== rest ? text : sentenceOf(text.replace(/\.$/, "")) ?? text;
  return `${path.replace(": ", "：")}${said}${got === undefined ? "" : `，实际为 ${valueOf(got)}`}。`;
}

function sentenceOf(body: string): string | undefined {
  for (const [pattern, zh] of PATTERNS) {
    const values = pattern.exec(body)?.slice(1).map(valueOf);
    let next = 0;
    if (values) return zh.replace(/\{(\d?)\}/g, (_, at: string) => values[at ? Number(at) : next++] ?? "");
  }
  return undefined;
}

const valueOf = (text: string): string =>
  VALUES[text] ?? text.replace(/^(\d+) numbers$/, "$1 个数").replace(/^(\d+) cells at /, "$1 格，位于 ").replace(/,? or (?=\S+$)/, " 或 ");
