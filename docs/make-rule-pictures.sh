#!/usr/bin/env bash
# Makes the pictures of robust.md: for each rule the same place of two runs, without it and with it.
# Needs no display; ImageMagick, and for most pictures the scans that assets/fetch-scans.sh fetches.
#   docs/make-rule-pictures.sh [PROGRAM [RULE...]]
# The places were looked for with `run --report -`, which lists each fault and where it is.
set -euo pipefail
export LC_ALL=C  # Points, not commas, in numbers.
program=$(realpath "${1:-$(dirname "$0")/../build/bin/spiraling-edge}")
cd "$(dirname "$0")"
shift || true
wanted=" $* "
command -v convert >/dev/null || { echo "no pictures of rules: ImageMagick's convert is missing" >&2; exit 0; }
mkdir -p images
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A mesh that the program wrote, in lines: "v x y z nx ny nz" and "f a b c".
unpack() {
    local head count bytes kind faces
    head=$(($(grep -abo -m1 '^end_header$' "$1" | cut -d: -f1) + 11))
    read -r count bytes kind faces < <(head -c "$head" "$1" | awk '
        BEGIN { split("char 1 uchar 1 short 2 ushort 2 int 4 uint 4 float 4 double 8", word)
                for (i = 1; i in word; i += 2) size[word[i]] = word[i + 1] }
        $1 == "element" { vertex = $2 == "vertex"; if (vertex) count = $3; if ($2 == "face") faces = $3 }
        $1 == "property" && vertex { bytes += size[$2]; kind = kind ? kind : $2 }
        END { print count, bytes, kind, faces }')
    head -c $((head + count * bytes)) "$1" | tail -c $((count * bytes)) | od -An -v -tu1 -w"$bytes" | awk -v kind="$kind" '
        function float(i,    e) {
            e = $(i + 3) % 128 * 2 + int($(i + 2) / 128)
            return e == 0 ? 0 : ($(i + 3) > 127 ? -1 : 1) * 2^(e - 127) * \
                                (1 + (($(i + 2) % 128 * 256 + $(i + 1)) * 256 + $i) / 2^23)
        }
        function double(i,    e, m, k) {
            e = $(i + 7) % 128 * 16 + int($(i + 6) / 16)
            m = $(i + 6) % 16
            for (k = 5; k >= 0; k--) m = m * 256 + $(i + k)
            return e == 0 ? 0 : ($(i + 7) > 127 ? -1 : 1) * 2^(e - 1023) * (1 + m / 2^52)
        }
        function number(n) { return kind == "double" ? double(n * 8 + 1) : float(n * 4 + 1) }
        { printf "v %.9g %.9g %.9g %.9g %.9g %.9g\n", number(0), number(1), number(2), number(3), number(4), number(5) }'
    head -c $((head + count * bytes + faces * 13)) "$1" | tail -c $((faces * 13)) | od -An -v -tu1 -w13 | awk '
        function number(i) { return (($(i + 3) * 256 + $(i + 2)) * 256 + $(i + 1)) * 256 + $i }
        { printf "f %d %d %d\n", number(2), number(6), number(10) }'
}

# NAME FILE OPTION...: runs the program; leaves NAME.mesh, and NAME.faults with triangles in pairs.
triangulate() {
    local name=$work/$1 file=$2
    shift 2
    "$program" run "$file" "$@" -q -o "$name.ply" --report "$name.json"
    unpack "$name.ply" >"$name.mesh"
    tr -d ' \n' <"$name.json" | { grep -o '"triangle":[0-9]*,"other":[0-9n]*' || true; } |
        tr -c '0-9\n' ' ' | awk '{ print $1, $NF }' >"$name.faults"
}

# NAME OTHER COLOR: draws three times as large as wanted.
panel() {
    awk -v place="$place" -v radius="$radius" -v turn="$turn" -v own="$3" -v focus="${focus:-}" \
        -v large="${large:-}" -v lines="${lines:-1}" -v width=1074 -v height=870 -v unit=3 \
        -f draw_mesh.awk "$work/$2.mesh" "$work/$1.mesh" "$work/$1.faults" |
        convert ppm:- -filter Box -resize 358x290 "$work/$1.png"
    convert "$work/$1.png" -gravity north -background white -splice 0x30 \
        -font DejaVu-Sans -pointsize 15 -fill '#222222' -annotate +0+7 "$1" "$work/$1-titled.png"
}

# RULE FILE PLACE RADIUS TURN OPTION...   (see draw_mesh.awk)
picture() {
    local rule=$1 file=$2 place=$3 radius=$4 turn=$5 out=images/rule-$1.png
    shift 5
    [[ $wanted == "  " || $wanted == *" $rule "* ]] || return 0
    case $file in
    scene:* | "$work"/*) ;;
    *) [ -f "$file" ] || { echo "skipped $out: no $file (assets/fetch-scans.sh)" && return 0; } ;;
    esac
    triangulate without "$file" "$@" --rule "$rule=off"
    triangulate with "$file" "$@" --rule "$rule=on"
    panel without with "246 178 122"
    panel with without "128 190 238"
    cmp -s "$work/without.png" "$work/with.png" && echo "$out shows no difference: look for another place" >&2
    convert "$work/without-titled.png" \( -size 4x320 xc:'#c8ccd2' \) "$work/with-titled.png" \
        +append +dither -colors 200 -depth 8 -strip -define png:exclude-chunk=date,time "PNG8:$out"
    echo "docs/$out"
}

# A ball that a wall cuts open: even points along a spiral, and as even ones on the circle in the wall
# (+z, which is 4).
ball() {
    awk 'BEGIN {
        pi = 3.14159265358979; n = 110; top = 0.9; spacing = sqrt(4 * pi / n); low = atan2(sqrt(1 - top * top), top)
        for (i = 0; i < n; i++) {
            z = 1 - (2 * i + 1) / n; r = sqrt(1 - z * z)
            if (atan2(r, z) > low + 0.55 * spacing) row[++rows] = sprintf("%.6f %.6f %.6f", r * cos(2.4 * i), r * sin(2.4 * i), z)
        }
        r = sqrt(1 - top * top); m = int(2 * pi * r / spacing + 0.5)
        for (i = 0; i < m; i++) row[++rows] = sprintf("%.6f %.6f %.6f", r * cos(2 * pi * i / m), r * sin(2 * pi * i / m), top)
        print "ply\nformat ascii 1.0\nelement vertex " rows
        split("x y z nx ny nz", name)
        for (i = 1; i <= 6; i++) print "property float " name[i]
        print "property uchar scalar_se_type\nend_header"
        for (i = 1; i <= rows; i++) print row[i], row[i], (i > rows - m) * 4
    }' >"$work/ball.ply"
}
ball

scans=../assets/scans
picture tangent scene:linked-tori "1.82 0.16 -1.09" 0.28 "40 0" --rules corrected -k 24
picture unblocked scene:torus "0.873 0.021 -0.373" 0.25 "0 0" --rules paper
focus=0.75 picture stepback scene:genus-2 "-2.177 0.357 0.394" 0.25 "0 0" --rules paper
picture wallsdone "$work/ball.ply" "-0.15 -0.42 0.83" 0.8 "0 0" --rules paper -k 16
picture bothwalls ../assets/points/corner.ply "-0.08 -1.106 -2.444" 0.85 "0 0" --rules robust
focus=0.8 picture guard $scans/oni.xyz "0.075 -0.076 0.236" 0.1 "0 40" --rules robust -k 24
picture nopillow scene:genus-2 "1.507 -1.338 0.143" 0.18 "40 0" --rules paper -k 20
picture gap scene:coarse-torus "-0.1 -0.9 -0.03" 0.45 "15 0" --rules paper -k 12
picture nocross $scans/hippo.ply "-0.0915 0.0365 0.042" 0.03 "0 0" --rules robust
focus=0.9 picture nofold $scans/kitten.xyz "-0.2065 0.0487 -0.193" 0.05 "0 -20" --rules corrected -k 32
picture nomeet $scans/fin90.xyz "0.0146 0.1174 0.0204" 0.08 "0 -40" --rules robust
focus=0.9 picture nolayer $scans/kitten.xyz "0.1311 -0.4316 -0.1008" 0.05 "0 0" --rules corrected --rule guard=on -k 24
lines=0 large=0.04 picture rim $scans/hippo.ply "0.02 -0.05 -0.04" 0.38 "-30 0 70" --rules robust
focus=0.9 picture delay $scans/kitten.xyz "-0.191 0.291 0.0128" 0.055 "0 0" --rules corrected -k 24
picture shelve $scans/oni.xyz "-0.1377 0.4443 0.2898" 0.12 "0 0" --rules robust -k 16
picture fill $scans/hippo.ply "0.2115 0.156 0.1306" 0.0165 "0 0" --rules robust
picture droppatches $scans/fin90.xyz "0.0228 0.5348 0.0122" 0.06 "0 -40" --rules robust
picture reinsert $scans/hippo.ply "-0.138 -0.0086 -0.121" 0.031 "0 0" --rules robust
picture closeholes $scans/hippo.ply "0.2475 -0.036 0.1056" 0.016 "0 0" --rules corrected --rule guard=on
picture flip $scans/kitten.xyz "-0.0831 0.2031 0.2035" 0.039 "0 0" --rules robust
picture remesh $scans/fin90.xyz "0.0221 0.2069 0.0043" 0.06 "0 -40" --rules robust
