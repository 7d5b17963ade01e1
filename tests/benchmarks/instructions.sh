#!/usr/bin/env bash
# Instructions an expansion, counted by callgrind over the queries alone (no world, no reference search, no set-up), and
# left in instructions.json, where the verdicts look for them.
#
#   tests/benchmarks/instructions.sh                      every contender but the textbook's on N
#   tests/benchmarks/instructions.sh P astar_1 astar_3    these on P
#
# QUERIES (5) queries each. BUILD (build) is the build tree, built with -DSEAHEX_BUILD_BENCHMARKS=ON.
set -euo pipefail

build="${BUILD:-build}"
program="$build/tests/benchmarks/seahex_contest"
world="${1:-N}"
shift || true
contenders=("$@")
if [ ${#contenders[@]} -eq 0 ]; then
    mapfile -t contenders < <("$program" --worlds="$world" --benchmark_list_tests |
        sed -n "s,^search/$world/\([^/]*\).*,\1,p" | grep -v '^textbook')
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for contender in "${contenders[@]}"; do
    valgrind --tool=callgrind --collect-atstart=no --toggle-collect='seahex::contest::Trial::solve(*' \
        --callgrind-out-file="$scratch/$contender.callgrind" \
        "$program" --worlds="$world" --queries="${QUERIES:-5}" --passes=1 \
        --benchmark_filter="^search/$world/$contender/" --benchmark_out="$scratch/$contender.json" \
        --benchmark_out_format=json >/dev/null 2>"$scratch/$contender.log"
    collected=$(sed -n 's/.*Collected : *\([0-9]*\).*/\1/p' "$scratch/$contender.log")
    /usr/bin/python3 - "$build/instructions.json" "$world" "$contender" "$collected" "$scratch/$contender.json" <<'PYTHON'
import json
import os
import sys

file, world, contender, collected, run = sys.argv[1:]
expanded = json.load(open(run))["benchmarks"][0]["expanded"]
figures = json.load(open(file)) if os.path.exists(file) else {}
figures[f"instructions/{world}/{contender}"] = int(collected) / expanded
json.dump(figures, open(file, "w"), indent=2)
print(f"{world} {contender}: {int(collected) / expanded:.0f} instructions an expansion ({expanded:.0f} expansions)")
PYTHON
done
