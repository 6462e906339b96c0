#!/usr/bin/env bash
# Drives the program as a user or a script would.
#   cli_test.sh PROGRAM CASE    runs one case, in an empty folder of its own
set -uo pipefail
program=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
. "$(dirname "$0")/../support/one_case.sh"

# expect CODE ARGUMENTS...: runs the program; its output is in `out` and `err` afterwards.
expect() {
    local wanted=$1 code=0
    shift
    "$program" "$@" >out 2>err </dev/null || code=$?
    [ "$code" = "$wanted" ] || fail "\`spiraling-edge $*\` ended with $code, not $wanted: $(cat err)"
}

says() { grep -qF -- "$2" "$1" || fail "'$2' is not in $1: $(head -c 2000 "$1")"; }
empty() { [ ! -s "$1" ] || fail "$1 should be empty: $(head -c 500 "$1")"; }
absent() { [ ! -e "$1" ] || fail "$1 should not exist"; }
# number FIELD FILE: the number of a field of a JSON report.
number() { sed -n "s/^ *\"$1\": \\(-\\{0,1\\}[0-9.e+-]*\\),\\{0,1\\}\$/\\1/p" "$2" | head -1; }
is() { [ "$1" = "$2" ] || fail "$3: $1, not $2"; }
header_count() { head -c 2000 "$2" | tr -d '\0' | grep -a "^element $1 " | cut -d' ' -f3; }

# The corners of an icosahedron, as XYZ with normals: closes with 20 triangles.
icosahedron() {
    local a b
    for a in 0.5257311 -0.5257311; do
        for b in 0.8506508 -0.8506508; do
            printf '%s\n' "0 $a $b 0 $a $b" "$a $b 0 $a $b 0" "$b 0 $a $b 0 $a"
        done
    done
}

# A grid of 5 by 5 points a unit apart, as XYZ with normals.
square() {
    local x y
    for x in 0 1 2 3 4; do
        for y in 0 1 2 3 4; do echo "$x $y 0 0 0 1"; done
    done
}

# Even points of a sphere, as XYZ with normals; written to `file`.
sphere_points() {
    expect 0 run scene:sphere -q -o sphere.obj
    awk '$1 == "v" { v[++n] = $2 " " $3 " " $4 } $1 == "vn" { print v[++m], $2, $3, $4 }' \
        sphere.obj >"$1"
    rm sphere.obj
}

# fields REPORT: the path and the kind of each value, one a line; rows of a list count as one.
fields() {
    awk '{
        depth = (match($0, /[^ ]/) - 1) / 2
        text = substr($0, RSTART)
        if (text ~ /^[]}]/) next
        key[depth] = "[]"
        if (match(text, /^"[a-z0-9_]+": /)) {
            key[depth] = substr(text, 2, RLENGTH - 4)
            text = substr(text, RLENGTH + 1)
        }
        kind = text ~ /^"/ ? "text" : text ~ /^[tf]/ ? "switch" : text ~ /^n/ ? "null" : \
            text ~ /^\[/ ? "list" : text ~ /^{/ ? "object" : "number"
        path = ""
        for (i = 1; i <= depth; ++i) path = path "." key[i]
        print path, kind
    }' "$@" | sort -u
}

cases_are_listed() {
    grep -oE '^[a-z_]+\(\) \{$' "$here/cli_test.sh" | tr -d '(){ ' | sort >defined
    sed -n '/^set(cases/,/^)/p' "$here/CMakeLists.txt" | grep -oE '^    [a-z_]+' | tr -d ' ' |
        sort >listed
    printf '%s\n' ball clean expect fail fields height_map icosahedron interrupted_after lab_with_solution lesson_result refuses sphere_points sphere_with_normals square user_ticks | sort >helpers
    comm -23 defined helpers | diff - listed || fail "cases and list differ"
}

help_and_version() {
    expect 0 --help
    for verb in run info doctor why check compare diff practice reduce sample table1 scenes view render; do says out "  $verb "; done
    empty err
    expect 0 --version
    grep -qE '^spiraling-edge [0-9]+\.[0-9]+\.[0-9]+$' out || fail "version: $(cat out)"
    for verb in run info doctor why check compare diff practice reduce sample table1 scenes render; do
        expect 0 $verb --help
        says out "Usage: spiraling-edge $verb"
    done
    expect 0 help run
    says out "--max-pivots"
    says out "closetwo"
    expect 2
    says err "Usage:"
    empty out
}

docs_command_line_is_current() {
    command -v python3 >/dev/null || return 0
    "$here/../../docs/make-lists.py" --check "$program" || fail "see above"
}

docs_link_to_the_program_if_it_has_an_address() {
    command -v python3 >/dev/null || return 0
    "$here/../../docs/link-pages.py" '' plain "$program" || fail "no copies"
    diff -r "$here/../../docs" plain || fail "links without an address"
    "$here/../../docs/link-pages.py" https://example.org/ linked "$program" || fail "no copies with links"
    says linked/paper-map.md '[Figure 8](https://example.org/#scene=figure-8&goto=9.sphere.2)'
    says linked/paper-map.md '| 12 | [74.join.1](https://example.org/#scene=figure-12&goto=74.join.1) |'
    ! grep -n 'example.org/#[^)]*\[' linked/*.md || fail "a link in a link"
}

unknown_verb_is_wrong_usage() {
    expect 2 triangulate
    says err "triangulate: neither a verb nor a file"
    empty out
}

unknown_option_is_wrong_usage() {
    expect 2 --frobnicate
    expect 2 run scene:sphere --frobnicate
    says err "--frobnicate"
    expect 2 run
    says err "IN is required"
    expect 2 run scene:sphere scene:torus
}

wrong_values_are_wrong_usage() {
    expect 2 run scene:sphere --rules strict
    says err "paper, printed"
    expect 2 run scene:sphere --rule closetwo
    says err "closetwo=on"
    expect 2 run scene:sphere --rule unknown=on
    says err "--rule unknown=on: there is no rule \"unknown\"; the nearest is "
    says err "; spiraling-edge run --help lists all"
    expect 2 run scene:sphere --rule sphre=off
    says err "the nearest is sphere;"
    expect 2 run scene:sphere --rule maxgap=200
    says err "--rule maxgap=200: write maxgap=VALUE with a number from 90 to 180"
    expect 2 run scene:sphere --rule tie=middle
    says err "tie=nearest, tie=farthest or tie=both"
    expect 2 run scene:sphere --what-if "5.sphere hold 3"
    says err "is no what-if"
    expect 2 run scene:sphere --symmetric=much
    says err "Could not convert: --symmetric = much"
    expect 2 run scene:sphere --neighbors -3
    expect 2 run scene:sphere --radius 1 --neighbors 5
    expect 2 run scene:sphere --max-pivots -1
    expect 2 run scene:sphere -o mesh.fbx
    says err ".stl and .glb can be written"
    expect 2 run scene:sphere -o - --trace -
    expect 2 run scene:sphere --report - --trace -
}

missing_file_is_missing_input() {
    expect 3 run missing.ply -o mesh.ply
    absent mesh.ply
    expect 3 info missing.ply
    expect 3 missing.ply
    expect 3 run .
    says err "is a folder"
}

malformed_file_is_malformed_input() {
    printf 'ply\nformat ascii 1.0\nelement vertex 5\n' >cut.ply
    expect 3 run cut.ply -o mesh.ply
    says err "cut.ply"
    absent mesh.ply
    : >empty.xyz
    expect 3 run empty.xyz
    head -c 3000 /dev/zero >zero.bin
    expect 3 info zero.bin
}

missing_pieces_are_derived() {
    printf '0 0 0\n1 0 0\n0 1 0\n1 1 0.1\n' >bare.xyz
    expect 0 run bare.xyz -o bare.ply --report bare.json
    grep -q '"normals": true' bare.json || fail "the report does not list the derived normals"
    expect 0 run bare.xyz
    says err "derived    normals"
    expect 0 info bare.xyz
    says out "none: a run derives them"
    # What was derived is written: the second run takes it as given.
    expect 0 run bare.ply --report again.json
    grep -q '"normals": false' again.json || fail "the derived normals were not written"
    expect 0 run bare.ply --orient --box auto
    says err "wall types"
    expect 2 run bare.xyz --box 1,2,3
    says err "six numbers"
    expect 2 run bare.xyz --box 0,0,0,1,1,0
    says err "lower corner first"
    expect 2 run bare.ply --orient --derive-normals
    for kind in obj off stl glb; do
        expect 0 run bare.xyz -o "bare.$kind"
        [ -s "bare.$kind" ] || fail "no bare.$kind"
    done
}

sides_face_a_scanner_or_are_unknown() {
    awk 'BEGIN { for (i = 0; i < 144; i++) print i % 12 + (i % 5) / 50, int(i / 12), (i % 3) / 9 }' \
        >sheet.xyz
    expect 0 info sheet.xyz
    says out "none: a run derives them; which side faces out is unknown"
    expect 1 doctor sheet.xyz
    says out "the file has no normals; which side faces out is unknown"
    expect 0 run sheet.xyz -o mesh.ply
    says err "which side faces out is unknown"
    for height in 20 -20; do
        expect 0 run sheet.xyz --scanner=5,5,$height -o $((height > 0)).ply --report report.json
        is "$(number unknown_sides report.json)" 0 "unknown sides, scanner at $height"
    done
    cmp -s 0.ply 1.ply && fail "the scanner turns nothing"
    expect 2 run sheet.xyz --scanner 1,2
    says err "--scanner 1,2: expected three numbers separated by commas: X,Y,Z"
    expect 2 run mesh.ply --scanner 1,2,3
    says err "--scanner: The points have normals; only flipped or derived ones can face a scanner (--orient, --derive-normals)"
    expect 0 run mesh.ply --orient --scanner 1,2,3
}

rims_are_found_on_request() {
    awk 'BEGIN { for (j = -10; j <= 10; ++j) for (i = -20; i <= 20; ++i) {
        x = i + j / 2; y = j * 0.8660254; if (x * x + y * y < 67) print x, y, 0, 0, 0, 1 } }' >disc.xyz
    expect 0 run disc.xyz --derive-rim -o disc.ply
    says err "1 rim with"
    expect 0 run scene:sphere --derive-rim
    says err "no rim"
    expect 0 run disc.xyz --derive-rim --report disc.json
    grep -q '"rim_chains": 1' disc.json || fail "the report does not count the rim"
    grep -q '"boundary_loops": 1' disc.json || fail "the disc has more than one border"
    # Rim points are written: the second run takes them as given.
    expect 0 info disc.ply
    says out "away from walls"
    expect 0 run disc.ply --report again.json
    grep -q '"rim": false' again.json || fail "the rim was derived again"
    expect 0 run disc.xyz
    grep -q "rim" err && fail "a rim that was not requested"
    return 0
}

unknown_scene_is_missing_input() {
    expect 3 run scene:nowhere
    says err "spiraling-edge scenes"
}

run_writes_a_mesh() {
    icosahedron >points.xyz
    expect 0 run points.xyz -o mesh.ply
    is "$(header_count vertex mesh.ply)" 12 points
    is "$(header_count face mesh.ply)" 20 triangles
    says err "12 points, 20 triangles in 1 component, no boundary, Euler characteristic 2"
    empty out
    expect 0 run mesh.ply -o again.ply # a mesh is points with normals, too
    cmp mesh.ply again.ply || fail "a mesh that is run again changes"
    is "$(ls | sort | tr '\n' ' ')" "again.ply err mesh.ply out points.xyz " files
}

run_reads_standard_input() {
    icosahedron >points.xyz
    "$program" run - --report - <points.xyz >out 2>err || fail "code $?"
    is "$(number triangles out)" 20 triangles
    says out '"input": "-"'
}

run_writes_standard_output() {
    icosahedron >points.xyz
    expect 0 run points.xyz -o - -q
    cp out piped.ply
    expect 0 run points.xyz -o mesh.ply
    cmp mesh.ply piped.ply || fail "file and pipe differ"
}

report_has_every_field() {
    expect 0 run scene:torus --rules robust -q --report report.json
    empty err
    for field in points triangles pivots components isolated stranded splits joins max_ring_length \
        max_stack_depth boundary_edges boundary_loops non_manifold_edges inconsistent_edges \
        degenerate_triangles points_in_no_triangle euler_characteristic flipped_triangles \
        non_manifold_vertices seeds skipped discarded closed_rings freed_rings holes lost_seeds failed_seeds \
        non_finite zero_normals duplicates unscaled_normals dropped_list_entries alerts_total \
        greatest_distance mean_distance points_lost hole_edges openings_closed extra_pieces \
        triangles_against_normals pieces_facing_in points_not_covered points_amiss report_version second_layers small_components \
        read prepare triangulate write; do
        [[ "$(number $field report.json)" =~ ^-?[0-9] ]] || fail "no number $field"
    done
    for field in state_hash neighbors_computed rules stop_reason alerts set_aside seconds; do
        says report.json "\"$field\": "
    done
    grep -qE '"state_hash": "[0-9a-f]{16}"' report.json || fail "state_hash"
    is "$(number euler_characteristic report.json)" 0 "Euler characteristic of a torus"
    is "$(number boundary_edges report.json)" 0 "boundary edges of a torus"
    says report.json '"stop_reason": "finished"'
}

# The same run by version 0.1.0 wrote tests/golden/0.1.0/report.json: programs that read its fields
# find them in those of today, with the same kinds of values, and under the same names of rules.
report_has_the_fields_of_the_first_version() {
    local old=$here/../golden/0.1.0
    {
        echo '# x y z nx ny nz intensity'
        awk '{ printf "%.2f %.2f %.2f %s %s %s %d\n",
               $1 + 500000, $2 + 5400000, $3 + 300, $4, $5, $6, NR }' "$old/points.xyz"
    } >far.xyz
    expect 0 run far.xyz -k 8 --rules robust --rule keepseeds=off --rule nofold=off --rule nomeet=off --rule flip=off \
        --rule wallsdone=off --rule fill=off --rule delay=off --rule nocross=off --rule gap=off --rule rim=off \
        --rule tie=farthest --what-if "1.sphere keep 13" -o far.stl --report report.json
    # A lost seed, and a flipped triangle.
    expect 0 run scene:sparse-spot -q --report lost.json
    # report_version 2 has other names for these, or another place; the rule `reseat` is gone.
    fields "$old/report.json" |
        sed -E '/\.reseat /d; s/^\.faults\.(non_manifold_edge|inconsistent_edge) /.faults.\1s /; s/^\.faults\.folded /.faults.folded_edges /
            s/^\.faults\.(degenerate|flipped|intersecting) /.faults.\1_triangles /; s/^\.sound /.verdict.sound /
            s/^\.unused_points /.points_in_no_triangle /' | sort >wanted
    [ "$(wc -l <wanted)" -gt 140 ] || fail "few fields: $(cat wanted)"
    comm -23 wanted <(fields report.json lost.json) >lost
    empty lost
    says lost.json '"kind": "lost_seed"'
    says lost.json '"class": "flipped_triangles"'
    for field in input output columns stop_reason set tie onsphere holesize gap flip maxgap; do
        says report.json "$(grep "\"$field\": " "$old/report.json" | head -1 | tr -d ,)"
    done
    for name in '"class": "intersecting_triangles"' '"1.sphere keep 13"'; do
        says report.json "$name"
    done
}

rules_can_be_set_and_runs_forked() {
    expect 0 run scene:torus -q --rule reseat=off
    says err "--rule reseat=off: this rule is gone, and changes nothing"
    expect 0 run scene:torus --report true.json
    expect 0 run scene:torus --rule maxgap=100 --rule tie=farthest --report set.json
    says set.json '"maxgap": 100'
    says set.json '"tie": "farthest"'
    expect 0 run scene:torus --trace trace.txt -q
    local line pivot point
    line=$(grep -m 1 -E '^[0-9]+\.sphere\..*: removed\.' trace.txt)
    pivot=${line%%.*}
    point=$(sed -E 's/.*Point ([0-9]+) lies.*/\1/' <<<"$line")
    expect 0 run scene:torus --what-if "$pivot.sphere keep $point" --report fork.json
    says fork.json "\"$pivot.sphere keep $point\""
    [ "$(grep run_hash true.json)" = "$(grep run_hash fork.json)" ] && fail "the fork has the hash of the plain run"
    expect 0 run scene:torus --report again.json
    is "$(grep run_hash again.json)" "$(grep run_hash true.json)" "hash of the plain run"
    expect 2 run scene:torus --what-if "5 list 7 7"
    says err "A point is not in its own list"
    expect 2 run scene:torus --what-if "99999.sphere keep 1"
    says err "The run has no pivot 99999"
}

