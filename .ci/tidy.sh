#!/usr/bin/env bash
# clang-tidy with the rules of .clang-tidy over our sources, as many at a time as there are cores.
#   tidy.sh BUILD [FOLDER...]    BUILD holds compile_commands.json; default: core/src and
#   app/cli; app/viewer takes twice as long as both
# A file that was clean is not looked at again until it, a header or the rules change.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1
build=$1
shift
folders=("$@")
[ ${#folders[@]} -gt 0 ] || folders=(core/src app/cli)
tidy=$(command -v clang-tidy-16 || command -v clang-tidy) || { echo "no clang-tidy"; exit 1; }
cache=$build/tidy
mkdir -p "$cache"

common=$({ "$tidy" --version; cat .clang-tidy; find core app tests -name '*.h' | sort | xargs sha256sum; } | sha256sum)
work=()
while read -r file; do
    grep -qF "$PWD/$file\"" "$build/compile_commands.json" || continue # not in this build
    key=$({ echo "$common $file"; cat "$file"; } | sha256sum | cut -d' ' -f1)
    [ -e "$cache/$key" ] || work+=("$file" "$cache/$key")
done < <(find "${folders[@]}" -name '*.cpp' | sort)
echo "clang-tidy: $((${#work[@]} / 2)) files to look at"
[ ${#work[@]} -gt 0 ] || exit 0

check() {
    local output
    # -w: compiler warnings are the compiler's business.
    output=$("$1" -p "$2" --quiet --extra-arg=-w "$3" 2>/dev/null) &&
        : >"$4" && return 0
    echo "$output"
    return 1
}
export -f check
printf '%s\0' "${work[@]}" | xargs -0 -n 2 -P "$(nproc)" bash -c 'check "$@"' check "$tidy" "$build"
