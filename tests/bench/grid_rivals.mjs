// The rivals of `grid.mjs`: our planners and the peers on a map, each in a process of its own, and the race between
// them.
import { fork } from "node:child_process";
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { importScene, init, Planner } from "../../pkg/node.js";
import { agrees, load, walk } from "./movingai.mjs";

export const [maps, peers, native, count = "20", repeats = "5", goals = "", role] = process.argv.slice(2);
await init();

export const cpu = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};
export const wall = () => performance.now();
/** Milliseconds of some work. */
export function timed(work, clock = cpu) {
  const start = clock();
  work();
  return clock() - start;
}
/** Each of some works in turns; the milliseconds of each one's fastest round: what it takes when nothing disturbs. */
export function fastest(rounds, works, clock = cpu) {
  const best = works.map(() => Infinity);
  for (let round = 0; round < rounds; round++) {
    for (const [k, work] of works.entries()) best[k] = Math.min(best[k], timed(work, clock));
  }
  return best;
}
export const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b);
  return (sorted[(values.length - 1) >> 1] + sorted[values.length >> 1]) / 2;
};

/** Our planner on a map: asks in cells from the north, as the files do. */
export function ours(map, id, config = {}) {
  const { scene } = importScene({ [`${map.name}.map`]: map.text });
  const planner = new Planner(id, scene, config);
  const { resolution, origin } = scene.map;
  const point = (x, y) => ({
    x: origin[0] + (x + 0.5) * resolution,
    y: origin[1] + (map.height - y - 0.5) * resolution,
  });
  const ask = (q) => planner.search(point(q.x0, q.y0), point(q.x1, q.y1));
  const path = ({ path: points }) =>
    points.map((v, i) =>
      i % 2 === 0
        ? Math.floor((v - origin[0]) / resolution)
        : map.height - 1 - Math.floor((v - origin[1]) / resolution),
    );
  return { ask, path, planner, point };
}

/**
 * The lengths that one of our planners tells of its paths, where they are not the files': walks are compared with them.
 */
export function told(map, id, config) {
  const { ask } = ours(map, id, config);
  return (q) => ask(q).costMicro / 1e6;
}

const peer = createRequire(join(peers, "package.json"));

/** PathFinding.js needs a copy of the grid for every search. */
function pathfinding(map, finder, diagonals) {
  const PF = peer("pathfinding");
  const rows = Array.from({ length: map.height }, (_, y) =>
    Array.from(map.blocked.subarray(y * map.width, (y + 1) * map.width)),
  );
  const grid = new PF.Grid(map.width, map.height, rows);
  const search = new PF[finder](
    diagonals
      ? { diagonalMovement: PF.DiagonalMovement.OnlyWhenNoObstacles, heuristic: PF.Heuristic.octile }
      : { diagonalMovement: PF.DiagonalMovement.Never, heuristic: PF.Heuristic.manhattan },
  );
  return { ask: (q) => search.findPath(q.x0, q.y0, q.x1, q.y1, grid.clone()), path: (cells) => cells.flat() };
}

function nba(map) {
  const createGraph = peer("ngraph.graph");
  const ngraph = peer("ngraph.path");
  const { width, height, blocked } = map;
  const graph = createGraph();
  const free = (x, y) => x >= 0 && y >= 0 && x < width && y < height && blocked[y * width + x] === 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) if (free(x, y)) graph.addNode(y * width + x, { x, y });
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      for (const [dx, dy] of [
        [1, 0],
        [0, 1],
        [1, 1],
        [-1, 1],
      ]) {
        const legal =
          free(x, y) && free(x + dx, y + dy) && (dx === 0 || dy === 0 || (free(x + dx, y) && free(x, y + dy)));
        if (legal) graph.addLink(y * width + x, (y + dy) * width + x + dx, dx !== 0 && dy !== 0 ? Math.SQRT2 : 1);
      }
  const finder = ngraph.nba(graph, {
    distance: (_a, _b, link) => link.data,
    heuristic: (a, b) => {
      const [dx, dy] = [Math.abs(a.data.x - b.data.x), Math.abs(a.data.y - b.data.y)];
      return Math.max(dx, dy) + (Math.SQRT2 - 1) * Math.min(dx, dy);
    },
  });
  return {
    ask: (q) => finder.find(q.y0 * width + q.x0, q.y1 * width + q.x1),
    path: (nodes) => nodes.reverse().flatMap((node) => [node.data.x, node.data.y]),
  };
}