a_report_is_written_beside_the_summary() {
    expect 0 run scene:torus --report report.json
    says err "triangulate"
    expect 0 run scene:torus --report report.json -q
    empty err
}

report_to_standard_output_is_all_there() {
    expect 0 run scene:torus --rules robust --report -
    is "$(head -c 1 out)" "{" begin
    is "$(tail -n 1 out)" "}" end
    says err "written"
}

same_input_gives_the_same_bytes() {
    for i in 1 2; do
        expect 0 run scene:torus -o mesh$i.ply --trace trace$i.txt --report report$i.json
        sed -i '/"seconds"/,$d; s/mesh[12]/mesh/' report$i.json
    done
    cmp mesh1.ply mesh2.ply || fail "meshes differ"
    cmp trace1.txt trace2.txt || fail "traces differ"
    cmp report1.json report2.json || fail "reports differ"
}

trace_has_one_line_per_event() {
    icosahedron >points.xyz
    expect 0 run points.xyz --trace - -q
    tab=$(printf '\t')
    bad=$(grep -cvE "^[0-9]+\.[a-z]+\.[0-9]+$tab[^$tab]+\$" out)
    is "$bad" 0 "lines that are not ADDRESS<tab>SENTENCE"
    is "$(cut -f1 out | sort | uniq -d | wc -l)" 0 "addresses that occur twice"
    is "$(head -1 out | cut -f1)" 1.seed.1 "first event"
    is "$(grep -c '\.emit\.' out)" 20 "emitted triangles"
    expect 0 run points.xyz --trace trace.txt -q
    cmp out trace.txt 2>/dev/null || "$program" run points.xyz --trace - -q 2>/dev/null | cmp - trace.txt ||
        fail "file and pipe differ"
}

trace_is_the_golden_one() {
    # core_tests made and checks these files; here another build must give the same.
    expect 0 run scene:figure-8 --trace trace.txt
    grep -E '^8\.' trace.txt | diff - "$here/../golden/figure-8.txt" || fail "pivot 8 differs"
    expect 0 run scene:figure-12 --trace trace.txt
    grep -E '^(35|74)\.' trace.txt | diff - "$here/../golden/figure-12.txt" || fail "pivots differ"
}

max_pivots_stops_early() {
    expect 0 run scene:torus --max-pivots 10 --report report.json -o mesh.ply
    is "$(number pivots report.json)" 10 pivots
    says report.json '"stop_reason": "max_pivots"'
    is "$(header_count face mesh.ply)" "$(number triangles report.json)" triangles
    expect 0 run scene:torus --max-pivots 0 --report report.json
    is "$(number pivots report.json)" 0 pivots
}

rules_change_the_report() {
    expect 0 run scene:sphere --report paper.json
    says paper.json '"set": "paper"'
    says paper.json '"closetwo": true'
    "$program" run scene:sphere --rules printed --report printed.json >out 2>err
    says printed.json '"closetwo": false'
    says printed.json '"drop_opposing_normals": false'
    "$program" run scene:sphere --rules printed --rule closetwo=on --rule realhole=on \
        --report mixed.json >out 2>err
    says mixed.json '"closetwo": true'
    says mixed.json '"realhole": true'
    says mixed.json '"freesector": false'
}

radius_and_neighbors() {
    expect 0 run scene:sphere --neighbors 16 --report k.json
    expect 0 run scene:sphere -r 0.3 --report r.json
    is "$(number euler_characteristic r.json)" 2 "sphere by radius"
    expect 0 run scene:sphere -k 3 --report few.json
    [ "$(number state_hash few.json)" != "$(number state_hash k.json)" ] ||
        [ "$(number triangles few.json)" != "$(number triangles k.json)" ] ||
        fail "--neighbors changes nothing"
    expect 0 run scene:sphere --keep-opposing --report keep.json
    says keep.json '"drop_opposing_normals": false'
}

check_finds_faults() {
    icosahedron >points.xyz
    expect 0 run points.xyz --check --report report.json
    is "$(number flipped_triangles report.json)" 0 "flipped triangles"
    # The same corners with the normal of one turned inwards.
    icosahedron | sed '1s/ 0 0.5257311 0.8506508$/ 0 -0.5257311 -0.8506508/' >flipped.xyz
    expect 1 run flipped.xyz --keep-opposing --check --rules printed -q
    says err "the mesh has faults at 1 place: 1 of non-manifold edges"
    says err "; --best may avoid them"
}

check_fails_where_there_is_no_mesh() {
    printf 'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n' >none.ply
    expect 3 run none.ply --check -o mesh.ply
    says err "none.ply: holds no points to triangulate"
    expect 3 run none.ply
    "$program" run - <none.ply >out 2>err
    is $? 3 "exit code of standard input without points"
    says err "standard input: holds no points"
    absent mesh.ply
    printf '0 0 0 0 0 1\n1 0 0 0 0 1\n' >two.xyz
    expect 1 run two.xyz --check
    says err "two.xyz: the run made no triangle of 2 points"
    expect 0 run two.xyz
    says err "two.xyz: the run made no triangle of 2 points"
    expect 1 run two.xyz --best -o two.ply --report two.json
    says err "two.xyz: the run made no triangle of 2 points"
    says two.json '"sound": false'
    expect 1 check two.ply --points two.xyz
    # Neither is there a fault to list: no point is usable.
    printf '0 0 0 0 0 0\n1 0 0 0 0 0\n' >zero.xyz
    expect 0 run zero.xyz -o zero.ply --report zero.json
    says zero.json '"sound": false'
    says err "zero.xyz: the run made no triangle of 2 points"
    expect 1 check zero.ply --points zero.xyz --allow lost_points
    says out "zero.ply: 0 triangles, not sound: no triangle"
    expect 1 check zero.ply --points zero.xyz --json
    says out '"sound": false'
    expect 0 why zero.xyz --failures
    is "$(head -1 out)" "not sound: no triangle" "verdict of why"
    expect 0 why zero.xyz --failures --json
    says out '"sound": false'
    # Twenty copies of one corner: more is set aside than used.
    { icosahedron; for _ in $(seq 20); do icosahedron | head -1; done; } >copies.xyz
    expect 1 run copies.xyz --check -q
    says err "copies.xyz: more points were set aside (20) than used (12)"
    expect 0 run copies.xyz -q
}

faults_and_places_are_counted_alike() {
    expect 1 run scene:uneven-density --check --report report.json -o mesh.ply
    says err "the mesh has faults at 6 places: 1 of holes, 3 of lost points, "
    is "$(number places_total report.json)" 6 "places of the report"
    expect 1 check mesh.ply
    says out "6 places: 1 of holes, 3 of lost points, "
    says out "#2 2 lost points; at ("
    expect 1 check mesh.ply --json
    is "$(number places_total out)" 6 "places of check"
    expect 0 why scene:uneven-density --failures --most 1
    [[ $(head -1 out) = "6 places: 1 of holes, 3 of lost points, "* ]] || fail "why: $(head -1 out)"
    says out "#1 1 hole of 5 edges, "
    says out "... and 5 more by --json"
    expect 0 why scene:uneven-density --failures --json
    is "$(number places_total out)" 6 "places of why"
}

run_ends_with_its_faults() {
    expect 0 run scene:close-sheets
    tail -1 err | grep -qE '^scene:close-sheets: the mesh has 29 faults: 1 non-manifold vertex, 1 inconsistent edge, 4 degenerate triangles, 2 folded edges, 10 flipped triangles, 9 small components, 2 lost points; intersecting triangles and second layers not counted \(use --check\); --best may avoid them$' ||
        fail "last line: $(tail -1 err)"
    expect 0 run scene:close-sheets --report report.json
    tail -1 err | grep -qE 'the mesh has faults at 5 places: .*; --best may avoid them$' ||
        fail "last line with a report: $(tail -1 err)"
    expect 0 run scene:close-sheets -q
    empty err
    icosahedron >points.xyz
    expect 0 run points.xyz
    grep -q fault err && fail "faults where there are none"
    return 0
}

capped_run_ends_with_one() {
    # All neighbors at once and no rule that keeps a run in order: it has to be stopped.
    expect 1 run scene:sphere -k 300 --rules printed --keep-opposing --check --report report.json
    says report.json '"stop_reason": "capped"'
    says report.json '"sound": false'
    says err "is not a surface"
    absent mesh.ply
}

holes_are_closed_up_to_a_size() {
    # A sheet of uneven points with a hole of its own, 9 across.
    awk 'BEGIN { for (y = 0; y < 20; ++y) for (x = 0; x < 20; ++x)
             if ((x - 10) ^ 2 + (y - 10) ^ 2 > 20) print x + 0.3 * sin(7 * x + 3 * y), y + 0.3 * sin(5 * x + 11 * y), 0, 0, 0, 1
         }' >sheet.xyz
    expect 0 run sheet.xyz --rules robust
    says err "  open       2 loops, the widest "
    expect 0 run sheet.xyz --rules robust --rule holewidth=5 --report narrow.json
    is "$(number boundary_loops narrow.json)" 2 "loops"
    expect 0 run sheet.xyz --rules robust --rule holewidth=12 --rule holeedges=40 --check
    says err "  open       1 loop, "
    # It is no opening that counts as closed against the wish of the user.
    expect 0 run sheet.xyz --best --rule holewidth=12 --report wide.json
    is "$(number boundary_loops wide.json)" 1 "loops"
    expect 2 run sheet.xyz --rule holewidth=-1
    says err "holewidth"
}

best_is_the_run_with_its_options() {
    # The paper's rules close the opening of the sheet and lose points; another change is better.
    expect 0 run scene:uneven-density --best -o best.ply --report best.json
    local options
    options=$(python3 - <<'EOF'
import json
best = json.load(open("best.json"))["best"]
tried = best["tried"]
first, chosen = tried[0], tried[best["chosen"]]
assert first["options"] == [] and 2 <= len(tried) <= 20, tried
robust = [each["verdict"] for each in tried if each["options"] == ["--rules", "robust"] or each["options"] == ["--rules robust"]]
def rank(verdict):
    return (not verdict["sound"], verdict["points_amiss"], verdict["extra_pieces"], verdict["mean_distance"])
assert all(rank(chosen["verdict"]) <= rank(each["verdict"]) for each in tried), (tried, chosen)
assert rank(chosen["verdict"]) < rank(first["verdict"]), (first, chosen)
assert len(robust) == 1 and all(each["work"] > 0 for each in tried), tried
print(" ".join(chosen["options"]))
EOF
    ) || fail "the trials of best.json: $(head -c 600 best.json)"
    # shellcheck disable=SC2086 # several words
    expect 0 run scene:uneven-density $options -q -o same.ply
    cmp best.ply same.ply || fail "--best gives another mesh than its options: $options"
    expect 0 run scene:uneven-density --best
    says err "  tried      "
    says err "  before     6 places: "
    says err "  instead    $options"
    # A sound mesh needs no other.
    icosahedron >points.xyz
    expect 0 run points.xyz --best
    says err "  tried      0 changes of the settings"
    says err "  best       as given; no change is better"
    expect 2 run points.xyz --best --what-if "1.sphere keep 2"
    says err "--what-if excludes --best"
}

output_folder_is_checked_first() {
    for option in -o --report --trace; do
        expect 2 run scene:sphere $option none/file.ply
        says err "there is no folder none"
        expect 2 run scene:sphere $option .
        says err "is a folder"
    done
    # Before the input is looked at.
    expect 2 run missing.ply -o none/mesh.ply
}

output_names_are_checked_first() {
    for option in -o --report --trace; do
        expect 2 run missing.ply $option ''
        says err "the file name is empty"
    done
    expect 2 sample torus -n 50 -o ''
    expect 2 doctor scene:sphere --fix ''
    expect 2 reduce scene:sphere --failure holes -o ''
    expect 2 render scene:sphere -o ''
    expect 2 run missing.ply -o a.ply --report ./a.ply
    says err "-o and --report both name ./a.ply; give two names"
    expect 2 run missing.ply --report a.txt --trace "$PWD/a.txt"
    echo old >b.ply
    ln -s b.ply c.ply
    expect 2 run missing.ply -o b.ply --trace c.ply
    is "$(cat b.ply)" old "the file that was named twice"
    # Two links to one file that does not exist yet.
    ln -s later d.ply
    expect 2 run missing.ply -o later --report d.ply
    expect 0 run scene:sphere -q --report /dev/null --trace /dev/null
}

# refuses INPUT OUTPUT ARGUMENTS...: wrong usage that names both and --force, and the input stays.
refuses() {
    local input=$1 output=$2
    shift 2
    cp "$input" kept
    expect 2 "$@"
    says err " $output: is the same file as "
    says err " $input, which would be replaced; choose another name, or add --force to replace it"
    cmp -s "$input" kept || fail "\`spiraling-edge $*\` replaced $input"
}

outputs_do_not_replace_the_input() {
    local option
    icosahedron >in.xyz
    expect 0 run in.xyz -q -o in.ply
    ln -s in.ply link.ply
    ln in.ply hard.ply
    for option in -o --report --trace; do refuses in.ply link.ply run in.ply $option link.ply; done
    refuses in.ply hard.ply doctor in.ply --fix hard.ply
    refuses in.ply hard.ply reduce in.ply --failure holes -o hard.ply
    cp in.xyz small.ply
    ln small.ply other.sesession
    refuses small.ply other.sesession reduce small.ply --failure holes -o other.ply
    # Standard input that is a file, and standard output.
    cp in.ply kept.ply
    "$program" run - -q -o in.ply <in.ply 2>err
    is $? 2 "-o that is standard input"
    says err "-o in.ply: is the same file as the input -"
    "$program" run /dev/stdin -q -o in.ply <in.ply 2>err
    is $? 2 "-o that is /dev/stdin"
    "$program" run in.ply -q -o - >>in.ply 2>err
    is $? 2 "standard output that is the input"
    cmp -s in.ply kept.ply || fail "standard output was appended to the input"
    # A second input.
    echo '{"triangles": []}' >start.json
    refuses start.json start.json run in.ply --start start.json --report start.json
    printf 'keep 1\n' >moves.txt
    refuses moves.txt ./moves.txt practice --answer moves.txt --result ./moves.txt
    refuses in.ply in.ply lesson new in.ply -o in.ply
    lesson_result a.result.json '"q"' '' true
    refuses a.result.json a.result.json lesson results in.ply a.result.json -o a.result.json
    ball 'isovalue:=1'
    ln ball.nhdr ball.ply
    refuses ball.nhdr ball.ply sample ball.nhdr -n 50 -o ball.ply
    ln ball.raw raw.ply
    expect 2 sample ball.nhdr -n 50 -o raw.ply
    says err "-o raw.ply: is the same file as the data file ball.raw"
}

