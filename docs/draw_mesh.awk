# Draws a place of a mesh beside another run's mesh of the same points, as a plain PPM picture, with a
# depth buffer: crossing triangles are seen to cross. Files: the other mesh and this one, in lines
# "v x y z nx ny nz" and "f a b c", and the faults of this one, triangles in pairs. make-rule-pictures.sh
# makes them.
#   place="x y z"  what is in the middle        radius=R  half of the height, in units of the scene
#   turn="yaw pitch roll"  in degrees, from straight above the surface
#   width=W height=H unit=U  in pixels; U: of a thin line        own="r g b"  triangles only here
#   focus=F  tint only what is nearer than F radii      large=L  tint only what has an edge longer than L
#   lines=0  neither mesh edges nor points

function clamp(x, low, high) { return x < low ? low : x > high ? high : x }
function least(a, b, c) { return a < b ? (a < c ? a : c) : (b < c ? b : c) }
function most(a, b, c) { return a > b ? (a > c ? a : c) : (b > c ? b : c) }

# ---- the camera: rows right, up and back (to the eye) --------------------------------------------

function crossUp() { ux = by * rz - bz * ry; uy = bz * rx - bx * rz; uz = bx * ry - by * rx }
function look(    part, i, size, c, s, x, y, z) {
    split(place, at, " ")
    split(turn, part, " ")
    for (i = 0; i < vertices; i++)
        if ((X[i] - at[1])^2 + (Y[i] - at[2])^2 + (Z[i] - at[3])^2 < radius * radius / 4) {
            bx += NX[i]; by += NY[i]; bz += NZ[i]
        }
    size = sqrt(bx * bx + by * by + bz * bz)
    if (size == 0) bz = size = 1
    bx /= size; by /= size; bz /= size
    if (bx * bx + by * by > 1e-4) { rx = -by; ry = bx; rz = 0 } else { rx = 1; ry = 0; rz = -bx / bz }
    size = sqrt(rx * rx + ry * ry + rz * rz)
    rx /= size; ry /= size; rz /= size
    crossUp()
    c = cos(part[1] * degree); s = sin(part[1] * degree)
    x = bx * c + rx * s; y = by * c + ry * s; z = bz * c + rz * s
    rx = rx * c - bx * s; ry = ry * c - by * s; rz = rz * c - bz * s
    bx = x; by = y; bz = z
    c = cos(part[2] * degree); s = sin(part[2] * degree)
    bx = bx * c + ux * s; by = by * c + uy * s; bz = bz * c + uz * s
    crossUp()
    c = cos(part[3] * degree); s = sin(part[3] * degree)
    rx = rx * c + ux * s; ry = ry * c + uy * s; rz = rz * c + uz * s
    crossUp()
}
function project(    i, x, y, z) {
    zoom = height / 2 / radius
    for (i = 0; i < vertices; i++) {
        x = X[i] - at[1]; y = Y[i] - at[2]; z = Z[i] - at[3]
        PX[i] = width / 2 + zoom * (x * rx + y * ry + z * rz)
        PY[i] = height / 2 - zoom * (x * ux + y * uy + z * uz)
        PZ[i] = zoom * (x * bx + y * by + z * bz)
    }
}

# ---- what can be drawn ----------------------------------------------------------------------------

