#!/usr/bin/env bash
# The way of the program to the reader: all files of a site together, each packed as servers pack them; and of
# each page before the program, as it is.
#   size.sh SITE     fails above 1.8 MB, or with a page above 40 kB
set -euo pipefail
limit=1800000
sum=0
while read -r file; do
    bytes=$(gzip -9 -c "$file" | wc -c)
    printf '%9d  %s\n' "$bytes" "${file##*/}"
    sum=$((sum + bytes))
done < <(find "$1"/*/ -maxdepth 1 -type f | sort)
echo "$sum bytes by gzip, at most $limit"
[ "$sum" -le "$limit" ]
pages=$(find "$1"/*/*/ -name index.html | wc -l)
large=$(find "$1"/*/*/ -name index.html -size +40000c)
echo "$pages pages, each at most 40000 bytes${large:+, but for $large}"
[ "$pages" -gt 0 ] && [ -z "$large" ]
