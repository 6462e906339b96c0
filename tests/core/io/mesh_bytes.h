/// Positions from written STL and GLB, read by the specifications of the formats.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "spiraling_edge/io/read_points.h"

namespace se::test {

inline std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < 4; ++i) {
        word |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + i))} << (8 * i);
    }
    return word;
}
inline float floatAt(const std::string& bytes, std::size_t at) {
    const std::uint32_t word = wordAt(bytes, at);
    float value = 0.0F;
    std::memcpy(&value, &word, sizeof value);
    return value;
}
inline Vec3 vectorAt(const std::string& bytes, std::size_t at) {
    return {floatAt(bytes, at), floatAt(bytes, at + 4), floatAt(bytes, at + 8)};
}

/// The place in the header of an STL file that its positions are relative to; 0 if it names none.
inline Vec3 shiftInHeader(const std::string& stl) {
    Vec3 shift(0.0);
    const std::string header = stl.substr(0, 80);
    const std::size_t at = header.find("add ");
    if (at == std::string::npos) return shift;
    REQUIRE(std::sscanf(header.c_str() + at, "add %lf %lf %lf", &shift.x, &shift.y, &shift.z) == 3);
    return shift;
}

/// The corners of all triangles of an STL file, in the coordinates of the input.
inline std::vector<Vec3> stlCorners(const std::string& stl) {
    const Vec3 shift = shiftInHeader(stl);
    std::vector<Vec3> corners;
    for (std::size_t row = 84; row < 84 + 50 * std::size_t{wordAt(stl, 80)}; row += 50) {
        for (std::size_t i = 0; i < 3; ++i)
            corners.push_back(shift + vectorAt(stl, row + 12 + 12 * i));
    }
    return corners;
}

/// The first `count` positions of a GLB file: those of its buffer plus the translation of the node.
inline std::vector<Vec3> glbPositions(const std::string& glb, std::size_t count) {
    const std::size_t json = wordAt(glb, 12);
    const std::string text = glb.substr(20, json);
    Vec3 place(0.0);
    const std::size_t at = text.find("\"translation\":");
    REQUIRE(at != std::string::npos);
    REQUIRE(std::sscanf(text.c_str() + at, "\"translation\":[%lf,%lf,%lf]", &place.x, &place.y,
                        &place.z) == 3);
    std::vector<Vec3> positions;
    for (std::size_t p = 0; p < count; ++p)
        positions.push_back(place + vectorAt(glb, 28 + json + 12 * p));
    return positions;
}

}  // namespace se::test