function plot(x, y, z, color,    i) {
    i = y * width + x
    if (z > depth[i]) { depth[i] = z; pixel[i] = color }
}
# What lies far behind fades.
function faded(r, g, b, z,    fog) {
    fog = clamp((-z / height * 2 - 0.8) / 3, 0, 0.7)
    return sprintf("%d %d %d", r + (255 - r) * fog, g + (255 - g) * fog, b + (255 - b) * fog)
}
function triangle(a, b, c, red, green, blue,    area, x, y, x0, x1, y0, y1, wa, wb, wc, z, la, lb, lc,
                  nx, ny, light, fill, line, front) {
    area = (PX[b] - PX[a]) * (PY[c] - PY[a]) - (PX[c] - PX[a]) * (PY[b] - PY[a])
    if (area == 0) return
    x0 = int(clamp(least(PX[a], PX[b], PX[c]), 0, width))
    x1 = clamp(most(PX[a], PX[b], PX[c]), -1, width - 1)
    y0 = int(clamp(least(PY[a], PY[b], PY[c]), 0, height))
    y1 = clamp(most(PY[a], PY[b], PY[c]), -1, height - 1)
    if (x0 > x1 || y0 > y1) return
    front = area < 0  # y grows downwards.
    nx = (PY[b] - PY[a]) * (PZ[c] - PZ[a]) - (PZ[b] - PZ[a]) * (PY[c] - PY[a])
    ny = (PZ[b] - PZ[a]) * (PX[c] - PX[a]) - (PX[b] - PX[a]) * (PZ[c] - PZ[a])
    # Light from behind the eye, a little to the left and above; back sides are darker.
    light = (0.22 * nx + 0.30 * ny - 0.93 * area) / sqrt(nx * nx + ny * ny + area * area)
    light = (0.58 + 0.46 * clamp(front ? light : -light, 0, 1)) * (front ? 1 : 0.62)
    red = clamp(red * light, 0, 255); green = clamp(green * light, 0, 255); blue = clamp(blue * light, 0, 255)
    z = (PZ[a] + PZ[b] + PZ[c]) / 3
    fill = faded(red, green, blue, z)
    line = lines ? faded(red * 0.5, green * 0.5, blue * 0.53, z) : fill
    la = lines ? sqrt(area^2 / ((PX[c] - PX[b])^2 + (PY[c] - PY[b])^2 + 1e-9)) : 1e9
    lb = lines ? sqrt(area^2 / ((PX[a] - PX[c])^2 + (PY[a] - PY[c])^2 + 1e-9)) : 1e9
    lc = lines ? sqrt(area^2 / ((PX[b] - PX[a])^2 + (PY[b] - PY[a])^2 + 1e-9)) : 1e9
    for (y = y0; y <= y1; y++)
        for (x = x0; x <= x1; x++) {
            wa = ((PX[b] - x) * (PY[c] - y) - (PX[c] - x) * (PY[b] - y)) / area
            if (wa < 0) continue
            wb = ((PX[c] - x) * (PY[a] - y) - (PX[a] - x) * (PY[c] - y)) / area
            wc = 1 - wa - wb
            if (wb < 0 || wc < 0) continue
            plot(x, y, wa * PZ[a] + wb * PZ[b] + wc * PZ[c] + 0.1 * front, \
                 wa * la < 0.6 * unit || wb * lb < 0.6 * unit || wc * lc < 0.6 * unit ? line : fill)
        }
}
# A line with round ends, drawn a little nearer than it is.
function stroke(a, b, half, color,    x, y, x0, x1, y0, y1, dx, dy, t, square) {
    dx = PX[b] - PX[a]; dy = PY[b] - PY[a]
    square = dx * dx + dy * dy + 1e-9
    x0 = int(clamp(least(PX[a], PX[b], PX[b]) - half, 0, width))
    x1 = clamp(most(PX[a], PX[b], PX[b]) + half, -1, width - 1)
    y0 = int(clamp(least(PY[a], PY[b], PY[b]) - half, 0, height))
    y1 = clamp(most(PY[a], PY[b], PY[b]) + half, -1, height - 1)
    for (y = y0; y <= y1; y++)
        for (x = x0; x <= x1; x++) {
            t = clamp(((x - PX[a]) * dx + (y - PY[a]) * dy) / square, 0, 1)
            if ((x - PX[a] - t * dx)^2 + (y - PY[a] - t * dy)^2 <= half * half)
                plot(x, y, PZ[a] + t * (PZ[b] - PZ[a]) + 2.5 * unit, color)
        }
}
function disc(i, half, color, nearer,    x, y, x1, y1) {
    x1 = clamp(PX[i] + half, -1, width - 1); y1 = clamp(PY[i] + half, -1, height - 1)
    for (y = int(clamp(PY[i] - half, 0, height)); y <= y1; y++)
        for (x = int(clamp(PX[i] - half, 0, width)); x <= x1; x++)
            if ((x - PX[i])^2 + (y - PY[i])^2 <= half * half) plot(x, y, PZ[i] + nearer * unit, color)
}

