/** Measures the road manuscript's tables again, a scene per worker. */
import type { RoadTable } from "parkade";
import { workersHere, type Progress } from "./crew";
import { Helper } from "./helper";
import type { Engine } from "./module";

export class RoadPapers {
  private helpers: Helper[] = [];

  constructor(private readonly engine: Engine) {}

  get running(): boolean {
    return this.helpers.length > 0;
  }

  /** Measures every scene, telling those there are, in their order, whenever there is one more. */
  async measure(told: (progress: Progress, tables: RoadTable[]) => void): Promise<void> {
    this.stop();
    const helpers = (this.helpers = Array.from({ length: workersHere() }, () => new Helper(this.engine)));
    try {
      const rows = await helpers[0]!.call("roadRows", undefined as never);
      const order = rows.map(({ id }) => id), waiting = [...order], tables = new Map<string, RoadTable>();
      const tell = (): void => told({ done: tables.size, of: order.length }, order.flatMap((id) => tables.get(id) ?? []));
      tell();
      await Promise.all(helpers.map(async (helper) => {
        for (let row = waiting.shift(); row; row = waiting.shift()) {
          tables.set(row, await helper.call("road", { row }));
          if (this.helpers === helpers) tell();
        }
      }));
    } catch (error) {
      if (this.helpers === helpers) throw error;
    } finally {
      if (this.helpers === helpers) this.stop();
    }
  }

  stop(): void {
    const { helpers } = this;
    this.helpers = [];
    for (const helper of helpers) helper.stop();
  }
}
