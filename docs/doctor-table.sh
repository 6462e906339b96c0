#!/usr/bin/env bash
# What the doctor says of every file in some folders, as the table of docs/doctor.md.
#   doctor-table.sh build/bin/spiraling-edge ../shared/data/points ../shared/data/hazards ...
set -uo pipefail
program=$1
shift
echo "| file | exit | errors and warnings | notes |"
echo "|---|---|---|---|"
for file in $(find "$@" -maxdepth 1 -type f | sort); do
    code=0
    said=$("$program" doctor "$file" 2>&1) || code=$?
    # found SEVERITY: "30 points with ..." after the name of the check.
    found() { sed -nE "s/^  $1 +([a-z_]+): ([0-9]+ [a-z]+|the file|).*/\1 (\2)/p" <<<"$said"; }
    list() { paste -sd, | sed 's/,/, /g; s/ (the file)//g'; }
    accused=$({ found error; found warning; } | list)
    [ "$code" != 3 ] || accused="refused: ${said##*: }"
    echo "| $(basename "$(dirname "$file")")/$(basename "$file") | $code | $accused | $(found note | list) |"
done
