# Sourced by demo.sh and test.sh: one preset configured and built in build/PRESET, with progress.
# shellcheck shell=bash
# Needs stop() of packages.sh.

# Bash runs these when the command under way has ended, before what the script says about its failure.
trap 'echo; exit 130' INT
trap 'exit 143' TERM

# How many compilers may run at once: one a core, while each has 1.5 GB for this project's templates.
jobs_here() {
  local cores megabytes limit
  cores=$(nproc)
  megabytes=$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)  # of a container
  if [ "$limit" != max ] && [ $((limit / 1048576)) -lt "$megabytes" ]; then
    megabytes=$((limit / 1048576))
  fi
  local fit=$((megabytes / 1536))
  [ "$fit" -ge 1 ] || fit=1
  echo $((fit < cores ? fit : cores))
}

# One build at a time in this checkout; the lock is held until the script ends.
lock_build_folder() {
  mkdir -p build 2>/dev/null
  { exec 9>build/lock; } 2>/dev/null ||
    stop 3 "The folder $PWD/build cannot be written to: is it another user's?"
  if ! flock -n 9; then
    echo "Waiting for another build in this folder to end..."
    flock 9
  fi
  # ccache gives up where it has no folder of its own to write to.
  [ -w "${HOME:-/nonexistent}" ] || export CCACHE_DIR="${CCACHE_DIR:-$PWD/build/ccache}"
}

# Prints ninja's lines as one that changes on a terminal, and about ten in a pipe.
show_progress() {
  local name=$1 line done total shown=-1 width=$((${COLUMNS:-80} - 1))
  while IFS= read -r line; do
    [[ $line =~ ^\[([1-9][0-9]*)/([0-9]+)\]\ (.*) ]] || continue
    done=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
    if [ -t 1 ]; then
      printf '\r\033[K%.*s' "$width" "Building $name: $done of $total, ${BASH_REMATCH[3]##*/}"
    elif [ $((done * 10 / total)) -ne "$shown" ]; then
      shown=$((done * 10 / total))
      echo "Building $name: $done of $total"
    fi
  done
  [ -t 1 ] && printf '\r\033[K'
  return 0
}

# The compiler's, linker's or CMake's first error in a log, with what it points at.
first_error() {
  grep -m1 -A4 -E 'error:|CMake Error|undefined reference|multiple definition' "$1" || tail -n 5 "$1"
}

# configure PRESET TARGET: does nothing where the build folder is of this checkout and newer than the
# presets; ninja itself runs CMake again for everything else. A configuration that was cut short starts
# afresh. The target `all` has tests and benchmarks in it, which need packages of their own.
configure() {
  local folder=build/$1 parts=(-DSHADOWLAB_TESTS=OFF -DSHADOWLAB_BENCH=OFF) tests='(ON|OFF)'
  [ "$2" != all ] || parts=() tests=ON
  if [ -f "$folder/build.ninja" ] && [ "$folder/build.ninja" -nt CMakePresets.json ] &&
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$folder/CMakeCache.txt" &&
    grep -Eq "^SHADOWLAB_TESTS:BOOL=$tests" "$folder/CMakeCache.txt"; then
    return
  fi
  mkdir -p "$folder"
  echo "Configuring $1"
  if ! cmake --fresh --preset "$1" "${parts[@]}" >"$folder/configure.log" 2>&1; then
    rm -f "$folder/build.ninja"
    first_error "$folder/configure.log" >&2
    stop 3 "CMake could not configure shadowlab; all it said is in $folder/configure.log."
  fi
  # CMake leaves an unchanged file's time alone.
  touch "$folder/build.ninja"
}

# build PRESET TARGET...
build() {
  local folder=build/$1
  configure "$1" "$2"
  set +e
  ninja -C "$folder" -j "$(jobs_here)" "${@:2}" 2>&1 | tee "$folder/build.log" | show_progress "$1"
  local status=${PIPESTATUS[0]}
  set -e
  if [ "$status" -ne 0 ]; then
    first_error "$folder/build.log" >&2
    stop 1 "shadowlab did not compile; all that the compiler said is in $folder/build.log."
  fi
}
