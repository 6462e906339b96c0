#!/usr/bin/env bash
# Makes the Debian packages, and installs, uses and removes them in a clean Debian 12. By hand, as root; not part of
# ./test.sh. The last line counts.
#   app/packaging/test.sh [-j N] [--site DIR] [--build-site]
# --site DIR: a folder that app/web/build.sh has made, with spiraling-edge.html and site/ (default: build-web, if it is
# there); --build-site builds build-web. Without one there is no package spiraling-edge-web, and its checks are skipped.
# The packages lie in build-package/packages/, the log of each check in build-package/logs/.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
jobs=$(nproc)
site=$PWD/build-web
build_site=
while [ $# -gt 0 ]; do
    case $1 in
        -j) jobs=$2; shift ;;
        --site) site=$(realpath "$2"); shift ;;
        --build-site) build_site=yes ;;
        *) sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
    esac
    shift
done
build=$PWD/build-package
made=$build/packages
logs=$build/logs
root=$build/root
mkdir -p "$logs"
passed=0 failed=0 skipped=0

# check NAME COMMAND...
check() {
    local name=$1 start=$SECONDS
    shift
    if "$@" >"$logs/$name.log" 2>&1 </dev/null; then
        passed=$((passed + 1))
        echo "ok    $name ($((SECONDS - start)) s)"
    else
        failed=$((failed + 1))
        echo "FAIL  $name: $logs/$name.log"
        tail -n 15 "$logs/$name.log"
    fi
}
skip() {
    skipped=$((skipped + 1))
    echo "skip  $1: $2"
}
finish() {
    [ "$skipped" = 0 ] || echo "$skipped skipped"
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
    exit
}

# Equal commits give equal packages: the time in them is that of the commit.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

