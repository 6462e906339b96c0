#!/usr/bin/env bash
# Builds the program for the browser and tests it: its decisions against those of the native program, its
# size, and the page in Chromium and Firefox. By hand: it is not part of ./test.sh.
#   test.sh [-j N]
# Pictures of the page go to build-web/pictures/.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
app/web/build.sh "$@"
.ci/packages.sh web-test
app/web/tests/hashes.sh build/bin/spiraling-edge build-web/build/bin/spiraling-edge.js
app/web/tests/size.sh build-web/site
xvfb-run -a node app/web/tests/warm.js build/bin/spiraling-edge-viewer build-web/site
node app/web/tests/pages.js build-web/site build-web/spiraling-edge.html build-web/pictures
xvfb-run -a node app/web/tests/firefox.js build-web/site build-web/spiraling-edge.html build-web/pictures
