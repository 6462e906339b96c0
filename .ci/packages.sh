#!/usr/bin/env bash
# The one list of Debian packages that the project needs, and their installation.
#   packages.sh run     to build and run the programs
#   packages.sh test    to build and run the tests, too
#   packages.sh web     to build the page, app/web/build.sh
#   packages.sh web-test    to test it, app/web/test.sh
#   packages.sh package     to make and test Debian packages, app/packaging/test.sh
# Installs missing packages, as root or with sudo; returns quickly if there are none.
set -euo pipefail

run=(
    g++ cmake ninja-build pkg-config ccache
    libglm-dev zlib1g-dev                              # core
    libcli11-dev nlohmann-json3-dev libfmt-dev         # programs
    libcmark-dev libtomlplusplus-dev                   # lessons
    libglfw3-dev libimgui-dev libstb-dev python3-glad  # viewer
    libcgif-dev                                        # animations
    libegl-dev libegl1 libgl1 libgl1-mesa-dri          # OpenGL, in software if necessary
    fonts-dejavu-core fonts-inter
)
test=(
    doctest-dev libbenchmark-dev
    libnanoflann-dev     # the baseline of the neighbor search
    admesh assimp-utils librsvg2-bin ffmpeg  # other programs, to test written and read files
    pybind11-dev python3-dev python3-numpy               # the Python package,
    python3-pytest python3-pip python3-venv python3-matplotlib python3-meshio  # its tests and examples
    clang-format-14 clang-tidy-16
    xvfb xauth xdotool x11-utils x11-xserver-utils imagemagick python3-xlib  # the viewer under a virtual display
)

web=(emscripten nodejs dpkg-dev python3 python3-fonttools)
browsers=(chromium firefox-esr xvfb xauth)
package=(pybind11-dev python3-dev python3-numpy dpkg-dev fakeroot lintian mmdebstrap desktop-file-utils appstream shared-mime-info librsvg2-bin man-db groff zsh fish)

case "${1:-}" in
    run) wanted=("${run[@]}") ;;
    test) wanted=("${run[@]}" "${test[@]}") ;;
    web) wanted=("${run[@]}" "${web[@]}") ;;
    web-test) wanted=("${run[@]}" "${web[@]}" "${browsers[@]}") ;;
    package) wanted=("${run[@]}" "${package[@]}") ;;
    *) sed -n '2,8p' "$0" >&2; exit 2 ;;
esac

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "Not a Debian system: please install these: ${wanted[*]}" >&2
    exit 0
fi

# Packages of the list that are not installed, one per line. dpkg-query fails if one of them is
# unknown, which is not an error here.
missing() {
    local installed
    installed=$({ dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true; } |
        sed -n 's/ installed$//p')
    printf '%s\n' "${wanted[@]}" | grep -vxF -e "$installed" || true
}

mapfile -t needed < <(missing)
[ "${#needed[@]}" -gt 0 ] || exit 0

sudo=()
if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "Please install as root: apt-get install ${needed[*]}" >&2
        exit 1
    fi
    sudo=(sudo)
fi
echo "Installing: ${needed[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
apt=("${sudo[@]}" apt-get -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3 -qq)
"${apt[@]}" update >&2
"${apt[@]}" install -y --no-install-recommends "${needed[@]}" >&2
