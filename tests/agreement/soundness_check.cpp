/// An independent count of the faults of docs/robust.md: plain loops, and no code of the library.
///   soundness_check MESH.ply...    binary, as `run -o MESH.ply` writes it, with normals and types
/// Two triangles that touch, or overlap in one plane, do not count as intersecting; the latter are
/// a second layer. Prints a line for each mesh: its name, then a number for each class. Exits with
/// 1 if a mesh is not sound, unused points aside. Quadratic but for a sort along x: 85,000
/// triangles take some seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

struct V {
    double x = 0, y = 0, z = 0;
};
V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator+(const V& a, const V& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator*(double s, const V& a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(const V& a, const V& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const V& a) { return std::sqrt(dot(a, a)); }
V unit(const V& a) {
    const double l = length(a);
    return l > 0 ? (1 / l) * a : a;
}

using T = std::array<int, 3>;
struct Mesh {
    std::vector<V> point, normal;
    std::vector<bool> ends;  ///< Per point: on a wall or a rim, by its type.
    std::vector<T> triangle;
};

// ---- input --------------------------------------------------------------------------------------

template <typename Number>
double number(const char* bytes) {
    Number value;
    std::memcpy(&value, bytes, sizeof value);
    return double(value);
}
struct Column {
    std::string type, name;
    int size() const {
        if (type == "double") return 8;
        if (type == "float" || type == "int" || type == "uint") return 4;
        return type == "short" || type == "ushort" ? 2 : 1;
    }
    /// Of positions, normals and types; other columns are not read.
    double value(const char* bytes) const {
        if (type == "double") return number<double>(bytes);
        return type == "float" ? number<float>(bytes) : number<unsigned char>(bytes);
    }
};
struct Header {
    std::size_t points = 0, triangles = 0;
    std::vector<Column> columns;  ///< Of the points.
};

bool read(std::istream& in, Header& header) {
    std::string line;
    std::string element;
    if (!std::getline(in, line) || line != "ply") return false;
    if (!std::getline(in, line) || line != "format binary_little_endian 1.0") return false;
    while (std::getline(in, line) && line != "end_header") {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "element") {
            std::size_t count = 0;
            words >> element >> count;
            if (element == "vertex") header.points = count;
            if (element == "face") header.triangles = count;
        } else if (word == "property" && element == "vertex") {
            Column column;
            words >> column.type >> column.name;
            header.columns.push_back(column);
        }
    }
    return bool(in);
}

bool read(const char* name, Mesh& mesh) {
    std::ifstream in(name, std::ios::binary);
    Header header;
    if (!read(in, header)) return false;
    std::array<char, 13> bytes{};
    for (std::size_t i = 0; i < header.points; ++i) {
        std::map<std::string, double> row;
        for (const Column& column : header.columns) {
            in.read(bytes.data(), column.size());
            row[column.name] = column.value(bytes.data());
        }
        mesh.point.push_back({row["x"], row["y"], row["z"]});
        mesh.normal.push_back({row["nx"], row["ny"], row["nz"]});
        // The bits of the six walls, and of the rim; the seventh, of corners, adds nothing.
        mesh.ends.push_back((int(row["scalar_se_type"]) & (63 | 128)) != 0);
    }
    for (std::size_t i = 0; i < header.triangles; ++i) {
        in.read(bytes.data(), 13);  // a byte and three int
        if (bytes[0] != 3) return false;
        mesh.triangle.push_back({int(number<int>(&bytes[1])), int(number<int>(&bytes[5])),
                                 int(number<int>(&bytes[9]))});
    }
    return bool(in);
}

/// Everything about a triangle that pairs are tested by.
struct Shape {
    std::array<V, 3> corner;
    V low, high;
    V normal;   ///< Unit, by the order of the corners.
    V outward;  ///< As `normal`, turned to the side of the corners' normals.
    double area = 0;
    double perimeter = 0;
    double longest = 0;

    /// Such a triangle has no side to face, and counts as this fault alone.
    bool isNeedle() const { return !(2 * area > 1e-6 * longest * longest); }
};

Shape shapeOf(const Mesh& mesh, const T& t) {
    Shape s;
    V sum;
    for (int i = 0; i < 3; ++i) {
        s.corner[i] = mesh.point[t[i]];
        sum = sum + mesh.normal[t[i]];
    }
    const V area = 0.5 * cross(s.corner[1] - s.corner[0], s.corner[2] - s.corner[0]);
    s.area = length(area);
    s.normal = unit(area);
    s.outward = dot(s.normal, sum) < 0 ? -1.0 * s.normal : s.normal;
    s.low = s.high = s.corner[0];
    for (int i = 0; i < 3; ++i) {
        const double edge = length(s.corner[(i + 1) % 3] - s.corner[i]);
        s.perimeter += edge;
        s.longest = std::max(s.longest, edge);
        const V& c = s.corner[i];
        s.low = {std::min(s.low.x, c.x), std::min(s.low.y, c.y), std::min(s.low.z, c.z)};
        s.high = {std::max(s.high.x, c.x), std::max(s.high.y, c.y), std::max(s.high.z, c.z)};
    }
    return s;
}

// ---- pairs --------------------------------------------------------------------------------------

struct P2 {
    double x, y;
};
double turn(const P2& a, const P2& b, const P2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
double areaOf(const std::vector<P2>& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        sum += turn(polygon[0], polygon[i], polygon[i + 1]);
    }
    return 0.5 * sum;
}
/// The part of a convex polygon left of the line from a to b.
std::vector<P2> leftOf(const std::vector<P2>& polygon, const P2& a, const P2& b) {
    std::vector<P2> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const P2& p = polygon[i];
        const P2& q = polygon[(i + 1) % polygon.size()];
        const double dp = turn(a, b, p);
        const double dq = turn(a, b, q);
        if (dp >= 0) left.push_back(p);
        if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
            const double s = dp / (dp - dq);
            left.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
        }
    }
    return left;
}

