# The beginning of one row of compare.sh's table: medians of one method on one input, and their
# ratios to the first row's, taken run by run and then the median. Prints nothing if there are no
# runs.
function median(values, count,    i, j, swap) {
    for (i = 2; i <= count; i++)
        for (j = i; j > 1 && values[j - 1] > values[j]; j--) {
            swap = values[j]; values[j] = values[j - 1]; values[j - 1] = swap
        }
    return count % 2 ? values[(count + 1) / 2] : (values[count / 2] + values[count / 2 + 1]) / 2
}
function column(from, to,    values, i, j, count) {
    for (i = 1; i <= runs; i++) {
        split(line[i], field, ",")
        values[++count] = 0
        for (j = from; j <= to; j++) values[count] += field[j]
    }
    return median(values, count)
}
function ratio(from, to,    values, i, j, mine, theirs, count) {
    for (i = 1; i <= runs; i++) {
        split(line[i], field, ",")
        split(first[field[3]], other, ",")
        mine = theirs = 0
        for (j = from; j <= to; j++) { mine += field[j]; theirs += other[j] }
        if (theirs > 0) values[++count] = mine / theirs
    }
    return count ? median(values, count) : 0
}
$1 == label && $2 == base { first[$3] = $0 }
$1 == label && $2 == method { line[++runs] = $0; triangles = $9 }
END {
    if (!runs) exit
    printf "| %s | %.3f | %.3f | %.3f | %.3f | %.2f | %.2f | %.2f | %d |\n", \
        (method ~ /^(paper|robust|corrected|printed)$/ ? "ours, `" method "`" : "`" method "`"), \
        column(4, 4), column(5, 5), column(6, 6), column(7, 7), column(8, 8), \
        ratio(6, 6), ratio(4, 7), triangles
}
