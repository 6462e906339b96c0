#include "mesh_export.h"

#include <span>

#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/fault_fields.h"
#include "spiraling_edge/points/usable_points.h"

namespace se::view {

bool MeshTarget::writesFaultFields() const {
    const MeshFormat* format = meshFormatOf(path);
    return faultFields && format != nullptr && keepsColumns(*format);
}

FinishedMesh finishMesh(const Model& model, const PointFile& input,
                        const std::shared_ptr<const RunEnd>& end) {
    PointFile points = input;
    storeDerived(model.points, model.report, points);
    FinishedMesh mesh;
    mesh.points = std::make_shared<const PointFile>(std::move(points));
    mesh.triangles = std::shared_ptr<const std::vector<Triangle>>(end, &end->mesh);
    mesh.usedPoints = countUsedPoints(model.points.size(), end->mesh);
    mesh.capped = end->capped;
    return mesh;
}

namespace {

/// The points to write, with the columns of faults if they are wanted and the format holds them.
std::shared_ptr<const PointFile> pointsFor(const Model& model, const FinishedMesh& mesh,
                                           const MeshTarget& target) {
    if (!target.writesFaultFields()) return mesh.points;
    PointFile points = *mesh.points;
    setFaultFields(points, model.points, *mesh.triangles,
                   inspectMesh(model.points, *mesh.triangles));
    return std::make_shared<const PointFile>(std::move(points));
}

}  // namespace

Result<SavedMesh> saveMesh(const Model& model, const FinishedMesh& mesh, const MeshTarget& target) {
    SavedMesh saved{target, mesh.triangles->size(), mesh.pointsFor(target), mesh.capped};
    const std::shared_ptr<const PointFile> all = pointsFor(model, mesh, target);
    const auto write = [&](const PointFile& points,
                           std::span<const Triangle> triangles) -> Result<SavedMesh> {
        const Status written = writeMesh(target.path, points, triangles);
        if (!written) return written.error();
        saved.shift = shiftOf(*meshFormatOf(target.path), points, triangles);
        return saved;
    };
    if (!target.usedOnly) return write(*all, *mesh.triangles);
    const PointFile used = withUsedPoints(*all, *mesh.triangles);
    return write(used, used.faces);
}

}  // namespace se::view