/// Normals within 45 degrees, at least 2 % of the smaller triangle over or under the other, and the
/// least gap there at most half of the mean edge length of the two.
bool isSecondLayer(const Shape& a, const Shape& b) {
    if (a.area <= 0 || b.area <= 0 || dot(a.outward, b.outward) < std::sqrt(0.5)) return false;
    const V up = unit(a.outward + b.outward);
    const V right = unit(cross(std::abs(up.x) < 0.7 ? V{1, 0, 0} : V{0, 1, 0}, up));
    const V ahead = cross(up, right);
    const auto flat = [&](const Shape& s) {
        std::vector<P2> polygon;
        for (const V& c : s.corner) {
            const V d = c - a.corner[0];
            polygon.push_back({dot(d, right), dot(d, ahead)});
        }
        if (areaOf(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
        return polygon;
    };
    const std::vector<P2> one = flat(a);
    const std::vector<P2> other = flat(b);
    std::vector<P2> common = one;
    for (int i = 0; i < 3 && !common.empty(); ++i) {
        common = leftOf(common, other[i], other[(i + 1) % 3]);
    }
    if (common.size() < 3 || areaOf(common) < 0.02 * std::min(areaOf(one), areaOf(other))) {
        return false;
    }
    double gap = std::numeric_limits<double>::max();
    for (const P2& p : common) {
        const V at = a.corner[0] + p.x * right + p.y * ahead;
        const auto height = [&](const Shape& s) {
            return dot(s.corner[0] - at, s.normal) / dot(up, s.normal);
        };
        gap = std::min(gap, std::abs(height(a) - height(b)));
    }
    return gap <= 0.5 * (a.perimeter + b.perimeter) / 6;
}

/// True if two triangles have the same corners.
bool isSame(T a, T b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
}
/// True if the segment p, q passes through the inside of the triangle.
bool pierces(const V& p, const V& q, const Shape& t) {
    const double dp = dot(p - t.corner[0], t.normal);
    const double dq = dot(q - t.corner[0], t.normal);
    const double tiny = 1e-9 * t.longest;
    if ((dp > -tiny && dq > -tiny) || (dp < tiny && dq < tiny)) return false;
    const V x = p + (dp / (dp - dq)) * (q - p);
    for (int i = 0; i < 3; ++i) {
        const V edge = t.corner[(i + 1) % 3] - t.corner[i];
        if (dot(cross(edge, x - t.corner[i]), t.normal) <= tiny * length(edge)) return false;
    }
    return true;
}
bool intersect(const Shape& a, const Shape& b) {
    for (int i = 0; i < 3; ++i) {
        if (pierces(a.corner[i], a.corner[(i + 1) % 3], b)) return true;
        if (pierces(b.corner[i], b.corner[(i + 1) % 3], a)) return true;
    }
    return false;
}

// ---- counts -------------------------------------------------------------------------------------

struct Counts {
    long nonManifoldEdges = 0, nonManifoldPoints = 0, inconsistent = 0, needles = 0, flipped = 0;
    long intersecting = 0, folded = 0, layers = 0, holes = 0, openings = 0;
    long components = 0, smallComponents = 0, unused = 0;
    // Of the verdict.
    long loops = 0, holeEdges = 0, inward = 0, twins = 0, lost = 0, uncovered = 0;
    long pieces = 0;
    std::vector<bool> besideHole;  ///< Per point.
};

int find(std::vector<int>& parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// By point: the root of its component. Components are joined by common points.
std::vector<int> rootsOf(const Mesh& mesh) {
    std::vector<int> parent(mesh.point.size());
    for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = int(i);
    for (const T& t : mesh.triangle) {
        parent[find(parent, t[0])] = find(parent, t[1]);
        parent[find(parent, t[1])] = find(parent, t[2]);
    }
    std::vector<int> root(parent.size());
    for (std::size_t i = 0; i < parent.size(); ++i) root[i] = find(parent, int(i));
    return root;
}

/// An edge of a single triangle, as the triangle passes it: the surface is to the left.
struct Border {
    int from, to;
};
using Loop = std::vector<Border>;

/// The sector without triangles at p, counterclockwise about its normal from a to b, in degrees.
double freeSector(const Mesh& mesh, int a, int p, int b) {
    const V n = unit(mesh.normal[p]);
    const auto flat = [&](int q) {
        const V d = mesh.point[q] - mesh.point[p];
        return d - dot(d, n) * n;
    };
    const V u = flat(a);
    const V v = flat(b);
    const double angle = std::atan2(dot(cross(u, v), n), dot(u, v)) * 180 / std::acos(-1.0);
    return angle < 0 ? angle + 360 : angle;
}

/// True if the points of a loop from wall to wall are boundary points but for single ones: more
/// than two in three, and one of any two neighbors.
bool followsWalls(const Mesh& mesh, const Loop& loop) {
    std::size_t walls = 0;
    for (const Border& side : loop) {
        if (!mesh.ends[side.from] && !mesh.ends[side.to]) return false;
        if (mesh.ends[side.from]) ++walls;
    }
    return 3 * walls > 2 * loop.size();
}

/// The number of points with a free sector over 120 degrees; those passed twice do not count.
std::size_t endsOf(const Mesh& mesh, const Loop& loop) {
    std::map<int, std::vector<int>> before;
    std::map<int, std::vector<int>> after;
    for (const Border& side : loop) {
        after[side.from].push_back(side.to);
        before[side.to].push_back(side.from);
    }
    std::size_t ends = 0;
    for (const auto& [p, next] : after) {
        if (next.size() != 1 || before[p].size() != 1) continue;
        if (freeSector(mesh, before[p][0], p, next[0]) > 120) ++ends;
    }
    return ends;
}

/// True if the surface ends at a loop; else it is a hole. `triangles`: of its component.
bool isOpening(const Mesh& mesh, const Loop& loop, std::size_t triangles) {
    for (const Border& side : loop) {
        if (length(mesh.normal[side.from]) == 0) return true;
    }
    if (followsWalls(mesh, loop)) return true;
    V area;
    V normals;
    double perimeter = 0;
    for (const Border& side : loop) {
        const V& origin = mesh.point[loop[0].from];
        area = area + 0.5 * cross(mesh.point[side.from] - origin, mesh.point[side.to] - origin);
        normals = normals + mesh.normal[side.from];
        perimeter += length(mesh.point[side.to] - mesh.point[side.from]);
    }
    // Counterclockwise about the normals: the surface is inside.
    if (dot(area, normals) > 0 && triangles <= loop.size() * loop.size()) return true;
    const double edge = perimeter / double(loop.size());
    const double width = 4 * length(area) / perimeter;
    return width >= 2.5 * edge && 3 * endsOf(mesh, loop) > 2 * loop.size();
}

void countLoops(const Mesh& mesh, const std::vector<Border>& border, Counts& n) {
    std::vector<int> parent(mesh.point.size());
    for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = int(i);
    for (const Border& side : border) parent[find(parent, side.from)] = find(parent, side.to);
    std::map<int, Loop> loops;
    for (const Border& side : border) loops[find(parent, side.from)].push_back(side);
    const std::vector<int> root = rootsOf(mesh);
    for (const auto& [some, loop] : loops) {
        std::size_t triangles = 0;
        for (const T& t : mesh.triangle) triangles += root[t[0]] == root[loop[0].from];
        const bool opening = isOpening(mesh, loop, triangles);
        n.openings += opening;
        n.holes += !opening;
        ++n.loops;
        if (opening) continue;
        n.holeEdges += long(loop.size());
        for (const Border& side : loop) n.besideHole[side.from] = n.besideHole[side.to] = true;
    }
}

// ---- the verdict --------------------------------------------------------------------------------

/// The 12 nearest of each point, copies left out, nearest first.
std::vector<std::vector<int>> nearestOf(const Mesh& mesh, const std::vector<bool>& copy) {
    std::vector<std::vector<int>> nearest(mesh.point.size());
    for (std::size_t p = 0; p < nearest.size(); ++p) {
        if (copy[p]) continue;
        std::vector<std::pair<double, int>> all;
        for (std::size_t q = 0; q < nearest.size(); ++q) {
            const V d = mesh.point[q] - mesh.point[p];
            if (q != p && !copy[q]) all.push_back({dot(d, d), int(q)});
        }
        const std::size_t count = std::min<std::size_t>(12, all.size());
        std::partial_sort(all.begin(), all.begin() + std::ptrdiff_t(count), all.end());
        for (std::size_t i = 0; i < count; ++i) nearest[p].push_back(all[i].second);
    }
    return nearest;
}

/// The distance from a point to the nearest point of a triangle, by trying all of its features.
double distanceTo(const Mesh& mesh, const T& t, const V& x) {
    const auto toSegment = [&](const V& a, const V& b) {
        const V d = b - a;
        const double square = dot(d, d);
        const double at = square > 0 ? std::clamp(dot(x - a, d) / square, 0.0, 1.0) : 0;
        return length(x - a - at * d);
    };
    const V& a = mesh.point[t[0]];
    const V& b = mesh.point[t[1]];
    const V& c = mesh.point[t[2]];
    double best = std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
    const V normal = unit(cross(b - a, c - a));
    const auto left = [&](const V& from, const V& to) {
        return dot(cross(to - from, x - from), normal) >= 0;
    };
    if (length(normal) > 0 && left(a, b) && left(b, c) && left(c, a))
        best = std::min(best, std::abs(dot(x - a, normal)));
    return best;
}

/// Closed pieces with a negative volume.
void countInward(const Mesh& mesh, const std::vector<Border>& border, Counts& n) {
    const std::vector<int> root = rootsOf(mesh);
    std::map<int, double> volume;
    for (const T& t : mesh.triangle) {
        const V& o = mesh.point[root[t[0]]];
        volume[root[t[0]]] +=
            dot(mesh.point[t[0]] - o, cross(mesh.point[t[1]] - o, mesh.point[t[2]] - o));
    }
    for (const Border& side : border) volume[root[side.from]] = 1;
    for (const auto& [piece, six] : volume) n.inward += six < 0;
}

/// Points in no triangle by reason, points that are not covered, and pieces of the points.
void countPoints(const Mesh& mesh, Counts& n) {
    const std::size_t count = mesh.point.size();
    std::vector<bool> used(count), copy(count);
    for (const T& t : mesh.triangle) used[t[0]] = used[t[1]] = used[t[2]] = true;
    for (std::size_t p = 0; p < count; ++p) {
        for (std::size_t q = 0; q < p && !copy[p]; ++q)
            copy[p] = length(mesh.point[p] - mesh.point[q]) == 0;
    }
    const auto nearest = nearestOf(mesh, copy);
    const auto away = [&](std::size_t p, std::size_t i) {
        return length(mesh.point[nearest[p][i]] - mesh.point[p]);
    };
    std::vector<int> parent(count);
    for (std::size_t p = 0; p < count; ++p) parent[p] = int(p);
    for (std::size_t p = 0; p < count; ++p) {
        if (copy[p]) continue;
        const bool twin = away(p, 0) < 0.25 * away(p, 3);
        if (!used[p] && twin && used[nearest[p][0]]) {
            ++n.twins;
        } else if (!used[p]) {
            ++n.lost;
        }
        double distance = used[p] ? 0 : 1e300;
        for (const T& t : mesh.triangle)
            if (!used[p]) distance = std::min(distance, distanceTo(mesh, t, mesh.point[p]));
        n.uncovered += used[p] ? n.besideHole[p] : distance > 0.5 * away(p, 2);
        for (const int q : nearest[p]) {
            const auto& back = nearest[q];
            if (std::find(back.begin(), back.end(), int(p)) != back.end() &&
                length(mesh.point[p] - mesh.point[q]) <= 2 * std::min(away(p, 2), away(q, 2)))
                parent[find(parent, int(p))] = find(parent, q);
        }
    }
    std::map<int, int> size;
    for (std::size_t p = 0; p < count; ++p) ++size[find(parent, int(p))];
    for (const auto& [piece, points] : size) n.pieces += points >= 3;
}

void countEdges(const Mesh& mesh, const std::vector<Shape>& shapes, Counts& n) {
    std::map<std::pair<int, int>, std::vector<std::pair<int, bool>>> edges;
    std::vector<std::vector<std::pair<int, int>>> around(mesh.point.size());
    for (std::size_t i = 0; i < mesh.triangle.size(); ++i) {
        const T& t = mesh.triangle[i];
        for (int k = 0; k < 3; ++k) {
            const int u = t[k];
            const int v = t[(k + 1) % 3];
            edges[{std::min(u, v), std::max(u, v)}].push_back({int(i), u < v});
            around[u].push_back({v, t[(k + 2) % 3]});
        }
    }
    std::vector<Border> border, irregular;
    std::set<std::pair<int, int>> folded;
    for (const auto& [edge, sides] : edges) {
        n.nonManifoldEdges += sides.size() > 2;
        const auto ascending =
            std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second; });
        n.inconsistent += ascending > 1 || long(sides.size()) - ascending > 1;
        if (sides.size() == 1 && sides[0].second) border.push_back({edge.first, edge.second});
        if (sides.size() == 1 && !sides[0].second) border.push_back({edge.second, edge.first});
        const bool plain = sides.size() == 2 && sides[0].second != sides[1].second;
        // Nearly on one another: the normals are more than 170 degrees apart.
        if (!plain) irregular.push_back({edge.first, edge.second});
        if (!plain) continue;
        const Shape& a = shapes[sides[0].first];
        const Shape& b = shapes[sides[1].first];
        if (!a.isNeedle() && !b.isNeedle() && dot(a.normal, b.normal) < -0.984807753012208) {
            folded.insert({sides[0].first, sides[1].first});
        }
    }
    n.folded = long(folded.size());
    countLoops(mesh, border, n);
    countInward(mesh, irregular, n);
    countPoints(mesh, n);
    for (std::size_t p = 0; p < around.size(); ++p) {
        n.unused += around[p].empty();
        // The triangles at a point are one fan if their far edges hang together.
        std::map<int, int> parent;
        for (const auto& [u, v] : around[p]) parent[u] = u, parent[v] = v;
        const auto root = [&](int x) {
            while (parent[x] != x) x = parent[x];
            return x;
        };
        for (const auto& [u, v] : around[p]) parent[root(u)] = root(v);
        std::set<int> fans;
        for (const auto& [u, v] : around[p]) fans.insert(root(u));
        n.nonManifoldPoints += fans.size() > 1;
    }
}

/// The mean length of the sides of all triangles.
double meanEdge(const std::vector<Shape>& shapes) {
    double sum = 0;
    for (const Shape& s : shapes) sum += s.perimeter / 3;
    return sum / double(shapes.size());
}

/// Small: under 14 triangles, and a point within two mean edges of one of a larger component.
void countComponents(const Mesh& mesh, double edge, Counts& n) {
    const std::vector<int> root = rootsOf(mesh);
    std::map<int, int> size;
    for (const T& t : mesh.triangle) ++size[root[t[0]]];
    n.components = long(size.size());
    std::set<int> small;
    for (std::size_t p = 0; p < root.size(); ++p) {
        const auto own = size.find(root[p]);
        if (own == size.end() || own->second >= 14) continue;
        for (std::size_t q = 0; q < root.size(); ++q) {
            const auto other = size.find(root[q]);
            if (other != size.end() && other->second > own->second &&
                length(mesh.point[p] - mesh.point[q]) <= 2 * edge) {
                small.insert(root[p]);
            }
        }
    }
    n.smallComponents = long(small.size());
}

Counts count(const Mesh& mesh) {
    Counts n;
    n.besideHole.resize(mesh.point.size());
    std::vector<Shape> shapes;
    for (const T& t : mesh.triangle) {
        shapes.push_back(shapeOf(mesh, t));
        const Shape& s = shapes.back();
        n.needles += s.isNeedle();
        n.flipped += !s.isNeedle() && dot(s.normal, s.outward) < 0;
    }
    countEdges(mesh, shapes, n);
    countComponents(mesh, meanEdge(shapes), n);
    std::vector<int> order(shapes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = int(i);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return shapes[a].low.x < shapes[b].low.x; });
    double reach = 0;  // Half of the longest mean edge length: no gap is wider.
    for (const Shape& s : shapes) reach = std::max(reach, s.perimeter / 6);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Shape& a = shapes[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Shape& b = shapes[order[j]];
            if (b.low.x > a.high.x + reach) break;
            if (a.isNeedle() || b.isNeedle()) continue;
            const double gap = 0.75 * (a.perimeter + b.perimeter) / 6;
            if (b.low.x > a.high.x + gap || b.low.y > a.high.y + gap || a.low.y > b.high.y + gap ||
                b.low.z > a.high.z + gap || a.low.z > b.high.z + gap) {
                continue;
            }
            n.intersecting +=
                intersect(a, b) || isSame(mesh.triangle[order[i]], mesh.triangle[order[j]]);
            n.layers += isSecondLayer(a, b);
        }
    }
    return n;
}

}  // namespace

