#!/usr/bin/env bash
# Installs what is missing, builds shadowlab and renders every recipe of scripts/ into out/gallery.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
exec </dev/null
. checks/packages.sh
. checks/build.sh

install_packages without_tests
lock_build_folder
build release shadowlab
build/release/bin/shadowlab gallery -o out/gallery

cat <<END

Every recipe of scripts/ is drawn: open file://$PWD/out/gallery/index.html

Draw one yourself, and then change its numbers:
  build/release/bin/shadowlab run scripts/projected_stencil.lua -o out.png
END
