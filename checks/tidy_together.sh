#!/usr/bin/env bash
# tidy_together.sh CLANG_TIDY BUILD_FOLDER SOURCE...: clang-tidy finds nothing in these sources.
#
# Most of its time goes into the headers that all of them have, so they are read as one; but each whose
# own names are an earlier one's too, or that needs flags of its own, alone.
set -uo pipefail
tidy=$1 build=$2
shift 2

# read_as_one CHECKS SOURCE...: warnings are the compiler's business, and a template is read where it is
# used first: most of the libraries' are never.
read_as_one() {
  local checks=$1 source flags=(-w -fdelayed-template-parsing -ferror-limit=0)
  shift
  for source in "${@:1:$#-1}"; do flags+=("-include$source"); done
  "$tidy" --quiet -p "$build" --checks="$checks" "${flags[@]/#/--extra-arg=}" "${!#}" 2>&1
}
# The sources that cannot be compiled behind those before them.
clashing() {
  read_as_one '-*,misc-unused-alias-decls' "$@" |
    sed -n 's|^\(/[^:]*\.cpp\):[0-9]*:[0-9]*: error: .*\[clang-diagnostic-error\]$|\1|p' | sort -u
}

together=() alone=("$@")
if [ $# -gt 1 ]; then
  mapfile -t alone < <(clashing "$@")
  for source in "$@"; do
    [[ " ${alone[*]} " == *" $source "* ]] || together+=("$source")
  done
fi
failed=0
# They are included, which is suspicious. An error in a header is two things of one name in one floor.
[ ${#together[@]} -eq 0 ] || read_as_one '-bugprone-suspicious-include' "${together[@]}" || failed=1
for source in "${alone[@]}"; do read_as_one '' "$source" || failed=1; done
exit $failed
