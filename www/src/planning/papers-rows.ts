/** Measures a paper's tables again, a row per worker. */
import type { PaperClaim, ParkingTable, RoadTable } from "parkade";
import { workersHere, type Progress } from "./worker-count";
import { Helper } from "./job-client";
import type { Engine } from "./engine-loader";
import { nth } from "../scene/nth";

export interface Tables {
  road: RoadTable;
  parking: ParkingTable;
}

export class RowPapers<Name extends keyof Tables> {
  private helpers: Helper[] = [];

  constructor(
    private readonly engine: Engine,
    private readonly name: Name,
  ) {}

  get running(): boolean {
    return this.helpers.length > 0;
  }

  /** Measures every row, telling those there are, in their order, whenever there is one more. */
  async measure(told: (progress: Progress, tables: Tables[Name][]) => void): Promise<void> {
    this.stop();
    const helpers = (this.helpers = Array.from({ length: workersHere() }, () => new Helper(this.engine)));
    try {
      const rows = await nth(helpers, 0).call(`${this.name}Rows`, undefined as never);
      const order = rows.map(({ id }) => id),
        waiting = [...order],
        tables = new Map<string, Tables[Name]>();
      const tell = (): void =>
        told(
          { done: tables.size, of: order.length },
          order.flatMap((id) => tables.get(id) ?? []),
        );
      tell();
      await Promise.all(
        helpers.map(async (helper) => {
          for (let row = waiting.shift(); row; row = waiting.shift()) {
            tables.set(row, (await helper.call(this.name, { row })) as Tables[Name]);
            if (this.helpers === helpers) tell();
          }
        }),
      );
    } catch (error) {
      if (this.helpers === helpers) throw error;
    } finally {
      if (this.helpers === helpers) this.stop();
    }
  }

  /** What is judged of all tables; nothing while some are missing. */
  async claims(tables: readonly Tables[Name][]): Promise<readonly PaperClaim[]> {
    const helper = new Helper(this.engine);
    try {
      return (await helper.call("verdicts", { [this.name]: tables }))[this.name];
    } finally {
      helper.stop();
    }
  }

  stop(): void {
    const { helpers } = this;
    this.helpers = [];
    for (const helper of helpers) helper.stop();
  }
}
