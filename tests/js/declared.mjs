/** What declaration files say: exported names, and the answers of functions and methods as JSON Schema. */
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createGenerator } from "ts-json-schema-generator";

// The compiler's API comes with the generator; the workspace's own compiler has none.
const ts = createRequire(createRequire(import.meta.url).resolve("ts-json-schema-generator"))("typescript");

/** What stands for a typed array in a schema. */
const TYPED = "@typed";

const marked = (/** @type {string} */ text) =>
  text.replaceAll(/\b(?:Float|Int|Uint)\d+Array\b/g, `{ ${JSON.stringify(TYPED)}: "$&" }`);

/**
 * The exported types and values, and the types of what functions and methods of classes answer, by `name` and
 * `Class.name`, also those of files that are exported whole. What answers nothing or a promise is left out.
 * @param {string} file
 */
export function declared(file) {
  const source = ts.createSourceFile(file, readFileSync(file, "utf8"), ts.ScriptTarget.ES2022, true);
  /** @type {string[]} */ const types = [];
  /** @type {string[]} */ const values = [];
  /** @type {Record<string, string>} */ const answers = {};
  const take = (/** @type {string} */ name, /** @type {any} */ { type }) => {
    const text = type?.getText() ?? "void";
    if (!/^void$|^Promise</.test(text)) answers[name] = text;
  };
  for (const node of source.statements) {
    if (ts.isExportDeclaration(node) && !node.exportClause && !node.isTypeOnly) {
      const more = declared(join(file, "..", node.moduleSpecifier.text.replace(/\.js$/, ".d.ts")));
      types.push(...more.types);
      values.push(...more.values);
      Object.assign(answers, more.answers);
    }
    if (ts.isExportDeclaration(node) && node.exportClause)
      (node.isTypeOnly ? types : values).push(...node.exportClause.elements.map((one) => one.name.text));
    if (ts.isInterfaceDeclaration(node) || ts.isTypeAliasDeclaration(node)) types.push(node.name.text);
    if (ts.isFunctionDeclaration(node) || ts.isClassDeclaration(node)) values.push(node.name.text);
    if (ts.isFunctionDeclaration(node)) take(node.name.text, node);
    if (ts.isClassDeclaration(node))
      node.members
        .filter(ts.isMethodDeclaration)
        .forEach((one) => take(`${node.name.text}.${one.name.getText()}`, one));
  }
  return { types, values, answers };
}

/**
 * The JSON Schema of an object of these types, which are written as in the file. Typed arrays have the keyword
 * `typedArray`.
 * @param {string} file `index.d.ts` beside its `settings.d.ts`, or in `core/` below them
 * @param {Record<string, string>} types
 */
export function schemaOf(file, types) {
  const root = file.replace(/core.index\.d\.ts$|index\.d\.ts$/, ""),
    folder = mkdtempSync(join(tmpdir(), "parkade-types-"));
  try {
    for (const name of readdirSync(root, { recursive: true, encoding: "utf8" }).filter((one) =>
      one.endsWith(".d.ts"),
    )) {
      mkdirSync(join(folder, name, ".."), { recursive: true });
      writeFileSync(join(folder, name), marked(readFileSync(join(root, name), "utf8")));
    }
    const index = join(folder, file.slice(root.length)),
      path = index.replace("index.d.ts", "answers.ts");
    const names = [index, index.replace("index.d.ts", "settings.d.ts")].flatMap((one) => declared(one).types);
    const fields = Object.entries(types).map(
      ([name, type]) => `  ${JSON.stringify(name)}: ${marked(type.replace("complete.", ""))};`,
    );
    writeFileSync(
      path,
      [`import type { ${names.join(", ")} } from "./index.js";`, "export interface Answers {", ...fields, "}"].join(
        "\n",
      ),
    );
    const schema = createGenerator({
      path,
      type: "Answers",
      expose: "none",
      topRef: false,
      skipTypeCheck: true,
      additionalProperties: false,
      jsDoc: "none",
    }).createSchema();
    return JSON.parse(JSON.stringify(schema), (_, value) => {
      const name = value?.properties?.[TYPED]?.const;
      return name ? { typedArray: name } : value;
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
}
