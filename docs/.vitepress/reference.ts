/** The JavaScript reference, from the package's types: each exported name with what stands above it. */
import { readFileSync } from "node:fs";

const TYPES = ["index.d.ts", "settings.d.ts"].map((name) => new URL(`../../packages/parkade/${name}`, import.meta.url));
const KINDS = { class: "Classes", function: "Functions", interface: "Shapes", type: "Words" } as const;

export function reference(): string {
  const parts: Record<string, string[]> = { Classes: [], Functions: [], Shapes: [], Words: [] };
  for (const { kind, name, comment, code } of declarations(
    TYPES.map((file) => readFileSync(file, "utf8")).join("\n"),
  )) {
    parts[KINDS[kind]]!.push(`### ${name}\n\n${comment}\n\n\`\`\`ts\n${code}\n\`\`\``);
  }
  const all = Object.entries(parts).map(([title, texts]) => `## ${title}\n\n${texts.join("\n\n")}`);
  return `# JavaScript\n\nSI units, radians; x east, y north, headings counter-clockwise from east. What is bad throws a \`ParkadeError\`.\n\n${all.join("\n\n")}\n`;
}

interface Declaration {
  kind: keyof typeof KINDS;
  name: string;
  comment: string;
  code: string;
}

/** Declarations of the file, each until the next one's comment; overloads and neighbours without a comment stay apart. */
export function declarations(text: string): Declaration[] {
  const found: Declaration[] = [];
  const lines = text.split("\n");
  for (let i = 0; i < lines.length; i++) {
    const match = /^export (?:declare )?(class|function|interface|type) (\w+)/.exec(lines[i]!);
    if (!match) continue;
    const from = i;
    while (!isEnd(lines.slice(from, i + 1).join("\n"))) i++;
    found.push({
      kind: match[1] as Declaration["kind"],
      name: match[2]!,
      comment: commentBefore(lines, from),
      code: lines.slice(from, i + 1).join("\n"),
    });
  }
  return found;
}

/** True if brackets are closed and the statement is over. */
function isEnd(code: string): boolean {
  const bare = code.replace(/\/\*[^]*?\*\/|\/\/.*|"[^"\n]*"/g, "");
  const open = (bare.match(/[{([]/g)?.length ?? 0) - (bare.match(/[})\]]/g)?.length ?? 0);
  return open === 0 && /[;}]\s*$/.test(bare);
}

function commentBefore(lines: string[], at: number): string {
  const end = at - 1;
  if (!lines[end]?.trimEnd().endsWith("*/")) return "";
  let from = end;
  while (!lines[from]!.trimStart().startsWith("/**")) from--;
  return lines
    .slice(from, end + 1)
    .join("\n")
    .replace(/^\s*\/\*\*|\*\/\s*$/g, "")
    .replace(/^\s*\* ?/gm, "")
    .replaceAll("<", "&lt;")
    .replaceAll("{{", "{ {")
    .trim();
}
