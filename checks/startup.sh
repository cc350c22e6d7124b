#!/usr/bin/env bash
# What a whole `shadowlab run` costs: the median of some runs with a warm shader cache, of some with a
# cold one, and the peak of memory. A figure, not a test: run it on a quiet machine.
#
#   checks/startup.sh [RUNS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
runs=${1:-15}
program=$PWD/build/release/bin/shadowlab
[ -x "$program" ] || { echo "There is no $program; ./demo.sh builds it." >&2; exit 3; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Milliseconds and kilobytes of one run, from Python's account of its child.
run_once() {
  python3 - "$program" "$folder/out.png" <<'PYTHON'
import resource, subprocess, sys, time
begin = time.monotonic()
subprocess.run([sys.argv[1], "run", "scripts/projected_stencil.lua", "-o", sys.argv[2]], check=True)
print(round((time.monotonic() - begin) * 1000, 1), resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
PYTHON
}
median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

export MESA_SHADER_CACHE_DIR=$folder/warm
run_once >/dev/null
for _ in $(seq "$runs"); do run_once; done >"$folder/warm.txt"
for i in $(seq "$runs"); do MESA_SHADER_CACHE_DIR=$folder/cold$i run_once; done >"$folder/cold.txt"
echo "projected_stencil at 512x512, a whole process, median of $runs:"
echo "  warm shader cache  $(median <"$folder/warm.txt") ms  (target 60)"
echo "  cold shader cache  $(median <"$folder/cold.txt") ms  (target 200)"
echo "  peak memory        $(awk '{ print $2 / 1024 }' "$folder"/warm.txt "$folder"/cold.txt | sort -n | tail -1) MB  (target 150)"
