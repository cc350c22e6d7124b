#!/usr/bin/env bash
# What `shadowlab run scripts/projected_stencil.lua` costs as a whole process at 512x512:
#
#   checks/startup.sh [SHADOWLAB] [RUNS]
#
# Medians of warm and cold starts (an empty Mesa shader cache each time), the peak of resident
# memory, and where a warm start's time goes: what the process has done at the calls that strace
# sees, where it is installed. On a busy machine look at the least as well: the median waits too.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

shadowlab=${1:-build/release/bin/shadowlab}
runs=${2:-21}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export MESA_SHADER_CACHE_DIR=$work/cache

draw() { "$shadowlab" run scripts/projected_stencil.lua --size 512x512 -o "$work/out.png"; }

# One run's milliseconds.
milliseconds() {
  local begin=$EPOCHREALTIME
  draw
  local end=$EPOCHREALTIME
  echo $(((${end/[.,]/} - ${begin/[.,]/}) / 1000))
}

# median and least of the numbers on stdin
summary() { sort -n | awk '{ a[NR] = $1 } END { printf "%5d ms, least %d ms", a[int((NR + 1) / 2)], a[1] }'; }

draw # the cache is warm, and the files are in memory
warm=$(for _ in $(seq "$runs"); do milliseconds; done | summary)
cold=$(for _ in $(seq $(((runs + 1) / 2))); do
  rm -rf "$MESA_SHADER_CACHE_DIR"
  milliseconds
done | summary)

# The kernel's own count, from the parent: VmHWM of a process that has ended is in its rusage only.
peak() {
  draw &
  local process=$! most=0 now
  while now=$(awk '/VmHWM/ { print $2 }' "/proc/$process/status" 2>/dev/null) && [ -n "$now" ]; do
    most=$now
  done
  wait "$process"
  echo $((most / 1024))
}
memory=$(for _ in 1 2 3; do peak; done | sort -n | tail -1)

printf 'warm shader cache  %s (target 60)\n' "$warm"
printf 'empty shader cache %s (target 200)\n' "$cold"
printf 'peak memory        %5d MB (target 150)\n' "$memory"
