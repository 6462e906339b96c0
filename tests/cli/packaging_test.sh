#!/usr/bin/env bash
# Man pages, completions and the files for the desktop, without packages (those: app/packaging/test.sh).
#   packaging_test.sh PROGRAM CASE    runs one case, in an empty folder; ends with 77 if it cannot run here
set -uo pipefail
program=$(realpath "$1")
packaging=$(cd "$(dirname "$0")/../../app/packaging" && pwd)
viewer=$(dirname "$program")/spiraling-edge-viewer
. "$(dirname "$0")/../support/one_case.sh"
needs() { command -v "$1" >/dev/null || { echo "skipped: there is no $1"; exit 77; }; }
make_pages() {
    needs python3
    python3 "$packaging/pages.py" "$program" "$1" || fail "no pages"
    [ ! -x "$viewer" ] || python3 "$packaging/pages.py" "$viewer" "$1" || fail "no pages of the viewer"
}
# options_of PROGRAM WORDS...: the names in its help text, which was not made from the same lists.
options_of() { "$@" --help | sed -nE 's/^ {1,8}(-[^ ]*).*/\1/p' | tr ',' '\n' | sort -u; }

# have NAME FILE...: each file has the options of standard input, as shells and man pages write them.
have() {
    local name=$1 file options words before after missing
    options=$(cat)
    shift
    for file; do
        words=$options before="(^|[ '(\"|*)\n])" after="([[ '\"|)\n]|\$)"
        case $file in
            man1/*) before='(^|[ ,\n])' after='([ ,\n]|$)' ;;
            fish/*) words=$(sed -E 's/^--/-l /; t; s/^-/-s /' <<<"$options") before=' ' after='([ \n]|$)' ;;
        esac
        missing=$(before=$before after=$after awk '
            NR == FNR { words[$0]; next }
            { text = text "\n" $0 }
            END { for (each in words) if (text !~ ENVIRON["before"] each ENVIRON["after"]) print each }' \
            - "$file" <<<"$words")
        [ -z "$missing" ] || fail "$name: not in $file:" $missing
    done
}

every_verb_and_option_is_in_the_pages() {
    local verb shells file verbs=0
    make_pages .
    for file in man1/*.gz; do
        zcat "$file" | sed 's/\\-/-/g; s/\\fB/ /g; s/\\f[IR]/ /g' >"${file%.gz}"
    done
    shells=(bash/spiraling-edge zsh/_spiraling-edge fish/spiraling-edge.fish)
    while read -r verb; do
        verbs=$((verbs + 1))
        [ -s "man1/spiraling-edge-$verb.1" ] || fail "no page of $verb"
        grep -qx " $verb " man1/spiraling-edge.1 || fail "$verb is not in the main page"
        for file in "${shells[@]}"; do grep -qE "(^|[ ('\"])$verb([ :)'\"]|\$)" "$file" || fail "$verb is not in $file"; done
        [ "$verb" != view ] || continue # whose options are those of the viewer
        sed -n "/^ *\"$verb\")/,/;;/p" bash/spiraling-edge >"bash/$verb"
        sed -n "/^ *$verb)/,/;;/p" zsh/_spiraling-edge >"zsh/$verb"
        grep "from $verb'" fish/spiraling-edge.fish >"fish/$verb"
        have "$verb" "man1/spiraling-edge-$verb.1" {bash,zsh,fish}/"$verb" < <(options_of "$program" "$verb")
    done < <("$program" --help | sed -n 's/^  \([a-z][a-z0-9]*\)  *[a-z].*/\1/p')
    [ "$verbs" -ge 17 ] || fail "$verbs verbs in the help"
    [ -x "$viewer" ] || return
    have viewer man1/spiraling-edge-viewer.1 bash/spiraling-edge-viewer zsh/_spiraling-edge-viewer \
        fish/spiraling-edge-viewer.fish < <(options_of "$viewer")
}

man_pages_are_read_without_warnings() {
    local page
    needs groff
    make_pages .
    for page in man1/*; do
        zcat "$page" | groff -man -Tutf8 -Kutf8 -ww >text 2>warnings || fail "$page"
        # A long word at the end of a line is none of ours.
        ! grep -vE "can't break line|cannot (break|adjust) line" warnings || fail "$page: see above"
        [ "$(wc -l <text)" -gt 10 ] || fail "$page: is short"
    done
}

completions_are_read_by_their_shells() {
    local shell read=0
    make_pages .
    for shell in bash zsh fish; do
        command -v "$shell" >/dev/null || continue
        for file in "$shell"/*; do "$shell" -n "$file" || fail "$file"; done
        read=$((read + 1))
    done
    echo "$read of 3 shells are here"
}

bash_completes_words() {
    make_pages .
    # shellcheck disable=SC1091
    . bash/spiraling-edge
    # completes WORDS... -- RESULT: after the last word, which is begun.
    completes() {
        COMP_WORDS=(spiraling-edge "${@:1:$#-2}")
        COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
        _spiraling_edge
        [ "${COMPREPLY[*]}" = "${*: -1}" ] || fail "${COMP_WORDS[*]}: ${COMPREPLY[*]}, not ${*: -1}"
    }
    completes do -- doctor
    completes re -- "reduce render"
    completes run scan.ply --max-p -- --max-pivots
    completes export scan.ply --theme "" -- "dark light"
    completes run sc -- "" # a file, by the shell
}

equal_programs_give_equal_pages() {
    make_pages first
    make_pages second
    diff -r first second || fail "two runs differ"
}

desktop_files_are_valid() {
    local checks=0
    if command -v desktop-file-validate >/dev/null; then
        desktop-file-validate --no-hints "$packaging/spiraling-edge-viewer.desktop" || fail "the desktop file"
        checks=1
    fi
    if command -v appstreamcli >/dev/null; then
        sed 's/@PROJECT_VERSION@/1.0/; s/@release_type@/stable/; s/@release_date@/2026-01-01/' \
            "$packaging/org.spiraling_edge.viewer.metainfo.xml.in" >org.spiraling_edge.viewer.metainfo.xml
        appstreamcli validate --no-net --pedantic org.spiraling_edge.viewer.metainfo.xml || fail "the description"
        checks=2
    fi
    if command -v rsvg-convert >/dev/null; then
        rsvg-convert -w 16 -h 16 "$packaging/spiraling-edge-viewer.svg" >icon.png || fail "the icon"
        checks=3
    fi
    [ "$checks" -gt 0 ] || exit 77
}

# The types of our files, as the desktop of a user finds them, are those that the viewer opens.
file_names_have_types() {
    local type
    needs update-mime-database
    mkdir -p mime/packages
    cp "$packaging/spiraling-edge.xml" mime/packages
    XDG_DATA_HOME=$PWD update-mime-database mime || fail "the types"
    for name in sesession:session lesson.md:lesson setrace:trace; do
        type=application/x-spiraling-edge-${name#*:}
        grep -qxF "50:$type:*.${name%:*}" mime/globs2 || fail "no type of .${name%:*}"
        [ "$type" = application/x-spiraling-edge-trace ] && continue # beside a run alone
        for file in spiraling-edge-viewer.desktop org.spiraling_edge.viewer.metainfo.xml.in; do
            grep -qF "$type" "$packaging/$file" || fail "$file: not $type"
        done
    done
}

"$2"
exit "$failed"
