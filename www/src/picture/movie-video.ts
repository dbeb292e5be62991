/** Moving pictures as video, by the browser's own encoder. */
import { refused } from "../i18n/refusal";
import type { Container, Movie } from "./movie-format";

/**
 * What each container may hold, what is best first: names as encoders and as containers know them. Level 4 is 1080p.
 */
const CODECS = {
  webm: [
    ["vp09.00.40.08", "vp9"],
    ["vp8", "vp8"],
  ],
  mp4: [
    ["avc1.640028", "avc"],
    ["avc1.420028", "avc"],
    ["vp09.00.40.08", "vp9"],
  ],
} as const;

/** Bits a pixel: thin lines stay sharp. */
const BITS = 0.15;
/** Seconds from one frame that needs no other to the next. */
const KEY_EVERY = 2;
/** Frames that wait for the encoder at most. */
const QUEUE = 4;

type Size = Pick<Movie, "width" | "height" | "rate">;

async function encoding(format: Container, { width, height, rate }: Size) {
  for (const [codec, name] of CODECS[format]) {
    const config = { codec, width, height, framerate: rate, bitrate: Math.round(width * height * rate * BITS) };
    const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
    if (supported) return { config, name };
  }
  return null;
}

/** True if this browser encodes the format. */
export const canEncodeVideo = async (format: Container): Promise<boolean> =>
  (await encoding(format, { width: 1280, height: 720, rate: 25 })) !== null;

/** Encodes what is drawn on the canvas; null where it was stopped. */
export async function encodeVideo(
  movie: Movie,
  format: Container,
  canvas: HTMLCanvasElement,
  tell: (done: number) => boolean,
): Promise<Blob | null> {
  const { frames, rate, draw } = movie,
    found = await encoding(format, movie);
  if (!found) throw refused`This browser encodes no such video.`;
  const muxer = new (await import("./movie-muxer")).Muxer(format);
  await muxer.start(found.name, rate);
  let failure: unknown = null,
    written = Promise.resolve();
  const encoder = new VideoEncoder({
    output: (chunk, meta) => {
      written = written.then(() => muxer.add(chunk, meta));
    },
    error: (error) => {
      failure = error;
    },
  });
  encoder.configure(found.config);
  try {
    for (let i = 0; i < frames; i++) {
      draw(canvas, i);
      const frame = new VideoFrame(canvas, { timestamp: (i * 1e6) / rate, duration: 1e6 / rate });
      encoder.encode(frame, { keyFrame: i % (KEY_EVERY * rate) === 0 });
      frame.close();
      while (encoder.encodeQueueSize > QUEUE && !failure)
        await new Promise((done) => encoder.addEventListener("dequeue", done, { once: true }));
      if (failure) throw failure;
      if (!tell(i / frames)) return null;
    }
    await encoder.flush();
    await written;
    if (failure) throw failure;
    return new Blob([await muxer.finish()], { type: `video/${format}` });
  } finally {
    if (encoder.state !== "closed") encoder.close();
  }
}
