#!/usr/bin/env bash
# Every C++ file is as clang-format leaves it. With --fix it rewrites those that are not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(--dry-run --Werror)
[ "${1:-}" = --fix ] && mode=(-i)
find src tests \( -name '*.cpp' -o -name '*.h' \) -print0 |
  xargs -0 -n 20 -P "$(nproc)" clang-format "${mode[@]}" ||
  { echo "These files are not formatted: checks/format.sh --fix does it." >&2; exit 1; }
