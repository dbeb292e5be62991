/** Measures the papers' tables again in several workers, a few seeds at a time. */
import type { PaperClaim, PaperRow, PaperTable } from "parkade";
import { workersHere, type Progress } from "./worker-count";
import { Helper } from "./job-client";
import type { Engine } from "./engine-loader";
import { median } from "./medians";
import { nth } from "../scene/nth";

/** `times`: mean milliseconds per row and planner. */
export interface Summary {
  tables: PaperTable[];
  claims: PaperClaim[];
  times: Record<string, number[]>;
}
export interface Seeds {
  from: number;
  to: number;
}

interface Slice extends Seeds {
  row: PaperRow;
}

/** Cells whose searches take about as long as a worker should be silent. */
const SLICE_CELLS = 30_000;
const SUMMARY_MS = 400;
const CLOCK_STEP_MS = 0.1;

/** Figures are kept map by map: a wider range measures only what is missing. */
export class Papers {
  rows: PaperRow[] = [];
  planners: string[] = [];
  columns: string[] = [];
  private readonly figures = new Map<string, Map<number, Float64Array>>();
  private helpers: Helper[] = [];

  constructor(private readonly engine: Engine) {}

  get running(): boolean {
    return this.helpers.length > 0;
  }

  /** Measures every row on the maps of these seeds; resolves to false where it was stopped. */
  async measure(seeds: Seeds, told: (progress: Progress, summary: Summary | null) => void): Promise<boolean> {
    this.stop();
    const helpers = (this.helpers = Array.from({ length: workersHere() + 1 }, () => new Helper(this.engine)));
    const [clerk, ...crew] = helpers as [Helper, ...Helper[]];
    try {
      ({
        rows: this.rows,
        planners: this.planners,
        columns: this.columns,
      } = await clerk.call("rows", undefined as never));
      const of = this.rows.length * (seeds.to - seeds.from + 1);
      const slices = this.missing(seeds);
      let done = of - slices.reduce((sum, one) => sum + one.to - one.from + 1, 0),
        shown = 0,
        asking = false;
      const tell = async (): Promise<void> => {
        told({ done, of }, null);
        if (asking || performance.now() - shown < SUMMARY_MS) return;
        asking = true;
        const summary = await this.summary(clerk, seeds);
        asking = false;
        shown = performance.now();
        if (summary && this.helpers === helpers) told({ done, of }, summary);
      };
      told({ done, of }, null);
      await Promise.all(
        crew.map(async (helper) => {
          for (let slice = slices.shift(); slice; slice = slices.shift()) {
            this.keep(slice, await helper.call("paper", { row: slice.row.id, from: slice.from, to: slice.to }));
            done += slice.to - slice.from + 1;
            void tell().catch(() => undefined);
          }
        }),
      );
      told({ done, of }, await this.summary(clerk, seeds));
      return true;
    } catch (error) {
      if (this.helpers !== helpers) return false;
      throw error;
    } finally {
      if (this.helpers === helpers) this.stop();
    }
  }

  /** The seeds on which the literal risk field is incomplete, by row. */
  async incomplete(seeds: Seeds): Promise<Record<string, number[]>> {
    const helper = new Helper(this.engine);
    try {
      const found = this.rows.map(
        async ({ id }) => [id, await helper.call("incomplete", { row: id, ...seeds })] as const,
      );
      return Object.fromEntries(await Promise.all(found));
    } finally {
      helper.stop();
    }
  }

  /** Gives up what runs and keeps what is measured. */
  stop(): void {
    const helpers = this.helpers;
    this.helpers = [];
    for (const helper of helpers) helper.stop();
  }

  /** Small seeds of every row first, so that all tables fill together. */
  private missing({ from, to }: Seeds): Slice[] {
    const slices = this.rows.flatMap((row) => {
      const known = this.figures.get(row.id),
        most = Math.max(1, Math.floor(SLICE_CELLS / (row.size * row.size)));
      const list: Slice[] = [];
      for (let seed = from; seed <= to; seed++) {
        if (known?.has(seed)) continue;
        const last = list.at(-1);
        if (last && last.to === seed - 1 && last.to - last.from + 1 < most) last.to = seed;
        else list.push({ row, from: seed, to: seed });
      }
      return list;
    });
    return slices.sort((a, b) => a.from - b.from);
  }

  private keep({ row, from, to }: Slice, figures: Float64Array): void {
    const kept = this.figures.get(row.id) ?? new Map<number, Float64Array>();
    this.figures.set(row.id, kept);
    const width = figures.length / (to - from + 1);
    for (let i = 0; from + i <= to; i++) kept.set(from + i, figures.slice(i * width, (i + 1) * width));
  }

  /**
   * Browsers' clocks step by a tenth of a millisecond or more, longer than many searches take. Single times say nothing
   * then, and no claim is judged by them; but their mean says something: what one search loses to a step another one
   * gains. Times far beyond the others are the machine's, not the search's.
   */
  private takeTimes(figures: Float64Array): number[] {
    const {
        columns: { length: step },
        planners,
      } = this,
      width = step * planners.length,
      column = this.columns.indexOf("milliseconds");
    return planners.map((_, planner) => {
      const times: number[] = [];
      for (let i = planner * step + column; i < figures.length; i += width) {
        times.push(nth(figures, i));
        if (!crossOriginIsolated) figures[i] = 0;
      }
      const most = 3 * median(times) + 2 * CLOCK_STEP_MS;
      return times.reduce((sum, time) => sum + Math.min(time, most), 0) / times.length;
    });
  }

  private async summary(clerk: Helper, { from, to }: Seeds): Promise<Summary | null> {
    const measured: Record<string, Float64Array> = {},
      times: Summary["times"] = {};
    for (const { id } of this.rows) {
      const parts: Float64Array[] = [];
      for (let seed = from; seed <= to; seed++) {
        const part = this.figures.get(id)?.get(seed);
        if (part) parts.push(part);
      }
      if (parts.length === 0) continue;
      const width = nth(parts, 0).length;
      measured[id] = new Float64Array(parts.length * width);
      parts.forEach((part, i) => measured[id]!.set(part, i * width));
      times[id] = this.takeTimes(measured[id]);
    }
    if (Object.keys(measured).length === 0) return null;
    const { tables, claims } = await clerk.call("summary", measured);
    if (crossOriginIsolated) return { tables, claims, times };
    return {
      times,
      tables: tables.map((table) => ({
        ...table,
        ratios: table.ratios.filter(({ figure }) => figure !== "milliseconds"),
      })),
      claims: claims.map((claim) => ({ ...claim, figures: withoutTimes(claim.figures) })),
    };
  }
}

/** The clock is too coarse for them. */
const withoutTimes = (figures: PaperClaim["figures"]): PaperClaim["figures"] =>
  Object.fromEntries(Object.entries(figures).filter(([name]) => !name.startsWith("time")));
