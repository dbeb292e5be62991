/** Spelling of all texts, by lists of what people often write wrong, and the glossary's places. */
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";

const ROOT = join(import.meta.dirname, "../..");
const tracked = execFileSync("git", ["ls-files"], { cwd: ROOT, encoding: "utf8" })
  .split("\n")
  .filter(
    (file) => /\.(rs|ts|js|mjs|md|json|toml|html|css)$/.test(file) && !/package-lock|tests\/data|\.cargo/.test(file),
  )
  // Some tests misspell what the package must refuse.
  .filter((file) => !/js\/(spelling|command|package-types)\.test\.ts$/.test(file) && existsSync(join(ROOT, file)));
const read = (file: string): string => readFileSync(join(ROOT, file), "utf8");

/** Whole words, or their beginnings where a hyphen follows. */
const MISSPELT = `
  accomodat- acheiv- accross adress- agressiv- algoritm- allready alot apparant- arbitary arguement- assymmetr-
  asyncron- availab1- becuase begining beleiv- bellow boundry calender cancelation catagor- chnage- collison-
  comand- comming commited comparision- compatab- compatib1- completly concious- consistant- coordiante-
  correspond1- curvatur curvture definate- dependan- desgin- diferen- dimention- direciton- discription- distnace-
  doesnt efficien1- embarass- enviroment- equivilent- existance explicitely feasable finaly foward- freqeun-
  funciton- gauranteed- grammer guarantie- heuristc- hierachy immediatly implemention indepedent- independant-
  inital- intialis- intersting interupt- lenght- libary maintainance manuever- manouver- necesary neccessar-
  neigbour- neighour- neighbhor- noticable obstical- obstacel- occassion- occured occurence- ommit- optimis1-
  orginal- paralell paramter- parmeter- perfomance perpendiculr persistan- planer- plannar- polgyon- postion-
  preceed- prefered priviledge- probabl1- proccess- programatic- propogat- publically recieve- recomend- refered
  refrence- relevent repositiory resolutoin responsab- retreive- reverese- sceanrio- scenrio- seach- sepera-
  similiar- simultanous- specificaly statment- steeering straighforward strengh- succesful- successfull- suport-
  suprise- synchron1- tempora1- teh thier thresold- threshhold- tolerence- trajectroy- trajctor- truely unecessary-
  unkown untill usefull vehicel- vehical- verfiy visable wich wierd writting
`
  .trim()
  .split(/\s+/)
  .filter((word) => !/\d/.test(word));
const WRONG = new RegExp(`\\b(${MISSPELT.map((word) => word.replace(/-$/, "\\w*")).join("|")})\\b`, "gi");

/** Prose is in British English, as the words of the page are. */
const AMERICAN = new RegExp(
  [
    /\b(colors?|neighbors?|meters?|centers?|centered|behaviors?|labeled|modeling|canceled|traveled|gray)\b/,
    /\b(optimiz|normaliz|visualiz|minimiz|maximiz|initializ|recogniz)\w+\b/,
  ]
    .map(({ source }) => source)
    .join("|"),
  "gi",
);

/** Without code, addresses and titles of others' works. */
const prose = (text: string): string =>
  text
    .replace(/```[^]*?```/g, "")
    .replace(/`[^`]*`/g, "")
    .replace(/<[^>]*>/g, "")
    .replace(/\(https?:[^)]*\)/g, "");

describe("texts", () => {
  it("are many", () => {
    expect(tracked.length).toBeGreaterThan(500);
    expect("the lenght of a trajctory".match(WRONG)).toEqual(["lenght", "trajctory"]);
    expect(prose("a `color` in grey, colored").match(AMERICAN)).toBeNull();
  });

  it("have no common misspelling", () => {
    const found = tracked.flatMap((file) => (read(file).match(WRONG) ?? []).map((word) => `${file}: ${word}`));
    expect(found).toEqual([]);
  });

  it("are in British English", () => {
    const pages = tracked.filter((file) => file.endsWith(".md"));
    const found = pages.flatMap((file) => (prose(read(file)).match(AMERICAN) ?? []).map((word) => `${file}: ${word}`));
    expect(pages.length).toBeGreaterThan(10);
    expect(found).toEqual([]);
  });
});

describe("the glossary", () => {
  const rows = [
    ...read("DESIGN.md")
      .split("## Glossary")[1]!
      .split("\n## ")[0]!
      .matchAll(/^\| ([a-z][^|`]*) \| [^|]+ \| ([^|]+) \|$/gm),
  ].filter(([, term]) => term !== "term");

  it("names rooms that there are", () => {
    const places = rows.flatMap(([, term, where]) =>
      [...where!.matchAll(/`([\w/]+)`/g)].map(([, place]) => [term!.trim(), place!] as const),
    );
    expect(places.length).toBeGreaterThan(30);
    const missing = places.filter(
      ([, place]) =>
        !["src", "www/src"].some((room) => ["", ".rs", ".ts"].some((end) => existsSync(join(ROOT, room, place + end)))),
    );
    expect(missing).toEqual([]);
  });

  it("is in order", () => {
    const terms = rows.map(([, term]) => term!.toLowerCase());
    expect(terms).toEqual(terms.toSorted((a, b) => a.localeCompare(b, "en")));
  });
});
