#!/usr/bin/env bash
# Fuzzes what reads bytes of strangers, each for so many seconds, from tests/fuzz/corpus and what
# earlier runs found:
#
#   checks/fuzz.sh [BUILD_FOLDER] [SECONDS] [NAME...]      build/release, 600, all
#
# An input that breaks something is left in BUILD_FOLDER/fuzz/NAME/. Once it is mended, put the input
# into tests/fuzz/corpus/NAME: each run begins with those.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$(realpath "${1:-build/release}") seconds=${2:-600}
shift $(($# < 2 ? $# : 2))
[ $# -gt 0 ] || set -- obj png wire recipe manifest

# Leaks are looked for after each input: at the end the driver's libraries have let go of theirs.
export ASAN_OPTIONS=leak_check_at_exit=0
for name in "$@"; do
  found=$build/fuzz/$name
  mkdir -p "$found/corpus"
  # Memory and time that an input may take: those of the largest that the readers allow.
  "$build/bin/fuzz_$name" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 \
    -artifact_prefix="$found/" -print_final_stats=1 -verbosity=0 \
    "$found/corpus" "tests/fuzz/corpus/$name" 2>"$found/log" ||
    { tail -60 "$found/log" >&2; echo "fuzz_$name: the input is in $found" >&2; exit 1; }
  printf '%s: %s inputs\n' "$name" "$(sed -n 's/.*number_of_executed_units: *//p' "$found/log")"
done
