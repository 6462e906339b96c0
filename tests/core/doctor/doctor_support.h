/// Helpers of the doctor's tests.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "spiraling_edge/doctor/doctor.h"
#include "support/clouds.h"
#include "support/oracles.h"

namespace se::test {

inline Diagnosis examined(const PointFile& file) {
    auto diagnosis = examine(file);
    REQUIRE(diagnosis.ok());
    return std::move(diagnosis.value());
}

/// The names of the problems found, each followed by a blank.
inline std::string problemNames(const Diagnosis& diagnosis) {
    std::string names;
    for (const Finding& finding : diagnosis.findings) {
        if (finding.isProblem()) names += std::string(finding.check->name) + " ";
    }
    return names;
}
inline std::string problemNames(const PointFile& file) { return problemNames(examined(file)); }

inline const Finding* findingOf(const Diagnosis& diagnosis, const std::string& name) {
    for (const Finding& finding : diagnosis.findings) {
        if (finding.check->name == name) return &finding;
    }
    return nullptr;
}

/// The finding of this name, which there must be.
inline Finding findingIn(const PointFile& file, const std::string& name) {
    const Diagnosis diagnosis = examined(file);
    const Finding* finding = findingOf(diagnosis, name);
    REQUIRE_MESSAGE(finding != nullptr, name);
    return *finding;
}

/// Checks that the finding of this name has these points, and that there is no other problem.
inline void checkAlone(const PointFile& file, const std::string& name,
                       const std::vector<Index>& points, Severity severity) {
    const Diagnosis diagnosis = examined(file);
    CHECK(problemNames(diagnosis) == (severity == Severity::Note ? "" : name + " "));
    const Finding* finding = findingOf(diagnosis, name);
    REQUIRE_MESSAGE(finding != nullptr, name);
    CHECK(finding->points == points);
    CHECK(finding->severity == severity);
}

/// Even points with gradient normals: 300 on a sphere.
inline PointFile ball(std::uint64_t seed = 1) { return closedFamilies(1.0)[0].sample(seed); }

inline PointFile moved(PointFile file, const Vec3& by, double scale = 1.0) {
    for (Vec3& x : file.position) x = scale * x + by;
    return file;
}

inline void append(PointFile& file, const PointFile& more) {
    file.position.insert(file.position.end(), more.position.begin(), more.position.end());
    file.normal.insert(file.normal.end(), more.normal.begin(), more.normal.end());
    file.type.insert(file.type.end(), more.type.begin(), more.type.end());
}

/// Turns the normals of the points for which `wrong(p)` holds, and returns those points.
template <typename Wrong>
std::vector<Index> turn(PointFile& file, Wrong&& wrong) {
    std::vector<Index> turned;
    for (Index p = 0; p < file.position.size(); ++p) {
        if (!wrong(p)) continue;
        file.normal[p] = -file.normal[p];
        turned.push_back(p);
    }
    return turned;
}

inline std::vector<Index> allOf(const PointFile& file, Index from = 0) {
    std::vector<Index> all;
    for (Index p = from; p < file.position.size(); ++p) all.push_back(p);
    return all;
}

/// side x side points of a plane, one apart, each moved by up to `jitter` within it.
inline PointFile flatLattice(int side, double jitter, std::uint64_t seed = 1) {
    Random random(seed);
    PointFile file;
    file.positionType = ScalarType::Double;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const double dx = random.between(-jitter, jitter);
            file.position.emplace_back(i + dx, j + random.between(-jitter, jitter), 0.0);
            file.normal.emplace_back(0, 0, 1);
        }
    }
    return file;
}

/// The file with the lists of the `k` nearest.
inline PointFile withLists(PointFile file, std::size_t k = 12) {
    const std::vector<bool> usable(file.position.size(), true);
    file.neighbors = findNeighbors(file.position, {}, usable, reach(k, false)).value();
    return file;
}

/// Replaces one list.
inline void setList(PointFile& file, Index p, const std::vector<Index>& list) {
    NeighborLists lists;
    for (Index q = 0; q < file.neighbors.size(); ++q) {
        const auto old = file.neighbors[q];
        lists.append(q == p ? std::span<const Index>(list) : old);
    }
    file.neighbors = std::move(lists);
}
inline std::vector<Index> listOf(const PointFile& file, Index p) {
    const auto list = file.neighbors[p];
    return {list.begin(), list.end()};
}

}  // namespace se::test
