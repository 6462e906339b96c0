/// What there is to say about the thing picked, as numbers: for Inspect and the picture.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "run/overview.h"
#include "run/picture.h"
#include "run/selection.h"

namespace se::view {

class Session;

struct SelectionFacts {
    bool present = false;  ///< There at the cursor.
    // Of an edge.
    double length = 0.0;  ///< Scene units.
    std::string ring;     ///< "active ring", "stacked ring #2"; empty: on none at the cursor.
    /// Numbers of the triangles at the edge, as far as the run is known; those at the cursor first.
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

/// The facts of a session's selection, worked out anew only when something changed; of two
/// sessions in turn, as two that are compared ask.
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
/// The decision that made it: `137.emit.3`.
std::optional<Address> birthOfTriangle(const RunOverview& run, std::size_t number);

}  // namespace se::view