function crate(map, which) {
  const module = new WebAssembly.Module(readFileSync(join(peers, "grid_peers.wasm")));
  const { exports } = new WebAssembly.Instance(module);
  const room = exports.alloc(map.blocked.length);
  new Uint8Array(exports.memory.buffer, room, map.blocked.length).set(map.blocked);
  exports.init(map.width, map.height);
  const path = () => new Uint32Array(exports.memory.buffer, exports.path(), exports.path_len()).slice();
  return { ask: (q) => (exports.query(which, q.x0, q.y0, q.x1, q.y1) ? path() : null), path: (cells) => cells };
}

/** A rival's process: answers `{ question, runs }` with its CPU time per run and what its path is worth. */
function serve(name, kind, rules) {
  const map = load(maps, name);
  const makers = { ours, pathfinding, nba, crate };
  const rival = makers[kind[0]](map, ...kind.slice(1));
  process.on("message", ({ question, runs }) => {
    const start = cpu();
    let found;
    for (let run = 0; run < runs; run++) found = rival.ask(question);
    process.send({ ms: (cpu() - start) / runs, length: walk(map, question, rival.path(found), rules) });
  });
  process.send("ready");
}

/**
 * Asks everybody every question in turns. Returns CPU milliseconds by name: of each question's fastest round, summed.
 */
export async function race(map, questions, rivals) {
  for (const rival of rivals) {
    const rules = { four: rival.four, cuts: rival.cuts };
    const role = JSON.stringify([map.name, rival.kind, rules]);
    rival.process = fork(process.argv[1], [maps, peers, native, count, repeats, goals, role], {
      execArgv: ["--max-old-space-size=4000"],
    });
    await once(rival.process, "message");
  }
  const ask = async (rival, question, runs) => {
    rival.process.send({ question, runs });
    return (await once(rival.process, "message"))[0];
  };
  const times = rivals.map(() => questions.map(() => []));
  // Engines compile what is called often, on threads of their own; that is not to be measured.
  for (const [k, rival] of rivals.entries()) {
    for (let spent = 0, n = 0; spent < 400 && n < 3 * questions.length; n++) {
      const q = n % questions.length;
      const runs = 8;
      const first = await ask(rival, questions[q], 1);
      times[k][q].first = first.ms;
      if (first.ms < 20) await ask(rival, questions[q], runs);
      spent += first.ms * (first.ms < 20 ? runs + 1 : 1);
    }
  }
  for (let round = 0; round < Number(repeats); round++) {
    for (const [q, question] of questions.entries()) {
      for (const k of rivals.keys()) {
        const which = (k + q + round) % rivals.length;
        const rival = rivals[which];
        const before = Math.min(times[which][q].first ?? 1, ...times[which][q]);
        // Long enough that a rival finds its caches as it left them, not as the one before it did.
        const runs = Math.max(1, Math.min(1024, Math.floor(10 / Math.max(before, 0.005))));
        const { ms, length } = await ask(rival, question, runs);
        times[which][q].push(ms);
        const expected = rival.expect?.(question) ?? question.length;
        if (rival.mine && !agrees(length, expected)) {
          throw new Error(`${map.name}: ${rival.name} answers ${length} instead of ${expected}`);
        }
        if (typeof length !== "number") throw new Error(`${map.name}: ${rival.name}: ${length}`);
      }
    }
  }
  for (const rival of rivals) rival.process.kill();
  return Object.fromEntries(rivals.map((r, k) => [r.name, times[k].reduce((sum, t) => sum + Math.min(...t), 0)]));
}

// A rival's own process goes no further.
if (role !== undefined) {
  serve(...JSON.parse(role));
  await new Promise(() => undefined);
}
