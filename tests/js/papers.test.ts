import { beforeAll, describe, expect, it } from "vitest";
import { markdown, pages, picture, type Page } from "../../docs/.vitepress/papers";

/** Two maps of each kind: what is held here does not depend on how many. */
const SEEDS = 2;
let en: Page[], zh: Page[];

beforeAll(async () => {
  [en, zh] = [await pages("en", SEEDS), await pages("zh", SEEDS)];
}, 300_000);

/** What is said of a page without its words. */
const skeletonOf = ({ id, blocks }: Page) => [
  id,
  ...blocks.map((block) => {
    switch (block.kind) {
      case "table":
        return ["table", block.head.length, block.rows.length];
      case "list":
        return ["list", block.items.length];
      case "figure":
        return ["figure", block.figure.id, block.figure.scene, block.figure.planners.join()];
      default:
        return block.kind;
    }
  }),
];

describe("the papers' pages", () => {
  it("have every table of the papers with results: 2 of the risk field, 10 of parking, 6 of roads", () => {
    const headings = (id: string) =>
      en.find((page) => page.id === id)!.blocks.flatMap((block) => (block.kind === "heading" ? [block.text] : []));
    expect(headings("risk-field").filter((one) => /^Table [34]: /.test(one)).length).toBe(6);
    expect(headings("parking").flatMap((one) => /^Table (\d+): /.exec(one)?.[1] ?? [])).toEqual([
      "2",
      "3",
      "4",
      "5",
      "6",
      "7",
      "8",
      "9",
      "10",
      "11",
    ]);
    expect(headings("road")).toEqual(
      expect.arrayContaining([
        "Path length, m",
        "Turning points",
        "Time, s",
        "Memory, MB",
        "Collisions of 1000 drives",
      ]),
    );
  });

  it("are the same in Chinese, and in Chinese words", () => {
    expect(zh.map(skeletonOf)).toEqual(en.map(skeletonOf));
    for (const { id, blocks } of zh) {
      const claims = blocks.find((block) => block.kind === "table")!;
      expect(
        claims.kind === "table" && claims.rows.every((row) => row.every((cell) => /[\u4e00-\u9fff]/.test(cell))),
        id,
      ).toBe(true);
      expect(
        blocks.every(
          (block) =>
            block.kind !== "heading" || /[\u4e00-\u9fff]/.test(block.text) || /^(regular|random)/.test(block.text),
        ),
        id,
      ).toBe(true);
    }
  });

  it("judge every claim", () => {
    const verdicts = en.flatMap(({ blocks }) =>
      blocks.flatMap((block) =>
        block.kind === "table" && block.head[1] === "verdict" ? block.rows.map((row) => row[1]!) : [],
      ),
    );
    expect(verdicts.length).toBeGreaterThanOrEqual(17);
    expect(verdicts.filter((one) => !/^(holds|holds in part|does not hold)$/.test(one))).toEqual([]);
  });

  it("draw every figure", () => {
    const figures = en.flatMap(({ blocks }) =>
      blocks.flatMap((block) => (block.kind === "figure" ? [block.figure] : [])),
    );
    expect(figures.map(({ id }) => id)).toEqual(
      expect.arrayContaining([
        "fig2",
        "stages",
        "potential",
        "fig8-30",
        "fig8-60",
        "fig8-100",
        "fig9-30",
        "fig9-60",
        "fig9-100",
        "fig4",
        "fig10",
        "fig11",
        "fig12",
        "fig13",
        "fig14",
        "fig15",
        "fig16",
        "road-fig1",
        "sensitivity",
        "band-road-narrow",
        "compared-road",
        "compared-grid",
      ]),
    );
    expect(figures.find(({ id }) => id === "road-fig1")!.svg!.match(/<rect/g)!.length).toBe(20);
    const drawn = (id: string): string => picture(figures.find((one) => one.id === id)!);
    expect(drawn("stages").match(/<circle/g)!.length).toBeGreaterThan(20);
    expect(drawn("potential").match(/<polyline/g)!.length).toBeGreaterThan(15);
    for (const mark of "ABCDSWE") expect(drawn("fig16")).toContain(`>${mark}</text>`);
    for (const { id } of figures.filter(({ scene }) => !scene.startsWith("road")))
      expect(drawn(id), id).toMatch(/^<svg [^]*<\/svg>\s*$/);
  }, 60_000);

  it("write a cell's bar so that its row keeps its columns", () => {
    expect(markdown([{ kind: "table", head: ["a", "b"], rows: [["x|y", "z"]] }], () => "")).toContain("| x\\|y | z |");
  });
});
