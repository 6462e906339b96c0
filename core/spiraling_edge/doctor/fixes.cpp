/// Repairs of a file that need no guess, each with a line in the report. Points are dropped at the
/// end, together, and lists and faces renumbered once. O(file).
#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/given_normals.h"
#include "spiraling_edge/prepare/normals.h"

namespace se {
namespace {

/// Repairs a copy of the file.
class FixApplication {
  public:
    explicit FixApplication(const PointFile& file)
        : file_(file), keep_(file.position.size(), true) {}

    FixedFile run(std::span<const Index> alsoDrop, std::string_view reason) && {
        markUnfit();
        fixNormals();
        markAsked(alsoDrop, reason);
        scaleNormals();
        correctCorners();
        const bool all = !isAmong(false, keep_);
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
        if (count > 0) fixes_.push_back({name, count, counted(count, what, many)});
    }

    void markUnfit() {
        placed_ = placedPoints(file_.position, file_.farValues);
        // Before the copies are dropped: their normals count in the mean.
        averageOverCopies(placed_, file_.normal);
        std::array<std::size_t, kAsides> count{};
        for (std::size_t p = 0; p < keep_.size(); ++p) {
            keep_[p] = placed_.aside[p] == Aside::No;
            ++count[static_cast<std::size_t>(placed_.aside[p])];
        }
        const auto of = [&](Aside reason) { return count[static_cast<std::size_t>(reason)]; };
        note("non_finite", of(Aside::NotFinite),
             "point with a coordinate that is not finite dropped",
             "points with coordinates that are not finite dropped");
        note("duplicates", of(Aside::Copy), "exact copy dropped", "exact copies dropped");
        note("sentinels", of(Aside::Sentinel), "point where a missing value was written dropped",
             "points where a missing value was written dropped");
    }

    /// Normals without a direction: takes all normals out, to be derived, if most are so; else
    /// derives these, and drops the points where that is not possible.
    void fixNormals() {
        std::vector<Index> missing;
        for (Index p = 0; p < file_.normal.size(); ++p) {
            if (keep_[p] && !hasDirection(file_.normal[p])) missing.push_back(p);
        }
        if (missing.empty()) return;
        if (lacksNormals(file_.normal, keep_)) {
            file_.normal.clear();
            const std::string rest = ": all normals taken out, to be derived";
            return note("zero_normals", missing.size(), "normal is zero or not finite" + rest,
                        "normals are zero or not finite" + rest);
        }
        file_.normal = completeNormals(file_, keep_).value();  // Fails only if cancelled.
        std::size_t planeless = 0;
        for (const Index p : missing) {
            if (file_.normal[p] != Vec3(0.0)) continue;
            keep_[p] = false;
            ++planeless;
        }
        note("zero_normals", missing.size() - planeless,
             "normal that was zero or not finite derived",
             "normals that were zero or not finite derived");
        note("zero_normals", planeless, "point dropped: its normal cannot be derived",
             "points dropped: their normals cannot be derived");
    }

    void markAsked(std::span<const Index> alsoDrop, std::string_view reason) {
        const auto present = std::count(keep_.begin(), keep_.end(), true);
        std::size_t asked = 0;
        for (const Index p : alsoDrop) {
            if (!keep_[p]) continue;
            keep_[p] = false;
            ++asked;
        }
        const std::string what = "of " + counted(static_cast<std::size_t>(present), "point") +
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
        const std::vector<Index>& original = placed_.original;
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
    PlacedPoints placed_;
    std::vector<Index> number_;  // empty if no point is dropped
};

}  // namespace

std::vector<std::string> FixedFile::texts() const {
    std::vector<std::string> all;
    all.reserve(fixes.size());
    for (const AppliedFix& fix : fixes) all.push_back(fix.text);
    return all;
}

Status requireMostLeft(std::span<const Vec3> before, std::span<const Vec3> after,
                       std::span<const std::string> done) {
    const std::size_t places = countPlaces(before);
    const std::size_t left = countPlaces(after);
    const bool emptied = left == 0 && !before.empty();
    if (!emptied && 2 * left >= places) return success();
    const std::string text = joined(done, "; ");
    return Error{"the fixes would leave " + std::to_string(left) + " of " +
                 counted(places, "distinct finite position") +
                 (places == 0 ? "" : ", fewer than half") +
                 (text.empty() ? "" : " (" + text + ")")};
}

FixedFile applyFixes(const PointFile& file, std::span<const Index> alsoDrop,
                     std::string_view reason) {
    assert(checkColumns(file).ok());
    return FixApplication(file).run(alsoDrop, reason);
}

}  // namespace se