outputs_replace_the_input_by_force() {
    icosahedron >in.xyz
    expect 0 run in.xyz -q -o in.ply
    cp in.ply points.ply
    expect 0 run points.ply -q -o points.ply --force
    is "$(header_count face points.ply)" 20 triangles
    ln -s points.ply link.ply
    expect 1 doctor points.ply -q --fix link.ply --force  # What is found is left.
    [ -L link.ply ] || fail "the link was replaced"
    # Two outputs are two files, force or not.
    expect 2 run in.ply -o a.ply --report a.ply --force
    says err "-o and --report both name a.ply; give two names"
    expect 2 run in.ply -o - --report /dev/stdout --force
}

mesh_goes_to_open_files_by_name() {
    icosahedron >in.xyz
    expect 0 run in.xyz -q -o mesh.ply
    "$program" run in.xyz -q -o /dev/stdout 2>err | cmp - mesh.ply || fail "/dev/stdout: $(cat err)"
    echo before >log
    "$program" run in.xyz -q --trace /dev/stdout >>log
    is "$(head -1 log)" before "the log that the trace was appended to"
    [ "$(wc -l <log)" -gt 2 ] || fail "no trace in the log"
}

coordinates_beyond_float_are_refused() {
    icosahedron | awk '{ print $1 * 1e39, $2 * 1e39, $3 * 1e39, $4, $5, $6 }' >far.xyz
    for name in far.stl far.glb; do
        expect 5 run far.xyz -q -o $name
        says err "$name: a coordinate is too large for"
        absent $name
    done
    expect 0 run far.xyz -q -o far.ply
}

trace_is_written_as_the_mesh_is() {
    expect 0 run scene:torus -q --trace trace.txt
    ln -s trace.txt link.txt
    expect 0 run scene:torus -q --trace link.txt
    [ -L link.txt ] || fail "the link was replaced"
    "$program" run scene:torus --trace - -q 2>/dev/null | cmp - trace.txt || fail "link: other bytes"
    chmod 0444 trace.txt
    expect 2 run scene:sphere -q --trace trace.txt
    says err "trace.txt: cannot be written: Permission denied"
}

signals_leave_no_part_of_a_file() {
    local signal process
    # The points arrive by a pipe that stays open: the trace is begun, the run is not.
    mkfifo pipe
    for signal in TERM HUP INT; do
        # `env`: a shell starts background programs with Ctrl+C ignored; this undoes it.
        env --default-signal=INT "$program" run - -o mesh.ply --trace trace.txt <pipe >out 2>err &
        process=$!
        exec 3>pipe
        until ls -A | grep -q '\.part$' || ! kill -0 $process 2>/dev/null; do sleep 0.02; done
        ls -A | grep -q '\.part$' || fail "the trace was not begun"
        kill -$signal $process
        wait $process
        is $? $((128 + $(kill -l $signal))) "exit code"
        exec 3>&-
        is "$(ls -A | sort | tr '\n' ' ')" "err out pipe " "files after $signal"
    done
    says err interrupted
}

failure_leaves_no_file() {
    printf 'ply\nformat ascii 1.0\nelement vertex 5\n' >cut.ply
    expect 3 run cut.ply -o mesh.ply --trace trace.txt --report report.json
    is "$(ls | sort | tr '\n' ' ')" "cut.ply err out " files
    expect 5 run scene:sphere -o /dev/full
    says err "cannot be written"
    expect 5 run scene:sphere --trace /dev/full
}

# height_map SIDE: a height map of SIDE by SIDE points with normals, as XYZ.
height_map() {
    awk -v side="$1" 'BEGIN { for (x = 0; x < side; ++x) for (y = 0; y < side; ++y)
        print x, y, 0.3 * sin(x / 9) * cos(y / 7), 0, 0, 1 }'
}

# user_ticks PROCESS: hundredths of a second that it has computed, in `ticks`: -1 before the program
# has set its signal handlers (the last is that of SIGXCPU), empty once it ended.
user_ticks() {
    local words=() key value caught=0
    { read -ra words <"/proc/$1/stat"; } 2>/dev/null || true
    ticks=${words[13]:-}
    while read -r key value; do
        if [ "$key" = SigCgt: ]; then caught=$((0x$value & 0x800000)); fi
    done 2>/dev/null <"/proc/$1/status"
    if [ -n "$ticks" ] && { [ "${words[1]}" != "(spiraling-edge)" ] || [ $caught = 0 ]; }; then
        ticks=-1
    fi
}

# interrupted_after TICKS SIGNAL_ACTION ARGUMENTS...: runs the program, and sends SIGINT once it has
# computed so long; one that ended before, since this shell had to wait, is run again, without the
# files new.* that it wrote. Its exit code is in `code`, the seconds that it computed after the
# signal in `late`. The input of a verb that reads none is a pipe that stays open.
interrupted_after() {
    local wanted=$1 action=$2 process ticks before=() after=() try
    shift 2
    for try in 1 2 3 4 5 6 7 8 9 10; do
        times >before
        env "--$action-signal=INT" "$program" "$@" <&"$never" >out 2>err &
        process=$!
        while user_ticks $process; [ -n "$ticks" ] && [ "$ticks" -lt "$wanted" ]; do
            read -rt 0.005 -u "$never"
        done
        kill -STOP $process 2>/dev/null && user_ticks $process && kill -INT $process &&
            kill -CONT $process && break
        wait $process || true
        rm -f new.*
        [ $try != 10 ] || fail "\`spiraling-edge $*\` ended before it was interrupted"
    done
    code=0
    wait $process || code=$?
    times >after
    late=$(cat before after | awk -v ticks="${ticks:-0}" '
        NR % 2 == 0 { split($1, part, /[ms]/); user[NR] = 60 * part[1] + part[2] }
        END { printf "%.2f", user[4] - user[2] - ticks / 100 }')
    rm before after
}

interrupts_end_every_verb_at_once() {
    mkfifo silence
    exec {never}<>silence
    height_map 150 >big.xyz
    height_map 400 >bigger.xyz
    expect 0 run big.xyz -q -o mesh.ply --trace run.setrace
    local files now code late
    files=$(ls | sort | tr '\n' ' ')
    while read -r ticks arguments; do
        # shellcheck disable=SC2086
        interrupted_after "$ticks" default $arguments
        is "$code" 130 "$arguments after $ticks ticks: exit code"
        says err interrupted
        echo "$late s after the signal: $arguments"
        awk "BEGIN { exit !($late < 0.06) }" || fail "$arguments: computed for $late s after it"
        now=$(ls | sort | tr '\n' ' ')
        is "$now" "$files" "$arguments: files"
    done <<'VERBS'
1 run big.xyz -o new.ply --report new.json
4 run big.xyz -o new.ply --report new.json
9 run big.xyz -o new.ply --report new.json
14 run big.xyz -o new.ply --check --report new.json
40 run big.xyz --best -o new.ply
2 info bigger.xyz
1 doctor big.xyz --fix new.ply
6 doctor big.xyz --fix new.ply
1 check mesh.ply
4 check mesh.ply
9 check mesh.ply --points big.xyz
20 sample sphere -n 100000 -o new.ply
3 why big.xyz --failures
20 why big.xyz --failures
6 compare big.xyz --with --rules robust
3 diff run.setrace big.xyz --rules robust
12 reduce big.xyz --failure openings -o new.ply
5 table1
20 figures --check
1 lesson check tour
0 practice --answer -
0 info -
VERBS
    exec {never}>&-
}

budgets_end_reading() {
    local verb arguments
    icosahedron >points.xyz
    {
        printf 'NRRD0004\ntype: uint8\ndimension: 3\nsizes: 200 200 200\nencoding: gzip\n\n'
        head -c 8000000 /dev/zero | gzip
    } >bomb.nrrd
    [ "$(wc -c <bomb.nrrd)" -lt 20000 ] || fail "the volume is not packed"
    mkdir folder
    printf '# T\n\n```se lesson\nversion = 1\ninput = "zero"\n```\n## S\n' >folder/a.lesson.md
    head -c 200000 /dev/zero >folder/zero
    while read -r verb arguments; do
        # shellcheck disable=SC2086
        expect 3 $verb --most-bytes 100000 $arguments
        says err "holds more than 100000 bytes, read or unpacked; --most-bytes N raises this limit"
    done <<'READERS'
run /dev/zero -o new.ply
run /dev/zero --best -o new.ply
info /dev/zero
doctor /dev/zero
check /dev/zero
check points.xyz --points /dev/zero
why /dev/zero --failures
compare /dev/zero --with --rules robust
compare points.xyz --mesh /dev/zero
reduce /dev/zero --failure holes -o new.ply
sample bomb.nrrd -n 10 --iso 0.5 -o new.ply
lesson new folder/zero -o folder/new.lesson.md
READERS
    expect 3 lesson check folder/a.lesson.md --most-bytes 100000
    says out "holds more than 100000 bytes"
    absent new.ply
    yes 1 2 3 | "$program" info - --most-bytes 100000 >out 2>err && fail "endless input was read"
    says err "standard input: holds more than 100000 bytes"
    expect 0 info points.xyz --most-bytes "$(wc -c <points.xyz)"
    expect 2 info points.xyz --most-bytes 0
    # What has a limit of its own has no option.
    expect 3 diff /dev/zero points.xyz
    says err "/dev/zero: holds more than 268435456 bytes"
    expect 3 run points.xyz --start /dev/zero
    says err "/dev/zero: holds more than 67108864 bytes"
    expect 3 lesson results /dev/zero
    says err "/dev/zero: holds more than 67108864 bytes"
}

promises_of_headers_take_no_memory() {
    # Programs that take the memory that a header promises end at this limit.
    ulimit -v 2000000
    printf 'ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n' >a.ply
    sed 's/ascii/binary_little_endian/' a.ply >b.ply
    sed 's/element vertex 4000000000/element vertex 1\nproperty float w\nelement foo 4000000000/' a.ply >c.ply
    printf 'OFF\n4000000000 4000000000 0\n0 0 0\n' >a.off
    printf 'VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4000000000\nHEIGHT 1\nPOINTS 4000000000\nDATA ascii\n0 0 0\n' >a.pcd
    sed 's/ascii/binary/' a.pcd >b.pcd
    printf 'NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1000000 1000000 1000000\nencoding: raw\n\nabc' >a.nrrd
    sed 's/raw/gzip/' a.nrrd >b.nrrd
    truncate -s 1T huge.xyz
    truncate -s 1T huge.nrrd
    local file
    for file in a.ply b.ply c.ply a.off a.pcd b.pcd huge.xyz; do
        expect 3 info $file
        says err "$file"
    done
    for file in a.nrrd b.nrrd huge.nrrd; do
        expect 3 sample $file -n 10 --iso 0.5 -o new.ply
        says err "$file"
    done
    says err "2147483648 bytes"
    absent new.ply
}

an_ignored_interrupt_stays_ignored() {
    mkfifo silence
    exec {never}<>silence
    height_map 400 >big.xyz
    local code late
    interrupted_after 1 ignore run big.xyz -q -o new.ply
    exec {never}>&-
    is "$code" 0 "exit code"
    empty err
    expect 0 info new.ply
}

used_points_alone_are_written() {
    # A point that no list reaches is in no triangle.
    { icosahedron; echo "9 9 9 0 0 1"; } >far.xyz
    expect 0 run far.xyz --radius 1.2 -q -o all.ply
    is "$(header_count vertex all.ply)" 13 "points of all"
    expect 0 run far.xyz --radius 1.2 -q --used-points -o used.ply
    is "$(header_count vertex used.ply)" 12 "used points"
    is "$(header_count face used.ply)" 20 "triangles of the used points"
    expect 0 check used.ply
    expect 2 run far.xyz --used-points
    says err "--output"
}

crop_keeps_the_points_in_a_box() {
    square >square.xyz
    expect 0 run square.xyz --crop -1,1,0,2,3,0 -o piece.ply --report report.json
    is "$(header_count vertex piece.ply)" 9 "points in the box"
    head -c 2000 piece.ply | grep -aqx "property uint index" || fail "no column index"
    is "$(number kept report.json)" 9 "points kept"
    is "$(number points_in_file report.json)" 25 "points in the file"
    says report.json '"thin": null'
    expect 0 run square.xyz --crop -1,1,0,2,3,0
    says err "kept       9 of 25 points: crop"
    expect 0 run square.xyz --report report.json
    says report.json '"piece": null'
    # A piece of a piece has the numbers of the whole file: at last that of (2, 3).
    expect 0 run square.xyz --crop -1,1,0,2,3,0 --max-pivots 0 -q -o piece.ply
    expect 1 doctor piece.ply --crop 1,0,0,9,9,0 --fix last.ply
    says out "kept     6 of 9 points: crop"
    says out "try (not tried here): spiraling-edge run piece.ply --crop 1,0,0,9,9,0 --best -o OUT.ply"
    is "$(tail -c 12 last.ply | od -An -tu4 | awk '{ print $NF }')" 13 "last index"
}

thin_keeps_a_spacing() {
    square >square.xyz
    expect 0 info square.xyz --crop 0,1,0,4,4,0 --thin 1.5
    says out "square.xyz: 6 points"
    says out "kept       6 of 25 points: crop, thin 1.5"
    expect 0 info square.xyz --thin 2 --json
    is "$(number kept out)" 9 "points kept"
    is "$(number thin out)" 2.0 "spacing"
    expect 0 info square.xyz --thin 2 --json
    cp out first
    expect 0 info square.xyz --thin 2 --json
    cmp -s out first || fail "another piece of the same file"
}

scale_multiplies_coordinates() {
    square >square.xyz
    expect 0 info square.xyz --scale-by 10,2,0.5
    says out "kept       25 of 25 points: scale 10,2,0.5"
    expect 0 run square.xyz --crop 0,0,0,2,2,0 --scale-by 10,2,0.5 -q -o mesh.ply --report report.json
    is "$(number kept report.json)" 9 "points in the box"
    expect 0 info mesh.ply --json
    python3 - <<'EOF' || fail "not scaled"
import json
assert json.load(open("out"))["facts"]["box"]["high"] == [20.0, 4.0, 0.0]
piece = json.load(open("report.json"))["piece"]
assert piece["scale"] == [10.0, 2.0, 0.5], piece
EOF
    "$program" check mesh.ply --points square.xyz --crop 0,0,0,2,2,0 --scale-by 10,2,0.5 --json >out
    is "$(number lost_points out)" 0 "lost points of the scaled ones"
    expect 2 run square.xyz --scale-by 1,0,1
    says err "--scale-by 1,0,1: expected three numbers > 0 separated by commas: X,Y,Z"
    expect 2 compare square.xyz --with --scale-by 2,2,2
    says err "give it before --with"
}

doctor_converts_units() {
    # A wave in meters, x and y as degrees.
    awk 'BEGIN { for (i = 0; i < 30; i++) for (j = 0; j < 30; j++) {
        x = 0.3 * i + 0.02 * sin(7 * j + i); y = 0.3 * j + 0.02 * sin(5 * i + 3 * j)
        printf "%.10f %.10f %.4f\n", 11.57 + x / 74300, 48.13 + y / 111132, 520 + 3 * sin(0.35 * x) * cos(0.4 * y)
    } }' >"in degrees.xyz"
    expect 1 doctor "in degrees.xyz"
    says out "; with x and y as degrees of longitude and latitude, in meters, "
    says out "try: spiraling-edge run 'in degrees.xyz' --scale-by 74300,111132,1 -o OUT.ply"
    says out ", by robust sound (before no triangle)"
    expect 0 run "in degrees.xyz" --scale-by 74300,111132,1 --rules robust -q -o mesh.ply
    expect 0 check mesh.ply
    # Factors that are given already are not multiplied again.
    expect 1 doctor "in degrees.xyz" --scale-by 2,2,2 --json
    python3 - <<'EOF' || fail "a command for points that are scaled"
