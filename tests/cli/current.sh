#!/usr/bin/env bash
# current.sh FILE GENERATOR [ARGUMENT…]: FILE is what GENERATOR prints now.
set -uo pipefail
"${@:2}" | diff -u "$1" - ||
  { echo "$1 is not what the code says: ninja -C build/release docs writes it anew." >&2; exit 1; }
