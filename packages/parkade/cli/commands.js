// @ts-check
// The commands of `parkade`: their texts, options and modules.
import { AUDIT_ABOUT, AUDIT_OPTIONS } from "./audit-options.js";

export const HELP =
  `usage: parkade <command> [options]

  plan SCENE…      plan a path            --planner ID  --set NAME=VALUE  --format json|csv|svg|trajectory  --out FILE
  check SCENE [PATH]   check a scene, or a path against it (plan.json, or CSV as from \`plan\`)
  judge SCENE TRAJECTORY   judge a trajectory or a path by the protocol of the public benchmarks (CSV, or JSON columns)
  audit SCENE      which bays can be reached   --vehicle ID,ID…  --entry both|head-in|reverse-in  --csv FILE  --svg FILE
  bench SCENE…     time planners          --planner ID,ID…  --repeats N  --format markdown|csv|json
  batch SCENES…    plan many scenes       --planner ID,ID…  --jobs N  --shard I/N  --out FILE.jsonl  --set NAME=VALUE
  columns FILE…    the results of \`batch\` as Parquet    --out FILE.parquet
  report FILE…     the results of \`batch\`, or Parquet, as one HTML page    --out FILE.html
  digest FILE…     one hash over the results of \`batch\`, in any order and number of files
  lot              draw a parking lot by seed   --preset ID  --seed N  --out FILE
  vehicles         list the library of vehicles
  planners         list the planners, or the settings of one (--planner ID)
  scenarios        list the built-in scenes
  scenario ID      print a built-in scene
  generate         draw a map by its seed  --family random|regular|trap  --size N  --seed N
  convert FILES…   print maps of other programs as scenes  --format json|jsonl  --out FILE
  completion SHELL print what bash, zsh or fish completes

SCENE is a scene as JSON, a MovingAI .map, a ROS .yaml, a TPCAP .csv, a site plan (.dxf, .svg, .geojson, .osm),
the id of a built-in scene, or - for standard input.
\`parkade <command> --help\` lists the options of a command.

exit codes: 0 done; 1 no path, a path or trajectory that fails its check, a blocked start or goal, or scenes that ` +
  `could not be planned;
2 bad input, or a file that cannot be read or written; 3 internal error; 124 --timeout; 130 a batch that was ` +
  `interrupted,
which the same command continues
`;

