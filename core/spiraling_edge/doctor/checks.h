/// The checks of the doctor, in the order of the table in doctor.cpp.
#pragma once

#include "spiraling_edge/doctor/examined_file.h"

namespace se {

// point_checks.cpp: single points
std::optional<Finding> findNonFinite(const Patient& patient);
std::optional<Finding> findDuplicates(const Patient& patient);
std::optional<Finding> findTooFewPoints(const Patient& patient);

// spacing_checks.cpp: distances between points
std::optional<Finding> findNearDuplicates(const Patient& patient);
std::optional<Finding> findIsolatedPoints(const Patient& patient);
std::optional<Finding> findInLine(const Patient& patient);
std::optional<Finding> findUnevenSpacing(const Patient& patient);
std::optional<Finding> findTies(const Patient& patient);

// normal_checks.cpp
std::optional<Finding> findNoNormals(const Patient& patient);
std::optional<Finding> findZeroNormals(const Patient& patient);
std::optional<Finding> findUnscaledNormals(const Patient& patient);
std::optional<Finding> findCloseSheets(const Patient& patient);

// side_checks.cpp: normals against each other
std::optional<Finding> findFlippedNormals(const Patient& patient);
std::optional<Finding> findInsideOut(const Patient& patient);

// list_checks.cpp: neighbor lists in the file
std::optional<Finding> findEntriesOutside(const Patient& patient);
std::optional<Finding> findRepeatedEntries(const Patient& patient);
std::optional<Finding> findUnsortedLists(const Patient& patient);
std::optional<Finding> findShortLists(const Patient& patient);
std::optional<Finding> findUnsymmetricLists(const Patient& patient);
/// True if the list of p is ordered by distance, up to the rounding of floats. Points that do not
/// exist, or have no finite position, are ignored.
bool isNearestFirst(std::span<const Vec3> position, Index p, std::span<const Index> list);

// type_checks.cpp
std::optional<Finding> findCornerBits(const Patient& patient);
std::optional<Finding> findTypesOffBox(const Patient& patient);

// border_checks.cpp
std::optional<Finding> findOpenBorder(const Patient& patient);

}  // namespace se
