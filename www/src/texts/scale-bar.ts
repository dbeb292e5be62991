/** The map's scale: a round length at the lower left. */
import { number, type Lang } from "../i18n/index";
import { LOW_MAP, type View } from "../view/camera";

const LONGEST_PX = 110;
/** Maps narrower than this have no room for it, CSS pixels. */
const NARROWEST = 220;

/** The longest of 1, 2, 5, 10, … metres that is not longer than the bar may be. */
export function barLength(scale: number): number {
  const most = LONGEST_PX / scale,
    ten = 10 ** Math.floor(Math.log10(most));
  return ten * ([5, 2].find((times) => times * ten <= most) ?? 1);
}

/** Puts the bar into a map, or in step with its camera. */
export function showScale(root: ParentNode, { camera: { scale }, width, height }: View, lang: Lang): void {
  const bar = root.querySelector<HTMLElement>(".scale");
  if (!bar) return;
  const metres = barLength(scale),
    digits = Math.max(0, -Math.floor(Math.log10(metres)));
  const text = metres < 1000 ? `${number(lang, metres, digits)} m` : `${number(lang, metres / 1000, 0)} km`;
  bar.hidden = width < NARROWEST || height < LOW_MAP;
  if (bar.textContent !== text) bar.textContent = text;
  bar.style.setProperty("--length", `${metres * scale}px`);
}
