/** Moving pictures as video, by the browser's own encoder. */
import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  QUALITY_HIGH,
  WebMOutputFormat,
} from "mediabunny";
import type { Movie } from "./movie";

type Container = "webm" | "mp4";

const CODECS = { webm: ["vp9", "vp8"], mp4: ["avc", "vp9"] } as const;

/** True if this browser encodes the format. */
export const canEncodeVideo = async (format: Container): Promise<boolean> =>
  (await getFirstEncodableVideoCodec([...CODECS[format]])) !== null;

/** Encodes what is drawn on the canvas; null where it was stopped. */
export async function encodeVideo(
  { width, height, frames, rate, draw }: Movie,
  format: Container,
  canvas: HTMLCanvasElement,
  tell: (done: number) => boolean,
): Promise<Blob | null> {
  const codec = await getFirstEncodableVideoCodec([...CODECS[format]], { width, height });
  if (!codec) throw new Error("This browser encodes no such video.");
  const target = new BufferTarget();
  const output = new Output({ format: format === "mp4" ? new Mp4OutputFormat() : new WebMOutputFormat(), target });
  const source = new CanvasSource(canvas, { codec, bitrate: QUALITY_HIGH });
  output.addVideoTrack(source, { frameRate: rate });
  await output.start();
  for (let i = 0; i < frames; i++) {
    draw(canvas, i);
    await source.add(i / rate, 1 / rate);
    if (!tell(i / frames)) {
      await output.cancel();
      return null;
    }
  }
  await output.finalize();
  return new Blob([target.buffer!], { type: format === "mp4" ? "video/mp4" : "video/webm" });
}
