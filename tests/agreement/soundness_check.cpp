/// An independent count of the faults of docs/robust.md: plain loops, and no code of the library.
///   soundness_check MESH.off...    NOFF, as `run --normals -o MESH.off` writes it
/// Two triangles in one plane that overlap count as a second layer, not as intersecting.
/// Prints a line for each mesh: its name, then a number for each class. Exits with 1 if a mesh is
/// not sound. Quadratic but for a sort along x: 85,000 triangles take some seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <set>
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
    std::vector<T> triangle;
};

bool read(const char* name, Mesh& mesh) {
    std::ifstream in(name);
    std::string word;
    std::size_t points = 0;
    std::size_t faces = 0;
    std::size_t edges = 0;
    if (!(in >> word >> points >> faces >> edges)) return false;
    const bool normals = word == "NOFF";
    if (!normals && word != "OFF") return false;
    for (std::size_t i = 0; i < points; ++i) {
        V p;
        V n;
        in >> p.x >> p.y >> p.z;
        if (normals) in >> n.x >> n.y >> n.z;
        mesh.point.push_back(p);
        mesh.normal.push_back(n);
    }
    for (std::size_t i = 0; i < faces; ++i) {
        int n = 0;
        T t{};
        in >> n >> t[0] >> t[1] >> t[2];
        if (n != 3) return false;
        mesh.triangle.push_back(t);
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
    long intersecting = 0, folded = 0, layers = 0, loops = 0, components = 0, unused = 0;
};

int find(std::vector<int>& parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
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
    std::vector<int> border(mesh.point.size());
    for (std::size_t i = 0; i < border.size(); ++i) border[i] = int(i);
    std::set<int> onBorder;
    std::set<std::pair<int, int>> folded;
    for (const auto& [edge, sides] : edges) {
        n.nonManifoldEdges += sides.size() > 2;
        const auto ascending =
            std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second; });
        n.inconsistent += ascending > 1 || long(sides.size()) - ascending > 1;
        if (sides.size() == 1) {
            border[find(border, edge.first)] = find(border, edge.second);
            onBorder.insert(edge.first);
            onBorder.insert(edge.second);
        }
        const bool plain = sides.size() == 2 && sides[0].second != sides[1].second;
        // Nearly on one another: the normals are more than 170 degrees apart.
        if (plain && dot(shapes[sides[0].first].normal, shapes[sides[1].first].normal) <
                         -0.984807753012208) {
            folded.insert({sides[0].first, sides[1].first});
        }
    }
    n.folded = long(folded.size());
    std::set<int> loops;
    for (const int p : onBorder) loops.insert(find(border, p));
    n.loops = long(loops.size());
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

void countComponents(const Mesh& mesh, Counts& n) {
    std::vector<int> parent(mesh.point.size());
    for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = int(i);
    for (const T& t : mesh.triangle) {
        parent[find(parent, t[0])] = find(parent, t[1]);
        parent[find(parent, t[1])] = find(parent, t[2]);
    }
    std::set<int> roots;
    for (const T& t : mesh.triangle) roots.insert(find(parent, t[0]));
    n.components = long(roots.size());
}

Counts count(const Mesh& mesh) {
    Counts n;
    std::vector<Shape> shapes;
    for (const T& t : mesh.triangle) {
        shapes.push_back(shapeOf(mesh, t));
        const Shape& s = shapes.back();
        n.needles += !(2 * s.area > 1e-6 * s.longest * s.longest);
        n.flipped += dot(s.normal, s.outward) < 0;
    }
    countEdges(mesh, shapes, n);
    countComponents(mesh, n);
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
            std::fprintf(stderr, "%s: expected an OFF file of triangles\n", argv[i]);
            return 3;
        }
        const Counts n = count(mesh);
        std::printf(
            "%s: non_manifold_edges %ld non_manifold_vertices %ld inconsistent_edges %ld needles "
            "%ld flipped %ld intersecting %ld folded %ld second_layers %ld loops %ld components "
            "%ld unused %ld\n",
            argv[i], n.nonManifoldEdges, n.nonManifoldPoints, n.inconsistent, n.needles, n.flipped,
            n.intersecting, n.folded, n.layers, n.loops, n.components, n.unused);
        sound = sound && n.nonManifoldEdges + n.nonManifoldPoints + n.inconsistent + n.needles +
                                 n.flipped + n.intersecting + n.folded + n.layers ==
                             0;
    }
    return sound ? 0 : 1;
}
