import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { init, ParkadeError } from "parkade";
import { chineseReasons } from "../../www/src/i18n/reasons-zh";
import type { Said } from "../../www/src/i18n/said";
import { ValueError } from "../../www/src/app/schema";
import { bounded } from "../../www/src/scene/foreign";
import catalogue from "../../www/src/i18n/reasons-zh.json";
import type { Scenario } from "../../www/src/scene/scenario";
import { misusesOfApi } from "./misuses";

const chineseReason = chineseReasons(catalogue);

const ROOT = join(import.meta.dirname, "../..");

/** Every rule, complaint and note that the Rust sources state, with figures for its values. */
function rules(): string[] {
  const files = readdirSync(join(ROOT, "src"), { recursive: true, encoding: "utf8" }).filter((name) =>
    name.endsWith(".rs"),
  );
  const found = files.flatMap((name) => {
    const code = readFileSync(join(ROOT, "src", name), "utf8")
      .split("#[cfg(test)]")[0]!
      .replaceAll(/^\s*\/\/.*$/gm, "")
      .replaceAll(/\\\n\s*/g, "");
    return [...code.replaceAll(/(?:expect|assert!?|panic!|unreachable!)\("[^"]*"/g, "").matchAll(STATED)].map(
      ([, text]) => text!.replaceAll('\\"', '"').replaceAll(/\{[^}]*\}/g, "7"),
    );
  });
  return [...new Set(found)];
}

/** A text that says what must be, what is missing or unknown, or how something was read. */
const SIGNS = /\bmust |\bmissing\b|unknown field|no such |unknown cells|cells between|Turned by/.source;
const STATED = new RegExp(`"((?:[^"\\\\\\n]|\\\\.)*(?:${SIGNS})(?:[^"\\\\\\n]|\\\\.)*)"`, "g");