import json
found = [f for f in json.load(open("out"))["findings"] if f["name"] == "mixed_units"]
assert len(found) == 1 and found[0]["remedy"] is None and found[0]["tried"] is None, found
EOF
}

pieces_go_through_all_verbs() {
    expect 0 run scene:sphere --crop -9,-9,-9,9,9,0 --thin 0.05 -q -o mesh.ply
    expect 3 check mesh.ply --points scene:torus --crop -9,-9,-9,9,9,0
    expect 1 check mesh.ply --points scene:sphere --json
    [ "$(number isolated_points out)" -gt 0 ] || fail "points outside of the box should be missed"
    "$program" check mesh.ply --points scene:sphere --crop -9,-9,-9,9,9,0 --thin 0.05 --json >out
    is "$(number isolated_points out)" 0 "isolated points of the piece"
    expect 2 check mesh.ply --crop -9,-9,-9,9,9,0
    says err "--points"
    expect 0 compare scene:sphere --crop -9,-9,-9,9,9,0 --with --rules paper
    says out "--crop=-9,-9,-9,9,9,0"
    says err "scene:sphere: kept "
    local last
    last=$(($(header_count vertex mesh.ply) - 1))
    expect 0 why scene:sphere --crop -9,-9,-9,9,9,0 --thin 0.05 --point $last
    says err "scene:sphere: kept $((last + 1)) of "
    expect 0 why scene:sphere --thin 0.05 --point 0 -q
    empty err
    expect 3 why scene:sphere --crop -9,-9,-9,9,9,0 --thin 0.05 --point $((last + 1))
    expect 0 reduce scene:four-edge-hole --crop -9,-9,-9,9,9,9 --failure non_manifold_edges -q -o small.ply
    grep -q -- --crop small.sh && fail "reduced points are cut again: $(cat small.sh)"
    expect 2 compare scene:sphere --with --thin 0.1
    says err "give it before --with"
}

pieces_check_their_arguments() {
    square >square.xyz
    expect 2 run square.xyz --crop "0 0 0 1 1 1"
    says err "--crop 0 0 0 1 1 1: expected six numbers separated by commas"
    expect 2 run square.xyz --thin -1
    # Before the file is read.
    for verb in info doctor; do expect 2 $verb missing.xyz --thin 0; done
    expect 2 why missing.xyz --charts --crop 1
    expect 2 run square.xyz --crop 0.2,0,0,0.8,4,0 -o piece.ply
    says err "holds 0 of the 25 points of square.xyz"
    absent piece.ply
}

quiet_says_nothing() {
    expect 0 run scene:sphere -o mesh.ply -q
    empty out
    empty err
    expect 0 run scene:sphere
    says err "nothing; name a file with -o"
}

info_tells_what_a_file_holds() {
    icosahedron >points.xyz
    expect 0 info points.xyz
    says out "points.xyz: 12 points"
    says out "normals    yes"
    expect 0 run points.xyz -o mesh.ply -q
    expect 0 info mesh.ply --json
    is "$(number points out)" 12 points
    is "$(number triangles out)" 20 triangles
    says out '"closed_manifold": true'
    expect 0 info scene:sheet
    says out "on a wall"
}

info_says_how_columns_were_read() {
    awk 'BEGIN { for (y = 0; y < 8; ++y) for (x = 0; x < 8; ++x) print x, y, 0.01 * x * y, 30 * x, 255 - y, 7 }' >colored.xyz
    expect 0 info colored.xyz
    says out "columns    x y z red green blue (columns 4 to 6 are whole numbers from 0 to 255: colors)"
    says out "normals    none: a run derives them"
    says out "also       red, green, blue"
    expect 0 info colored.xyz --json
    says out '"columns": "x y z red green blue"'
    expect 0 run colored.xyz -o colored.ply --report report.json
    grep -qa '^property uchar red$' colored.ply || fail "no colors in the mesh"
    says report.json '"columns": "x y z red green blue"'
    is "$(number components report.json)" 1 "components"
    tr . , <colored.xyz >mixed.xyz
    expect 3 info mixed.xyz
    says err "mixed.xyz: line 10: expected commas"
}

far_stl_says_its_shift() {
    sphere_points near.xyz
    awk '{ printf "%.4f %.4f %.4f\n", $1 + 500001, $2 + 5400001, $3 + 301 }' near.xyz >far.xyz
    expect 0 info far.xyz
    grep -qE 'box +500000[.0-9]* 54000[0-9.]+ ' out || fail "the box has too few digits: $(cat out)"
    expect 0 run far.xyz -o far.stl
    says err "far.stl: positions are relative to (500000, 5400000, 300), since STL keeps 7 digits"
    head -c 80 far.stl >header
    says header "add 500000 5400000 300"
    expect 0 run far.xyz -o far.stl --report report.json
    says err "far.stl: positions are relative to (500000, 5400000, 300)"
    tr -d ' \n' <report.json >flat
    says flat '"shift":[500000.0,5400000.0,300.0]'
    expect 0 run far.xyz -o far.stl -q
    empty err
    expect 0 run near.xyz --rules robust -o near.stl --report report.json
    says report.json '"shift": null'
    ! grep -q "positions are relative" err || fail "near the origin nothing is shifted: $(cat err)"
}

fault_fields_are_columns_of_a_ply_alone() {
    expect 0 run scene:stranded-point -q -o plain.ply
    expect 0 run scene:stranded-point -q -o fields.ply --fault-fields --report report.json
    head -c 2000 fields.ply | grep -aq "^property uchar scalar_se_fault" || fail "no column of faults"
    head -c 2000 fields.ply | grep -aq "^property .* scalar_se_distance" || fail "no column of distances"
    head -c 2000 plain.ply | grep -aq "scalar_se_fault" && fail "columns without the option"
    [ "$(number points_in_no_triangle report.json)" -gt 0 ] || fail "the scene has no unused point"
    expect 0 run scene:stranded-point -q -o used.ply --fault-fields --used-points
    "$program" run scene:stranded-point -q --fault-fields -o - | cmp - fields.ply || fail "-o - writes another PLY"
    for kind in stl obj off glb; do
        expect 2 run scene:sphere -q -o mesh.$kind --fault-fields
        says err "--fault-fields -o mesh.$kind: this format cannot hold numbers of points; choose .ply"
        absent mesh.$kind
    done
    expect 2 run scene:sphere -q --fault-fields
}

off_is_plain_unless_normals_are_asked_for() {
    expect 0 run scene:sphere -q -o plain.off
    is "$(head -1 plain.off)" OFF "keyword"
    expect 0 run scene:sphere -q -o full.off --normals
    is "$(head -1 full.off)" NOFF "keyword with --normals"
    expect 2 run scene:sphere -o mesh.stl --normals
    says err "this format cannot hold normals"
    absent mesh.stl
    expect 2 run scene:sphere --normals
    says err "name a file with -o"
    expect 0 sample sphere -n 200 -q -o points.off
    is "$(head -1 points.off)" NOFF "keyword of sampled points"
}

info_counts_what_is_wrong() {
    {
        icosahedron
        icosahedron | head -1  # a copy
        echo '5 0 0 0 0 0'     # no direction
        echo 'nan 0 0 1 0 0'   # nowhere
        echo '0 0 1.5 0 0 7'   # not of unit length
    } >odd.xyz
    expect 0 info odd.xyz --json
    is "$(number duplicates out)" 1 duplicates
    is "$(number completed_normals out)" 1 "normals to derive"
    is "$(number non_finite out)" 1 "not finite"
    is "$(number unscaled_normals out)" 1 "not of unit length"
}

doctor_says_what_is_wrong() {
    sphere_points good.xyz
    expect 0 doctor good.xyz
    is "$(cat out)" "good.xyz: 600 points, 0.137 between points, 2 x 2 x 2, nothing found" "a clean set"
    expect 0 doctor good.xyz --json
    says out '"accused": false'
    says out '"findings": []'
    is "$(number median out | cut -c1-5)" 0.136 "spacing"
    awk 'NR == 8 { $4 = $5 = $6 = 0 } NR == 30 { $1 = "nan" } { print } NR == 50' good.xyz >odd.xyz
    expect 1 doctor odd.xyz
    empty err
    says out "odd.xyz: 601 points, 0.137 between points, 2 x 2 x 2, 3 findings"
    says out "warning  zero_normals: 1 point with a normal that is zero, NaN or infinite"
    says out "at point 7"
    says out "try: spiraling-edge doctor odd.xyz --fix OUT.ply"
    expect 1 doctor odd.xyz --json
    for name in non_finite duplicates zero_normals; do says out "\"name\": \"$name\""; done
    is "$(number count out)" 1 "count of the first"
    "$program" doctor - -q <odd.xyz >out 2>err
    is $? 1 "code of standard input"
    empty out
    # A note is no fault.
    expect 0 doctor scene:figure-8
    says out "note     unsymmetric_lists"
    expect 1 doctor scene:grid
}

doctor_mends_what_needs_no_guessing() {
    sphere_points good.xyz
    awk 'NR == 8 { $4 = $5 = $6 = 0 } NR == 30 { $1 = "nan" } NR == 9 { $4 *= 3; $5 *= 3; $6 *= 3 }
         { print } NR == 50' good.xyz >odd.xyz
    expect 0 doctor odd.xyz --fix fixed.ply
    says out "fixed.ply: written, 599 points"
    says out "fixed    1 normal that was zero or not finite derived"
    says out "fixed    1 exact copy dropped"
    is "$(header_count vertex fixed.ply)" 599 points
    expect 0 doctor fixed.ply
    says out "nothing found"
    # To standard output the same bytes; words go to standard error.
    "$program" doctor odd.xyz --fix - >piped.ply 2>err || fail "--fix - ended with $?"
    cmp fixed.ply piped.ply || fail "--fix - writes other bytes"
    says err "fixed    1 exact copy dropped"
    expect 0 doctor odd.xyz --fix fixed.ply --json
    is "$(grep -A 100 '"fixed"' out | grep -c '"count"')" 4 repairs
    # What would need guessing is left, and reported.
    { cat good.xyz; echo 40 0 0 1 0 0; } >stray.xyz
    expect 1 doctor stray.xyz --fix left.ply
    says out "left     isolated_points"
    expect 0 doctor stray.xyz --fix dropped.ply --drop isolated_points
    is "$(header_count vertex dropped.ply)" 600 points
}

doctor_empties_no_file() {
    local value
    sphere_points good.xyz
    for value in nan inf 0.0; do
        awk -v v=$value '{ print $1, $2, $3, v, v, v }' good.xyz >bad.xyz
        expect 1 doctor bad.xyz
        says out "600 points with a normal that is zero, NaN or infinite: most, so all normals are derived"
        expect 1 doctor bad.xyz --fix fixed.ply
        is "$(header_count vertex fixed.ply)" 600 "points with normals of $value"
        for file in bad.xyz fixed.ply; do
            expect 0 run $file --rules robust -q --check -o mesh.ply
            is "$(header_count face mesh.ply)" 1196 "triangles of $file with normals of $value"
        done
    done
    # Rays, far from each other: each point is in line with all of its nearest.
    awk 'BEGIN { for (y = 0; y < 4; ++y) for (x = 0; x < 50; ++x) print x, 1000 * y, 0, 0, 0, 1 }' >lines.xyz
    expect 1 doctor lines.xyz
    says out "error    in_line: 200 points"
    grep -q -- "--drop in_line" out && fail "a fix that is refused is proposed"
    echo old >out.ply
    expect 1 doctor lines.xyz --fix out.ply --drop noise --drop in_line
    says err "lines.xyz: out.ply not written: the fixes would leave 0 of 200 distinct finite positions"
    says err "200 of 200 points dropped"
    says err "leave out --drop noise, --drop in_line, or add --force to write the rest"
    is "$(cat out.ply)" old "the file that was there"
    expect 1 doctor lines.xyz -q --fix out.ply --drop in_line --force
    is "$(header_count vertex out.ply)" 0 "points that were asked for"
    for i in 1 2 3 4 5; do echo nan 0 0 0 0 1; done >nowhere.xyz
    expect 1 doctor nowhere.xyz --fix nothing.ply
    says err "would leave 0 of 0 distinct finite positions"
    absent nothing.ply
    # Copies are no places of their own, and one far off is that of a missing value.
    { cat good.xyz; for i in $(seq 900); do echo 0 0 3 0 0 1; done; } >copies.xyz
    expect 0 doctor copies.xyz --fix out.ply
    is "$(header_count vertex out.ply)" 600 "points without copies"
    says out "900 points where a missing value was written dropped"
}

doctor_remedies_help() {
    sphere_points good.xyz
    awk '$3 > 0.7 { $4 = -$4; $5 = -$5; $6 = -$6 } { print }' good.xyz >patch.xyz
    awk '{ $4 = -$4; $5 = -$5; $6 = -$6; print }' good.xyz >inside.xyz
    awk '{ print $1, $2, $3 }' good.xyz >bare.xyz
    { cat good.xyz; awk 'NR == 40 { $1 += 1e-9; print }' good.xyz; } >twin.xyz
    awk '{ $4 = 0; $5 = 0; $6 = 1; print }' good.xyz >alike.xyz
    { cat good.xyz; awk '{ $1 += 0.004; $2 -= 0.003; print }' good.xyz; } >pairs.xyz
    local file command
    # A surface that ends without a wall is a note, and --derive-rim helps.
    awk '$3 < 0.6' good.xyz >open.xyz
    expect 0 doctor open.xyz
    says out "note     open_border: "
    says out "along 1 rim "
    says out "try: spiraling-edge run open.xyz --derive-rim -o OUT.ply"
    expect 0 run open.xyz --derive-rim -q -o OUT.ply
    expect 0 doctor OUT.ply
    says out "nothing found"
    rm OUT.ply
    for file in patch inside bare twin alike pairs; do
        expect 1 doctor $file.xyz
        command=$(sed -n 's/^ *try: spiraling-edge \(.*\) OUT.ply\(.*\)$/\1 OUT.ply\2/p' out)
        if [ $file = twin ]; then
            # The mesh does not suffer from one pair.
            says out "without gain: spiraling-edge doctor twin.xyz --fix OUT.ply --drop near_duplicates: by paper 1 point amiss (before"
            is "$command" "" "a command without gain"
            continue
        fi
        # shellcheck disable=SC2086
        expect 0 $command
        expect 0 doctor OUT.ply
        rm OUT.ply
    done
}

doctor_checks_its_arguments() {
    expect 2 doctor
    expect 2 doctor scene:grid --drop ties
    expect 2 doctor scene:grid --fix out.obj
    says err "only .ply"
    expect 2 doctor scene:grid --fix - --json
    expect 2 doctor scene:grid --fix nowhere/out.ply
    expect 2 doctor scene:grid --fix out.ply --drop warts
    says err "no such check"
    expect 3 doctor missing.ply
    printf 'ply\nformat ascii 1.0\nelement vertex 5\n' >cut.ply
    expect 3 doctor cut.ply --fix out.ply
    absent out.ply
}

other_files_are_refused_as_points() {
    ball
    local verb
    for verb in run info doctor; do
        expect 3 $verb ball.nhdr
        says err "is a volume; \`spiraling-edge sample ball.nhdr"
        expect 3 $verb sample:torus,n=50
        says err "works in the viewer only"
        printf 'ASTM-E57' >scan.e57
        expect 3 $verb scan.e57
        says err "is an E57 file, which cannot be read; convert it"
    done
}

