/// Thinning goes through the points once and keeps each that no kept point is near. Kept points are
/// found by the cells of a grid twice as wide as the spacing, in a hash table: a ball around a
/// point meets eight cells, and in a cell there are never more than some twenty kept points.
/// Memory: some 20 bytes per kept point.
#include "spiraling_edge/prepare/piece.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/points/wall_types.h"
#include "spiraling_edge/prepare/given_normals.h"

namespace se {
namespace {

/// Points of which no two are nearer to each other than a spacing.
class SpacedPoints {
  public:
    SpacedPoints(std::span<const Vec3> position, double spacing)
        : position_(position), spacing_(spacing), first_(kLeastBuckets, kNone) {}

    /// Adds point p, unless it is nearer than the spacing to one that was added before. True if it
    /// was added. Requires a finite position.
    bool add(Index p) {
        const Vec3& x = position_[p];
        const Cell home = cellOf(x);
        if (isCrowded(x, home)) return false;
        const Cell from = cellOf(x - spacing_);
        const Cell to = cellOf(x + spacing_);
        Cell cell = from;
        for (cell.z = from.z; cell.z <= to.z; ++cell.z) {
            for (cell.y = from.y; cell.y <= to.y; ++cell.y) {
                for (cell.x = from.x; cell.x <= to.x; ++cell.x) {
                    if (cell != home && isCrowded(x, cell)) return false;
                }
            }
        }
        if (entries_.size() == first_.size()) widen();
        entries_.push_back({p, kNone});
        link(entries_.size() - 1);
        return true;
    }

  private:
    using Cell = glm::i64vec3;
    struct Entry {
        Index point;
        Index next;  ///< Another entry of the same bucket, or kNone.
    };
    static constexpr std::size_t kLeastBuckets = 1024;

    /// Rounding is monotonic: what is within the spacing of x is in a cell from that of x - spacing
    /// to that of x + spacing, however far from the origin. Beyond 2^53 cells the numbers would
    /// have gaps; what is there shares the last cell.
    Cell cellOf(const Vec3& x) const {
        constexpr double kLast = 9007199254740992.0;
        return Cell(glm::clamp(glm::floor(x / (2.0 * spacing_)), -kLast, kLast));
    }
    std::size_t bucketOf(const Cell& cell) const {
        std::uint64_t h = 0;
        for (int i = 0; i < 3; ++i) {
            h = (h ^ static_cast<std::uint64_t>(cell[i])) * 0x9e3779b97f4a7c15U;
            h ^= h >> 32U;
        }
        return static_cast<std::size_t>(h) & (first_.size() - 1);
    }
    /// True if a point of the cell, or another one of its bucket, is nearer than the spacing.
    bool isCrowded(const Vec3& x, const Cell& cell) const {
        for (Index i = first_[bucketOf(cell)]; i != kNone; i = entries_[i].next) {
            // Divided first: the squares of very long or short differences would be no numbers.
            const Vec3 difference = (position_[entries_[i].point] - x) / spacing_;
            if (glm::dot(difference, difference) < 1.0) return true;
        }
        return false;
    }
    void link(std::size_t i) {
        Index& first = first_[bucketOf(cellOf(position_[entries_[i].point]))];
        entries_[i].next = first;
        first = static_cast<Index>(i);
    }
    void widen() {
        first_.assign(2 * first_.size(), kNone);
        for (std::size_t i = 0; i < entries_.size(); ++i) link(i);
    }

    std::span<const Vec3> position_;
    double spacing_;
    std::vector<Index> first_;  ///< First entry of each bucket, or kNone.
    std::vector<Entry> entries_;
};

/// True if x is finite and in the box.
bool holds(const Box& box, const Vec3& x) {
    return isFinite(x) && glm::clamp(x, box.low, box.high) == x;
}

void thin(std::span<const Vec3> position, double spacing, std::vector<bool>& keep) {
    SpacedPoints kept(position, spacing);
    for (Index p = 0; p < position.size(); ++p) {
        if (keep[p] && isFinite(position[p])) keep[p] = kept.add(p);
    }
}

/// Of several points at one place thinning keeps the first: it gets the mean of their normals, and
/// of missing values none is kept, since one alone is not known for what it is.
void prepareThinning(PointFile& file, std::vector<bool>& keep) {
    const PlacedPoints placed = placedPoints(file.position, file.farValues);
    averageOverCopies(placed, file.normal);
    std::size_t missing = 0;
    for (Index p = 0; p < keep.size(); ++p) {
        if (placed.aside[p] != Aside::Sentinel) continue;
        keep[p] = false;
        ++missing;
    }
    if (missing > 0) {
        file.notes.push_back("left out by thinning: " + counted(missing, "point") +
                             " where a missing value was written");
    }
}

/// The triangles whose corners all have a number, renumbered.
std::vector<Triangle> keptFaces(std::span<const Triangle> faces, const std::vector<Index>& number) {
    std::vector<Triangle> kept;
    for (const Triangle& t : faces) {
        const Triangle made{number[t.a], number[t.b], number[t.c]};
        if (made.a != kNone && made.b != kNone && made.c != kNone) kept.push_back(made);
    }
    return kept;
}

/// Adds the index of each kept point, unless the file has such a column.
void addIndices(const std::vector<bool>& keep, PointFile& file) {
    const auto isThere = [](const Attribute& each) { return each.name == kIndexColumn; };
    if (std::any_of(file.attributes.begin(), file.attributes.end(), isThere)) return;
    Attribute index{std::string(kIndexColumn), ScalarType::UInt32, {}};
    index.values.reserve(file.position.size());
    for (std::size_t p = 0; p < keep.size(); ++p) {
        if (keep[p]) index.values.push_back(static_cast<double>(p));
    }
    file.attributes.push_back(std::move(index));
}

/// Frees what the columns do not need any more: a piece is a small part of a large file.
void freeUnused(PointFile& file) {
    file.position.shrink_to_fit();
    file.normal.shrink_to_fit();
    file.type.shrink_to_fit();
    for (Attribute& attribute : file.attributes) attribute.values.shrink_to_fit();
}

/// The shortest decimal number that reads back as this float.
std::string floatText(float value) {
    std::array<char, 32> out{};
    for (int digits = 6; digits <= 9; ++digits) {
        std::snprintf(out.data(), out.size(), "%.*g", digits, static_cast<double>(value));
        if (std::strtof(out.data(), nullptr) == value) break;
    }
    return out.data();
}

/// "(0, -1, 2.5)", with as many digits as the file has.
std::string cornerText(const Vec3& x, ScalarType type) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        const bool wide = type == ScalarType::Double;
        text += i > 0 ? ", " : "(";
        text += wide ? plainNumber(x[i]) : floatText(static_cast<float>(x[i]));
    }
    return text + ")";
}

