#!/usr/bin/env bash
# tidy_finds.sh CLANG_TIDY: with the project's list it finds what is planted in planted.cpp, and no more.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

expected=$(sed -n 's|^.*[;{]  *// *\(.*\)$|\1|p' planted.cpp | tr ' ' '\n' | sort)
# It ends with 1, since it finds something.
found=$({ "$1" --quiet planted.cpp -- -std=c++20 -w -fdelayed-template-parsing 2>/dev/null || true; } |
  sed -n 's/.*error: .*\[\([a-z-]*\),-warnings-as-errors\]$/\1/p' | sort)
diff <(echo "$expected") <(echo "$found")
