#!/bin/sh
# Two groups of six repeats of the same thing, 200 times: how often does `compare` call them different? Some 10 minutes.
#   tests/benchmark/aa_pairs.sh [FOLDER]      FOLDER keeps the run; without one it is thrown away
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
cmake --build "$root/build/release" --target alcove benchmark_aa_pairs > /dev/null
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run=${1:-$work/run}
"$root/build/release/harness/app/alcove" run --scene bunny --method hemisphere_ssao --size 192x144 --frames 0:16 \
    --repeat 2400 --audit 0 --out "$run" > "$work/log" || { cat "$work/log"; exit 1; }
"$root/build/release/tests/benchmark/benchmark_aa_pairs" "$run"
