/// Changes of how the points of a run are prepared: trials make each of them, and the answer about
/// a failure names one that prevents it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se {

/// Number of preparationChanges().
inline constexpr std::size_t kPreparationChanges = 9;
/// Changes of normals, rims and lists, one field each, in the order in which they are tried.
std::vector<SpecChange> preparationChanges();

/// True if a change leaves right normals alone: it derives them only if the given ones do not fit,
/// and turns them only if some of the given ones are flipped.
bool respects(const MeshJudge& judge, const SpecChange& change);

/// The part of a change that a run of `spec` over `file` does not have already.
SpecChange withoutPresent(const SpecChange& change, const RunSpec& spec, const PointFile& file);

/// The points of a run, prepared with one field of its spec changed. They keep their numbers.
struct OtherPreparation {
    FieldValue change;
    /// Nothing if they cannot be prepared so, or if cancelled.
    std::function<std::optional<PointSet>(const Progress&)> points;
};

/// Other preparations of the points of a run, and the judge of the meshes of all.
struct Alternatives {
    std::shared_ptr<const MeshJudge> judge;
    std::vector<OtherPreparation> preparations;
};

/// The preparations of preparationChanges() that differ from that of a run of `spec` over `file`,
/// with PrepareOptions::leaveOut, and leave right normals alone (respects()). None for what-ifs or
/// a given start, which name decisions and triangles of that run. `file` must outlive them.
std::vector<OtherPreparation> otherPreparations(const PointFile& file, const RunSpec& spec,
                                                const MeshJudge& judge,
                                                const std::vector<Index>& leaveOut = {});
/// The otherPreparations() of a run, with the judge of all meshes, which must not be null.
Alternatives alternativesOf(const PointFile& file, const RunSpec& spec,
                            std::shared_ptr<const MeshJudge> judge,
                            const std::vector<Index>& leaveOut = {});

}  // namespace se
