import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { chineseReasons } from "../../www/src/i18n/reasons-zh";
import catalogue from "../../www/src/i18n/reasons-zh.json";

const chineseReason = chineseReasons(catalogue);

const ROOT = join(import.meta.dirname, "../..");

/** Every rule that the Rust sources state, with figures for its values. */
function rules(): string[] {
  const files = readdirSync(join(ROOT, "src"), { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".rs"));
  const found = files.flatMap((name) => {
    const code = readFileSync(join(ROOT, "src", name), "utf8").split("#[cfg(test)]")[0]!.replaceAll(/^\s*\/\/.*$/gm, "").replaceAll(/\\\n\s*/g, "");
    return [...code.matchAll(/"(must (?:[^"\\]|\\.)+)"/g)].map(([, text]) => text!.replaceAll('\\"', '"').replaceAll(/\{[^}]*\}/g, "7"));
  });
  return [...new Set(found)];
}

/** The page's own reasons. */
function sentences(): string[] {
  return ["scene/link", "scene/files", "scene/compact"].flatMap((name) =>
    [...readFileSync(join(ROOT, `www/src/${name}.ts`), "utf8").matchAll(/Error\([`"](T[^`"]+)[`"]\)/g)].map(([, text]) => text!.replaceAll(/\$\{[^}]*\}/g, "slots")));
}

describe("reasons in Chinese", () => {
  it("are there for every rule of the planners and importers", () => {
    const all = rules();
    expect(all.length).toBeGreaterThan(80);
    expect(all.filter((rule) => /\b(must|got|which|that|there|the|or|numbers|at)\b/.test(chineseReason(rule)))).toEqual([]);
  });

  it("are there for every reason of links and files", () => {
    const all = sentences();
    expect(all.length).toBeGreaterThan(12);
    expect(all.filter((text) => /\b(This|is|has|the)\b/.test(chineseReason(text)))).toEqual([]);
  });

  it("keep field, figures and order", () => {
    expect(chineseReason("start.x: must be finite, within ±1e11 m, got 1e22.")).toBe("start.x：须为有限值且在 ±1e11 m 以内，实际为 1e22。");
    expect(chineseReason("path: must be driven within 100000 s, takes 127106 s")).toBe("path：须在 100000 s 内驶完，实际需要 127106 s。");
    expect(chineseReason("must be at least 2 for 9 s, got 1")).toBe("时长 9 s 时须不小于 2，实际为 1。");
    expect(chineseReason("must have 12 characters, got 3.")).toBe("须有 12 个字符，实际为 3。");
    expect(chineseReason("EOF while parsing an object at line 1 column 1.")).toBe("JSON 语法错误，第 1 行第 1 列。");
    expect(chineseReason("nobody knows this one")).toBe("nobody knows this one");
    expect(chineseReason("必须是整数。")).toBe("必须是整数。");
  });
});