files_of_other_programs_are_read() {
    # With their number before the rows, and packed, points give the same mesh.
    sphere_with_normals 'x, y, z, x, y, z' >sphere.xyz
    expect 0 run sphere.xyz -q -o mesh.ply
    { wc -l <sphere.xyz; cat sphere.xyz; } >count.pts
    gzip -k sphere.xyz
    expect 0 run sphere.xyz.gz -q -o same.ply
    cmp mesh.ply same.ply || fail "packed: another mesh"
    expect 0 info count.pts
    says out "read       line 1 is the number of points"
    expect 0 info count.pts --json
    says out '"line 1 is the number of points"'
    # Heights without a value are set aside, unless the user says that they are places.
    awk 'NR % 20 == 3 { $3 = -999 } { print $1, $2, $3 }' sphere.xyz >raster.xyz
    expect 0 info raster.xyz
    says out "where a missing value was written"
    expect 0 info raster.xyz --keep-sentinels
    grep -q "missing value" out && fail "far values are not kept"
    expect 1 doctor raster.xyz
    says out "try: spiraling-edge doctor raster.xyz --fix OUT.ply"
    expect 1 doctor raster.xyz --keep-sentinels -q
    head -c 300 sphere.xyz.gz >cut.xyz.gz
    expect 3 info cut.xyz.gz
    says err "cut.xyz.gz: the gzip data end too early"
    expect 3 info sphere.xyz.gz --most-bytes 1000
    says err "holds more than 1000 bytes, read or unpacked"
}

neighbors_within_spacings() {
    expect 0 run scene:sphere -q --report near.json --reach 1.6 -o near.ply
    expect 0 run scene:sphere -q --report far.json --reach 2.6 -o far.ply
    is "$(number triangles near.json)" 1196 "triangles within 1.6 spacings"
    grep -q '"neighbors": true' near.json || fail "lists are not marked as derived"
    cmp -s near.ply far.ply && fail "--reach changes nothing"
    # As a radius of that many times the spacing that `info` prints.
    expect 0 info scene:sphere
    spacing=$(sed -n 's/.*nearest point at \([0-9.]*\) on.*/\1/p' out)
    expect 0 run scene:sphere -q --radius "$(awk -v s="$spacing" 'BEGIN { print 1.6 * s }')" -o radius.ply
    cmp near.ply radius.ply || fail "it is no radius"
    for reach in 0 -1 nan many; do expect 2 run scene:sphere "--reach=$reach"; done
    expect 2 run scene:sphere --reach 1.6 --neighbors 12
    expect 2 run scene:sphere --reach 1.6 --radius 1
}

# A ball of radius 2 in 5 x 5 x 5 samples, 4 - r^2, with its header in ball.nhdr.
ball() {
    printf '%s\n' NRRD0004 'type: int8' 'dimension: 3' 'sizes: 5 5 5' 'spacings: 1 1 1' \
        'axis mins: -2 -2 -2' 'encoding: raw' 'data file: ball.raw' "$@" >ball.nhdr
    local x y z
    for z in 4 1 0 1 4; do
        for y in 4 1 0 1 4; do
            for x in 4 1 0 1 4; do printf "\\$(printf %o $(((260 - x - y - z) % 256)))"; done
        done
    done >ball.raw
}

why_names_the_decision() {
    expect 0 run scene:stranded-point -q -o mesh.ply
    expect 0 why scene:stranded-point --point 32
    says out "Point 32 is not in the mesh, and would be with this decision inverted: "
    grep -q '^> ' out || fail "no line is marked: $(cat out)"
    grep -q '98.strand.1 ' out || fail "its end is not reported"
    # It is proved: the run with the inverted decision has the point.
    inverse=$(sed -n 's/^Inverted: --what-if "\(.*\)"$/\1/p' out)
    expect 0 run scene:stranded-point -q --what-if "$inverse" -o inverted.ply
    expect 0 why scene:stranded-point --what-if "$inverse" --point 32 -q
    says out "Point 32 is in the mesh"
    expect 0 why scene:stranded-point --point 32 --json
    says out '"present": false'
    says out '"cause": "'
    says out '"margin": '
    # A triangle of the mesh, with its edges and corners, is there; the reasons are triangles.
    expect 0 why scene:torus --triangle 1,2,3 --json
    expect 0 why scene:torus --edge 0,1 -q
    empty err
    expect 0 why scene:torus --rules robust --point 0
    says out "Point 0 is in the mesh. Triangle "
    says out " Not proved: "
    # Every address can be gone to: it is one of the trace.
    expect 0 run scene:stranded-point --trace trace.txt -q
    "$program" why scene:stranded-point --point 32 -q | sed -n '3,$s/^[> ] \([0-9]*[.][a-z]*[.][0-9]*\) .*/\1/p' >addresses
    [ -s addresses ] || fail "no addresses"
    cut -f1 trace.txt >known
    while read -r address; do
        grep -qxF "$address" known || fail "$address is not in the trace"
    done <addresses
}

why_finds_decisions() {
    expect 0 why scene:torus --closest 3
    is "$(grep -c 'flips it$' out)" 3 "closest calls"
    expect 0 why scene:torus --closest 2 --json
    says out '"nudge": {'
    expect 0 why scene:torus --find "stage=split" --most 1
    says out "the first 1 of them:"
    expect 0 why scene:torus --find "stage=sphere kept" --json
    [ "$(number total out)" -gt 100 ] || fail "too few: $(head -3 out)"
    expect 0 why scene:four-edge-hole --failure intersecting_triangles
    says out "decided          54.sphere.1 "
    says out "would not be with this decision inverted: "
    says out 'Inverted: --what-if "54.sphere drop 63"'
    expect 0 why scene:four-edge-hole --failure lost_points --json
    says out '"first_touched": {'
    expect 1 why scene:torus --failure duplicate_triangles
    says err "the run has 0 failures of class duplicate_triangles"
}

why_proves_the_causes_of_failures() {
    expect 0 why scene:stranded-point --failure lost_points:2 --json
    says out '"proved_by": "inversion"'
    # A what-if of the answer is one that runs take.
    sed -n 's/^ *"\([0-9].* [a-z]* [0-9]*\)",\{0,1\}$/\1/p' out | head -1 >turn
    expect 0 run scene:stranded-point --what-if "$(cat turn)" -o turned.ply
    expect 0 why scene:noise --failure flipped_triangles --more
    # Of lists that are wrong no rule makes a sound mesh, but others do.
    expect 0 why scene:wrong-lists --rules robust --failure holes
    says out "The option --neighbors 10 prevents it, and leaves a sound mesh."
    says out "Change:   --neighbors 10"
    expect 0 run scene:wrong-lists --rules robust --neighbors 10 --check -o other.ply
    expect 0 why scene:wrong-lists --rules robust --failure holes --json
    says out '"change": "--neighbors 10"'
    expect 2 why scene:torus --failures --more
    says err "--more: needs"
    expect 0 why scene:stranded-point --failures --prove
    says err "--prove is not needed"
}

why_names_what_made_a_ring() {
    expect 0 why scene:torus --ring 5
    says out "Active ring at 5 has "
    grep -q '^> 1.seed.1 ' out || fail "the seed is not the cause"
    "$program" why scene:torus --find "stage=split" --most 1 -q | sed -n 's/^[> ] \([0-9.a-z]*\) .*/\1/p' >split
    expect 0 why scene:torus --ring "$(cat split)#1" --json
    says out "\"cause\": \"$(cat split)\""
    expect 2 why scene:torus --ring dragon
    expect 3 why scene:torus --ring 5#9
    says err "There is no ring #9 at 5"
    expect 3 why scene:torus --ring 99999
    says err "The run has no 99999: it ends with pivot 706."
}

why_draws_charts_whose_bars_are_lists() {
    expect 0 why scene:torus --charts
    says out "Refusals by stage"
    sed -n 's/^  [^ ]* *#* *\([0-9]*\)  \(stage=.*\)$/\1\t\2/p' out >bars
    [ "$(wc -l <bars)" -gt 10 ] || fail "too few bars: $(cat out)"
    while IFS=$'\t' read -r count query; do
        expect 0 why scene:torus --find "$query" --most 0 --json
        is "$(number total out)" "$count" "$query"
    done < <(sed -n '1p;8p;$p' bars)
    expect 0 why scene:torus --charts --json
    says out '"find": "stage=pivot ring='
}

why_checks_its_arguments() {
    expect 2 why scene:torus
    expect 2 why scene:torus --point 1 --edge 1,2
    for bad in x 1,2 -1 "" 99999999999; do expect 2 why scene:torus "--point=$bad"; done
    for bad in 1 1,x 1,2,3 1,; do expect 2 why scene:torus --edge "$bad"; done
    expect 2 why scene:torus --closest 0
    says err "--closest: 0: expected a whole number from 1 on"
    expect 2 why scene:torus --find dragons
    says err '"dragons" is not understood'
    expect 2 why scene:torus --failure dragons
    expect 2 why scene:torus --failure holes:0
    expect 3 why scene:torus --point 100000
    says err "There is no point 100000"
    expect 3 why scene:torus --find "stage=sphere point=100000"
    says err "There is no point 100000: the points are 0 to 999."
    expect 2 why scene:torus --failure hole
    says err "intersecting_triangles"
    expect 3 check scene:torus
    says err "spiraling-edge why scene:torus --failures"
    expect 3 why scene:torus --edge 5,5
    expect 3 why missing.ply --point 1
}

check_says_what_is_wrong_with_a_mesh() {
    expect 0 run scene:sphere --rules robust -q -o good.ply
    expect 0 check good.ply
    says out "triangles, sound"
    expect 0 check good.ply --points scene:sphere -q
    empty out
    expect 0 run scene:four-edge-hole -q -o bad.ply
    expect 1 check bad.ply
    says out "3 intersecting_triangles"
    expect 1 check bad.ply --points scene:four-edge-hole --json
    is "$(number flipped_triangles out)" 2 "flipped triangles"
    says out '"good": false'
    # Any mesh with vertices and faces, and what it may have.
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
    # Without normals a border is no hole.
    expect 0 check one.obj
    says out "1 opening, no fault"
    printf 'NOFF\n5 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n9 9 0 0 0 1\n3 0 1 2\n3 0 2 3\n' >lost.off
    expect 1 check lost.off
    says out "1 isolated_point"
    says out "lost.off: 2 triangles, 1 place: 1 of isolated points"
    expect 0 check lost.off --allow isolated_points
    says out "lost.off: 2 triangles, 1 place: 1 of isolated points, allowed"
    says out "#1 1 isolated point; at (9, 9, 0)"
    printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 2 1 0\n' >twice.off
    expect 1 check twice.off --json
    is "$(number duplicate_triangles out)" 1 "duplicates"
    is "$(number lost_points out)" 1 "points in no triangle"
    expect 2 check one.obj --allow dragons
    expect 3 check missing.obj
    printf '0 0 0\n1 0 0\n' >points.xyz
    expect 3 check points.xyz
    says err "has no triangles"
    expect 3 check one.obj --points scene:sphere
    says err "is no point of scene:sphere"
}

check_prepares_points_as_the_run_did() {
    # A sphere whose noise is as wide as its spacing: the run sets points aside.
    awk 'BEGIN {
        for (i = 0; i < 2000; ++i) {
            z = 1 - (2 * i + 1) / 2000
            x = sqrt(1 - z * z) * cos(2.399963229728653 * i)
            y = sqrt(1 - z * z) * sin(2.399963229728653 * i)
            some = (some * 16807 + 12345) % 2147483647
            r = 1 + 0.2 * (some / 2147483647 - 0.5)
            printf "%.9f %.9f %.9f %.9f %.9f %.9f\n", r * x, r * y, r * z, x, y, z
        }
    }' >noisy.xyz
    expect 0 run noisy.xyz --rules robust -q -o mesh.ply --report report.json
    [ "$(sed -n '/"set_aside"/,/}/p' report.json >aside; number noise aside)" -gt 100 ] || fail "nothing was set aside"
    expect 0 check mesh.ply --points noisy.xyz --json
    is "$(number lost_points out)" 0 "points lost; noise is counted beside them"
    [ "$(number noise_points out)" -gt 100 ] || fail "no noise: $(cat out)"
    "$program" check mesh.ply --points noisy.xyz --rules robust --json >out 2>err
    for class in lost_points second_layers holes small_components; do
        is "$(number $class out)" "$(sed -n '/"faults"/,/}/p' report.json >faults; number $class faults)" $class
    done
    "$program" check mesh.ply --points noisy.xyz --rules robust --keep-noise --json >out 2>err
    is "$(number lost_points out)" 0 "points lost, whatever the run has kept"
    expect 2 check mesh.ply --rules robust
    says err "--points"
    expect 2 check mesh.ply --points noisy.xyz --rules dragons
}

# 600 even points (x, y, z) of a sphere with the normals $1, three expressions of awk.
sphere_with_normals() {
    awk "BEGIN { for (i = 0; i < 600; ++i) {
        z = 1 - (2 * i + 1) / 600; x = sqrt(1 - z * z) * cos(2.399963229728653 * i)
        y = sqrt(1 - z * z) * sin(2.399963229728653 * i); f = z > 0.8 ? -1 : 1
        s = sqrt((4 - x) ^ 2 + (1 - y) ^ 2 + (2 - z) ^ 2)
        printf \"%.9f %.9f %.9f %.9f %.9f %.9f\\n\", x, y, z, $1 } }"
}

a_run_is_called_sound_when_that_was_checked() {
    expect 0 run scene:sphere --rules robust --check
    says err "none: the mesh is sound"
    expect 0 run scene:sphere --rules robust
    ! grep -q sound err || fail "soundness that was not checked is told"
    expect 1 run scene:torus --check
    ! grep -q sound err || fail "a mesh with faults is called sound"
}

check_counts_what_the_run_says() {
    sphere_with_normals "x, y, z" >right.xyz
    sphere_with_normals "f * x, f * y, f * z" >flipped.xyz
    sphere_with_normals "(4 - x) / s, (1 - y) / s, (2 - z) / s" >sight.xyz
    sphere_with_normals "0, 0, 0" >zero.xyz
    sphere_with_normals "-x, -y, -z" >inward.xyz
    local name class
    for name in right flipped sight zero inward; do
        for options in --best "--rules robust"; do
            # shellcheck disable=SC2086 # several words
            "$program" run $name.xyz $options -q -o mesh.ply --report report.json 2>err
            sed -n '/"faults"/,/}/p' report.json >faults
            "$program" check mesh.ply --points $name.xyz --json >out 2>err
            for class in flipped_triangles intersecting_triangles holes second_layers lost_points isolated_points; do
                is "$(number $class out)" "$(number $class faults)" "$name $options $class"
            done
            sed -n '/^  "verdict"/,/^  }/p' out >verdict
            sed -n '/^  "verdict"/,/^  }/p' report.json | cmp - verdict || fail "$name $options: another verdict"
        done
    done
    # Given normals are turned, or others derived, only where they do not fit or contradict each other.
    for name in right inward; do
        expect 0 run $name.xyz --best --rules corrected -q -o mesh.ply --report report.json
        grep -qE '"--(orient|derive-normals)"' report.json && fail "right normals of $name are turned"
    done
    expect 0 run sight.xyz --best -q -o mesh.ply
    expect 0 check mesh.ply --points sight.xyz
    says out "judged by derived normals: the given ones are "
    expect 0 run flipped.xyz --orient -q -o mesh.ply
    expect 0 check mesh.ply --points flipped.xyz
    says out "that point against those around them"
    # By the user's word the inside is turned out; without it the same mesh is inside out.
    expect 0 run inward.xyz --orient --check -q -o mesh.ply
    expect 0 check mesh.ply --points inward.xyz --orient
    expect 1 check mesh.ply --points inward.xyz --json
    is "$(number flipped_triangles out)" 1196 "triangles against the given normals"
}

