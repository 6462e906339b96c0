#!/usr/bin/env bash
# Checks beyond the compiler's: the includes between parts, the one place that writes files, the version, that
# every source file is named in a CMakeLists.txt, the entries of the root, and the limits of size.
# Prints every violation; fails if there is one.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1
breaches=0

breach() {
    echo "$*"
    breaches=$((breaches + 1))
}

# sources FOLDER: the C++ files below a folder.
sources() { find "$1" -name '*.cpp' -o -name '*.h' | sort; }

# no PATTERN WHY FILES...: no line of these files may match.
no() {
    local pattern=$1 why=$2 found
    shift 2
    [ $# -gt 0 ] || return 0
    found=$(grep -nHE "$pattern" "$@") || return 0
    while read -r line; do breach "$why: $line"; done <<<"$found"
}

include() { printf '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"](%s)' "$1"; }

window='glad/|GL/|GLES|EGL/|GLFW/|KHR/|imgui|backends/'
programs='CLI/|nlohmann/|fmt/|stb|toml|cmark'

mapfile -t core < <(sources core)
mapfile -t cli < <(sources app/cli)
mapfile -t teach < <(sources app/teach)
viewer=()
[ ! -d app/viewer ] || mapfile -t viewer < <(sources app/viewer)
mapfile -t web < <(sources app/web)
mapfile -t python < <(sources app/python)
# in_viewer PATTERN: the files of the viewer whose path below app/viewer matches.
in_viewer() { printf '%s\n' ${viewer[@]+"${viewer[@]}"} | grep -E "^app/viewer/$1"; }
mapfile -t not_gl < <(printf '%s\n' "${viewer[@]}" | grep -vE '^app/viewer/(render/|offscreen|window|main|application)')
mapfile -t plain < <(in_viewer '(run|jobs|scene|layers|rows|session|layout|input|paint|export|panel_state|document|lesson|compare|commands)/')

# core -> GLM, the standard library, zlib in inflate.cpp.
no "$(include "$window|$programs|app/|viewer|cli/|teach/|benchmark|doctest|nanoflann")" "core must not know" "${core[@]}"
mapfile -t not_inflate < <(printf '%s\n' "${core[@]}" | grep -v '/inflate.cpp')
no "$(include 'zlib')" "only inflate.cpp may use zlib" "${not_inflate[@]}"
no 'reinterpret_cast' "pointers are of the type that they point to" "${not_inflate[@]}"
no '\b(f?printf|f?puts)\(|std::(cout|cerr|clog)\b' "core prints nothing" "${core[@]}"
no '^#include "([^s]|s[^p])' "core includes as spiraling_edge/ROOM/..." "${core[@]}"
# Rooms of core, from the bottom: each may include those before it. Sampling may include the rooms
# up to prepare; only programs include it.
known=()
rooms=(base points geometry mesh io stepper prepare doctor scenes spec run why)
for room in "${rooms[@]}"; do
    known+=("$room")
    mapfile -t files < <(sources "core/spiraling_edge/$room")
    not_yet=$(printf '%s\n' "${rooms[@]}" sampling | grep -vxF "$(printf '%s\n' "${known[@]}")" | paste -sd '|')
    no "$(include "spiraling_edge/($not_yet)/")" "$room/ must not know" "${files[@]}"
done
mapfile -t files < <(sources core/sampling)
no "$(include 'spiraling_edge/(doctor|scenes|spec|run|why)/')" "sampling/ must not know" "${files[@]}"
mapfile -t files < <(sources core/spiraling_edge/stepper/phases)
no "$(include '.*/robust/')" "phases/ must not know" "${files[@]}"
mapfile -t files < <(sources core/spiraling_edge/stepper/robust)
no "$(include '.*/phases/')" "robust/ must not know" "${files[@]}"
# A run is described once: its options and keys stand in the table of spec/spec_fields.cpp, and nothing else reads them.
mapfile -t not_fields < <(printf '%s\n' "${core[@]}" "${cli[@]}" "${teach[@]}" ${viewer[@]+"${viewer[@]}"} |
    grep -vE '/spec/spec_fields\.cpp$')
options=$(grep -ohE '"(-[kr],)?--[a-z-]+"' core/spiraling_edge/spec/spec_fields.cpp | tr -d '"' | sed 's/.*,//' | sort -u |
    grep -vE '^--(neighbors|box|crop)$' | paste -sd '|')
no "add_(option|flag)\(\"(-[a-z],)?($options)\"" "options of a run follow from spec_fields.cpp" "${not_fields[@]}"

# teach -> core; cli and viewer -> teach
no "$(include "$window|viewer|cli/|glm/gtc|stb|CLI/|fmt/|spiraling_edge/sampling/")" "teach/ must not know" "${teach[@]}"
no "$(include 'toml|cmark')" "only teach/ may use toml++ and cmark" "${cli[@]}" ${viewer[@]+"${viewer[@]}"}
# cli -> core
no "$(include "$window|viewer|\\.\\./viewer|glm/gtc|stb")" "the command line must not know" "${cli[@]}"
# python -> core, sampling's gzip.h, and the painter's figures; these are built without the rest of the viewer
no "$(include "$window|$programs|viewer|cli/|teach/|options/|spiraling_edge/sampling/[^g]|paint/[^f]")" "the Python package must not know" "${python[@]}"
mapfile -t painter < <(printf 'app/viewer/%s\n' $(sed -n '/add_library(spiraling_edge_paint/,/)/s/^ *\(.*\.cpp\)$/\1/p' app/viewer/CMakeLists.txt))
no "$(include 'teach/|spiraling_edge/sampling/|run/model')" "the painter must not know" "${painter[@]}" "${painter[@]/%.cpp/.h}"
no "$(include 'pybind11/')" "only app/python may use pybind11" "${core[@]}" "${cli[@]}" "${teach[@]}" ${viewer[@]+"${viewer[@]}"}
# viewer
no "$(include 'glad/|EGL/|KHR/')" "only render/ may call OpenGL" "${not_gl[@]}"
no "$(include 'imgui|GLFW/')" "this part works without a window" "${plain[@]}"
mapfile -t not_export < <(printf '%s\n' "${viewer[@]}" | grep -v '^app/viewer/export/')
no "$(include 'cgif')" "only export/ may use cgif" "${not_export[@]}"
no "$(include '(\.\./)*web/')|__EMSCRIPTEN__" "the viewer must not know the page" "${viewer[@]}"
# Rooms of the viewer, from the bottom: a room may include those before it. Of one step, those with a
# bar between them do not know each other, those with a plus do.
steps=(run jobs scene 'render|layers' rows session 'layout|input' paint export panel_state document+lesson+compare commands panels)
# below ROOM ABOVE: the files of a room must not include one of the rooms above it.
below() {
    local files
    mapfile -t files < <(in_viewer "$1/")
    no "$(include "$2")" "$1/ must not know" "${files[@]}"
}
for i in "${!steps[@]}"; do
    for room in ${steps[i]//[|+]/ }; do
        own=$(grep -F + <<<"${steps[i]}" | tr + '|')
        above=$(printf '%s\n' "${steps[@]:i}" | tr '|+' '\n\n' | grep -vxE "${own:-$room}" | paste -sd '|')
        below "$room" "($above)/|(options|application|window|offscreen|start_settings)\.h"
    done
done
below render 'imgui\.h'
groups='step|why|faults|find|change|input|lesson|pages|frame|dialogs'
for group in ${groups//|/ }; do
    below "panels/$group" "panels/($(tr '|' '\n' <<<"$groups" | grep -vx "$group" | paste -sd '|'))/"
done
below panels/widgets "panels/($groups)/"

# What the compiler of the browser build does not have: each has one place.
mapfile -t ours < <(printf '%s\n' "${core[@]}" ${viewer[@]+"${viewer[@]}"} |
    grep -vE '/(number_text|text_scan|float_bits)\.h$')
no 'std::(jthread|stop_token|stop_source|bit_cast|ranges::|views::|condition_variable_any)' \
    "not in old compilers" "${ours[@]}"
no '__cpp_lib_to_chars|std::chars_format' "numbers as text go through number_text.h" "${ours[@]}"

# Files are written in one place, which leaves no partial file.
mapfile -t not_writers < <(printf '%s\n' "${core[@]}" "${cli[@]}" "${teach[@]}" "${web[@]}" "${python[@]}" ${viewer[@]+"${viewer[@]}"} |
    grep -vE '/(atomic_file|operating_system)\.(h|cpp)$')
no '\bos::(openToWrite|makeFile)\(|\b(f|fre|fd)open\(|\bofstream|std::fstream|O_CREAT|O_WRONLY|O_RDWR|\bcreat\(|mk(o)?stemp|tmpfile\(|stbi_write_(png|jpg|bmp|tga|hdr)\(|copy_file\(' \
    "only atomic_file.cpp may write files" "${not_writers[@]}"

# The operating system is called in one place; what videos and pictures without a display need of it is in theirs.
mapfile -t portable < <(printf '%s\n' "${core[@]}" "${cli[@]}" "${teach[@]}" "${web[@]}" "${python[@]}" ${viewer[@]+"${viewer[@]}"} |
    grep -vE '^(core/spiraling_edge/base/operating_system|app/viewer/export/mp4_writer)\.cpp$')
no "$(include 'sys/|unistd|fcntl|spawn\.h|dlfcn|signal\.h|poll|pthread|malloc\.h|pwd|termios|dirent|sched\.h|windows')" \
    "only base/operating_system.cpp calls the system (docs/porting.md)" "${portable[@]}"
no '/proc/self/exe' "the path of the program is os::programPath()" "${portable[@]}"
mapfile -t not_offscreen < <(in_viewer '' | grep -v '^app/viewer/offscreen')
no "$(include 'EGL/')" "only offscreen.cpp draws without a display (docs/porting.md)" "${not_offscreen[@]}"

# Text goes to the terminal in few places, which let nothing through that a terminal would obey.
mapfile -t not_printers < <(printf '%s\n' "${cli[@]}" "${teach[@]}" "${web[@]}" "${python[@]}" ${viewer[@]+"${viewer[@]}"} |
    grep -vE '^app/(cli/(output/output|progress)|viewer/(main|options|application|run/strings)|teach/share/.*)\.(h|cpp)$')
no '\b(f?printf|f?puts|fwrite|perror)\(|fmt::print\(|std::(cout|cerr|clog)\b' \
    "print by printText(), printNote() or printLines()" "${not_printers[@]}"

# The root.
allowed='app core shaders assets tests docs .ci CMakeLists.txt CMakePresets.json README.md CHANGELOG.md
    CONTRIBUTING.md LICENSE CITATION.cff run.sh test.sh .clang-format .clang-tidy .editorconfig
    .gitattributes .gitignore'
while read -r entry; do
    grep -qxF -- "$entry" <<<"${allowed// /$'\n'}" || breach "does not belong at the root: $entry"
done < <(git ls-tree --name-only HEAD 2>/dev/null)

# Dear ImGui breaks lines within numbers: running text goes through wrappedText().
no 'ImGui::(TextWrapped|PushTextWrapPos)' "wrap text by panels/widgets/widgets.h" "${viewer[@]}"

# The version stands in the main CMakeLists.txt; what cannot read it there says the same.
version=$(sed -n 's/^project(spiraling_edge VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
same() { # PATTERN FILE...: each match of the file says the version, or its first two numbers.
    local pattern=$1 file line
    shift
    for file; do
        line=$(grep -oE -m1 "$pattern" "$file") || { breach "no version in $file"; continue; }
        [[ " $version ${version%.*} " == *" $(grep -oE '[0-9]+(\.[0-9]+)+' <<<"$line") "* ]] || breach "not version $version: $file: $line"
    done
}
same '^version: .*' CITATION.cff
same '"version": "[0-9.]*"' app/packaging/vcpkg/vcpkg.json
same '^version = .*' app/python/pyproject.toml
same '^## [0-9][^,]*,' CHANGELOG.md
same 'find_package\(spiraling_edge [0-9.]+' README.md docs/library.md

# Every source is in a list.
while read -r file; do breach "in no CMakeLists.txt: $file"; done < <(python3 - <<'PYTHON' || echo 'the check itself fails'
import pathlib, re
for folder in map(pathlib.Path, ("core", "app", "tests")):
    named = {p.parent: set(re.findall(r"[\w-]+\.cpp", p.read_text())) for p in folder.rglob("CMakeLists.txt")}
    for file in sorted(folder.rglob("*.cpp")):
        listed = any(file.name in named.get(above, ()) for above in file.parents)
        if not listed and not file.is_relative_to("tests/consumer"):
            print(file)
PYTHON
)

# A source includes what it uses of GLM, or a header of ours does: builds that compile many sources
# as one do not tell.
while read -r file; do breach "does not include its part of GLM: $file"; done < <(python3 - <<'PYTHON' || echo 'the check itself fails'
import functools, pathlib, re
PARTS = {"geometric": "dot|cross|length|distance|normalize", "common": "abs|floor|ceil|round|min|max|clamp|mix"}
ROOTS = [pathlib.Path(p) for p in ("core", "core/sampling", "app", "app/viewer")]

@functools.cache
def reached(file):
    parts = set()
    for name in re.findall(r'^#include [<"]([^>"]+)[>"]', file.read_text(), re.M):
        if name.startswith("glm/"):
            parts.add(name)
        for root in [file.parent, *ROOTS]:
            if (root / name).is_file():
                parts |= reached(root / name)
                break
    return frozenset(parts)

def lacks(parts, part):
    return not any(p in (f"glm/{part}.hpp", "glm/glm.hpp") or p.startswith("glm/gtc/") for p in parts)

for folder in ("core", "app"):
    for file in sorted(pathlib.Path(folder).rglob("*.cpp")):
        for part, names in PARTS.items():
            if re.search(rf"glm::({names})\(", file.read_text()) and lacks(reached(file), part):
                print(f"{file} (glm/{part}.hpp)")
PYTHON
)

# CMake splits lists at semicolons: such a test would be registered in two halves, and never run.
mapfile -t tests < <(sources tests)
no '^TEST_CASE\(.*;.*"\)|^ +"[^"]*;[^"]*"\) \{$' "no semicolon in the name of a test" "${tests[@]}"

# Limits of size.
while read -r excess; do breach "$excess"; done < <(
    { sources core; sources app; } | xargs wc -l |
        awk '$1 > 900 && $2 != "total" { print "over 900 lines: " $2 " (" $1 ")" }'
    find core app tests -name '*.cpp' -o -name '*.h' | sed 's#/[^/]*$##' | sort | uniq -c |
        awk '$1 > 40 { print "over 40 sources: " $2 " (" $1 ")" }'
)

# Docs: a paragraph or an item of a list is short. Tables, headings and blocks of code are no text.
while read -r place; do breach "over 80 words: $place"; done < <(awk '
    function flush() { if (words > 80) print file ":" line " (" words ")"; words = 0 }
    FNR == 1 { flush(); fence = ""; file = FILENAME }
    fence != "" { if ($0 == fence) fence = ""; next }
    /^```/ { flush(); fence = $0; sub(/[^`].*/, "", fence); next }
    /^ *$/ || /^#/ || /^ *\|/ || /^<!--/ { flush(); next }
    /^ *([-*+]|[0-9]+\.) / { flush(); $1 = "" }
    { if (words == 0) line = FNR; words += NF - ($1 == "") }
    END { flush() }' README.md CONTRIBUTING.md docs/*.md)

echo "layers: $breaches breaches in $((${#core[@]} + ${#cli[@]} + ${#teach[@]} + ${#python[@]} + ${#viewer[@]})) files"
[ "$breaches" = 0 ]