describe("reasons in Chinese", () => {
  it("are there for every rule of the planners and importers", () => {
    const all = rules();
    expect(all.length).toBeGreaterThan(80);
    const english = (text: string): boolean =>
      !/[\u4e00-\u9fff]/.test(text) ||
      /\b(must|got|which|that|there|the|or|and|numbers|at|count|cells between)\b/.test(text);
    expect(all.filter((rule) => english(chineseReason(rule)))).toEqual([]);
  });

  it("are made of the rule and the values, whatever the values are", async () => {
    await init();
    const english: string[] = [],
      templates = new Set<string>();
    for (const { name, call } of misusesOfApi()) {
      let thrown: unknown;
      try {
        call();
      } catch (error) {
        thrown = error;
      }
      expect(thrown, name).toBeInstanceOf(ParkadeError);
      const { template, values = [], path, message } = thrown as ParkadeError;
      // The wrapper's own refusals are for programmers.
      if (!template) continue;
      const filled = values.reduce((text, value) => text.replace("{}", () => value), template);
      // The message cuts a value that is very long.
      const said = message.replace(/…$/, "");
      expect(
        [filled, `${path}: ${filled}`].some((whole) => whole.startsWith(said)),
        `${name}: ${message}`,
      ).toBe(true);
      // A text of the reader of JavaScript's values: it has no figures apart.
      if (templates.has(template) || template === "{}") continue;
      templates.add(template);
      // Figures that no template expects: the sentence must not depend on reading them.
      const chinese = chineseReason({ message, path, template, values: values.map((_, i) => `<${i}>`) });
      if (/[a-z]{2,} [a-z]{2,}/i.test(chinese.replaceAll(/"[^"]*"/g, "")) || !/[\u4e00-\u9fff]/.test(chinese))
        english.push(`${template} -> ${chinese}`);
      values.forEach((_, i) => expect(chinese, template).toContain(`<${i}>`));
    }
    expect(templates.size).toBeGreaterThan(40);
    expect(english).toEqual([]);
  });

  it("are there for every reason and note of site plans", () => {
    const folder = join(ROOT, "www/src/siteplan"),
      text = readdirSync(folder)
        .map((name) => readFileSync(join(folder, name), "utf8"))
        .join("\n")
        .replaceAll(/\$\{[^}]*\}/g, "{}");
    const found = [...text.matchAll(/SitePlanError\(\s*rule`([^`]+)`|\[`(Left out[^`]*)`|`(Outlines[^`]*)`/g)];
    // Each reason is a rule whose values stand apart.
    expect(found.filter(([, rule]) => rule).length).toBe(text.match(/new SitePlanError\(/g)!.length);
    const shown = (template: string): string => template.replaceAll("{}", "7"),
      chinese = found.map(([, rule, ...notes]) =>
        rule
          ? chineseReason({ message: shown(rule), template: rule, values: rule.match(/\{\}/g)?.map(() => "7") ?? [] })
          : chineseReason(shown(notes.find(Boolean)!)),
      );
    expect(chinese.filter((one) => /\b(must|the|at|most|that|this|Left|Outlines)\b|⟨|\{/.test(one))).toEqual([]);
  });

  it("are there for every refusal of the page itself, whatever its values are", () => {
    const folder = join(ROOT, "www/src"),
      texts = readdirSync(folder, { recursive: true, encoding: "utf8" })
        .filter((name) => name.endsWith(".ts"))
        .flatMap((name) => [...readFileSync(join(folder, name), "utf8").matchAll(/refused`([^`]+)`/g)])
        .map(([, text]) => text!.replaceAll(/\$\{[^}]*\}/g, "{}"));
    expect(texts.length).toBeGreaterThan(20);
    for (const template of texts) {
      const values = (template.match(/\{\}/g) ?? []).map((_, i) => `<${i}>`),
        chinese = chineseReason({ message: template, template, values });
      expect(chinese, template).toMatch(/[\u4e00-\u9fff]/);
      expect(chinese, template).not.toMatch(/\b(has|is|no|not|the)\b|\{|⟨/);
      for (const value of values) expect(chinese, template).toContain(value);
    }
  });

  it("are a checked value's own", () => {
    const broken = new ValueError({ field: "src", value: "a.json", rule: "answered", why: "404" });
    expect(chineseReason({ ...broken, message: broken.message })).toBe(
      'src：必须是 JSON 场景的地址（服务器返回 404），实际为 "a.json"。',
    );
    expect(broken.message).toBe('src: must be the address of a scene as JSON (the server answered 404), got "a.json"');
  });

  it("are there for what is too large for a page", () => {
    const start = { x: 0, y: 0, heading: 0 },
      map = { origin: [0, 0], width: 9, height: 9, resolution: 1 };
    const reasonOf = (more: object): Said => {
      try {
        bounded({ version: 1, map, start, goal: start, ...more } as unknown as Scenario);
      } catch (error) {
        return error as Said;
      }
      throw new Error("it is small enough");
    };
    expect(chineseReason(reasonOf({ slots: [], obstacles: Array(2001).fill({ type: "polygon", points: [] }) }))).toBe(
      "slots、obstacles：最多为 2000 个对象，实际为 2001。",
    );
    expect(chineseReason(reasonOf({ obstacles: [{ type: "polygon", points: Array(50_001).fill([0, 0]) }] }))).toBe(
      "points：最多为 50000 个点，实际为 50001。",
    );
    const long = reasonOf({ name: "x".repeat(201) });
    expect(chineseReason(long)).toBe("name：最多为 200 个字符，实际为 201。");
    expect(long.message).toBe("name: must be at most 200 characters, got 201");
    expect(long.values).toEqual(["200", "201"]);
  });

  it("name what a rule is about", () => {
    expect(chineseReason("column 4: must be one of .GS@OTW, got 'x'.")).toBe(
      "第 4 列须为下列之一：.GS@OTW，实际为 'x'。",
    );
    expect(chineseReason("resolution must be 0.001 to 1000 m, got 0.")).toBe("分辨率须为 0.001 到 1000 m，实际为 0。");
    expect(chineseReason("number 5, the corners of obstacle 2, must be a whole number from 3, got 1")).toBe(
      "第 5 个数（障碍物 2 的角点数）须为不小于 3 的整数，实际为 1。",
    );
    expect(chineseReason("12 unknown cells count as blocked.")).toBe("12 个未知格按占用处理。");
  });

  it("keep field, figures and order", () => {
    expect(chineseReason("start.x: must be finite, within ±1e11 m, got 1e22.")).toBe(
      "start.x：须为有限值且在 ±1e11 m 以内，实际为 1e22。",
    );
    expect(chineseReason("path: must be driven within 100000 s, takes 127106 s")).toBe(
      "path：须在 100000 s 内驶完，实际需要 127106 s。",
    );
    expect(chineseReason("must be at least 2 for 9 s, got 1")).toBe("时长 9 s 时须不小于 2，实际为 1。");
    expect(chineseReason("must have 12 characters, got 3.")).toBe("须有 12 个字符，实际为 3。");
    expect(chineseReason("EOF while parsing an object at line 1 column 1.")).toBe("JSON 语法错误，第 1 行第 1 列。");
    expect(chineseReason("nobody knows this one")).toBe("nobody knows this one");
    expect(chineseReason("the worker stopped.")).toBe("规划器的工作线程已停止。");
    expect(chineseReason("必须是整数。")).toBe("必须是整数。");
  });
});
