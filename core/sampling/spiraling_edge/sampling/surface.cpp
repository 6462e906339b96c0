/// Projection onto the surface along the gradient: a bracket from the Newton step, then the
/// Illinois variant of regula falsi. Curvature by differences of the unit normal. The search
/// marches over a lattice: the field is evaluated once per corner, layer by layer, and each edge
/// whose ends differ in sign gives one crossing. Curves on the walls come from marching squares.
/// O(cells) evaluations, in parallel by layers.
#include "spiraling_edge/sampling/surface.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "spiraling_edge/base/parallel.h"

namespace se::sampling {

Surface::Surface(Field field, double curvature) : field_(std::move(field)), influence_(curvature) {}

bool Surface::inside(const Vec3& x) const { return glm::clamp(x, field_.low, field_.high) == x; }

std::optional<Vec3> Surface::settle(const Vec3& x, HeldAxes held, double reach,
                                    double tolerance) const {
    const Vec3 g = without(field_.gradient(x), held);
    const double steepness = lengthOf(g);
    double here = value(x);
    if (here == 0.0) return x;
    if (!(steepness > 0.0)) return std::nullopt;
    const Vec3 along = (here > 0.0 ? -1.0 : 1.0) / steepness * g;
    const auto at = [&](double t) { return x + t * along; };
    // Bracket: the Newton step, slightly enlarged, then ever farther.
    double from = 0.0;
    double to = std::min(1.05 * std::abs(here) / steepness + 1e-12 * reach, reach);
    double there = value(at(to));
    while ((there > 0.0) == (here > 0.0) && there != 0.0) {
        if (to >= reach) return std::nullopt;
        from = to;
        here = there;
        to = std::min(2.0 * to, reach);
        there = value(at(to));
    }
    // Regula falsi, halving the weight of an end that stays (the Illinois variant).
    constexpr int kMaxSteps = 60;
    for (int i = 0; i < kMaxSteps && there != 0.0; ++i) {
        const double middle = from + (to - from) * here / (here - there);
        if (!(std::abs(middle - to) > tolerance * reach)) break;
        const double value = this->value(at(middle));
        if ((value > 0.0) == (there > 0.0)) {
            here *= 0.5;
        } else {
            from = to;
            here = there;
        }
        to = middle;
        there = value;
    }
    const Vec3 found = at(to);
    if (!inside(found)) return std::nullopt;
    return found;
}

double Surface::curvature(const Vec3& x) const {
    const Vec3 n = field_.normal(x);
    const Vec3 sizes = cell();
    const double step = 0.5 * std::min({sizes.x, sizes.y, sizes.z});
    const Vec3 aside = std::abs(n.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    const Vec3 across = glm::cross(n, aside);
    const double size = lengthOf(across);
    if (!(size > 0.0)) return 0.0;
    const Vec3 u = across / size;
    double sum = 0.0;
    for (const Vec3& direction : {u, glm::cross(n, u)}) {
        const Vec3 one = glm::clamp(x + step * direction, field_.low, field_.high);
        const Vec3 other = glm::clamp(x - step * direction, field_.low, field_.high);
        const double apart = std::max(lengthOf(one - other), 0.5 * step);
        const Vec3 turn = (field_.normal(one) - field_.normal(other)) / apart;
        sum += glm::dot(turn, turn);
    }
    return std::sqrt(sum);
}

double Surface::relativeSpacing(const Vec3& x) const {
    constexpr double kMaxDense = 5.0;
    if (!followsCurvature() || !(meanCurvature_ > 0.0)) return 1.0;
    return 1.0 / std::min(1.0 + influence_ * curvature(x) / meanCurvature_, kMaxDense);
}

// ---- search -------------------------------------------------------------------------------------

namespace {

/// The corners of the lattice.
class Lattice {
  public:
    explicit Lattice(const Surface& surface)
        : surface_(surface), cells_(surface.field().cells), cell_(surface.cell()) {}

    const glm::ivec3& cells() const { return cells_; }
    /// Position of a corner; exactly on the walls at both ends.
    Vec3 place(const glm::ivec3& at) const {
        Vec3 x = surface_.field().low + cell_ * Vec3(at);
        for (int axis = 0; axis < 3; ++axis) {
            if (at[axis] == cells_[axis]) x[axis] = surface_.field().high[axis];
        }
        return x;
    }
    /// The values at the corners of the plane along axes u and v, u fastest.
    std::vector<double> valuesOn(glm::ivec3 at, int u, int v) const {
        std::vector<double> values;
        for (at[v] = 0; at[v] <= cells_[v]; ++at[v]) {
            for (at[u] = 0; at[u] <= cells_[u]; ++at[u])
                values.push_back(surface_.value(place(at)));
        }
        return values;
    }
    /// The crossing of the surface with the edge from `at` along `axis`, whose ends have these
    /// values.
    Vec3 crossing(glm::ivec3 at, int axis, double here, double there) const {
        const Vec3 from = place(at);
        at[axis] += 1;
        const Vec3 to = place(at);
        double low = 0.0;
        double high = 1.0;
        double t = 0.0;
        // Regula falsi, in the variant of Illinois; exact at once where values are linear.
        constexpr int kMaxSteps = 40;
        for (int i = 0; i < kMaxSteps; ++i) {
            t = std::clamp(low + (high - low) * here / (here - there), 0.0, 1.0);
            const double value = surface_.value(from + t * (to - from));
            if (value == 0.0 || high - low < 1e-12) break;
            if ((value > 0.0) == (there > 0.0)) {
                if (!(std::abs(t - high) > 1e-12)) break;
                high = t;
                there = value;
                here *= 0.5;
            } else {
                if (!(std::abs(t - low) > 1e-12)) break;
                low = t;
                here = value;
                there *= 0.5;
            }
        }
        return from + t * (to - from);
    }

  private:
    const Surface& surface_;
    glm::ivec3 cells_;
    Vec3 cell_;
};

/// Position of a corner among those of a plane that is `across` cells wide.
std::size_t slotOf(int across, int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(across + 1) +
           static_cast<std::size_t>(i);
}

bool differ(double a, double b) { return (a > 0.0) != (b > 0.0); }

/// Crossings of the edges that begin in layers from .. to, a layer being all corners of one z.
class Layers {
  public:
    Layers(const Surface& surface, const Lattice& lattice) : surface_(surface), lattice_(lattice) {}

    void walk(int from, int to) {
        std::vector<double> next = layer(from);
        for (int k = from; k < to; ++k) {
            const std::vector<double> here = std::move(next);
            next = k < lattice_.cells().z ? layer(k + 1) : std::vector<double>{};
            for (int j = 0; j <= lattice_.cells().y; ++j) {
                for (int i = 0; i <= lattice_.cells().x; ++i) look({i, j, k}, here, next);
            }
        }
    }
    std::vector<Crossing> take() { return std::move(found_); }

  private:
    std::size_t slot(int i, int j) const { return slotOf(lattice_.cells().x, i, j); }
    std::vector<double> layer(int k) const { return lattice_.valuesOn({0, 0, k}, 0, 1); }
    void look(const glm::ivec3& at, const std::vector<double>& here,
              const std::vector<double>& above) {
        const double value = here[slot(at.x, at.y)];
        const auto meet = [&](int axis, double there) {
            if (differ(value, there)) add(at, axis, lattice_.crossing(at, axis, value, there));
        };
        if (at.x < lattice_.cells().x) meet(0, here[slot(at.x + 1, at.y)]);
        if (at.y < lattice_.cells().y) meet(1, here[slot(at.x, at.y + 1)]);
        if (!above.empty()) meet(2, above[slot(at.x, at.y)]);
    }
    /// Edges in one wall have half of their surroundings within the box, those in two walls a
    /// quarter.
    void add(const glm::ivec3& at, int axis, const Vec3& x) {
        const Vec3 cell = surface_.cell();
        double area = std::abs(surface_.field().normal(x)[axis]);
        for (int other = 0; other < 3; ++other) {
            if (other == axis) continue;
            const bool onWall = at[other] == 0 || at[other] == lattice_.cells()[other];
            area *= onWall ? 0.5 * cell[other] : cell[other];
        }
        found_.push_back({x, area});
    }

    const Surface& surface_;
    const Lattice& lattice_;
    std::vector<Crossing> found_;
};

/// Marching squares (after Lorensen and Cline 1987) on one wall, and the curves joined from their
/// pieces.
class Wall {
  public:
    Wall(const Lattice& lattice, int axis, bool high)
        : lattice_(lattice),
          u_((axis + 1) % 3),
          v_((axis + 2) % 3),
          across_(lattice.cells()[u_]),
          up_(lattice.cells()[v_]) {
        origin_[axis] = high ? lattice.cells()[axis] : 0;
        face_ = static_cast<std::uint8_t>((high ? 1U : 8U) << static_cast<unsigned>(axis));
    }

    std::vector<WallCurve> curves() {
        findNodes();
        if (node_.empty()) return {};
        for (int j = 0; j < up_; ++j) {
            for (int i = 0; i < across_; ++i) linkCell(i, j);
        }
        std::vector<WallCurve> found;
        visited_.assign(node_.size(), false);
        const auto start = [&](Index node) {
            if (!visited_[node]) found.push_back({face_, follow(node)});
        };
        for (Index node = 0; node < node_.size(); ++node) {
            if (link_[node][1] == kNone) start(node);
        }
        for (Index node = 0; node < node_.size(); ++node) start(node);
        return found;
    }

  private:
    glm::ivec3 corner(int i, int j) const {
        glm::ivec3 at = origin_;
        at[u_] = i;
        at[v_] = j;
        return at;
    }
    std::size_t slot(int i, int j) const { return slotOf(across_, i, j); }
    double value(int i, int j) const { return values_[slot(i, j)]; }

    void findNodes() {
        values_ = lattice_.valuesOn(origin_, u_, v_);
        flat_.assign(values_.size(), kNone);
        upright_.assign(values_.size(), kNone);
        for (int j = 0; j <= up_; ++j) {
            for (int i = 0; i <= across_; ++i) {
                if (i < across_) flat_[slot(i, j)] = nodeOn(i, j, u_, value(i + 1, j));
                if (j < up_) upright_[slot(i, j)] = nodeOn(i, j, v_, value(i, j + 1));
            }
        }
        link_.assign(node_.size(), {kNone, kNone});
    }
    Index nodeOn(int i, int j, int axis, double there) {
        if (!differ(value(i, j), there)) return kNone;
        node_.push_back(lattice_.crossing(corner(i, j), axis, value(i, j), there));
        return static_cast<Index>(node_.size() - 1);
    }

    void linkCell(int i, int j) {
        const Index bottom = flat_[slot(i, j)];
        const Index top = flat_[slot(i, j + 1)];
        const Index left = upright_[slot(i, j)];
        const Index right = upright_[slot(i + 1, j)];
        // Two curves pass if all four edges are crossed: corners with the sign of the middle are
        // connected.
        const double middle = value(i, j) + value(i + 1, j) + value(i, j + 1) + value(i + 1, j + 1);
        const bool aroundFirst = differ(middle, value(i, j));
        const std::array<Index, 4> around = aroundFirst ? std::array{bottom, left, top, right}
                                                        : std::array{bottom, right, top, left};
        std::vector<Index> ends;
        for (const Index node : around) {
            if (node != kNone) ends.push_back(node);
        }
        for (std::size_t end = 0; end + 1 < ends.size(); end += 2) join(ends[end], ends[end + 1]);
    }
    void join(Index a, Index b) {
        link_[a][link_[a][0] == kNone ? 0 : 1] = b;
        link_[b][link_[b][0] == kNone ? 0 : 1] = a;
    }

    std::vector<Vec3> follow(Index first) {
        std::vector<Vec3> line;
        Index node = first;
        while (node != kNone && !visited_[node]) {
            visited_[node] = true;
            line.push_back(node_[node]);
            const auto& links = link_[node];
            const bool free = links[0] != kNone && !visited_[links[0]];
            node = free ? links[0] : links[1];
        }
        if (link_[first][1] != kNone) line.push_back(line.front());
        return line;
    }

    const Lattice& lattice_;
    int u_, v_;
    int across_, up_;
    glm::ivec3 origin_{0};
    std::uint8_t face_;
    std::vector<double> values_;
    std::vector<Index> flat_, upright_;  ///< Nodes of the edges from each corner, kNone: none.
    std::vector<Vec3> node_;
    std::vector<std::array<Index, 2>> link_;
    std::vector<bool> visited_;
};

}  // namespace

Result<std::vector<Crossing>> findCrossings(const Surface& surface, unsigned threads,
                                            const Progress& progress) {
    const Lattice lattice(surface);
    const auto layers = static_cast<std::size_t>(lattice.cells().z) + 1;
    constexpr std::size_t kPerPiece = 8;  // for progress; pieces are the same for any threads
    std::vector<std::vector<Crossing>> piece((layers + kPerPiece - 1) / kPerPiece);
    const bool all = forEachWithProgress(piece.size(), threads, 1, progress, [&](std::size_t i) {
        Layers walk(surface, lattice);
        walk.walk(static_cast<int>(i * kPerPiece),
                  static_cast<int>(std::min((i + 1) * kPerPiece, layers)));
        piece[i] = walk.take();
    });
    if (!all) return Error{"sampling was cancelled"};
    std::vector<Crossing> crossings;
    for (const auto& found : piece) crossings.insert(crossings.end(), found.begin(), found.end());
    return crossings;
}

std::vector<WallCurve> findWallCurves(const Surface& surface) {
    const Lattice lattice(surface);
    std::vector<WallCurve> curves;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
            for (WallCurve& curve : Wall(lattice, axis, high).curves())
                curves.push_back(std::move(curve));
        }
    }
    return curves;
}

}  // namespace se::sampling