int main(int argc, char** argv) {
    bool sound = true;
    for (int i = 1; i < argc; ++i) {
        Mesh mesh;
        if (!read(argv[i], mesh)) {
            std::fprintf(stderr, "%s: expected a binary PLY file of triangles\n", argv[i]);
            return 3;
        }
        const Counts n = count(mesh);
        std::printf(
            "%s: non_manifold_edges %ld non_manifold_vertices %ld inconsistent_edges %ld needles "
            "%ld flipped %ld intersecting %ld folded %ld second_layers %ld holes %ld openings %ld "
            "components %ld small_components %ld unused %ld loops %ld hole_edges %ld inward %ld "
            "twins %ld lost %ld uncovered %ld pieces %ld\n",
            argv[i], n.nonManifoldEdges, n.nonManifoldPoints, n.inconsistent, n.needles, n.flipped,
            n.intersecting, n.folded, n.layers, n.holes, n.openings, n.components,
            n.smallComponents, n.unused, n.loops, n.holeEdges, n.inward, n.twins, n.lost,
            n.uncovered, n.pieces);
        sound = sound && n.nonManifoldEdges + n.nonManifoldPoints + n.inconsistent + n.needles +
                                 n.flipped + n.intersecting + n.folded + n.layers + n.holes +
                                 n.smallComponents ==
                             0;
    }
    return sound ? 0 : 1;
}
