#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER: clang-tidy finds nothing in src/. A floor that passed is not read again.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. checks/build.sh

# What clang-tidy counts and does not show is no news.
ninja -C "$1" -k 0 -j "$(jobs_here)" tidy 2>&1 | grep -vE '^[0-9]+ warnings? generated|^\[[0-9]+/'
exit "${PIPESTATUS[0]}"
