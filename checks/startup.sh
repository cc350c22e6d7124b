#!/usr/bin/env bash
# What `shadowlab run scripts/projected_stencil.lua` costs as a whole process at 512x512:
#
#   checks/startup.sh [SHADOWLAB] [RUNS]
#
# Elapsed time and processor time (of all threads) of warm starts and of starts with an empty Mesa
# shader cache, the peak of resident memory, and where a warm start's time goes: told from outside,
# by what smaller jobs cost. Medians; on a busy machine the processor time is what to read.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

shadowlab=${1:-build/release/bin/shadowlab}
runs=${2:-21}
recipe=scripts/projected_stencil.lua
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export MESA_SHADER_CACHE_DIR=$work/cache
echo 'return { draw = function() end }' >"$work/nothing.lua"

# once WORDS: milliseconds elapsed and of processors for one run of shadowlab.
once() {
  local TIMEFORMAT='%R %U %S'
  { time "$shadowlab" "$@" >"$work/printed" 2>&1; } 2>&1 |
    awk '{ printf "%.0f %.0f\n", $1 * 1000, ($2 + $3) * 1000 }'
}
# medians WORDS: of `runs` runs.
medians() {
  for _ in $(seq "$runs"); do once "$@"; done >"$work/times"
  local middle=$(((runs + 1) / 2))
  echo "$(cut -d' ' -f1 "$work/times" | sort -n | sed -n ${middle}p)" \
    "$(cut -d' ' -f2 "$work/times" | sort -n | sed -n ${middle}p)"
}

"$shadowlab" run $recipe -o "$work/out.png" # files are in memory, shaders in the cache
read -r main_elapsed main < <(medians --version)
read -r context_elapsed context < <(medians run "$work/nothing.lua" --size 1x1 -o "$work/out.png")
read -r small_elapsed small < <(medians run $recipe --size 16x16 -o "$work/out.png")
read -r warm_elapsed warm < <(medians run $recipe -o "$work/out.png")

for _ in $(seq "$runs"); do
  rm -rf "$MESA_SHADER_CACHE_DIR"
  once run $recipe -o "$work/out.png"
done >"$work/times"
middle=$(((runs + 1) / 2))
cold_elapsed=$(cut -d' ' -f1 "$work/times" | sort -n | sed -n ${middle}p)
cold=$(cut -d' ' -f2 "$work/times" | sort -n | sed -n ${middle}p)

# VmHWM is the kernel's own peak, while the process lives: the last reading is the one before its end.
peak=0
for _ in 1 2 3; do
  "$shadowlab" run $recipe -o "$work/out.png" &
  process=$!
  while read -r _ kilobytes _ < <(grep VmHWM "/proc/$process/status" 2>/dev/null); do
    [ "$kilobytes" -le "$peak" ] || peak=$kilobytes
  done
  wait "$process"
done

printf '%-34s %10s %10s\n' 'ms, medians' elapsed processor
printf '%-34s %10s %10s   target 60\n' 'warm shader cache' "$warm_elapsed" "$warm"
printf '%-34s %10s %10s   target 200\n' 'empty shader cache' "$cold_elapsed" "$cold"
printf 'of a warm start\n'
printf '%-34s %10s %10s\n' '  start to main' "$main_elapsed" "$main" \
  '  driver, context, Lua' $((context_elapsed - main_elapsed)) $((context - main)) \
  '  scene, shaders, passes at 16x16' $((small_elapsed - context_elapsed)) $((small - context)) \
  '  512x512 pixels and their PNG' $((warm_elapsed - small_elapsed)) $((warm - small))
printf '%-34s %7d MB              target 150\n' 'peak memory' $((peak / 1024))