check_is_not_sound_if_it_ended_early() {
    # 9,000 triangles about one point: all boxes meet, so the search for pairs ends, and none is at fault.
    awk 'BEGIN {
        n = 9000
        printf "OFF\n%d %d 0\n0 0 0\n", n + 1, n
        for (i = 0; i < n; ++i) printf "%.17g %.17g 0.1\n", cos(i * 6.283185307179586 / n), sin(i * 6.283185307179586 / n)
        for (i = 0; i < n; ++i) printf "3 0 %d %d\n", i + 1, (i + 1) % n + 1
    }' >fan.off
    expect 1 check fan.off
    says out "fan.off: 9000 triangles, no fault found, but the search ended early"
    expect 1 check fan.off --json
    says out '"good": false'
    says out '"sound": false'
    expect 0 check fan.off --allow intersecting_triangles --allow second_layers --json
    says out '"good": true'
    says out '"sound": false'
}

compare_finds_the_first_difference() {
    expect 0 compare scene:torus --with --rules paper
    says out "1996 triangles in both, 0 only in A, 0 only in B"
    says out "No difference: 705 pivots alike."
    expect 1 compare scene:torus --with --rule freesector=off
    says out "First difference, after 199 pivots alike:"
    says out "6.1, reciprocal at point 613: A takes point 384, B refuses point 384."
    says out "  A  200.reciprocal.1   taken "
    says out "  B  200.reciprocal.1   refused "
    says out "1 region of difference"
    # B is A except for what is given: other rules, other neighbors; quoted as well as not.
    expect 1 compare scene:torus --rules robust -k 10 --with "--rules corrected -r 0.3" --json
    says out '"title": "--rules robust --neighbors 10"'
    says out '"title": "--rules corrected --radius 0.3"'
    says out '"pivots_alike": '
    says out '"decides": true'
    expect 1 compare scene:torus --rules robust --with --rule flip=off -q
    empty out
    expect 0 compare scene:torus -k 10 --with --rule opensteps=off --json
    says out '"title": "--rule opensteps=off --neighbors 10"'
    says out '"first_difference": null'
}

compare_takes_a_mesh_of_another_program() {
    expect 0 run scene:torus -q -o torus.ply
    expect 0 compare torus.ply --mesh torus.ply
    says out "1996 triangles in both, 0 only in A, 0 only in B"
    # Vertices the other way round, triangles from another corner on, six digits.
    expect 0 run scene:torus -q -o torus.off
    awk 'NR == 2 { n = $1; m = $2 } NR > 2 && NR <= 2 + n { v[NR - 3] = $0 }
         NR > 2 + n && NF > 3 { t[k++] = $3 " " $4 " " $2 }
         END { print "OFF"; print n, m, 0
               for (i = n - 1; i >= 0; --i) { split(v[i], x, " "); printf "%.7g %.7g %.7g\n", x[1], x[2], x[3] }
               for (i = m - 1; i >= 0; --i) { split(t[i], c, " "); print 3, n - 1 - c[1], n - 1 - c[2], n - 1 - c[3] } }' \
        torus.off >other.off
    expect 0 compare torus.ply --mesh other.off
    says out "1996 triangles in both, 0 only in A, 0 only in B"
    # Another triangle in place of one, one vertex that is no point.
    sed '$s/.*/3 5 6 7/' other.off | awk 'NR == 3 { $1 += 5 } { print }' >moved.off
    expect 1 compare torus.ply --mesh moved.off
    says out "1 vertex of B on no point of torus.ply, the first 0"
    says out "explains why the run lacks this triangle of B."
    expect 1 compare torus.ply --mesh moved.off --json
    says out '"unmatched_vertices": ['
    number only_a out >count
    [ "$(cat count)" -ge 2 ] || fail "only_a: $(cat count)"
}

compare_keeps_a_word_with_blanks() {
    expect 1 compare scene:figure-8 --with --what-if "9.sphere.2 keep 46"
    says out "9.sphere keep 46"
    # One word alone holds all options of B.
    expect 1 compare scene:torus -k 10 --with "--rules corrected --reach 2.2" -q
}

compare_checks_its_arguments() {
    expect 2 compare scene:torus
    says err "--with"
    expect 2 compare scene:torus --mesh torus.ply --with --rules robust
    expect 2 compare scene:torus --with --rules dragons
    expect 2 compare scene:torus --with --goto 1
    local nothing
    for nothing in "--with" "--json --with --most 3" "--with -q"; do
        expect 2 compare scene:torus $nothing
        says err "--with: nothing follows it"
    done
    expect 2 compare scene:torus --with " "
    says err "--with: nothing follows it"
    expect 3 compare scene:torus --mesh absent.ply
    icosahedron >points.xyz
    expect 3 compare points.xyz --mesh points.xyz
    says err "has no triangles to compare with"
    expect 0 compare --help
    says out "--with"
}

reduce_keeps_what_fails() {
    expect 0 reduce scene:four-edge-hole --failure non_manifold_edges -o small.ply
    [ "$(header_count vertex small.ply)" -lt 30 ] || fail "not small: $(cat err)"
    grep -q "stopped early" err && fail "it did not stop early: $(cat err)"
    expect 0 run small.ply -q -o mesh.ply
    expect 1 check mesh.ply --points small.ply --json
    [ "$(number non_manifold_edges out)" -gt 0 ] || fail "it no longer fails"
    says small.sesession '"source": "small.ply"'
    "$program" why small.ply --failure non_manifold_edges >moments
    says small.sesession "\"address\": \"$(sed -nE 's/^ +created +([^ ]+) .*/\1/p' moments)\""
    SPIRALING_EDGE=$program sh small.sh >out 2>err && fail "the test passes"
    says out "still fails: non_manifold_edges"
    # Without the program the test names what is missing, and does not pass.
    SPIRALING_EDGE=/nowhere/spiraling-edge sh small.sh >out 2>err && fail "it passes without the program"
    says err "SPIRALING_EDGE=PATH"
    # The session prepares the points as the run did, and opens on the failure.
    expect 0 reduce scene:four-edge-hole -k 16 --box auto --failure intersecting_triangles -q -o k16.ply
    says k16.sesession '"neighbors": 16'
    says k16.sesession '"box": "auto"'
    says k16.sesession '"alert": "intersecting_triangles:1"'
    # Any three points end in two triangles back to back: that is no longer the failure.
    expect 0 reduce scene:noise --failure flipped_triangles -q -o flipped.ply
    [ "$(header_count vertex flipped.ply)" -gt 3 ] || fail "three points back to back"
    # With other rules the same test passes.
    expect 0 reduce scene:stranded-point --failure lost_points:2 --rules paper -q -o stranded.ply
    sed -i 's/ -q -o/ --rules robust&/' stranded.sh
    SPIRALING_EDGE=$program sh stranded.sh || fail "robust strands it, too"
    expect 1 reduce scene:sphere --failure flipped_triangles -o none.ply
    absent none.ply
    expect 2 reduce scene:sphere --failure dragons -o none.ply
    expect 2 reduce scene:sphere --failure holes -o none.obj
    expect 2 reduce scene:sphere --failure holes:x -o none.ply
}

reduce_finds_one_point_among_many() {
    # A spiral over the sphere, and one normal that points inwards.
    awk 'BEGIN { n = 20000; turn = 2.399963229728653
                 for (i = 0; i < n; ++i) { z = 1 - (2 * i + 1) / n; r = sqrt(1 - z * z)
                     x = r * cos(i * turn); y = r * sin(i * turn); s = i == 7777 ? -1 : 1
                     printf "%.9f %.9f %.9f %.9f %.9f %.9f\n", x, y, z, s * x, s * y, s * z } }' >planted.xyz
    expect 0 reduce planted.xyz --rules paper --failure lost_points -q -o few.ply
    [ "$(header_count vertex few.ply)" -lt 30 ] || fail "$(header_count vertex few.ply) points are left"
    SPIRALING_EDGE=$program sh few.sh >out 2>err && fail "the test passes"
    says out "still fails: lost_points"
}

tangled_runs_end_soon() {
    # The failures of such runs have millions of crossings; following all of them takes hours.
    local lists
    ulimit -v 1000000  # kB, most of it code and stacks that are not touched
    expect 0 sample torus -n 400 -q -o t.ply
    for lists in "--neighbors 100" "--radius 5" "--radius 1e300"; do
        # shellcheck disable=SC2086
        expect 0 why t.ply $lists --failures
        says out "first "
        says out " triangle_cap"
        cp out first
        # shellcheck disable=SC2086
        expect 0 why t.ply $lists --failures
        cmp -s out first || fail "$lists: not the same bytes"
        # shellcheck disable=SC2086
        expect 0 why t.ply $lists --failures --json
        says out '"complete": false'
        # shellcheck disable=SC2086
        expect 1 run t.ply $lists -q -o mesh.ply
        expect 1 check mesh.ply
        says out "first 10000 of "
        expect 1 check mesh.ply --json
        says out '"complete": false'
    done
    # More crossings than are looked for.
    expect 0 sample torus -n 1000 -q -o t.ply
    expect 1 run t.ply --radius 1e300 --check --report report.json -q -o mesh.ply
    says report.json '"exact": false'
    expect 1 check mesh.ply
    says out " or more: "
    says out "first 10000 of at least "
    expect 1 check mesh.ply --json
    says out '"intersecting_triangles": 10000'
    grep -A1 '"at_least"' out | grep -q intersecting_triangles || fail "not at least: $(head -c 2000 out)"
    # A usual run is followed to its end, and reports no limit.
    expect 0 why scene:four-edge-hole --failures --json
    grep -qE '"complete"|"at_least"' out && fail "it is complete"
}

reduce_stops_after_its_effort() {
    expect 0 sample torus -n 400 -q -o t.ply
    expect 0 reduce t.ply --neighbors 60 --failure holes --effort 40 -o some.ply
    says err "stopped early, after 40 million tests"
    says err "--effort 400"
    [ "$(header_count vertex some.ply)" -le 400 ] || fail "more points than before"
    SPIRALING_EDGE=$program sh some.sh >out 2>err && fail "it no longer fails"
    says out "still fails: holes"
    expect 2 reduce scene:four-edge-hole --failure non_manifold_edges -o small.ply --effort 0
}

