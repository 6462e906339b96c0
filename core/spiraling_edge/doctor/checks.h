/// The checks of the doctor, in the order of the table in doctor.cpp.
#pragma once

#include "spiraling_edge/doctor/examined_file.h"

namespace se {

// point_checks.cpp: single points
std::optional<Finding> findNonFinite(const ExaminedFile& examined);
std::optional<Finding> findDuplicates(const ExaminedFile& examined);
std::optional<Finding> findTooFewPoints(const ExaminedFile& examined);

// spacing_checks.cpp: distances between points
std::optional<Finding> findNearDuplicates(const ExaminedFile& examined);
std::optional<Finding> findIsolatedPoints(const ExaminedFile& examined);
std::optional<Finding> findInLine(const ExaminedFile& examined);
std::optional<Finding> findUnevenSpacing(const ExaminedFile& examined);
std::optional<Finding> findTies(const ExaminedFile& examined);

// normal_checks.cpp
std::optional<Finding> findNoNormals(const ExaminedFile& examined);
std::optional<Finding> findZeroNormals(const ExaminedFile& examined);
std::optional<Finding> findUnscaledNormals(const ExaminedFile& examined);
std::optional<Finding> findCloseSheets(const ExaminedFile& examined);

// side_checks.cpp: normals against each other
std::optional<Finding> findFlippedNormals(const ExaminedFile& examined);
std::optional<Finding> findInsideOut(const ExaminedFile& examined);

// list_checks.cpp: neighbor lists in the file
std::optional<Finding> findEntriesOutside(const ExaminedFile& examined);
std::optional<Finding> findRepeatedEntries(const ExaminedFile& examined);
std::optional<Finding> findUnsortedLists(const ExaminedFile& examined);
std::optional<Finding> findShortLists(const ExaminedFile& examined);
std::optional<Finding> findUnsymmetricLists(const ExaminedFile& examined);
/// True if the list of p is ordered by distance, up to the rounding of floats. Points that do not
/// exist, or have no finite position, are ignored.
bool isNearestFirst(std::span<const Vec3> position, Index p, std::span<const Index> list);

// type_checks.cpp
std::optional<Finding> findCornerBits(const ExaminedFile& examined);
std::optional<Finding> findTypesOffBox(const ExaminedFile& examined);

// border_checks.cpp
std::optional<Finding> findOpenBorder(const ExaminedFile& examined);

}  // namespace se
