#!/usr/bin/env bash
# Submissions a second of `shadowlab grade` with one job, beside the usual script: a process for each
# picture and an ImageMagick `compare` for each. Four pictures of 256², one after the other, the
# shader cache cold and warm. Prints milliseconds a submission, and the ratios: of a class of 100, with
# all that is done once for it (reference, worker, its shaders), against the script's one submission.
#
#   tests/bench/grading.sh PROGRAM [LAB] [SUBMISSIONS]
set -euo pipefail
program=$(realpath "$1") lab=${2:-06_projected_stencil} count=${3:-100}
home=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export LP_NUM_THREADS=0

seconds() {
  local from to
  from=$(date +%s%N)
  "$@" >/dev/null 2>&1 || true
  to=$(date +%s%N)
  echo $(((to - from) / 1000))
}
per() { awk -v t="$1" -v n="$2" 'BEGIN { printf "%8.1f ms a submission, %6.1f a second\n", t / n / 1000, n * 1e6 / t }'; }

kind() { # NAME FILE: so many copies of one recipe
  mkdir -p "$1"
  for i in $(seq "$count"); do cp "$2" "$1/s$i.lua"; done
}
kind right "$home/labs/$lab/solution.lua"
kind wrong "$(ls "$home/labs/$lab"/mistakes/*.lua | head -1)"
mkdir one && cp "$home/labs/$lab/solution.lua" one/

grade() { rm -rf out; "$program" grade "$lab" "$1" -o out --jobs 1; }
views=("2,4,1" "1,3,2" "-1,4,1" "0,5,1")
script() { # the usual one
  local view
  for view in "${views[@]}"; do
    "${runner[@]}" "$program" run "right/s1.lua" --size 256x256 --set "light=$view" -o mine.png "${context[@]}"
    compare -metric AE -fuzz 1.2% "expected_$view.png" mine.png null:
  done
}
thrice() { for _ in 1 2 3; do fresh; script; done; }
runner=() context=(--context osmesa)
for view in "${views[@]}"; do
  "$program" run right/s1.lua --size 256x256 --set "light=$view" -o "expected_$view.png"
done

for cache in cold warm; do
  if [ $cache = cold ]; then
    export MESA_SHADER_CACHE_DIR=$work/cache
    fresh() { rm -rf "$work/cache"; }
  else
    fresh() { :; }
    grade one >/dev/null 2>&1 || true
  fi
  fresh; started=$(seconds grade one)
  fresh; right=$(seconds grade right)
  fresh; wrong=$(seconds grade wrong)
  scripted=$(($(seconds thrice) / 3))
  printf '%s: started and one  ' $cache; per "$started" 1
  printf '%s: grade, right     ' $cache; per "$right" "$count"
  printf '%s: grade, wrong     ' $cache; per "$wrong" "$count"
  printf '%s: script, OSMesa   ' $cache; per "$scripted" 1
  if command -v xvfb-run >/dev/null; then
    runner=(xvfb-run -a) context=(--context glfw)
    scripted_x=$(($(seconds thrice) / 3))
    printf '%s: script, xvfb-run ' $cache; per "$scripted_x" 1
    runner=() context=(--context osmesa)
  else
    scripted_x=0
  fi
  awk -v a="$scripted" -v x="$scripted_x" -v g="$right" -v n="$count" -v c=$cache \
    'BEGIN { t = g / n; printf "%s: %.1f times the OSMesa script, %.1f times the xvfb-run one\n", c, a / t, x / t }'
done
