import { beforeAll, describe, expect, it } from "vitest";
import { markdown, pages, papers, picture, type Page } from "../../docs/.vitepress/papers";

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
      const sentences = blocks.flatMap((block) =>
        block.kind === "list" ? block.items : block.kind === "text" ? [block.text] : [],
      );
      expect(
        sentences.filter((one) => !/[\u4e00-\u9fff]/.test(one)),
        id,
      ).toEqual([]);
    }
  });

  it("say in both languages what each printed figure shows", () => {
    for (const pages of [en, zh])
      for (const { id, blocks } of pages)
        for (const block of blocks) {
          if (block.kind !== "figure" || !/^(Figure|图) ?\d/.test(block.figure.caption)) continue;
          expect(block.figure.printed, `${id} ${block.figure.id}`).toMatch(
            pages === en ? /^Printed: .+Here/ : /^论文：.+此处/,
          );
        }
  });

  it("lead from each scene's name to the scene", () => {
    const codes = (text: string): string[] => [...text.matchAll(/<<([^>]+)>>/g)].map(([, code]) => code!);
    const named = en.map(
      ({ id, blocks }) =>
        [
          id,
          codes(
            markdown(
              blocks,
              () => "",
              (code) => `<<${code}>>`,
            ),
          ),
        ] as const,
    );
    const rows: Readonly<Record<string, readonly string[]>> = {
      "risk-field": ["fig8-30", "fig8-60", "fig8-100", "fig9-30", "fig9-60", "fig9-100"],
      sixteen: ["fig8-30", "fig8-60", "fig8-100", "fig9-30", "fig9-60", "fig9-100"],
      parking: ["P0", "P1", "P2", "P3", "P4", "L0", "L1", "L2", "L3", "L4"],
      road: ["straight", "curve", "crossing", "narrow"].flatMap((road) => [`road-${road}`, `road-${road}-ship`]),
    };
    for (const [id, found] of named) expect(found, id).toEqual(expect.arrayContaining([...rows[id]!]));
  });

  it("show on the site points and letters as images, and other scenes live, with links to them", async () => {
    const [riskField, , parking] = await papers("zh", SEEDS);
    expect(riskField!.content.match(/<img alt="图 [567]：[^"]+" [^>]*src="data:image\/svg\+xml;base64,/g)!.length).toBe(
      3,
    );
    // Safety spaces in colours, and live: figure 1 and six of figures 8 and 9.
    expect(riskField!.content.match(/<img alt="图 [189][：，][^"]+" /g)!.length).toBe(7);
    expect(riskField!.content.match(/layers="slots obstacles path redundant grid"/g)!.length).toBe(7);
    expect(riskField!.content).not.toContain("<style");
    expect(parking!.content).toContain(
      '<a href="../../../embed.html#scene=L2&amp;controls=full&amp;lang=zh" target="_self"><code>L2</code></a>',
    );
    expect(parking!.content).toContain("`hybrid-forward`");
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
        "fig1",
        "fig3",
        "fig4",
        "fig5",
        "fig6",
        "fig7",
        "potential",
        "fig8-30",
        "fig8-60",
        "fig8-100",
        "fig9-30",
        "fig9-60",
        "fig9-100",
        "fig2-kinematics",
        "fig3-corners",
        "fig4-volumes",
        "fig6-separating",
        "fig7-steering",
        "fig8",
        "fig9",
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
    expect(new Set(figures.map(({ id }) => id)).size).toBe(figures.length);
    // Cells and kept points; the letters of the construction; arcs.
    expect(drawn("fig5").match(/<circle/g)!.length).toBeGreaterThan(20);
    for (const letter of ["S", "Q", "P", "B"]) expect(drawn("fig6")).toContain(`>${letter}<`);
    expect(drawn("fig7").match(/ 0 0 [01] /g)!.length).toBeGreaterThan(3);
    // Both safety spaces, the three paths, and the ends in blue and red.
    for (const ink of ["#F2C37B", "#C9B3DE", "#D55E00", "#0072B2", "#009E73", "#B3261E"])
      expect(drawn("fig9-60")).toContain(`"${ink}"`);
    // Three cells of a region, and one or two beyond them.
    expect(drawn("fig4").match(/fill="#BFE3D6"/g)!.length).toBe(9);
    expect(drawn("fig4").match(/fill="#F2C37B"/g)!.length).toBe(4);
    expect(drawn("potential").match(/<polyline/g)!.length).toBeGreaterThan(15);
    for (const corner of "ABCD") expect(drawn("fig3-corners")).toContain(`>${corner}</tspan>`);
    // Green and red dots: a line apart from the body's projection, one within it.
    for (const ink of ["#009E73", "#D55E00"])
      expect(drawn("fig6-separating").match(new RegExp(`r="6" fill="${ink}"`, "g"))!.length).toBe(1);
    for (const mark of "ABCDSWE") expect(drawn("fig16")).toContain(`>${mark}</text>`);
    for (const { id } of figures.filter(({ scene }) => !scene.startsWith("road")))
      expect(drawn(id), id).toMatch(/^<svg [^]*<\/svg>\s*$/);
  }, 60_000);

  it("write a cell's bar so that its row keeps its columns", () => {
    expect(markdown([{ kind: "table", head: ["a", "b"], rows: [["x|y", "z"]] }], () => "")).toContain("| x\\|y | z |");
  });
});
