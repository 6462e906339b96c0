#!/usr/bin/env bash
# Runs the command lines of README.md, docs/*.md and docs/lab/README.md, so that none mentions an option that is gone.
#   docs_commands.sh PROGRAM [PAGE...]   PAGE: a path below the checkout; without it, all pages
# Command lines stand in blocks that begin with ```sh. Each page gets an empty folder, with stand-ins
# for the inputs that pages name. Lines of spiraling-edge run as they stand; lines of
# spiraling-edge-viewer, and of `spiraling-edge view`, `render` and `export`, with --list-actions, which
# reads the options and opens no window. A comment `<!-- not run: REASON -->` before a block keeps its
# lines from running. Options in running text, `--option`, must be in the help of a verb.
set -uo pipefail
export LC_ALL=C
program=$(realpath "$1")
shift
root=$(cd "$(dirname "$0")/../.." && pwd)
viewer=$(dirname "$program")/spiraling-edge-viewer
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/inputs"
ln -s "$program" "$work/bin/spiraling-edge"
[ ! -x "$viewer" ] || ln -s "$viewer" "$work/bin/spiraling-edge-viewer"
PATH=$work/bin:$PATH
ran=0
failed=0
not_run=()

fail() {
    echo "FAIL: $*"
    failed=$((failed + 1))
}

# The inputs that pages name: points with a mesh, the mesh of another program, a volume.
inputs() {
    cd "$work/inputs" || exit 1
    spiraling-edge run scene:torus -q -o scan.ply &&
        spiraling-edge run scene:torus -q --rule convex=off -o mesh.ply || exit 1
    {
        printf 'NRRD0004\ntype: uint8\ndimension: 3\nsizes: 12 12 12\nencoding: raw\n\n'
        awk 'BEGIN { for (z = 0; z < 12; z++) for (y = 0; y < 12; y++) for (x = 0; x < 12; x++)
            printf "%c", 120 - int(2 * ((x - 5.5)^2 + (y - 5.5)^2 + (z - 5.5)^2) / 3) }'
    } >volume.nrrd
}

# lines PAGE: what stands in its blocks of ```sh, as REASON<tab>COMMAND, continued lines joined. Prints
# `outside<tab>LINE` for a command line that stands elsewhere.
lines() {
    awk '
        /^<!-- not run: .* -->$/ { reason = $0; sub(/^<!-- not run: /, "", reason); sub(/ -->$/, "", reason); next }
        /^```/ { fence = fence == "" ? $0 : ""; if (fence == "") reason = ""; next }
        fence == "```sh" {
            line = line $0
            if (sub(/\\$/, "", line)) next
            sub(/(^| +)# .*$/, "", line)
            if (line != "") print (reason == "" ? "-" : reason) "\t" line
            line = ""
            next
        }
        /^ *(\$ )?([a-z.\/]*\/)?spiraling-edge(-viewer)? / && (fence != "" || /^    /) { print "outside\t" $0 }
        fence == "" && NF { reason = "" }
    ' "$1"
}

# run COMMAND: in the present folder. `doctor`, `check`, `compare` and `diff` end with 1 if they find something.
run() {
    local command=$1 code=0
    case $command in
        spiraling-edge-viewer* | "spiraling-edge view"* | "spiraling-edge render"* | "spiraling-edge export"*)
            if [ ! -x "$viewer" ]; then
                not_run+=("$command (there is no viewer)")
                return
            fi
            command+=" --list-actions"
            ;;
    esac
    ran=$((ran + 1))
    timeout 100 bash -o pipefail -c "$command" >out 2>err </dev/null || code=$?
    [ "$code" != 1 ] || ! grep -qE '^spiraling-edge (doctor|check|compare|diff) ' <<<"$command" || code=0
    [ "$code" = 0 ] || fail "$page: \`$1\` ended with $code: $(head -c 1000 err)"
}

# options_exist PAGE: every option that its text names, as `--option ...`, is in the help of a verb.
options_exist() {
    local option
    [ -x "$viewer" ] || return
    [ -s "$work/options" ] || {
        spiraling-edge --help | sed -n 's/^  \([a-z][a-z0-9]*\)  *[a-z].*/\1/p' |
            while read -r verb; do spiraling-edge "$verb" --help; done
        spiraling-edge-viewer --help
    } | grep -oE -- '--[a-z][a-z-]*' | sort -u >"$work/options"
    while read -r option; do
        grep -qxFe "$option" "$work/options" || fail "$page: there is no option $option"
    done < <(grep -oE '`--[a-z][a-z-]*' "$1" | tr -d '`' | sort -u)
}

inputs
pages=("$@")
[ $# -gt 0 ] || mapfile -t pages < <(cd "$root" && printf '%s\n' README.md docs/*.md docs/lab/README.md)
for page in "${pages[@]}"; do
    mkdir -p "$work/$page"
    cp "$work/inputs/"* "$work/$page"
    cd "$work/$page" || exit 1
    while IFS=$'\t' read -r reason line; do
        if [ "$reason" = outside ]; then
            fail "$page: a command line outside of a block of \`\`\`sh: $line"
        elif [ "$reason" != - ]; then
            not_run+=("$line ($reason)")
        elif [[ $line == spiraling-edge* ]]; then
            run "$line"
        else
            fail "$page: neither a line of the programs nor marked: $line"
        fi
    done < <(lines "$root/$page")
    options_exist "$root/$page"
done
[ ${#not_run[@]} = 0 ] || printf 'not run: %s\n' "${not_run[@]}"
echo "$ran command lines ran, ${#not_run[@]} did not, $failed failed"
[ "$failed" = 0 ] && [ "$ran" -gt 0 ]