# The packages
make_packages() {
    rm -rf "$made"
    cpack --config "$build/CPackConfig.cmake" -B "$made" && rm -rf "$made/_CPack_Packages" && ls "$made"/*.deb
}
same_packages() {
    rm -rf "$build/again"
    cpack --config "$build/CPackConfig.cmake" -B "$build/again" || return
    for deb in "$made"/*.deb; do cmp "$deb" "$build/again/${deb##*/}" || return; done
    rm -rf "$build/again"
}
has() { compgen -G "$made/$1_*.deb" >/dev/null; }
# No folder of the machine that built them is in a package, and no path to look for libraries in.
no_traces_of_the_build() {
    local deb status=0 files="$build/unpacked"
    for deb in "$made"/*.deb; do
        rm -rf "$files"
        dpkg-deb -x "$deb" "$files"
        ! grep -rlF "$PWD" "$files" || status=1
        while read -r file; do
            ! readelf -d "$file" 2>/dev/null | grep -E 'R(UN)?PATH' || status=1
        done < <(find "$files" -type f \( -perm -100 -o -name '*.so*' \))
    done
    rm -rf "$files"
    return "$status"
}
tidy_packages() { lintian --fail-on error --tag-display-limit 0 "$made"/*.deb; }

check tools .ci/packages.sh package
configure() { cmake --preset package "-DSPIRALING_EDGE_SITE=$site"; }
check configure configure
check build cmake --build "$build" --parallel "$jobs"
if [ -n "$build_site" ]; then
    check site app/web/build.sh -j "$jobs" -p "$build/bin/spiraling-edge"
    configure >/dev/null # finds the site
fi
check packages make_packages
[ "$failed" = 0 ] || finish
check same_bytes same_packages
check no_traces_of_the_build no_traces_of_the_build
check lintian tidy_packages
grep -E '^[WE]:' "$logs/lintian.log"

# A clean system
clean_system() { mmdebstrap --variant=minbase --mode=root bookworm "$build/clean.tar"; }
# With the packages, and with the consumer of the library.
clean_root() {
    rm -rf "$root"
    mkdir "$root"
    tar -C "$root" -xf "$build/clean.tar" || return
    cp /etc/resolv.conf "$root/etc/"
    cp -r tests/consumer "$root/consumer"
    cp docs/library.md "$root/consumer"
    mkdir "$root/packages"
    cp "$made"/*.deb "$root/packages"
    inside "apt-get update -qq"
}
# inside COMMAND: as root in the clean system, with a /proc of its own, without the variables of this one.
inside() {
    unshare --mount --pid --fork --mount-proc="$root/proc" chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        bash -euo pipefail -c "$1"
}
install() { inside "apt-get install -y --no-install-recommends $*"; }
state() {
    inside "dpkg-query -W -f '\${Package}\n'"
    inside "find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /packages -o -path /consumer \
        -o -path /var/cache -o -path /var/lib/apt -o -path /var/lib/dpkg -o -path /var/log \) -prune -o -print" | sort
}

# Less than an installation: the programs run with the libraries of this machine.
run_unpacked() {
    rm -rf "$root"
    for deb in "$made"/*.deb; do dpkg-deb -x "$deb" "$root" || return; done
    "$root/usr/bin/spiraling-edge" run scene:torus --best --check -o "$root/torus.ply" &&
        "$root/usr/bin/spiraling-edge" render scene:torus -o "$root/torus.png"
}
run_program() {
    install ./packages/spiraling-edge_*.deb || return
    inside "spiraling-edge --version && cd /tmp && spiraling-edge run scene:torus --best -o torus.ply --check &&
        spiraling-edge check torus.ply && test -s /usr/share/man/man1/spiraling-edge-run.1.gz &&
        test -s /usr/share/bash-completion/completions/spiraling-edge && rm torus.ply" || return
    # A command line needs no window.
    ! inside "dpkg-query -W libgl1 || dpkg-query -W libx11-6"
}
run_viewer() {
    install ./packages/spiraling-edge-viewer_*.deb || return
    inside "cd /tmp && spiraling-edge-viewer --version && spiraling-edge render scene:torus -o torus.png && rm torus.png &&
        spiraling-edge export tour -o tour.html && rm tour.html &&
        test -s /usr/share/icons/hicolor/scalable/apps/spiraling-edge-viewer.svg && test -s /usr/share/man/man1/spiraling-edge-viewer.1.gz"
}
open_files_by_type() {
    install shared-mime-info desktop-file-utils libglib2.0-bin || return
    inside "cd /tmp && echo '{}' >a.sesession && echo '# A' >a.lesson.md && echo '{}' >a.setrace &&
        for each in sesession:session lesson.md:lesson setrace:trace; do
            gio info -a standard::content-type a.\${each%:*} | grep -F application/x-spiraling-edge-\${each#*:}; done &&
        for each in session lesson trace; do
            gio mime application/x-spiraling-edge-\$each | grep -F spiraling-edge-viewer.desktop; done && rm a.*"
}
# Each way to link gives the output that docs/library.md prints.
use_library() {
    install ./packages/libspiraling-edge-dev_*.deb g++ cmake ninja-build pkg-config || return
    inside 'cd /consumer
        sed -n "/^\`\`\`text\$/,/^\`\`\`\$/p" library.md | sed "1d;\$d" >wanted
        for library in core core_shared; do
            cmake -S find_package -B $library -G Ninja -DLIBRARY=spiraling_edge::$library && cmake --build $library
            $library/example | diff wanted -
        done
        ldd core_shared/example | grep -F libspiraling_edge.so.
        (! ldd core/example | grep -F libspiraling_edge)
        c++ -std=c++20 example.cpp $(pkg-config --cflags --libs spiraling_edge) -o shared
        c++ -std=c++20 example.cpp $(pkg-config --cflags spiraling_edge) -Wl,-Bstatic $(pkg-config --libs spiraling_edge) -Wl,-Bdynamic -o static
        for each in shared static; do ./$each | diff wanted -; done
        ldd shared | grep -F libspiraling_edge.so.; (! ldd static | grep -F libspiraling_edge)
        echo "#include <spiraling_edge/sampling/sampler.h>
            int main() { return se::Sampler::allSteps() > 0 ? 0 : 1; }" >sampling.cpp
        c++ -std=c++20 sampling.cpp $(pkg-config --cflags --libs spiraling_edge_sampling) -o sampling && ./sampling'
}
use_module() {
    install ./packages/python3-spiraling-edge_*.deb || return
    inside "cd /tmp && python3 -c 'import spiraling_edge as se
print(se.__version__, se.reconstruct(\"scene:torus\"))'"
}
fill_page() {
    install ./packages/spiraling-edge-web_*.deb || return
    inside "cd /tmp && spiraling-edge export --app tour -o tour.html && grep -qF '<meta name=\"start\" content=\"lesson=tour\">' tour.html && rm tour.html &&
        test -s /usr/share/spiraling-edge/site/index.html"
}
# All packages of ours, and what came with them.
remove_all() {
    inside "apt-get purge -y '?and(?installed,?name(spiraling-edge))' && apt-get autoremove --purge -y"
    inside "! find / -xdev \( -path /proc -o -path /packages -o -path /consumer -o -path /var/cache \) -prune -o -print |
        grep -i 'spiraling'" || return
    # Ours alone, beside the tools of the checks.
    inside "rm -rf /consumer/core* /consumer/wanted"
}
# Without the tools of the checks, everything is as before.
leaves_no_trace() {
    rm -rf "$root"
    clean_root || return
    state >"$build/before"
    install "./packages/*.deb" && inside "apt-get purge -y '?and(?installed,?name(spiraling-edge))' && apt-get autoremove --purge -y" || return
    state >"$build/after"
    diff "$build/before" "$build/after"
}

if ! clean_system >"$logs/clean_system.log" 2>&1; then
    skip install "mmdebstrap could not make a clean system, see $logs/clean_system.log; nothing was installed"
    check run_unpacked run_unpacked
    finish
fi
check clean_root clean_root
check run_program run_program
check run_viewer run_viewer
check open_files_by_type open_files_by_type
check use_library use_library
if has python3-spiraling-edge; then check use_module use_module; else skip use_module "this build has no Python module"; fi
if has spiraling-edge-web; then check fill_page fill_page; else skip fill_page "there is no $site/spiraling-edge.html"; fi
check remove_all remove_all
check leaves_no_trace leaves_no_trace
[ "$failed" != 0 ] || rm -rf "$root"
finish
