/// Repairs of a file that need no guess, each with a line in the report. Points are dropped at the
/// end, together, and lists and faces renumbered once. O(file).
#include <algorithm>
#include <cassert>
#include <utility>

#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// Repairs a copy of the file.
class FixApplication {
  public:
    explicit FixApplication(const PointFile& file)
        : file_(file), keep_(file.position.size(), true) {}

    FixedFile run(std::span<const Index> alsoDrop, std::string_view reason) && {
        dropEmptyNormals();
        markUnfit();
        markAsked(alsoDrop, reason);
        scaleNormals();
        correctCorners();
        const bool all = std::find(keep_.begin(), keep_.end(), false) == keep_.end();
        if (!all) number_ = keptNumbers(keep_);
        cleanLists();
        if (!all) {
            moveFaces();
            keepColumns(file_, keep_);
        }
        return {std::move(file_), std::move(fixes_)};
    }

  private:
    /// `what` is the text for one, `many` that for several.
    void note(std::string_view name, std::size_t count, const std::string& what,
              const std::string& many) {
        if (count == 0) return;
        fixes_.push_back(
            {name, count, count == 1 ? "1 " + what : std::to_string(count) + " " + many});
    }

    /// Drops normals that are all zero, so that normals are derived.
    void dropEmptyNormals() {
        const std::size_t count = file_.normal.size();
        if (std::any_of(file_.normal.begin(), file_.normal.end(),
                        [](const Vec3& normal) { return normal != Vec3(0.0); }))
            return;
        file_.normal.clear();
        note("zero_normals", count, "zero normal taken out, to be derived",
             "zero normals taken out, to be derived");
    }

    void markUnfit() {
        fitness_ = fitnessOf(file_.position, file_.normal);
        std::size_t notFinite = 0;
        std::size_t zero = 0;
        std::size_t copies = 0;
        for (std::size_t p = 0; p < fitness_.size(); ++p) {
            keep_[p] = fitness_[p] == Fitness::Usable;
            const bool directed = fitness_[p] != Fitness::NoDirection;
            if (fitness_[p] == Fitness::NonFinite || (!directed && !isFinite(file_.normal[p])))
                ++notFinite;
            else if (!directed)
                ++zero;
            else if (fitness_[p] == Fitness::Copy)
                ++copies;
        }
        note("non_finite", notFinite, "point with a value that is not finite dropped",
             "points with values that are not finite dropped");
        note("duplicates", copies, "exact copy dropped", "exact copies dropped");
        note("zero_normals", zero, "point with a zero normal dropped",
             "points with a zero normal dropped");
    }

    void markAsked(std::span<const Index> alsoDrop, std::string_view reason) {
        const auto present = std::count(keep_.begin(), keep_.end(), true);
        std::size_t asked = 0;
        for (const Index p : alsoDrop) {
            if (!keep_[p]) continue;
            keep_[p] = false;
            ++asked;
        }
        const std::string what = "of " + countText(static_cast<std::size_t>(present), "point") +
                                 " dropped: " + std::string(reason);
        note("dropped", asked, what, what);
    }

    void scaleNormals() {
        std::size_t scaled = 0;
        for (std::size_t p = 0; p < file_.normal.size(); ++p) {
            Vec3 normal = file_.normal[p];
            if (!keep_[p] || !scaleToUnit(normal)) continue;
            file_.normal[p] = normal;
            ++scaled;
        }
        note("unscaled_normals", scaled, "normal scaled to unit length",
             "normals scaled to unit length");
    }

    void correctCorners() {
        std::size_t corrected = 0;
        for (std::size_t p = 0; p < file_.type.size(); ++p) {
            const std::uint8_t type = withCornerBit(file_.type[p]);
            if (keep_[p] && type != file_.type[p]) ++corrected;
            file_.type[p] = type;
        }
        note("corner_bits", corrected, "corner bit corrected", "corner bits corrected");
    }

    /// The index of a point in the result, kNone if it is dropped.
    Index numberOf(Index p) const { return number_.empty() ? p : number_[p]; }

    void cleanLists() {
        if (!file_.hasNeighbors()) return;
        NeighborLists lists;
        std::vector<Index> kept;
        std::vector<Index> lastList(keep_.size(), kNone);
        std::size_t outside = 0;
        std::size_t repeated = 0;
        std::size_t unsorted = 0;
        for (Index p = 0; p < keep_.size(); ++p) {
            if (!keep_[p]) continue;
            kept.clear();
            lastList[p] = p;
            for (const Index q : file_.neighbors[p]) {
                if (q >= keep_.size()) {
                    ++outside;
                } else if (lastList[q] == p) {
                    ++repeated;
                } else {
                    lastList[q] = p;
                    if (keep_[q]) kept.push_back(q);
                }
            }
            if (!isNearestFirst(file_.position, p, kept)) {
                sortNearestFirst(file_.position, p, kept);
                ++unsorted;
            }
            for (Index& q : kept) q = numberOf(q);
            lists.append(kept);
        }
        file_.neighbors = std::move(lists);
        note("entries_outside", outside, "list entry for a point that does not exist dropped",
             "list entries for points that do not exist dropped");
        note("repeated_entries", repeated, "repeated list entry dropped",
             "repeated list entries dropped");
        note("unsorted_lists", unsorted, "list put in order", "lists put in order");
    }

    void moveFaces() {
        if (file_.faces.empty()) return;
        const std::vector<Index> original = originalsOf(file_.position, fitness_);
        const auto moved = [&](Index p) {
            return original[p] == kNone ? kNone : number_[original[p]];
        };
        std::vector<Triangle> faces;
        for (const Triangle& face : file_.faces) {
            const Triangle t{moved(face.a), moved(face.b), moved(face.c)};
            const bool whole = t.a != kNone && t.b != kNone && t.c != kNone;
            if (whole && t.a != t.b && t.b != t.c && t.c != t.a) faces.push_back(t);
        }
        note("faces", file_.faces.size() - faces.size(), "face on dropped points dropped",
             "faces on dropped points dropped");
        file_.faces = std::move(faces);
    }

    PointFile file_;
    std::vector<AppliedFix> fixes_;
    std::vector<bool> keep_;
    std::vector<Fitness> fitness_;
    std::vector<Index> number_;  // empty if no point is dropped
};

}  // namespace

FixedFile applyFixes(const PointFile& file, std::span<const Index> alsoDrop,
                     std::string_view reason) {
    assert(checkColumns(file).ok());
    return FixApplication(file).run(alsoDrop, reason);
}

}  // namespace se
