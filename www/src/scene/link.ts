import { pack, unpack } from "./link-codec";
import { checkScene } from "./files";
import { bounded } from "./foreign";
import { ensureIds } from "./model";
import type { Scenario } from "./scenario";
import { fitsLink } from "./large-scene";
import { nth } from "./nth";
import { isRecord } from "./records";
import { refused } from "../i18n/refusal";

const VERSION = "1";
/** A few kilobytes can inflate to gigabytes; no link's scene needs more than this. */
const LARGEST = 2 * 1024 * 1024;

export async function encodeScene(scene: Scenario): Promise<string> {
  const text = new TextEncoder().encode(JSON.stringify(pack(scene)));
  return VERSION + toBase64Url(await collect(stream(text).pipeThrough(new CompressionStream("deflate-raw")), Infinity));
}

/** Rejects with a sentence for people where the text is no scene. What follows an `&` is not about the scene. */
export async function decodeScene(link: string): Promise<Scenario> {
  const text = nth(link.split("&", 1), 0);
  if (!text.startsWith(VERSION)) throw refused`This link was made by a version this page does not read.`;
  let data: unknown;
  try {
    const bytes = fromBase64Url(text.slice(VERSION.length));
    const plain = await collect(stream(bytes).pipeThrough(new DecompressionStream("deflate-raw")), LARGEST);
    data = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(plain));
  } catch {
    throw refused`This link is damaged or cut off.`;
  }
  if (!isRecord(data)) throw refused`This link holds no scene.`;
  const scene = checkScene(unpack(data, (bare) => ensureIds(bounded(bare))));
  if (!fitsLink(scene)) throw refused`This link holds more cells than a link can.`;
  return scene;
}

type Bytes = Uint8Array<ArrayBuffer>;

const stream = (bytes: Bytes): ReadableStream<Bytes> =>
  new ReadableStream({
    start(controller) {
      controller.enqueue(bytes);
      controller.close();
    },
  });

async function collect(source: ReadableStream<Uint8Array>, limit: number): Promise<Bytes> {
  const chunks: Uint8Array[] = [];
  let size = 0;
  const reader = source.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    size += part.value.length;
    if (size > limit) {
      await reader.cancel();
      throw new Error("too large");
    }
    chunks.push(part.value);
  }
  const all = new Uint8Array(size);
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}

function toBase64Url(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

function fromBase64Url(text: string): Bytes {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (c) => c.charCodeAt(0));
}
