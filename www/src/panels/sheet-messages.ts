import type { VehicleSpec } from "parkade";
import { number, type Lang } from "../i18n/index";
import messages from "../i18n/messages/site-sheet.json";
import { translator } from "../i18n/translator";
import { vehicleOf } from "../scene/vehicle";

export const say = translator("siteSheet", messages);

export function vehicleText(lang: Lang, spec: VehicleSpec | undefined): string {
  const car = vehicleOf(spec),
    metres = (value: number): string => number(lang, value, 2);
  return say(lang, "vehicleText", {
    length: metres(car.rearToFront + car.rearToBack),
    width: metres(car.width),
    wheelbase: metres(car.wheelbase),
    radius: metres(car.minTurningRadius),
  });
}

/** The day by the reader's clock. */
export const today = (lang: Lang): string =>
  new Date().toLocaleDateString(lang === "zh" ? "zh-CN" : "en-GB", { year: "numeric", month: "long", day: "numeric" });
