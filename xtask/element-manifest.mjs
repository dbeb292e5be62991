// Writes custom-elements.json and web-types.json, which editors read, from the types of the element.
// `node xtask/element-manifest.mjs <element.d.ts> <folder> <version>`
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const TAG = "parkade-playground";

/** The members of an interface: what stands on a line of its own, with the comment on the line before. */
function membersOf(source, name) {
  const body = new RegExp(`interface ${name}[^{]*\\{\n([^]*?)\n\\}`).exec(source)?.[1];
  if (body === undefined) throw new Error(`element.d.ts: must hold the interface ${name}`);
  const member = /(?: {2}\/\*\* (.*?) \*\/\n)? {2}(readonly )?"?([\w-]+)"?(\??)(?:: (.*)|\((.*)\): (.*));/g;
  return [...body.matchAll(member)]
    .map(([, description, readonly, id, , type, parameters, result]) => ({
      description,
      readonly,
      id,
      type,
      parameters,
      result,
    }))
    .filter(({ id }) => id !== "addEventListener");
}

const described = ({ description }) => (description ? { description } : {});

/** The two manifests of the element that the types declare. */
export function manifests(source, version) {
  const attributes = membersOf(source, "PlaygroundAttributes").map((one) => ({
    name: one.id,
    ...described(one),
    type: one.type.replace(" | (string & {})", " | string"),
  }));
  const events = membersOf(source, "PlaygroundEvents").map((one) => ({
    name: one.id,
    type: `CustomEvent<${one.type}>`,
  }));
  const members = membersOf(source, "ParkadePlayground").map((one) =>
    one.type === undefined
      ? { kind: "method", name: one.id, ...described(one), return: { type: { text: one.result } } }
      : {
          kind: "field",
          name: one.id,
          ...described(one),
          ...(one.readonly && { readonly: true }),
          type: { text: one.type },
        },
  );
  const texts = (list) => list.map(({ type, ...rest }) => ({ ...rest, type: { text: type } }));
  const custom = {
    schemaVersion: "2.1.0",
    modules: [
      {
        kind: "javascript-module",
        path: "parkade-playground.js",
        declarations: [
          {
            kind: "class",
            name: "ParkadePlayground",
            customElement: true,
            tagName: TAG,
            superclass: { name: "HTMLElement" },
            attributes: texts(attributes),
            events: texts(events),
            members,
          },
        ],
        exports: [{ kind: "custom-element-definition", name: TAG, declaration: { name: "ParkadePlayground" } }],
      },
    ],
  };
  const web = {
    name: "parkade",
    version,
    "js-types-syntax": "typescript",
    contributions: {
      html: {
        elements: [
          {
            name: TAG,
            attributes: attributes.map(({ type, ...rest }) => ({ ...rest, value: { type } })),
            js: {
              events: events.map(({ name }) => ({ name })),
              properties: members
                .filter(({ kind }) => kind === "field")
                .map(({ name, type }) => ({ name, type: type.text })),
            },
          },
        ],
      },
    },
  };
  return { "custom-elements.json": custom, "web-types.json": web };
}

const [types, folder, version] = process.argv.slice(2);
if (process.argv[1]?.endsWith("element-manifest.mjs"))
  for (const [name, manifest] of Object.entries(manifests(readFileSync(types, "utf8"), version)))
    writeFileSync(join(folder, name), `${JSON.stringify(manifest, null, 2)}\n`);
