#!/usr/bin/env bash
# Makes the pictures of README.md and the pages here. Needs no display.
#   docs/make-pictures.sh [VIEWER]
set -euo pipefail
cd "$(dirname "$0")"
viewer=${1:-../build/bin/spiraling-edge-viewer}
mkdir -p images
"$viewer" scene:torus --no-config --size 1440x810 --goto 50% --screenshot images/viewer.png
./make-rule-pictures.sh "$(dirname "$viewer")/spiraling-edge"
