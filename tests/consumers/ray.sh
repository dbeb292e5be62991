#!/bin/sh
# Ray plans a folder of scenes in shards; the digest is that of one plain run. `sh tests/consumers/ray.sh`, with the
# package in pkg/ and Ray in the Python that PYTHON names.
set -eu
command="node $PWD/pkg/cli/main.js" example="$PWD/examples/cluster/ray_batch.py" into=$(mktemp -d)
trap 'rm -rf "$into"' EXIT
cd "$into"
for seed in $(seq 1 40); do $command generate --size 20 --seed "$seed" --out "scene-$seed.json"; done
mkdir scenes && mv scene-*.json scenes
whole=$($command batch scenes --planner eight --out whole.jsonl --quiet | sed 's/.*digest //')
sharded=$("${PYTHON:-python3}" "$example" scenes --shards 4 --planner eight --out shards --command "$command" |
  tail -n 1)
case "$sharded" in
  "$whole  40 results") echo "Ray: 4 shards, the digest of one run" ;;
  *) echo "Ray: $sharded, not $whole" && exit 1 ;;
esac
