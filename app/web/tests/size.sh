#!/usr/bin/env bash
# The way of the program to the reader: all files of a site together, each packed as servers pack them.
#   size.sh SITE     fails above 1.8 MB
set -euo pipefail
limit=1800000
sum=0
while read -r file; do
    bytes=$(gzip -9 -c "$file" | wc -c)
    printf '%9d  %s\n' "$bytes" "${file##*/}"
    sum=$((sum + bytes))
done < <(find "$1"/*/ -type f | sort)
echo "$sum bytes by gzip, at most $limit"
[ "$sum" -le "$limit" ]