reduce_quotes_names() {
    local name
    mkdir work
    cd work || exit 1
    for name in 'a b' "it's"' q"q $(touch pwned)`touch pwned`; touch pwned' \
        $'line\ntouch pwned\ttab and\rreturn' '-rf' 'scene:torus' 'back\slash'; do
        rm -rf ./* ../from
        "$program" run scene:four-edge-hole -q -o in.ply
        mkdir -- "../from"
        mv in.ply "../from/$name.ply"
        "$program" reduce "../from/$name.ply" --failure non_manifold_edges -q -o "./$name.ply" \
            >../out 2>../err || { fail "$name: $(cat ../err)"; continue; }
        # The first lines are comments; nothing but the check happens.
        [ "$(head -4 "./$name.sh" | LC_ALL=C grep -c '^#')" = 3 ] || fail "$name: $(cat "./$name.sh")"
        sed -n '2,3p' "./$name.sh" | LC_ALL=C grep -q '[[:cntrl:]]' && fail "$name: control characters"
        for way in "./$name.sh" "$PWD/$name.sh"; do
            SPIRALING_EDGE=$program sh "$way" >../out 2>../err
            is $? 1 "$name"
            is "$(cat ../out)" "still fails: non_manifold_edges" "$name"
            empty ../err
        done
        is "$(find . -type f -printf x | wc -c)" 3 "$name: files"
        [ -e pwned ] && fail "$name was run"
        python3 - "./$name.sesession" "$name.ply" <<'END' || fail "$name: $(cat "./$name.sesession")"
import json, os, sys
source = json.load(open(sys.argv[1]))["input"]["source"]
sys.exit(os.path.normpath(source) != sys.argv[2] or source.startswith("scene:"))
END
    done
    cd ..
}

compare_reads_standard_input() {
    expect 0 run scene:torus -q -o torus.ply
    local code=0
    "$program" compare - --with --rules robust <torus.ply >out 2>err || code=$?
    is "$code" 1 "compare - ($(cat err))"
    says out "triangles in both"
    code=0
    "$program" compare - --with --rules paper <torus.ply >out 2>err || code=$?
    is "$code" 0 "compare - with the same ($(cat err))"
    expect 3 compare - --with --rules robust
    says err "standard input: is empty"
    code=0
    echo "0 0 x" | "$program" compare - --with --rules robust >out 2>err || code=$?
    is "$code" 3 "a malformed input"
    says err "standard input"
    expect 2 compare - --mesh -
    expect 2 check - --points -
}

sample_has_a_most() {
    expect 2 sample torus -n 100000000 -o many.ply
    says err "10000000"
    expect 3 sample torus --spacing 1e-6 -o many.ply
    says err "10000000"
    absent many.ply
}

sample_lists_shapes() {
    expect 0 sample --list
    for shape in sphere torus two-tori genus-2 gyroid plane monkey-saddle hyperboloid-one-sheet \
        hyperboloid-two-sheets hydrogen blast-wave metaballs; do
        says out "$shape "
    done
    local lines
    lines=$(wc -l <out)
    expect 0 sample --list --json
    is "$(grep -c '"id"' out)" "$lines" "shapes in JSON"
}

sample_writes_points() {
    expect 0 sample plane -n 400 -o plane.ply
    says err "400 points"
    says err "4 corners"
    expect 0 run plane.ply --rules robust --report report.json
    is "$(number points report.json)" 400 points
    is "$(number points_in_no_triangle report.json)" 0 "unused points"
    is "$(number boundary_loops report.json)" 1 "loops"
    # Deterministic; another seed, other points.
    expect 0 sample plane -n 400 -o again.ply -q
    empty err
    cmp plane.ply again.ply || fail "same input, other bytes"
    expect 0 sample plane -n 400 --seed 2 -o other.ply
    cmp -s plane.ply other.ply && fail "--seed changes nothing"
    "$program" sample plane -n 400 -o - -q 2>err | cmp - plane.ply || fail "standard output differs"
    # By spacing, denser where it bends, in another box, with lists.
    expect 0 sample torus --spacing 0.2 --curvature 1 -k 8 -o torus.ply
    grep -qa '^element se_neighbors' torus.ply || fail "no lists"
    expect 0 sample sphere -n 300 --box=0,-2,-2,2,2,2 -o half.ply
    expect 0 run half.ply --rules robust --report report.json
    is "$(number boundary_loops report.json)" 1 "loops of half a sphere"
    expect 0 sample sphere -n 100 -o points.obj
    is "$(grep -c '^v ' points.obj)" 100 "points in OBJ"
}

sample_reads_volumes() {
    ball 'isovalue:=1'
    expect 0 sample ball.nhdr -n 200 -o ball.ply
    expect 0 run ball.ply --rules robust --report report.json
    is "$(number euler_characteristic report.json)" 2 "Euler number of a ball"
    expect 0 sample ball.nhdr --iso 2.5 -n 100 -o small.ply
    expect 2 sample ball.nhdr -n 100 --box -3,-2,-2,2,2,2 -o out.ply
    says err "ends at -2,-2,-2 and 2,2,2"
    ball
    expect 2 sample ball.nhdr -n 100 -o out.ply
    says err "from -8 to 4"
    truncate -s 100 ball.raw
    expect 3 sample ball.nhdr -n 100 --iso 1 -o out.ply
    says err "ball.raw: expected 125 bytes"
    sed -i 's/sizes: 5 5 5/sizes: 5 5/' ball.nhdr
    expect 3 sample ball.nhdr -n 100 --iso 1 -o out.ply
    says err "ball.nhdr: line 4: sizes"
    absent out.ply
}

sample_checks_its_arguments() {
    expect 2 sample
    expect 2 sample sphere -o out.ply
    says err "give the number of points"
    expect 2 sample sphere -n 0 -o out.ply
    expect 2 sample sphere -n 10 --spacing 0.1 -o out.ply
    expect 2 sample sphere -n 10
    expect 2 sample sphere -n 10 -o out.stl
    expect 2 sample sphere -n 10 -o none/out.ply
    expect 2 sample sphere -n 10 --box 1,2,3 -o out.ply
    expect 3 sample cube -n 10 -o out.ply
    says err "--list"
    expect 3 sample none.nrrd -n 10 -o out.ply
    expect 3 sample sphere --iso 100 -n 10 -o out.ply
    says err "no surface"
    absent out.ply
}

paper_table_is_reproduced() {
    # Stand-ins are small enough here only because their number is that of the paper: one run.
    expect 0 table1 --rules robust --json --save .
    is "$(grep -c '"set"' out)" 5 sets
    is "$(grep -c '"stand_in": true' out)" 2 "stand-ins"
    for points in 42906 3755 1393 1516 215; do says out "\"points\": $points,"; done
    is "$(grep -c '"points_in_no_triangle": 0,' out)" 5 "sets with every point in use"
    is "$(grep -c '"non_manifold_edges": 0,' out)" 5 "sets without non-manifold edges"
    is "$(header_count vertex hyperboloid.ply)" 215 "saved points"
    expect 2 table1 --volumes none
    says err "no such folder"
}

scenes_are_listed() {
    expect 0 scenes
    grep -qvE '^scene:[a-z0-9-]+  +[A-Z]' out && fail "odd lines: $(cat out)"
    [ "$(wc -l <out)" -ge 3 ] || fail "fewer than three scenes"
    local lines
    lines=$(wc -l <out)
    expect 0 scenes --json
    is "$(grep -c '"id"' out)" "$lines" "scenes in JSON"
}

figures_hold() {
    expect 0 figures 8
    says out "Figure 8: the circumsphere"
    says out "open     scene:figure-8 --goto 9.sphere.2"
    says out "points   p = 15, first = 20, t = 9, q = 46, s = 31, r = 35, last = 39"
    says out "without  --rule sphere=off:"
    expect 0 figures --check
    is "$(grep -c '^Figure ' out)" 25 "figures"
    grep -q FAILS out && fail "a figure does not hold"
    is "$(grep -c '^  skipped ' out)" 2 "figures that need a volume"
    says out "holds    9.emit.2 p t s: made"
    says out "holds    1516 points, 3024 triangles"
    expect 2 figures 26
    expect 2 figures --check --volumes nowhere
    says err "no such folder"
}

traces_are_compared() {
    expect 0 run scene:figure-8 -q --trace mine.setrace --rule limits=off
    is "$(wc -l <mine.setrace)" 84 "a header and 83 pivots"
    is "$(sed -n 9p mine.setrace)" '{"p":11,"first":1,"last":3,"fan":[1,18,20,3]}' "pivot 8"
    expect 1 diff mine.setrace scene:figure-8
    says out "after 7 pivots alike, pivot 8 (point 11 between 1 and 3): the fans differ"
    says out "  yours has no 17: ours moved start to it, 8.limits.1 (6.1)"
    says out "your whole trace, 83 pivots, behaves like --rule limits=off"
    expect 1 diff mine.setrace scene:figure-8 --json
    says out '"rules": ['
    is "$(number alike out)" 7 "pivots alike"
    expect 1 diff mine.setrace scene:figure-8 -q
    empty out
    expect 0 diff mine.setrace scene:figure-8 --rule limits=off
    says out "all 83 pivots alike"
    head -5 mine.setrace >part.setrace
    expect 1 diff part.setrace scene:figure-8 --rule limits=off
    expect 1 diff part.setrace scene:figure-8 --rule limits=off --upto emit
    says out "alike as far as yours goes, 4 pivots; ours goes on to 83 pivots"
    sed '5s/}$/,"ends":true}/' part.setrace >meant.setrace
    expect 0 diff meant.setrace scene:figure-8 --rule limits=off
    head -1 mine.setrace >none.setrace
    expect 1 diff none.setrace scene:figure-8 --upto emit
    says out "yours has no pivots, ours has 76"
    expect 0 run scene:figure-8 -q --trace stages.setrace --trace-stages
    "$program" diff - scene:figure-8 --upto ring <stages.setrace | grep -q "all 76 pivots" ||
        fail "a trace from standard input"
    expect 0 run scene:sphere -q --rules robust --trace robust.setrace
    expect 0 diff robust.setrace scene:sphere --rules robust
    expect 2 run scene:figure-8 --trace-stages
    expect 2 run scene:figure-8 --trace x.txt --trace-stages
    expect 2 diff stages.setrace scene:figure-8 --upto guard
    expect 2 diff - -
    expect 2 diff stages.setrace
}

bad_traces_are_malformed_input() {
    expect 0 run scene:figure-8 -q --trace good.setrace
    expect 3 diff missing.setrace scene:figure-8
    says err "missing.setrace"
    expect 3 diff good.setrace scene:torus
    says err 'good.setrace: line 1: points: the input has 1000 points, the trace is of 50'
    expect 3 diff good.setrace scene:figure-10 --upto sort
    says err 'good.setrace: line 2: sort: '
    head -c 3000 good.setrace >cut.setrace
    expect 3 diff cut.setrace scene:figure-8
    says err "the last line may be cut off"
    empty out
}

conformance_is_written() {
    local trace input start
    expect 0 figures --conformance made
    is "$(ls made/*.ply | wc -l) $(ls made/*.setrace | wc -l)" "34 34" "inputs and traces"
    for trace in made/*.setrace; do
        input=${trace%.setrace}
        start=()
        [ ! -f "$input.start.json" ] || start=(--start "$input.start.json")
        expect 0 diff "$trace" "$input.ply" --upto ring ${start[@]+"${start[@]}"}
    done
    expect 0 run made/opposing-normals.ply -q --rule opposing=off --trace opposing.setrace -o x.ply
    expect 1 diff opposing.setrace made/opposing-normals.ply
    says out "behaves like --rule opposing=off"
    expect 2 figures --conformance missing/folder
    says err "cannot be made"
    expect 2 figures 8 --conformance made
}

other_programs_write_traces() {
    local share=$here/../../app/teach/share
    expect 0 run scene:figure-4 -q --with-lists -o points.ply --trace ours.setrace
    cat >copy.c <<'C'
#include "setrace.h"
int main(void) {
    const double xyz[6] = {0.5, -1.0, 2.0, 1e-300, 0.1, -0.0};
    const uint32_t fan[3] = {1, 0, 2};
    setrace trace;
    setrace_begin(&trace, stdout, 2, xyz);
    setrace_pivot(&trace, 3, 1, 2);
    setrace_list(&trace, "fan", fan, 3);
    setrace_point(&trace, "start", 1);
    setrace_next(&trace, 2);
    setrace_pivot(&trace, 2, 1, 1);
    setrace_list(&trace, "fan", fan, 0);
    setrace_next(&trace, SETRACE_NONE);
    return setrace_end(&trace);
}
C
    cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -I "$share" copy.c -o copy || fail "setrace.h as C99"
    c++ -std=c++11 -Wall -Wextra -Werror -x c++ -I "$share" -fsyntax-only copy.c || fail "setrace.h as C++"
    ./copy >c.setrace
    is "$(tail -2 c.setrace | paste -sd ' ')" \
        '{"p":3,"first":1,"last":2,"fan":[1,0,2],"start":1,"next":2} {"p":2,"first":1,"last":1,"fan":[],"next":null}' \
        "lines of C"
    command -v python3 >/dev/null || return 0
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$share python3 - <<'PYTHON' || fail "setrace.py"
import setrace
header, _ = setrace.read("c.setrace")
assert header["hash"] == setrace.points_hash([(0.5, -1.0, 2.0), (1e-300, 0.1, -0.0)]), header
points = setrace.read_points("points.ply")
assert points.lists[0] == sorted(points.lists[0], key=lambda q: sum((a - b) ** 2 for a, b in zip(points.position[0], points.position[q]))), points.lists[0]
with setrace.Writer("python.setrace", points.position) as trace:
    for pivot in setrace.read("ours.setrace")[1]:
        trace.pivot(**pivot)
PYTHON
    cmp ours.setrace python.setrace || fail "setrace.py writes other bytes"
}

lessons_are_listed_and_shown() {
    expect 0 lesson list
    says out "tour               1.5 min"
    says out "class               20 min   5 questions  Twenty minutes in class"
    is "$(wc -l <out)" 9 "lessons"
    expect 0 lesson list --json
    is "$(grep -c '"minutes"' out)" 9 "lessons in JSON"
    expect 0 lesson show removal
    says out "2. Which of them go? (2 minutes)"
    says out "     A  q"
    grep -q "Answer:" out && fail "answers are shown"
    expect 0 lesson show removal --answers
    says out "Answer: q"
    says out "removing it leaves a gap of 53.4 deg: removed."
    expect 0 lesson show spiral
    says out "   scene:figure-2 --goto 1.advance.1 --with '--rule sphere=off'"
    expect 0 lesson show class
    says out "   lesson:class --step "
    mkdir folder
    printf '%s\n' '# T' '```se lesson' 'version = 1' 'input = "p.ply"' 'rules = "robust"' \
        'rule = ["sphere=off"]' 'options = { neighbors = 9 }' '```' '## One' '```se step' 'at = "1.emit.1"' \
        'what_if = ["1.sphere drop 559"]' '```' >folder/a.lesson.md
    expect 0 lesson show folder/a.lesson.md
    says out "   folder/p.ply --rules robust --rule sphere=off --what-if '1.sphere drop 559' --neighbors 9 --goto 1.emit.1"
    expect 3 lesson show nothing
    says err "no such lesson or file"
    expect 2 lesson show
    expect 2 lesson tell tour
    says err "expected list, show, check, new or results"
}

lessons_are_checked() {
    local each
    expect 0 lesson check tour spiral neighbor-ring removal split-join start-order-cost why-a-hole one-pivot class \
        "$here/../../docs/story.lesson.md"
    is "$(grep -c ': good: ' out)" 10 "good lessons, with that of the pictures"
    expect 0 lesson new scene:figure-8 -o good.lesson.md
    sed 's/^expect = "seed"/expect = "joins"/' good.lesson.md >wrong.lesson.md
    expect 1 lesson check good.lesson.md wrong.lesson.md
    says out 'expect: the outcome there is "seed"'
    sed 's/^at = "1.seed.1"/att = "1.seed.1"/' good.lesson.md >bad.lesson.md
    expect 3 lesson check bad.lesson.md wrong.lesson.md
    grep -qE '^bad.lesson.md:[0-9]+: att: no such key; the nearest is at$' out || fail "$(cat out)"
    expect 3 lesson check bad.lesson.md --json
    says out '"sort": "malformed"'
    expect 3 lesson check nowhere.lesson.md
    expect 2 lesson check
}

lessons_begin_with_an_input() {
    mkdir folder
    expect 0 run scene:torus -q -o folder/points.ply
    expect 0 lesson new folder/points.ply -o folder/new.lesson.md
    grep -q '^input = "points.ply"$' folder/new.lesson.md || fail "input: $(grep input folder/new.lesson.md)"
    expect 0 lesson check folder/new.lesson.md
    says out "new.lesson.md: good:"
    gzip folder/points.ply
    expect 0 lesson new folder/points.ply.gz -o folder/packed.lesson.md
    grep -q '^input = "points.ply.gz"$' folder/packed.lesson.md || fail "input: $(grep input folder/packed.lesson.md)"
    expect 0 lesson check folder/packed.lesson.md
    expect 3 lesson check folder/packed.lesson.md --most-bytes 1000
    says out "holds more than 1000 bytes"
    gunzip folder/points.ply.gz
    expect 0 lesson new scene:torus
    says out "# A lesson on scene:torus"
    expect 2 lesson new folder/points.ply -o new.d/new.lesson.md
    expect 2 lesson new folder/points.ply -o folder/points.ply
    mkdir other
    expect 2 lesson new folder/points.ply -o other/new.lesson.md
    says err "a lesson lies beside its inputs"
    expect 3 lesson new folder/missing.ply -o folder/x.lesson.md
    absent folder/x.lesson.md
    expect 2 lesson new -
}

# Writes the result of one person with one answer: FILE GIVEN WRONG RIGHT [MORE].
lesson_result() {
    printf '{"format": "spiraling-edge lesson result", "version": 1, "lesson": "L", "hash": "h", "answers": [
        {"step": 2, "title": "Q", "kind": "points", "given": [%s], "wrong": [%s], "right": %s, "score": 0.5,
         "seconds": 10, "tries": 1%s}]}' "$2" "$3" "$4" "${5-}" >"$1"
}

pivots_are_played() {
    local seed
    expect 0 practice --seed 10
    says out "fan first 4 7 last"
    says out "Pivot p = 17 between first = 28 and last = 25"
    says out " 10   0.000  1.000  UNUSED"
    says out "--seed 10 --answer FILE"
    expect 0 practice --seed 10 --json
    says out '"p":17,"first":28,"last":25,"neighbors":[25,28,20,'
    expect 0 practice --seed 10 --solution
    says out "remove 6                  # 33.sphere.1 (6.3)"
    cp out right.txt
    expect 0 practice --seed 10 --answer right.txt
    says out "right: all 5 moves"
    sed 's/remove 6/keep 6/' right.txt >wrong.txt
    expect 1 practice --seed 10 --answer wrong.txt
    says out "move 2, keep 6: wrong"
    says out "(33.sphere.1, 6.3)"
    says right.txt "fan first 10 14 last"
    head -3 right.txt >part.txt
    expect 1 practice --seed 10 --answer part.txt
    says out "move 4, missing"
    expect 1 practice --seed 10 --answer wrong.txt --json
    says out '"section": "6.3"'
    "$program" practice --seed 10 --answer - <right.txt | grep -q right || fail "standard input"
    echo "keep 99" >range.txt
    expect 3 practice --seed 10 --answer range.txt
    says err "range.txt: line 1: 99: there are 35 points, from 0"
    expect 3 practice --answer missing.txt
    for seed in x -1 99999999999999999999999; do
        expect 2 practice --seed $seed
        says err "--seed: $seed: expected a whole number from 0 on"
    done
    expect 2 practice --result a.result.json
    expect 2 practice --answer right.txt --result right.txt
    expect 0 practice --seed 10 --answer right.txt --result 1.result.json
    expect 1 practice --seed 10 --answer wrong.txt --result 2.result.json
    expect 0 lesson results [0-9]*.result.json -o class.csv
    says out "  1     2        50 %   6.3 sphere (1)    -               -                 Play a pivot"
    says class.csv "Practice,practice 1,1,Play a pivot,play,2,1,0.5,"
    grep -q tries 1.result.json && fail "tries are counted by a program that does not know of them"
}

# lab_with_solution: a copy of the lab with its data and the solution, in the present folder.
lab_with_solution() {
    local root=$here/../..
    cp -r "$root/docs/lab" lab && cp "$root/app/teach/share/setrace.py" lab && cd lab || exit 1
    mkdir bin && ln -s "$program" bin/spiraling-edge
    export PATH=$PWD/bin:$PATH PYTHONDONTWRITEBYTECODE=1
    ./lab.py data --seed 4711 >out || fail "data: $(cat out)"
    says out "35 inputs with traces are in data/"
    cp -r stages stubs
    cp "$root"/tests/lab/reference/*.py stages
}

lab_is_solved() {
    command -v python3 >/dev/null || return 0
    lab_with_solution
    ./lab.py hand-in >out || fail "the solution is wrong"
    is "$(grep -c ': right at 1243 pivots' out)" 6 "stages that are right"
    is "$(grep -c '"right": true' hand-in.json)" 6 "stages handed in"
    says hand-in.json '"seed": 4711'
    ./lab.py run data/mine.ply >out || fail "run"
    says out "pivot 30 meets a point of the ring again"
    expect 0 diff mine.setrace data/mine.ply
    says out "all 30 pivots alike"
    cp data/mine.ply first.ply
    ./lab.py data --seed 4712 >out || fail "data of another student"
    ! cmp -s data/mine.ply first.ply || fail "two students have the same points"
    ./lab.py check >out || fail "the solution is wrong on other points: $(cat out)"
    ./lab.py check sorted 2>err
    is $? 2 "exit code for an unknown stage"
}

lab_names_the_wrong_stage() {
    command -v python3 >/dev/null || return 0
    local stage wrong
    lab_with_solution
    while read -r stage wrong; do
        cp "stubs/$stage.py" stages
        ./lab.py check "$stage" >out && fail "$stage: a stub passes"
        is "$(cat out)" "$stage: not written yet" "what is said of a stub"
        sed "$wrong" "$here/../lab/reference/$stage.py" >"stages/$stage.py"
        ! cmp -s "stages/$stage.py" "$here/../lab/reference/$stage.py" || fail "$stage: no variant"
        ./lab.py check "$stage" >out && fail "$stage: a wrong variant passes"
        grep -q "^$stage: wrong at " out || fail "$stage: another fault: $(cat out)"
        grep -q "see: spiraling-edge-viewer [a-z].* --goto [0-9]*\.[a-z]" out || fail "no address"
        cp "$here/../lab/reference/$stage.py" stages
    done <<'VARIANTS'
sort s/ < end - SAME_ANGLE:/:/
limits s/dot(cross(a, b), at.normal\[s\]) > 0.0/True/
reciprocal s/at.position\[before\], at.position\[x\]/at.position[after], at.position[x]/
hole s/\* side(at.p) > 0.0/* side(at.p) < 0.0/
limits s/return (angle - low if side < 0 else high - angle) </return side < 0 or high - angle </
limits s/((x, s) if side < 0 else (s, x)) in at.open or //
reciprocal s/FULL_TURN if before == after else //
hole s/(b, a) in at.open or //
hole s/add(add(at.normal\[at.p\], at.normal\[a\]), at.normal\[b\])/at.normal[at.p]/
hole s/at.position\[b\], at.position\[a\]/at.position[at.last], at.position[at.first]/
sphere s/return True/return False/
sphere s/ or gap > 120.0//
emit s/at.ring\[end:start + 1\] + candidates/candidates + at.ring[end:start + 1]/
VARIANTS
    cp stubs/hole.py stages
    ./lab.py check >out && fail "a stub passes among other stages"
    is "$(cut -d: -f1 out | xargs)" "sort limits reciprocal hole" "stages up to the first that is wrong"
}

lab_says_where_a_run_stops() {
    command -v python3 >/dev/null || return 0
    local reference=$here/../lab/reference
    lab_with_solution
    sed 's/s, x = at.ring\[limit\]/s, x = at.ring[limit + 500]/' "$reference/limits.py" >stages/limits.py
    ./lab.py run data/mine.ply >out && fail "run after an exception"
    says out "pivot 2 (point 1 between 4 and 10): stages/limits.py, line 12: IndexError: list index"
    expect 1 diff mine.setrace data/mine.ply --upto ring
    says out "alike as far as yours goes, 1 pivot and pivot 2 up to sort; ours goes on to 96 pivots"
    sed 's/    start, end = .*/    return at.ring/' "$reference/limits.py" >stages/limits.py
    ./lab.py check limits >out && fail "a result of another kind passes"
    says out "expected (start, end, candidates)"
    sed 's/return kept$/pass/' "$reference/sort.py" >stages/sort.py
    ./lab.py check sort >out && fail "no result passes"
    says out "stages/sort.py: sort returns nothing"
    sed 's/while moves(at, start, end, -1)/while True/; s/start -= 1/pass/' "$reference/limits.py" \
        >stages/limits.py
    ./lab.py check limits >out && fail "a loop without an end passes"
    says out "TimeoutError: no end after 5 seconds"
    cp "$reference"/*.py stages
    sed 's/ + candidates$/[:-1] + candidates/' "$reference/emit.py" >stages/emit.py
    ./lab.py check emit >out && fail "a ring without start passes"
    grep -q "yours: fan \[.*\], ring \[" out || fail "no labels: $(cat out)"
    ./lab.py run data/mine.ply >out
    expect 1 diff mine.setrace data/mine.ply
    says out "the edge rings differ"
}

results_are_summed_up() {
    lesson_result a.result.json '"q"' '' true ', "first": {"given": ["s"], "mistakes": ["s", "without q"]}'
    lesson_result b.result.json '"t"' '"t"' false
    expect 0 lesson results a.result.json b.result.json -o class.csv
    says out "  2     2        50 %   t (1)             0 %             s (1)             Q"
    says class.csv "L,h,2,Q,points,2,1,0.5,0.5,10,t,1,0,s,1,,,,"
    expect 0 lesson results a.result.json -o -
    says out "lesson,hash,step,question"
    lesson_result c.result.json '"q"' '' maybe
    rm class.csv
    expect 3 lesson results a.result.json c.result.json -o class.csv
    absent class.csv
    expect 3 lesson results missing.result.json
    expect 2 lesson results
}

starts_are_given_as_json() {
    expect 0 run scene:figure-3 -q --with-lists --trace scene.txt -o points.ply
    echo '{"triangles": [[0, 2, 5], [0, 5, 6], [0, 6, 1]], "rings": [[0, 2, 5, 6, 1]]}' >start.json
    expect 0 run points.ply --start start.json -q --trace file.txt --report report.json
    cmp -s scene.txt file.txt || fail "the start of the file is another one"
    says report.json '"rings": 1'
    grep -q 'beyond\|not before last' file.txt || fail "t is no longer beyond last"
    expect 0 compare points.ply --start start.json --with --rule limits=off
    expect 1 compare points.ply --start start.json --with --rule maxangle=off
    expect 0 why points.ply --start start.json --point 4
    says out "(1.sphere.1)"
    expect 0 run scene:figure-3 --report report.json
    says report.json '"triangles": 3'
    expect 0 run scene:torus --report report.json
    says report.json '"start": null'
}

# As a user does who copies a line that the program printed.
printed_commands_run_in_a_shell() {
    local name command
    sphere_points good.xyz
    awk '{ print $1, $2, $3 }' good.xyz >bare
    mkdir bin
    ln -s "$program" bin/spiraling-edge
    PATH=$PWD/bin:$PATH
    for name in 'a b.xyz' '-n x;touch H;.xyz' "it's"' "q" $(touch H)`touch H`.xyz' '*&!!.xyz' \
        $'a\nb\e[31m.xyz' $'\xff.xyz' $'\u202e.xyz'; do
        cp bare "./$name"
        expect 1 doctor -- "$name"
        command=$(sed -n 's/^ *try: //p' out | head -1)
        sh -c "$command" >ran 2>&1 || fail "$command: $(cat ran)"
        expect 0 doctor OUT.ply
        rm OUT.ply
        expect 1 doctor --json -- "$name"
        if command -v python3 >/dev/null; then
            command=$(python3 -c 'import json; print(json.load(open("out"))["findings"][0]["remedy"])')
            sh -c "$command" >ran 2>&1 || fail "$command: $(cat ran)"
            rm OUT.ply
        fi
        expect 3 check -- "$name"
        command=$(sed -n 's/.*check reads meshes: \(.*\) makes one, .*/\1/p' err)
        sh -c "$command" >ran 2>&1 || fail "$command: $(cat ran)"
        rm mesh.ply
        command=$(sed -n 's/.* makes one, \(.*\) explains .*/\1/p' err)
        sh -c "$command" >ran 2>&1 || fail "$command: $(cat ran)"
        expect 1 why --failure lost_points:999 -- "$name"
        command=$(sed -n 's/.*; \(spiraling-edge why .*\) lists those it has$/\1/p' err)
        sh -c "$command" >ran 2>&1 || fail "$command: $(cat ran)"
    done
    absent H
    expect 3 run 'a b.nhdr'
    says err "\`spiraling-edge sample 'a b.nhdr' -n N"
}

