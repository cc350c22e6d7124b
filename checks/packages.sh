# Sourced by demo.sh and test.sh: the Debian packages of packages.txt, installed where they are missing.
# shellcheck shell=bash

# Says why the work cannot go on, in one sentence, and ends the script. 3: this machine cannot.
stop() {
  printf '%s\n' "$2" >&2
  exit "$1"
}

# wanted_packages all|without_tests: the names in packages.txt, one a line.
wanted_packages() {
  awk -v kind="$1" '/^#/ { part = $0; next } NF && (kind == "all" || part != "# tests") { print $1 }' \
    packages.txt | sort -u
}

# missing_packages all|without_tests: those of them that this machine has not installed.
missing_packages() {
  local wanted
  wanted=$(wanted_packages "$1")
  # dpkg-query fails when it does not know one of them, and still lists the others.
  # shellcheck disable=SC2086  # names are split into words on purpose
  dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
    sed -n 's/^installed //p' | sort -u | comm -23 <(printf '%s\n' "$wanted") - || true
}

# apt-get, as root or through sudo; it asks nothing, and waits for another apt-get to end.
apt() {
  local command=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@")
  if [ "$(id -u)" -eq 0 ]; then
    "${command[@]}"
  elif { : </dev/tty; } 2>/dev/null; then
    sudo "${command[@]}"
  else
    sudo -n "${command[@]}"
  fi
}

# Runs apt with its own progress on a terminal, and with its output kept in $log elsewhere.
apt_shown() {
  if [ -t 1 ]; then
    apt "$@" 2>&1 | tee -a "$log"
  else
    apt -q "$@" >>"$log" 2>&1
  fi
}

# install_packages all|without_tests
install_packages() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    stop 3 "This is not Debian (it has no apt-get): install what packages.txt lists, then build with cmake --preset release && cmake --build --preset release."
  fi
  local missing log why
  missing=$(missing_packages "$1" | tr '\n' ' ')
  missing=${missing% }
  [ -z "$missing" ] && return
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    stop 3 "Packages are missing and only root can install them: as root, run apt-get install $missing"
  fi
  echo "Installing $missing"
  log=$(mktemp)
  # Old lists name files that the mirror no longer has; without a network the lists may still do.
  apt_shown update || true
  # shellcheck disable=SC2086
  if ! apt_shown install -y --no-install-recommends $missing || [ -n "$(missing_packages "$1")" ]; then
    why=$(grep -m1 -E '^(E:|sudo:)' "$log" | sed -e 's/^E: //' -e 's/[.[:space:]]*$//')
    rm -f "$log"
    stop 3 "These packages are missing and could not be installed${why:+ ($why)}: $missing"
  fi
  rm -f "$log"
}
