/** Pictures as the browser decodes them. */
import type { Lang } from "../i18n";
import messages from "../i18n/messages/image-decode.json";
import { translator } from "../i18n/translator";
import type { Pixels } from "./image";

const say = translator("imageDecode", messages);

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

/**
 * The picture of a map server's description, in the form that importing reads: lightness is the mean of the colours.
 */
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
