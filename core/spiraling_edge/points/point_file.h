/// The content of a point file of any format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The scalar types of files. The last two occur in files alone, not in a PointFile: no double
/// holds all of their numbers.
enum class ScalarType : std::uint8_t {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float,
    Double,
    Int64,
    UInt64
};

/// A per-point column that the algorithm does not use but that output keeps.
struct Attribute {
    std::string name;
    ScalarType type = ScalarType::Float;
    std::vector<double> values;  ///< One per point; the types of a PointFile fit a double exactly.
};

/// The meaning of the columns of a file without a header for them (XYZ).
struct ColumnReading {
    std::string names;   ///< "x y z red green blue"; empty for other formats.
    std::string reason;  ///< The evidence, in words; empty for x, y and z alone.
};

/// The meaning of coordinates far off all others (sentinels.h).
enum class FarValues : std::uint8_t {
    Missing,  ///< Where a value was missing: those points are set aside.
    Real,     ///< Places, like all others.
};

/// The unmodified content of a point file: nothing repaired, nothing normalized, nothing dropped.
/// `prepare.h` turns it into a PointSet that the stepper accepts.
struct PointFile {
    std::vector<Vec3> position;
    /// Float or Double: how positions are written, so that no digit is lost. Text formats without
    /// types and PLY with other scalar types read as Double.
    ScalarType positionType = ScalarType::Float;
    std::vector<Vec3> normal;                   ///< Empty where the file has none.
    ScalarType normalType = ScalarType::Float;  ///< As positionType.
    std::vector<std::uint8_t> type;             ///< Empty where the file has none.
    NeighborLists neighbors;                    ///< size() == 0 where the file has none.
    std::vector<Triangle> faces;  ///< Polygons are split into fans. Empty for plain points.
    std::vector<Attribute> attributes;
    ColumnReading columns;
    /// Place of the sensor, if the file names one: the side of open sheets is known by it.
    std::optional<Vec3> viewpoint;
    FarValues farValues = FarValues::Missing;  ///< At the user's word.
    /// Sentences without a period on what was read in a way of its own, or left out: "line 1 is the
    /// number of points".
    std::vector<std::string> notes;

    bool hasNormals() const { return !normal.empty(); }
    bool hasTypes() const { return !type.empty(); }
    bool hasNeighbors() const { return neighbors.size() > 0; }
};

}  // namespace se