# ---- what is drawn --------------------------------------------------------------------------------

function isNear(i) { return (PX[i] - width / 2)^2 + (PY[i] - height / 2)^2 < (focus * height / 2)^2 }
function long(a, b) { return (PX[a] - PX[b])^2 + (PY[a] - PY[b])^2 + (PZ[a] - PZ[b])^2 > (large * zoom)^2 }
function plain(a, b, c) {
    if ((a, b, c) in other) return 1
    if (focus && !(isNear(a) && isNear(b) && isNear(c))) return 1
    return large && !(long(a, b) || long(b, c) || long(c, a))
}
# Against the sum of the normals of its corners; the report lists a hundred faults only.
function flipped(a, b, c,    ax, ay, az, cx, cy, cz) {
    ax = X[b] - X[a]; ay = Y[b] - Y[a]; az = Z[b] - Z[a]
    cx = X[c] - X[a]; cy = Y[c] - Y[a]; cz = Z[c] - Z[a]
    return (ay * cz - az * cy) * (NX[a] + NX[b] + NX[c]) + (az * cx - ax * cz) * (NY[a] + NY[b] + NY[c]) + \
           (ax * cy - ay * cx) * (NZ[a] + NZ[b] + NZ[c]) < 0
}
function drawTriangles(    i, a, b, c, tint) {
    split(own, tint, " ")
    for (i = 0; i < faces; i++) {
        a = A[i]; b = B[i]; c = C[i]
        if (plain(a, b, c)) triangle(a, b, c, 216, 220, 226)
        else if (i in fault || flipped(a, b, c)) triangle(a, b, c, 226, 66, 46)
        else triangle(a, b, c, tint[1], tint[2], tint[3])
    }
}
function drawEdge(a, b,    uses) {
    uses = edge[a, b] + edge[b, a]
    if (uses == 1) stroke(a, b, 1.5 * unit, "24 28 36")
    if (uses > 2) stroke(a, b, 1.8 * unit, "170 0 120")
}
function drawPoints(    i) {
    for (i = 0; i < vertices; i++)
        if (!(i in used)) {
            disc(i, 6.4 * unit, "24 28 36", 4); disc(i, 5.2 * unit, "255 255 255", 5); disc(i, 3.4 * unit, "213 60 30", 6)
        } else if (!(i in usedThere) && (!focus || isNear(i))) {
            disc(i, 4.6 * unit, "24 28 36", 4); disc(i, 3.6 * unit, "60 150 230", 5)
        } else disc(i, 1.5 * unit, "60 66 76", 3.5)
}

BEGIN { vertices = faces = 0; degree = 3.14159265358979 / 180; if (lines == "") lines = 1 }
FNR == 1 { file++ }
$1 == "v" && file == 2 {
    X[vertices] = $2; Y[vertices] = $3; Z[vertices] = $4
    NX[vertices] = $5; NY[vertices] = $6; NZ[vertices++] = $7
}
$1 == "f" {
    a = $2 + 0; b = $3 + 0; c = $4 + 0
    while (a > b || a > c) { first = a; a = b; b = c; c = first }
    if (file == 1) { other[a, b, c]; usedThere[a]; usedThere[b]; usedThere[c]; next }
    A[faces] = a; B[faces] = b; C[faces++] = c
    used[a]; used[b]; used[c]
    edge[a, b]++; edge[b, c]++; edge[c, a]++
}
file == 3 { fault[$1 + 0]; fault[$2 + 0] }
END {
    look()
    project()
    for (i = 0; i < width * height; i++) { depth[i] = -1e30; pixel[i] = "255 255 255" }
    drawTriangles()
    for (i = 0; i < faces; i++) { drawEdge(A[i], B[i]); drawEdge(B[i], C[i]); drawEdge(C[i], A[i]) }
    if (lines) drawPoints()
    print "P3\n" width, height, 255
    for (i = 0; i < width * height; i++) print pixel[i]
}
