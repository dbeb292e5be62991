import { readFileSync, writeFileSync } from "node:fs";
import { init, Planner, scenario } from "/tmp/b23-pkg/node.js";
await init();
const file="tests/data/plan-hashes.json"; const text=readFileSync(file,"utf8"); const all=JSON.parse(text);
let bad=0;
for (const [id,h] of Object.entries(all)) { for (const p of [...Object.keys(h).filter(k=>!k.startsWith("hybrid")), "dijkstra","greedy","rrt","genetic"]) { const q=new Planner(p, scenario(id)); const hash=q.plan().hash; q.free(); if (h[p]!==undefined) { if (h[p]!==hash) { bad++; console.log("differs",id,p);} } else h[p]=hash; } }
console.log("bad",bad);
const sorted=Object.fromEntries(Object.entries(all).map(([k,v])=>[k,Object.fromEntries(Object.entries(v).sort(([a],[b])=>a<b?-1:1))]));
writeFileSync(file, JSON.stringify(sorted,null,2)+(text.endsWith("\n")?"\n":""));
