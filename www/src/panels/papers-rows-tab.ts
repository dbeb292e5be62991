import type { PaperClaim } from "parkade";
import { nothing, type TemplateResult } from "lit";
import type { Values } from "../i18n/index";
import { workersHere, type Progress } from "../planning/worker-count";
import { RowPapers, type Tables } from "../planning/papers-rows";
import { PapersTab } from "./papers-tab";

/** Measurements of a paper, kept while the page is open. */
export class Measured<Name extends keyof Tables> {
  papers: RowPapers<Name> | null = null;
  tables: Tables[Name][] | null = null;
  /** Judged when all tables are there. */
  claims: readonly PaperClaim[] = [];

  constructor(readonly name: Name) {}
}

/** A paper whose tables are measured one by one. */
export abstract class PapersRowsTab<Name extends keyof Tables> extends PapersTab<Tables[Name][]> {
  constructor(private readonly measured: Measured<Name>) {
    super();
    this.summary = measured.tables;
  }

  leave(): void {
    this.measured.papers?.stop();
  }

  protected get claims(): readonly PaperClaim[] {
    return this.running ? [] : this.measured.claims;
  }

  protected abstract say(key: "progress" | "cancelled", values: Values): string;
  protected abstract tables(tables: Tables[Name][]): TemplateResult;

  protected get running(): boolean {
    return this.measured.papers?.running ?? false;
  }

  protected override render(): TemplateResult {
    return this.frame(this.button(), this.summary ? this.tables(this.summary) : nothing);
  }

  protected told({ done, of }: Progress): string {
    return this.say("progress", { done, of, workers: workersHere() });
  }

  protected cancelled(done: number): string {
    return this.say("cancelled", { done });
  }

  protected async work(): Promise<void> {
    const { measured } = this;
    measured.papers ??= new RowPapers(await this.app.complete(), measured.name);
    await measured.papers.measure((progress, tables) => {
      this.progress = progress;
      if (tables.length > 0) this.summary = measured.tables = tables;
    });
    if (measured.papers) measured.claims = await measured.papers.claims(measured.tables ?? []);
  }
}
