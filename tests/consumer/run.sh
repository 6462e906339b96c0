#!/usr/bin/env bash
# Uses the library from another project: installed, and from its sources.
#   run.sh BUILD [CMAKE ARGUMENTS]   BUILD: a finished build; the arguments go to both consumers
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
shift
work="$build/consumer"
rm -rf "$work"
mkdir -p "$work"

# The program and the output of docs/library.md are those of the program that is built here.
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$here/../../docs/library.md" | sed '1d;$d'; }
diff <(block cpp) "$here/example.cpp"

try() {
    local name=$1
    shift
    cmake -S "$here/$name" -B "$work/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" >"$work/$name.log"
    cmake --build "$work/$name" >>"$work/$name.log" || { cat "$work/$name.log"; exit 1; }
    "$work/$name/example" | tee "$work/$name.out"
    diff <(block text) "$work/$name.out"
}

cmake --install "$build" --prefix "$work/prefix" >"$work/install.log"
test -x "$work/prefix/bin/spiraling-edge"
"$work/prefix/bin/spiraling-edge" --version
try find_package -DCMAKE_PREFIX_PATH="$work/prefix" "$@"
try add_subdirectory "$@"
# Without CMake.
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name spiraling_edge.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046
${CXX:-c++} -std=c++20 -O0 "$here/example.cpp" $(pkg-config --cflags --libs spiraling_edge) -o "$work/pkg_config"
LD_LIBRARY_PATH=${PKG_CONFIG_PATH%/pkgconfig} "$work/pkg_config" | diff <(block text) -
cmp "$work/find_package.out" "$work/add_subdirectory.out"
