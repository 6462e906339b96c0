#include "spiraling_edge/mesh/fault_fields.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "spiraling_edge/mesh/fidelity.h"

namespace se {
namespace {

void setColumn(PointFile& file, std::string_view name, ScalarType type,
               std::vector<double> values) {
    std::erase_if(file.attributes, [&](const Attribute& each) { return each.name == name; });
    file.attributes.push_back({std::string(name), type, std::move(values)});
}

}  // namespace

std::vector<double> faultNumbers(std::size_t points, std::span<const MeshFailure> failures) {
    std::vector<double> numbers(points, 0.0);
    std::vector<int> severity(points, std::numeric_limits<int>::max());
    for (const MeshFailure& failure : failures) {
        if (!failure.kind->fault) continue;
        const auto number = static_cast<double>(failure.kind - failureClasses().data() + 1);
        for (const Index p : failure.points) {
            assert(p < points);
            if (failure.kind->severity >= severity[p]) continue;
            severity[p] = failure.kind->severity;
            numbers[p] = number;
        }
    }
    return numbers;
}

void setFaultFields(PointFile& file, const PointSet& points, std::span<const Triangle> triangles,
                    std::span<const MeshFailure> failures) {
    assert(file.position.size() == points.size());
    setColumn(file, kFaultField, ScalarType::UInt8, faultNumbers(points.size(), failures));
    // Of the same type as the positions, which it compares.
    setColumn(file, kDistanceField, file.positionType, distancesFromMesh(points, triangles));
}

}  // namespace se