/// Message for a box without points, with the box of all points.
std::string emptyBoxText(const PointFile& file, const std::string& name) {
    const std::string count = counted(file.position.size(), "point");
    if (std::none_of(file.position.begin(), file.position.end(), isFinite))
        return name + ": the position of none of its " + count + " is finite";
    const WallBox bounds = boxAround(file.position);
    return "the box holds 0 of the " + count + " of " + name + ", which lie between " +
           cornerText(bounds.low, file.positionType) + " and " +
           cornerText(bounds.high, file.positionType) + "; give a box that meets these bounds";
}

}  // namespace

std::vector<bool> pointsIn(std::span<const Vec3> position, const Piece& piece) {
    assert(piece.thin >= 0.0 && std::isfinite(piece.thin));
    std::vector<bool> keep(position.size(), true);
    if (piece.crop) {
        assert(isFinite(piece.crop->low) && isFinite(piece.crop->high));
        assert(glm::min(piece.crop->low, piece.crop->high) == piece.crop->low);
        for (std::size_t p = 0; p < position.size(); ++p) keep[p] = holds(*piece.crop, position[p]);
    }
    if (piece.thin > 0.0) thin(position, piece.thin, keep);
    return keep;
}

PointFile pieceOf(PointFile file, const Piece& piece) {
    file.farValues = piece.farValues;
    if (!piece.isWhole()) {
        std::vector<bool> keep = pointsIn(file.position, {piece.crop});
        if (piece.thin > 0.0) {
            prepareThinning(file, keep);
            thin(file.position, piece.thin, keep);
        }
        file = keptPoints(std::move(file), keep);
    }
    if (piece.isScaled()) return scaled(std::move(file), piece.scale);
    return file;
}

PointFile scaled(PointFile file, const Vec3& factors) {
    assert(isFinite(factors) && factors.x > 0.0 && factors.y > 0.0 && factors.z > 0.0);
    for (Vec3& x : file.position) x *= factors;
    if (file.viewpoint) *file.viewpoint *= factors;
    // At most 1, so that no normal gets infinitely long.
    const Vec3 shares = std::min({factors.x, factors.y, factors.z}) / factors;
    for (Vec3& normal : file.normal) {
        if (!hasDirection(normal)) continue;
        scaleToUnit(normal);
        normal *= shares;
        scaleToUnit(normal);
    }
    file.positionType = ScalarType::Double;
    file.normalType = ScalarType::Double;
    return file;
}

PointFile keptPoints(PointFile file, const std::vector<bool>& keep) {
    assert(checkColumns(file).ok());
    assert(keep.size() == file.position.size());
    if (file.hasNeighbors() || !file.faces.empty()) {
        const std::vector<Index> number = keptNumbers(keep);
        if (file.hasNeighbors()) file.neighbors = keptLists(file.neighbors, number);
        file.faces = keptFaces(file.faces, number);
    }
    keepColumns(file, keep);
    addIndices(keep, file);
    freeUnused(file);
    return file;
}

Result<PointFile> cutPiece(PointFile file, const Piece& piece, const std::string& name) {
    if (piece.crop && !file.position.empty()) {
        // Not after the cut, since the message has the bounds of the file.
        const std::vector<bool> keep = pointsIn(file.position, {piece.crop});
        if (std::find(keep.begin(), keep.end(), true) == keep.end())
            return Error{emptyBoxText(file, name)};
    }
    return pieceOf(std::move(file), piece);
}

}  // namespace se
