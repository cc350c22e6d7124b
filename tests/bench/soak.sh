#!/usr/bin/env bash
# Many submissions in one run: is anything lost, and does memory grow?
#
#   tests/bench/soak.sh PROGRAM [SUBMISSIONS] [LAB]     10,000 of 06_projected_stencil
#
# Copies of the lab's solution, its alternatives and mistakes, its template and one that takes
# all memory, in turns. Prints the resident memory of the grader and of its worker on the
# way, and wants a result of each submission, alike for all copies of one.
set -euo pipefail
program=$(realpath "$1") count=${2:-10000} lab=${3:-06_projected_stencil}
home=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
work=$(mktemp -d)
grader=''
trap '[ -z "$grader" ] || kill "$grader" 2>/dev/null || true; rm -rf "$work"' EXIT

kinds=("$home/labs/$lab"/{solution,template}.lua "$home/labs/$lab"/{alternatives,mistakes}/*.lua)
mkdir "$work/in"
echo 'return { draw = function() local t = {} while true do t[#t + 1] = ("x"):rep(1e6) .. #t end end }' >"$work/greedy.lua"
kinds+=("$work/greedy.lua")
for i in $(seq 0 $((count - 1))); do
  kind=$((i % ${#kinds[@]}))
  cp "${kinds[kind]}" "$work/in/$(printf '%02d-%05d' "$kind" "$i").lua"
done

"$program" grade "$lab" "$work/in" -o "$work/out" --jobs "$(nproc)" >"$work/said" 2>&1 &
grader=$!
began=$(date +%s)
resident() { # of a process, MiB
  awk '/^VmRSS/ { printf "%d", $2 / 1024 }' "/proc/$1/status" 2>/dev/null || true
}
# The worker that stays, not those that it forks: the oldest that descends from the grader.
worker() {
  local process=$1 child
  while child=$(pgrep -o -P "$process") && [ -n "$child" ]; do
    process=$child
    [[ $(tr '\0' ' ' <"/proc/$process/cmdline") != "$program worker"* ]] || break
  done
  echo "$process"
}
printf '%8s %8s %12s %12s\n' seconds results 'grader MiB' 'worker MiB'
next=0
while kill -0 "$grader" 2>/dev/null; do
  sleep 1
  done_now=$(wc -l <"$work/said")
  [ "$done_now" -ge "$next" ] || continue
  next=$((done_now + (count + 9) / 10))
  printf '%8d %8d %12s %12s\n' $(($(date +%s) - began)) "$done_now" "$(resident "$grader")" \
    "$(resident "$(worker "$grader")")"
done
status=0
wait "$grader" || status=$?
grader=''
took=$(($(date +%s) - began))
[ "$status" -eq 1 ] || { cat "$work/said"; exit 1; }

python3 - "$work/out" "$count" "$took" <<'PYTHON'
import csv, json, pathlib, sys
out, count, took = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
results = [json.loads(file.read_text()) for file in (out / "submissions").glob("*/result.json")]
rows = len(list(csv.reader((out / "scores.csv").open()))) - 1
kinds = {}
for one in results:
    kinds.setdefault(one["submission"][:2], set()).add((one["score"], one["verdict"]))
odd = {kind: said for kind, said in kinds.items() if len(said) > 1}
print(f"{len(results)} results of {count}, {rows} in scores.csv, {count / max(took, 1):.1f} a second; "
      f"{len(kinds)} kinds" + (f"; not alike: {odd}" if odd else ", all copies of one alike"))
sys.exit(len(results) != count or rows != count or bool(odd))
PYTHON
