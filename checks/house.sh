#!/usr/bin/env bash
# The rules of the house that a search finds: who may include whom, and that every script parses.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

failures=0
fail() {
  printf '%s\n' "$1" >&2
  failures=$((failures + 1))
}

# only FOLDERS HEADERS: the headers that match HEADERS are included in FOLDERS of src/ alone.
only() {
  local line
  while IFS= read -r line; do
    fail "$line: allowed only in ${1//|/, }"
  done < <(grep -rnE "#include *[<\"]($2)" src | grep -vE "^src/($1)/" || true)
}
only 'lua' '(lua|lauxlib|lualib)\.h'
only 'gl|context' 'GL/'
only 'context' 'EGL/|GLFW/|GL/(osmesa|glx)|X11/|wayland'
only 'live' 'imgui'

# src/CMakeLists.txt says on which floors a floor stands; with those that they stand on, these are
# all that it may include. tests/unit/FLOOR may include what FLOOR may; cli stands on everything.
declare -A below=([cli]=" cli ")
while read -r floor floors; do
  below[$floor]=" $floor "
  for direct in $floors; do below[$floor]+="${below[$direct]:-$direct} "; done
  below[cli]+="$floor "
done < <(sed 's/#.*//' src/CMakeLists.txt | tr '\n' ' ' | grep -oE 'shadowlab_floor\([^)]*\)' |
  sed -E 's/shadowlab_floor\(|\)| LIBRARIES.*//g; s/ FLOORS / /')
[ "${#below[@]}" -ge 10 ] || fail "src/CMakeLists.txt: its floors could not be read"

while IFS=: read -r file number included; do
  folder=${file#src/} folder=${folder#tests/unit/} folder=${folder%%/*}
  floor=${included#*\"} floor=${floor%%/*}
  [ -n "${below[$folder]:-}" ] && [ -n "${below[$floor]:-}" ] || continue
  [[ ${below[$folder]} == *" $floor "* ]] ||
    fail "$file:$number: the floor $folder does not stand on $floor"
done < <(grep -rnE '^#include "[a-z]+/' src tests/unit)

while IFS= read -r script; do
  bash -n "$script" || fail "$script: bash cannot read it"
done < <(find ./*.sh checks tests .ci/run -name '*.sh' -o -name run)

[ "$failures" -eq 0 ]
