/// Measures of the selection: for Inspect and the picture.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "run/overview.h"
#include "run/selection.h"

namespace se::view {

class Session;

struct SelectionFacts {
    bool present = false;  ///< Present at the cursor.
    // Of an edge.
    double length = 0.0;  ///< Scene units.
    std::string ring;     ///< "a, active", "b, on the stack"; empty: on none at the cursor.
    /// Numbers of the triangles at the edge, among the triangles known so far; those at the cursor
    /// first.
    std::vector<std::uint32_t> triangles;
    std::size_t trianglesPresent = 0;
    // Of a triangle.
    std::array<double, 3> degrees{};  ///< At its corners.
    double area = 0.0;
    /// Of the triangle, or the first one at the edge; none if no triangle is known.
    std::optional<std::uint32_t> number;
};

/// Requires session.ready(). Costs a walk along the rings for an edge.
SelectionFacts factsOf(const Session& session, const Selection& selection);

/// The facts of a session's selection, recomputed only when something changed; also for two
/// sessions in turn, as in a comparison.
class FactsCache {
  public:
    const SelectionFacts& of(const Session& session);

  private:
    struct Known {
        const Session* session = nullptr;
        std::uint32_t revision = 0;
        SelectionFacts facts;
    };
    std::array<Known, 2> known_;
};

/// The pivot that made triangle `number`, if the run is known so far.
std::optional<std::uint32_t> pivotOfTriangle(const RunOverview& run, std::size_t number);
/// The decision that made the triangle: `137.emit.3`.
std::optional<Address> originOfTriangle(const RunOverview& run, std::size_t number);

}  // namespace se::view
