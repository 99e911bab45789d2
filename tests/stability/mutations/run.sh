#!/bin/sh
# Which case notices a broken shader? Applies one mutation after the other to a copy of the tree, builds the program, runs the
# hard cases and says which cells fail that hold without the mutation. A mutation that no case notices is given to the
# contract tests of methods. Exits 1 if one stays unnoticed. Needs a few minutes; ccache makes it cheap if it is installed.
#   tests/stability/mutations/run.sh [WORK]     WORK: scratch folder, default a new one under the system's temporary folder
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
work=${1:-$(mktemp -d)}
tree=$work/tree
binaries=$tree/build/release
jobs=$(nproc)
mkdir -p "$tree"
# What git knows and what is new, as it lies here; build trees and fetched packages stay behind.
(cd "$root" && git ls-files -z --cached --others --exclude-standard | tar --null --ignore-failed-read -T - -cf - 2>/dev/null) |
    tar -C "$tree" -xf -
if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR="$tree" CCACHE_NOHASHDIR=1
fi
build() { cmake --build "$binaries" -j "$jobs" --target "$@" >"$work/build.log" 2>&1 || { tail -20 "$work/build.log"; exit 1; }; }
# Failing cells, one "case, method" a line.
run_cases() {
    "$binaries/harness/app/alcove" stability --out "$work/$1" >"$work/$1.txt"
    python3 - "$work/$1/stability.json" >"$work/$1.failing" <<'PY'
import json, sys
record = json.load(open(sys.argv[1]))
for cell in record["cells"]:
    for score, severity in zip(cell["scores"], range(len(cell["scores"]))):
        margin = score["score"] <= score["bound"] if isinstance(score["score"], (int, float)) else False
        if score["fault"] or not margin:
            print(f'{cell["case"]}\t{cell["method"]}\t{severity}\t{bool(score["fault"])}')
PY
}
(cd "$tree" && cmake --preset release >"$work/configure.log")
build alcove
run_cases sound
unnoticed=0
printf '%-22s %s\n' mutation 'noticed by (new failing case: methods)'
for patch in "$here"/*.patch; do
    name=$(basename "$patch" .patch)
    patch -s -d "$tree" -p1 <"$patch"
    build alcove
    run_cases "$name"
    said=$(python3 - "$work/sound.failing" "$work/$name.failing" <<'PY'
import sys
sound, broken = ({tuple(line.rstrip("\n").split("\t")) for line in open(path)} for path in sys.argv[1:])
cases = {}
for case, method, *_ in sorted(broken - sound):
    cases.setdefault(case, set()).add(method)
print("; ".join(f"{case}: {len(methods)}" for case, methods in cases.items()))
PY
)
    if [ -z "$said" ]; then
        build contract_methods_test
        if "$binaries/tests/contract/contract_methods_test" >"$work/$name.contract" 2>&1; then
            said='NOTHING'
            unnoticed=1
        else
            said="contract tests: $(grep -c '^\[  FAILED  \] .*ms)' "$work/$name.contract")"
        fi
    fi
    printf '%-22s %s\n' "$name" "$said"
    patch -s -R -d "$tree" -p1 <"$patch"
done
exit $unnoticed
