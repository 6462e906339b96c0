# growth.csv to an SVG plot: points against microseconds per point for neighbors and reconstruction,
# both axes logarithmic. A level line is growth in proportion to the points.
function x(points) { return left + width * (log(points) - lowX) / (highX - lowX) }
function y(value) { return top + height * (highY - log(value)) / (highY - lowY) }
function text(px, py, anchor, words) {
    printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>\n", px, py, anchor, words
}
function rule(x1, y1, x2, y2) {
    printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", x1, y1, x2, y2
}
function human(n) { return n >= 1e6 ? n / 1e6 "M" : n >= 1e3 ? n / 1e3 "k" : n "" }
function medianOf(list,    values, count, i, j, swap) {
    count = split(list, values, " ")
    for (i = 2; i <= count; i++)
        for (j = i; j > 1 && values[j - 1] + 0 > values[j] + 0; j--) {
            swap = values[j]; values[j] = values[j - 1]; values[j - 1] = swap
        }
    return count % 2 ? values[(count + 1) / 2] : (values[count / 2] + values[count / 2 + 1]) / 2
}
NR > 1 {
    key = $2 SUBSEP $1
    if (!(key in all)) { if (!($2 in seen)) { seen[$2] = 1; method[++methods] = $2 } order[$2, ++count[$2]] = $1 }
    all[key] = all[key] " " 1e6 * ($5 + $6) / $1
}
END {
    left = 60; top = 20; width = 480; height = 300
    split("#0072b2 #009e73 #d55e00 #cc79a7 #e69f00 #56b4e9 #000000 #999999 #f0e442", color, " ")
    lowY = lowX = 1e9; highY = highX = -1e9
    for (key in all) {
        split(key, part, SUBSEP)
        value[key] = medianOf(all[key])
        if (log(value[key]) < lowY) lowY = log(value[key])
        if (log(value[key]) > highY) highY = log(value[key])
        if (log(part[2]) < lowX) lowX = log(part[2])
        if (log(part[2]) > highX) highX = log(part[2])
    }
    lowY = log(10) * int(lowY / log(10) - (lowY < 0)); highY += 0.2
    if (highX <= lowX) highX = lowX + 1
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 660 370\" font-family=\"sans-serif\" font-size=\"12\">\n"
    printf "<rect width=\"660\" height=\"370\" fill=\"white\"/>\n"
    for (value10 = 0.01; value10 < 1e5; value10 *= 10)
        for (step = 1; step <= 5; step += (step == 1 ? 1 : 3)) {
            at = log(value10 * step)
            if (at < lowY - 1e-9 || at > highY) continue
            rule(left, y(value10 * step), left + width, y(value10 * step))
            text(left - 6, y(value10 * step) + 4, "end", value10 * step)
        }
    for (points = 100; points <= 1e8; points *= 10)
        if (log(points) >= lowX - 1e-9 && log(points) <= highX + 1e-9) {
            rule(x(points), top, x(points), top + height)
            text(x(points), top + height + 18, "middle", human(points))
        }
    text(left + width / 2, top + height + 40, "middle", "points")
    text(left, top - 6, "start", "microseconds per point, neighbors and reconstruction")
    for (m = 1; m <= methods; m++) {
        name = method[m]; path = ""
        for (i = 1; i <= count[name]; i++) {
            px = x(order[name, i]); py = y(value[name, order[name, i]])
            path = path sprintf("%.1f,%.1f ", px, py)
            printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", px, py, color[m]
        }
        printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\"/>\n", path, color[m]
        printf "<rect x=\"%d\" y=\"%d\" width=\"12\" height=\"12\" fill=\"%s\"/>\n", left + width + 20, top + 20 * m - 10, color[m]
        text(left + width + 38, top + 20 * m, "start", (name ~ /^(paper|robust)$/ ? "ours, " : "") name)
    }
    print "</svg>"
}
