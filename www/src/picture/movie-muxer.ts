/** Encoded frames into the file of a container. */
import {
  BufferTarget,
  EncodedPacket,
  EncodedVideoPacketSource,
  Mp4OutputFormat,
  Output,
  type VideoCodec,
  WebMOutputFormat,
} from "mediabunny";
import type { Container } from "./movie-format";

export class Muxer {
  private readonly target = new BufferTarget();
  private readonly output: Output;
  private source: EncodedVideoPacketSource | null = null;

  constructor(container: Container) {
    const format = container === "mp4" ? new Mp4OutputFormat() : new WebMOutputFormat();
    this.output = new Output({ format, target: this.target });
  }

  async start(codec: VideoCodec, rate: number): Promise<void> {
    this.source = new EncodedVideoPacketSource(codec);
    this.output.addVideoTrack(this.source, { frameRate: rate });
    await this.output.start();
  }

  async add(chunk: EncodedVideoChunk, meta?: EncodedVideoChunkMetadata): Promise<void> {
    await this.source!.add(EncodedPacket.fromEncodedChunk(chunk), meta);
  }

  async finish(): Promise<ArrayBuffer> {
    await this.output.finalize();
    return this.target.buffer!;
  }
}
