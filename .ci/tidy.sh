#!/usr/bin/env bash
# clang-tidy with the rules of .clang-tidy over our sources, as many at a time as there are cores.
#   tidy.sh BUILD [FOLDER...]    BUILD holds compile_commands.json; default: core and app
# Many sources are checked as one, which takes a tenth of the time, since most of it is spent in
# includes. A clean source is checked again only after it, a header or the rules change.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1
build=$1
shift
folders=("$@")
[ ${#folders[@]} -gt 0 ] || folders=(core app)
tidy=$(command -v clang-tidy-16 || command -v clang-tidy) || { echo "no clang-tidy"; exit 1; }
cache=$build/tidy
mkdir -p "$cache"

# Writes sources that include 60 others each, with their compile commands; prints their names.
together() {
    python3 - "$build" "$cache" "${folders[@]}" <<'PYTHON'
import json, pathlib, re, sys
build, cache, *folders = sys.argv[1:]
here, cache = pathlib.Path.cwd(), pathlib.Path(cache).resolve()
flags_of = {}  # source -> folder and flags that it is compiled with
for entry in json.loads((pathlib.Path(build) / "compile_commands.json").read_text()):
    file = pathlib.Path(entry["file"])
    sources = re.findall(r'#include "(.*)"', file.read_text()) if "Unity" in file.parts else [str(file)]
    for source in sources:
        if any(pathlib.Path(source).is_relative_to(here / folder) for folder in folders):
            flags_of.setdefault(source, (entry["directory"], entry["command"].split(" -o ")[0]))
groups = {}
for source, flags in sorted(flags_of.items()):
    groups.setdefault(flags, []).append(source)
commands = []
for (directory, flags), sources in groups.items():
    for i in range(0, len(sources), 60):
        file = cache / f"together_{len(commands)}.cpp"
        file.write_text("".join(f'#include "{source}"\n' for source in sources[i : i + 60]))
        commands.append({"directory": directory, "file": str(file), "command": f"{flags} -c {file}"})
(cache / "compile_commands.json").write_text(json.dumps(commands))
print("\n".join(command["file"] for command in commands))
PYTHON
}

common=$({ "$tidy" --version; cat .clang-tidy; find core app tests -name '*.h' | sort | xargs sha256sum; } | sha256sum)
work=()
while read -r file; do
    key=$({ echo "$common"; cat "$file"; sed -E 's/.*"(.*)"/\1/' "$file" | xargs cat; } | sha256sum | cut -d' ' -f1)
    [ -e "$cache/$key" ] || work+=("$file" "$cache/$key")
done < <(together)
echo "clang-tidy: $((${#work[@]} / 2)) times 60 files to look at"
[ ${#work[@]} -gt 0 ] || exit 0

check() {
    local output
    local checks=
    # This one takes half of the time in the templates that app includes.
    grep -q '/app/' "$3" && checks=-performance-unnecessary-value-param
    # -w: no compiler warnings here.
    output=$("$1" -p "$2" --config-file=.clang-tidy --checks="$checks" --quiet --extra-arg=-w "$3" \
        2>/dev/null) &&
        : >"$4" && return 0
    echo "$output"
    return 1
}
export -f check
printf '%s\0' "${work[@]}" | xargs -0 -n 2 -P "$(nproc)" bash -c 'check "$@"' check "$tidy" "$cache"