/** Each command's help text, options and module. @type {Record<string, Command>} */
export const COMMANDS = {
  plan: {
    about:
      `usage: parkade plan SCENE… [options]

  Several scenes or planners give a line of JSON each, which begins with the scene.

  --planner ID,ID…     default: hybrid
  --set NAME=VALUE     a setting of the planner; may be repeated
  --format json|csv|svg|trajectory  default: json. NaN and infinities are null in JSON, empty in CSV; trajectory is ` +
      `CSV over
                       time of what \`optimise\` makes of the plan, as \`judge\` reads it
  --out FILE           default: standard output
  --prefer shortest|fewest-changes|widest|fastest  what hybrid's path is chosen by
  --alternatives       include hybrid's other paths (json)
  --trace              include the expansions (json; svg always has them)
  --size WIDTHxHEIGHT  size of the svg in pixels; default: 720x420
  --theme auto|light|dark  colours of the svg; default: auto
  --timeout SECONDS    stop after so long, with exit code 124
  --layout single|overlay, --controls none|minimal  draw the svg as the poster of a playground with these attributes
`,
    options: {
      timeout: { type: "string" },
      planner: { type: "string" },
      set: { type: "string", multiple: true },
      format: { type: "string" },
      out: { type: "string" },
      prefer: { type: "string" },
      alternatives: { type: "boolean" },
      trace: { type: "boolean" },
      size: { type: "string" },
      theme: { type: "string" },
      layout: { type: "string" },
      controls: { type: "string" },
    },
    load: async () => (await import("./plan.js")).plan,
  },
  check: {
    about:
      `usage: parkade check SCENE [PATH] [options]

  Without PATH, checks that the scene can be read and that its car stands free at start and goal. PATH is JSON with ` +
      `\`path\` (x, y, heading, …) and optional \`directions\`, or
  CSV with columns x, y, theta and optional direction. The independent checker drives the body along it.

  --timeout SECONDS    stop after so long, with exit code 124
  --format text|json   default: text
`,
    options: { timeout: { type: "string" }, format: { type: "string" } },
    load: async () => (await import("./check.js")).check,
  },
  judge: {
    about:
      `usage: parkade judge SCENE TRAJECTORY [options]

  TRAJECTORY is CSV with a header: t,x,y,theta[,v,phi] (a trajectory) or x,y,theta[,gear] (a path, which is given ` +
      `times and driven
  by a simulated car), in seconds, metres and radians; or JSON with \`path\` and optional \`t\`, \`speeds\`, ` +
      `\`steering\`.

  --speed V            m/s; default: 2.5
  --acceleration A     m/s²; default: 1
  --deceleration B     m/s²; default: 1
  --steering-rate W    rad/s; default: 0.5, at most the car's own
  --timeout SECONDS    stop after so long, with exit code 124
  --format text|json   default: text
`,
    options: {
      timeout: { type: "string" },
      format: { type: "string" },
      speed: { type: "string" },
      acceleration: { type: "string" },
      deceleration: { type: "string" },
      "steering-rate": { type: "string" },
    },
    load: async () => (await import("./judge.js")).judge,
  },
  audit: {
    about:
      `usage: parkade audit SCENE [options]

  Asks of each bay whether each vehicle can drive in from each entrance, and out again. Exit code 1: some bay is ` +
      `out of reach.

${AUDIT_ABOUT}
  --csv FILE           write all rows
  --svg FILE           draw each bay filled by the fewest moves; with several vehicles, a file for each
  --format markdown|csv|json  of standard output or --out; default: markdown, a summary
  --out FILE           default: standard output
  --jobs N             worker threads; default: one per processor
  --timeout SECONDS    stop after so long, with exit code 124
  --quiet              show no progress
`,
    options: {
      ...AUDIT_OPTIONS,
      set: { type: "string", multiple: true },
      csv: { type: "string" },
      svg: { type: "string" },
      format: { type: "string" },
      out: { type: "string" },
      jobs: { type: "string" },
      timeout: { type: "string" },
      quiet: { type: "boolean" },
    },
    load: async () => (await import("./audit.js")).audit,
  },
  lot: {
    about: `usage: parkade lot [options]

  Draws a parking lot as a scene: a preset or, without one, what the seed draws, with the given numbers in their place.

  --preset ID          \`--list\` lists them
  --seed N             default: 1
  --rows N, --bays N   rows of bays, and bays in each
  --angle RADIANS      between aisle and bay
  --bay-width M, --bay-length M, --aisle M
  --columns N          bays from one column to the next; 0 for none
  --occupancy SHARE    0 to 1
  --entrances N        1 or 2
  --ramp M             width of a ramp that joins the first aisle at a right angle; 0 for none
  --out FILE           default: standard output
`,
    options: {
      list: { type: "boolean" },
      ...Object.fromEntries(
        ["preset", "seed", "rows", "bays", "angle", "bay-width", "bay-length", "aisle", "columns", "occupancy"]
          .concat(["entrances", "ramp", "out"])
          .map((name) => [name, { type: /** @type {const} */ ("string") }]),
      ),
    },
    load: async () => (await import("./audit.js")).lot,
  },
  vehicles: {
    about: "usage: parkade vehicles [--format text|json]\n",
    options: { format: { type: "string" } },
    load: async () => (await import("./audit.js")).vehicles,
  },
  bench: {
    about: `usage: parkade bench SCENE… [options]

  --planner ID,ID…     default: four,eight,risk-field,hybrid
  --repeats N          timed plans per planner, interleaved, after one warm-up; default: 25
  --timeout SECONDS    stop after so long, with exit code 124
  --format markdown|csv|json  default: markdown
`,
    options: {
      timeout: { type: "string" },
      planner: { type: "string" },
      repeats: { type: "string" },
      format: { type: "string" },
    },
    load: async () => (await import("./bench.js")).bench,
  },
  batch: {
    about:
      `usage: parkade batch SCENES… [options]

  Plans .json files, every .json below folders, and every line of .jsonl files. Appends a line per scene and ` +
      `planner to the
  results and skips those already there, so a stopped run continues when it is started again. The result of a scene that
  has changed since then is superseded.

  --planner ID,ID…     default: hybrid
  --task plan|audit    default: plan; audit asks every bay of each scene, with the options of \`parkade audit\`: ` +
      `--vehicle, --entry,
                       --what-if, --entrance. Its results have \`asked\`, \`reachable\`, \`undecided\` and ` +
      `\`rows\`: bay, vehicle, entrance,
                       entry, moves, length, driveTime, clearance, reason, …
  --set NAME=VALUE     a setting for all of the planners; may be repeated
  --sweep NAME=V,V…    plan with each of these values; repeated, with all combinations
  --jobs N             worker threads; default: one per processor
  --shard I/N          plan only part I of N; a hash of each scene decides its part
  --out FILE           default: results.jsonl, or results-I-of-N.jsonl with --shard
  --timeout SECONDS    give up a plan after so long; a later run tries it again
  --paths              results have \`path\` (x, y, heading, …) and \`directions\`
  --times              results have \`seconds\` by the clock, with reading and preparing; digests do not count them
  --quiet              show no progress
`,
    options: {
      timeout: { type: "string" },
      planner: { type: "string" },
      paths: { type: "boolean" },
      times: { type: "boolean" },
      task: { type: "string" },
      ...AUDIT_OPTIONS,
      set: { type: "string", multiple: true },
      sweep: { type: "string", multiple: true },
      jobs: { type: "string" },
      shard: { type: "string" },
      out: { type: "string" },
      quiet: { type: "boolean" },
    },
    load: async () => (await import("./batch.js")).batch,
  },
  columns: {
    about:
      `usage: parkade columns FILE… [options]

  Writes the newest results of \`batch\` (.jsonl, in any number of files) as the columns of one Parquet file, for ` +
      `DuckDB, pandas,
  Ray and \`parkade report\`. Results of \`--task audit\` become a row for each bay, vehicle, entrance and entry.

  --out FILE           default: results.parquet
`,
    options: { out: { type: "string" } },
    load: async () => (await import("./parquet.js")).columns,
  },
  report: {
    about:
      `usage: parkade report FILE… [options]

  Writes one HTML page over results (.jsonl of \`batch\`, or .parquet of \`columns\` or of Python): outcomes, ` +
      `quantiles, performance
  profiles, and who wins against whom on the same scenes. A row is a planner with its settings.

  --out FILE           default: report.html
`,
    options: { out: { type: "string" } },
    load: async () => (await import("./report.js")).report,
  },
  digest: {
    about: "usage: parkade digest FILE…\n",
    options: {},
    load: async () => (await import("./results.js")).digestFiles,
  },
  planners: {
    about: "usage: parkade planners [--planner ID] [--format text|json]\n",
    options: { planner: { type: "string" }, format: { type: "string" } },
    load: async () => (await import("./list.js")).planners,
  },
  scenarios: {
    about: "usage: parkade scenarios [--format text|json]\n",
    options: { format: { type: "string" } },
    load: async () => (await import("./list.js")).scenarios,
  },
  scenario: {
    about: "usage: parkade scenario ID [--out FILE]\n",
    options: { out: { type: "string" } },
    load: async () => (await import("./convert.js")).scenario,
  },
  generate: {
    about: `usage: parkade generate [options]

  --family random|regular|trap  default: random
  --size N             cells a side, 5 to 4096; default: 60
  --seed N             default: 1
  --density N          random: thousandths of the cells that are blocked; default: 150
  --block-min N, --block-max N  random: sides of the blocks, cells; default: 1 to 3
  --out FILE           default: standard output
`,
    options: {
      family: { type: "string" },
      size: { type: "string" },
      seed: { type: "string" },
      density: { type: "string" },
      "block-min": { type: "string" },
      "block-max": { type: "string" },
      out: { type: "string" },
    },
    load: async () => (await import("./convert.js")).generate,
  },
  convert: {
    about:
      `usage: parkade convert FILES… [options]

  Reads MovingAI .map with its .scen, ROS .yaml with its picture, TPCAP .csv, site plans (.dxf, .svg, .geojson, ` +
      `.osm), lots and
  scenes as .json, and prints scenes as JSON. The names of a plan's layers suggest what they are.

  --format json|jsonl  default: json, one scene; jsonl has each scene on a line, as \`batch\` reads them
  --resolution M       side of a cell, metres, of maps that do not say; default: 1
  --query N            which question of a .scen gives start and goal; default: 0
  --unknown blocked|free  cells that are neither; default: blocked
  --role LAYER=ROLE    what a layer of a plan is: none, wall, kerb, column, building, bay, ground; may be repeated
  --unit M             metres per unit of a plan that does not say
  --out FILE           default: standard output
`,
    options: {
      format: { type: "string" },
      resolution: { type: "string" },
      query: { type: "string" },
      unknown: { type: "string" },
      role: { type: "string", multiple: true },
      unit: { type: "string" },
      out: { type: "string" },
    },
    load: async () => (await import("./convert.js")).convert,
  },
  completion: {
    about: "usage: parkade completion bash|zsh|fish\n",
    options: {},
    load: async () => (await import("./completion.js")).completion(COMMANDS),
  },
};

/** @typedef {import("node:util").ParseArgsConfig["options"]} Options */
/** @typedef {Record<string, string | boolean | (string | boolean)[] | undefined>} Values */
/** @typedef {(places: string[], values: any, module: WebAssembly.Module) => Promise<number>} Run */
/** @typedef {{ about: string, options: Options, load(): Promise<Run> }} Command */
