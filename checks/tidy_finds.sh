#!/usr/bin/env bash
# tidy_finds.sh CLANG_TIDY: with the project's list it finds what is planted in planted/, and no more: in
# sources that are read as one as in one that clashes with them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/planted"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

sources=("$PWD"/{first,together,alone}.cpp)
for source in "${sources[@]}"; do
  printf '{"directory": "%s", "file": "%s", "arguments": ["c++", "-std=c++20", "-c", "%s"]}\n' "$work" "$source" "$source"
done | sed '1s/^/[/; $!s/$/,/; $s/$/]/' >"$work/compile_commands.json"

expected=$(sed -n 's|^.*[;{]  *// *\(.*\)$|\1|p' "${sources[@]}" | tr ' ' '\n' | sort)
# It ends with 1, since it finds something.
found=$({ ../tidy_together.sh "$1" "$work" "${sources[@]}" || true; } |
  sed -n 's/.*error: .*\[\([a-z-]*\),-warnings-as-errors\]$/\1/p' | sort)
diff <(echo "$expected") <(echo "$found")