# clean FILE: it has no byte that a terminal would obey, nor marks that turn text around.
clean() {
    ! LC_ALL=C grep -qaP '[\x00-\x09\x0b-\x1f\x7f\xff]|\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xa8-\xae]|\xe2\x81[\xa6-\xa9]' "$1" ||
        fail "$2: raw characters in $1: $(head -c 500 "$1" | od -c | head -20)"
}

texts_from_outside_are_shown_not_obeyed() {
    # Escape sequences of 7 and 8 bits, a bell, DEL, a mark that turns text around, no UTF-8.
    local bad=$'\e[31m\a\x7f\xc2\x9b1m\xe2\x80\xae\xe2\x81\xa6' each
    local name=$bad$'\n\t\xff.ply'
    printf 'ply\nformat ascii 1.0\ncomment %s\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float %s\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n' \
        "$bad" "$bad" >"$name"
    printf '%s\n' "x y z $bad" "0 0 0 1" "1 0 0 1" "0 1 0 1" >columns.xyz
    printf '{"%s": 1}' "$bad" >key.json
    printf '{"rings": [["%s"]]}' "\\u001b\\u009b\\u202e" >value.json
    printf '{"setrace":1,"points":50}\n{"p":"%s"}\n' "\\u001b\\u009b\\u202e" >field.setrace
    printf '# %s\n\n```se lesson\nversion = 1\ninput = "scene:figure-8"\n```\n\n## %s\n\n%s\n' "$bad" "$bad" "$bad" >text.lesson.md
    lesson_result text.result.json '"A"' '' true
    sed -i "s/\"L\"/\"\\\\u001b\\\\u009b\\\\u202e\"/" text.result.json
    run_clean() {
        "$program" "$@" >out 2>err </dev/null
        [ $? -le 3 ] || fail "$* ended with an internal error: $(cat err)"
        clean out "$*"
        clean err "$*"
    }
    for each in info doctor run check "run -o x.ply --report -" "reduce --failure holes -o $bad.ply" "why --failures" \
        "why --point 99 --json" "run --start key.json" "lesson check"; do
        # shellcheck disable=SC2086
        run_clean $each -- "$name"
        # shellcheck disable=SC2086
        run_clean $each --json -- "$name"
    done
    for each in "info columns.xyz" "run columns.xyz" "run scene:figure-3 --start key.json" \
        "run scene:figure-3 --start value.json" "diff field.setrace scene:figure-8" "lesson check text.lesson.md" \
        "lesson show text.lesson.md" "lesson show text.lesson.md --answers" "lesson results text.result.json" \
        "lesson results text.result.json -o -" "lesson show $bad" "$bad" "--$bad" "run scene:$bad" "run scene:figure-3 --rule $bad" \
        "run scene:figure-3 --box $bad" "why scene:figure-3 --find $bad" "run scene:figure-3 -o $bad/x.ply" "sample $bad -n 9 -o x.ply"; do
        # shellcheck disable=SC2086
        run_clean $each
    done
    says err "\\x1b[31m\\x07\\x7f"
    # Data keeps its bytes.
    expect 0 sample sphere -n 200 -q -o "$bad.ply"
    expect 0 sample sphere -n 200 -q -o -
    cmp out "$bad.ply" || fail "data on standard output is not that of the file"
    command -v python3 >/dev/null || return 0
    "$program" info --json -- "$name" >out
    python3 - "$bad" <<'PYTHON' || fail "JSON: $(cat out)"
import json, sys
facts = json.load(open("out"))
assert sys.argv[1] in facts["attributes"], facts["attributes"]
assert facts["input"] == sys.argv[1] + "\n\t\ufffd.ply", facts["input"]
PYTHON
}

bad_starts_are_malformed_input() {
    expect 0 run scene:figure-3 -q --with-lists -o points.ply
    local text says
    while IFS='|' read -r text says; do
        echo "$text" >bad.json
        expect 3 run points.ply --start bad.json
        says err "bad.json: $says"
        empty out
    done <<'END'
{"rings": [[0, 2, "x"]]}|rings[0][2]: expected the number of a point, from 0, got "x"
{"rings": [[0, 2, -1]]}|rings[0][2]: expected the number of a point, from 0, got -1
{"rings": 4}|rings: expected a list of rings, got 4
{"ring": []}|"ring": no such entry; expected triangles, rings, done or open
[]|expected an object with triangles and rings, got []
{"rings":|line 2, column 1: expected JSON, found the end
{}|expected triangles, rings or done points, there are none
{"triangles": [[0, 1]]}|triangles[0]: expected a triangle, such as [0, 1, 2], got [0,1]
{"rings": [[0, 2]], "open": [[0]]}|open[0]: expected a step of a ring, such as [0, 1], got [0]
{"done": [99]}|done[0]: there is no point 99; the points are 0 to 7.
{"rings": [[0, 2, 5, 6, 1]]}|rings[0]: the step 0 -> 2 is no edge of a triangle
END
    expect 3 run points.ply --start nowhere.json
    says err "nowhere.json"
    for verb in "run scene:figure-4 --best" "run scene:figure-4 --thin 1" \
        "why scene:figure-4 --point 1 --thin 1" \
        "reduce scene:figure-6 --rule reciprocal=off --failure intersecting_triangles -o x.ply"; do
        expect 2 $verb
        says err "the run begins with given triangles, which name points by numbers"
    done
    expect 2 run points.ply --start bad.json --best
}

lists_are_written_on_request() {
    expect 0 run scene:torus -q -o plain.ply
    is "$(header_count se_neighbors plain.ply)" "" "lists without the option"
    expect 0 run scene:torus -q --with-lists -o torus.ply --report first.json
    is "$(header_count se_neighbors torus.ply)" 1000 "lists"
    expect 0 run torus.ply -q -k 5 --report other.json
    expect 0 run torus.ply -q --report second.json
    says second.json '"neighbors_computed": false'
    is "$(grep state_hash second.json)" "$(grep state_hash first.json)" "the run on the written lists"
    expect 2 run scene:torus --with-lists
    expect 2 run scene:torus --with-lists -o torus.obj
    says err "this format cannot hold neighbor lists; choose .ply"
    expect 2 run scene:torus --with-lists --used-points -o torus.ply
    says err "leave out --used-points"
}

every_scene_runs() {
    "$program" scenes | cut -d' ' -f1 >list
    while read -r scene; do
        expect 0 run "$scene" --report report.json
        says report.json '"stop_reason": "finished"'
    done <list
}

render_writes_png_alone() {
    for name in x.svg x.gif x.jpg x -; do
        expect 2 render scene:sphere -o $name
        says err "pictures are written as .png only"
        absent $name
    done
}

view_without_viewer_says_so() {
    mkdir alone
    cp "$program" alone/
    program="$folder/alone/spiraling-edge" # the viewer is not beside it
    for command in "view scene:sphere" "scene:sphere" "render scene:sphere -o picture.png"; do
        # shellcheck disable=SC2086
        expect 4 $command
        says err "alone/spiraling-edge-viewer"
    done
    printf '#!/bin/sh\necho "viewer got: $*"\n' >alone/spiraling-edge-viewer
    chmod +x alone/spiraling-edge-viewer
    expect 0 view file.ply --some option
    says out "viewer got: file.ply --some option"
    expect 0 render scene:sphere -o picture.png
    says out "viewer got: scene:sphere --goto 100% --screenshot picture.png"
}

links_no_opengl() {
    command -v readelf >/dev/null || return 0
    readelf -d "$program" | grep NEEDED | grep -iE 'GL|glfw|X11' && fail "links a window library"
}

grep -qx "$2() {" "$here/cli_test.sh" || fail "there is no case $2"
[ "$failed" = 1 ] || "$2"
[ "$failed" = 0 ] && echo "ok: $2"
exit "$failed"
