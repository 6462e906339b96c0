/// The mesh at the end of a run with its points, and its file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/model.h"
#include "runner.h"

namespace se::view {

/// Destination of a mesh, and the choice of its points.
struct MeshTarget {
    std::string path;          ///< Its extension names the format (core's write_mesh.h).
    bool usedOnly = false;     ///< Without the points that are in no triangle.
    bool faultFields = false;  ///< With core's setFaultFields(), where the format holds columns.

    bool writesFaultFields() const;
};

/// The mesh at the end of a run, and the points that it is written with.
struct FinishedMesh {
    std::shared_ptr<const PointFile> points;  ///< Those of the input, with what was derived.
    std::shared_ptr<const std::vector<Triangle>> triangles;
    std::size_t usedPoints = 0;
    bool capped = false;  ///< Stopped at more triangles than a surface can have (rule `cap`).

    /// Number of points that are written.
    std::size_t pointsFor(const MeshTarget& target) const {
        return target.usedOnly ? usedPoints : points->position.size();
    }
};

/// A file that was written.
struct SavedMesh {
    MeshTarget target;
    std::size_t triangles = 0;
    std::size_t points = 0;
    bool capped = false;
    /// The offset that positions in the file are relative to, see shiftOf().
    std::optional<Vec3> shift = std::nullopt;
};

/// The mesh that `spiraling-edge run` makes of the same input with the same options: that of the
/// end of the run, with its points.
FinishedMesh finishMesh(const Model& model, const PointFile& input,
                        const std::shared_ptr<const RunEnd>& end);
/// Writes the mesh that `model` ends with as `spiraling-edge run -o` does. Fails with a sentence
/// that names the file.
Result<SavedMesh> saveMesh(const Model& model, const FinishedMesh& mesh, const MeshTarget& target);

}  // namespace se::view
