/** Pictures as the browser decodes them. */
import type { Lang } from "../i18n";
import { words } from "../i18n/words";
import type { Pixels } from "./image";

const say = words({
  large: [
    "the image has {width} × {height} pixels; the limit is 8192 per side.",
    "图片为 {width} × {height} 像素；每边不得超过 8192。",
  ],
  clear: [
    "{name} has transparent pixels, which are neither floor nor wall. Save it without transparency.",
    "{name} 含透明像素，无法判断是空地还是墙。请去除透明后再保存。",
  ],
});

const MOST = 8192;

/** Fails in the reader's language where there are too many. */
export async function pixelsOf(file: File, lang: Lang): Promise<Pixels> {
  const bitmap = await createImageBitmap(file, { colorSpaceConversion: "none" }),
    { width, height } = bitmap;
  try {
    if (Math.max(width, height) > MOST) throw new Error(say(lang, "large", { width, height }));
    const canvas = document.createElement("canvas");
    canvas.width = width;
    canvas.height = height;
    const ctx = canvas.getContext("2d", { willReadFrequently: true })!;
    ctx.drawImage(bitmap, 0, 0);
    return ctx.getImageData(0, 0, width, height);
  } finally {
    bitmap.close();
  }
}

/** The picture of a map server's description, in the form that importing reads: lightness is the mean of the colours. */
export async function pgmOf(file: File, lang: Lang): Promise<readonly [string, Uint8Array<ArrayBuffer>]> {
  const { width, height, data } = await pixelsOf(file, lang);
  const head = new TextEncoder().encode(`P5 ${width} ${height} 255\n`),
    bytes = new Uint8Array(head.length + width * height);
  bytes.set(head);
  for (let i = 0, at = head.length; i < data.length; i += 4, at++) {
    if (data[i + 3] !== 255) throw new Error(say(lang, "clear", { name: file.name }));
    bytes[at] = Math.round((data[i]! + data[i + 1]! + data[i + 2]!) / 3);
  }
  return [file.name.replace(/\.\w+$/, ".pgm"), bytes];
}
