#!/usr/bin/env bash
# Installs what is missing, builds shadowlab and runs its tests:
#
#   ./test.sh                all tests, with and without sanitizers
#   ./test.sh --release      those of the release build alone, checks of format and style among them
#   ./test.sh --asan         those of the build with the address and undefined-behaviour sanitizers
#   ./test.sh -R Planar      whatever else is given goes to ctest
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
exec </dev/null
. checks/packages.sh
. checks/build.sh

presets=(release asan)
case ${1:-} in
  --release | --debug | --asan | --tsan)
    presets=("${1#--}")
    shift
    ;;
esac

install_packages all
lock_build_folder
for preset in "${presets[@]}"; do build "$preset" all; done

# One run of CTest over the presets: a folder whose tests are theirs.
mkdir -p build/tests
printf 'subdirs("../%s")\n' "${presets[@]}" >build/tests/CTestTestfile.cmake

# GLFW needs a display: one of our own, so that no window opens on the user's and every machine
# tests the same driver.
exec {number_of_display}< <(exec Xvfb -displayfd 1 -screen 0 1024x768x24 -nolisten tcp 2>build/xvfb.log 9>&-)
xvfb=$!
trap 'kill "$xvfb" 2>/dev/null && wait "$xvfb" 2>/dev/null || true' EXIT
if read -r -t 20 -u "$number_of_display" number; then
  export DISPLAY=:$number
else
  unset DISPLAY
  echo "Xvfb does not start (see build/xvfb.log): tests of windows are skipped." >&2
fi
export MESA_SHADER_CACHE_DIR=$PWD/build/shader_cache
# As many tests as cores run at once, so each draws on its own thread alone.
export LP_NUM_THREADS=${LP_NUM_THREADS:-0}

# Not exec: the display ends when the tests have.
ctest --test-dir build/tests --parallel "$(nproc)" --output-on-failure --no-tests=error "$@"
