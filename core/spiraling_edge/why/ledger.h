/// The ledger: why a point, an edge or a triangle is in the mesh, or why not. Found by running
/// again and keeping the events about the subject; no log of a whole run is ever stored.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/spec/spec_fields.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se {

/// The subject of a query: one point, the two of an edge, or the three of a triangle, in any order.
class Subject {
  public:
    static Subject point(Index p) { return Subject({p, kNone, kNone}, 1); }
    static Subject edge(Index a, Index b) { return Subject({a, b, kNone}, 2); }
    static Subject triangle(Index a, Index b, Index c) { return Subject({a, b, c}, 3); }

    std::span<const Index> points() const { return {points_.data(), size_}; }
    std::size_t size() const { return size_; }
    Index operator[](std::size_t i) const { return points_[i]; }
    /// Position of p among the points, size() if it is none of them.
    std::size_t find(Index p) const;
    bool has(Index p) const { return find(p) < size_; }

  private:
    Subject(std::array<Index, 3> points, std::size_t size) : points_(points), size_(size) {}

    std::array<Index, 3> points_;
    std::size_t size_;
};
/// "point 812", "edge 812-640", "triangle (1, 2, 3)".
std::string nameOf(const Subject& subject);

/// True if the mesh has the subject: a point in some triangle, an edge, or the triangle in either
/// winding. O(triangles).
bool isInMesh(std::span<const Triangle> mesh, const Subject& subject);

/// The kinds of proof of an answer (proof.h).
enum class ProvedBy : std::uint8_t {
    Nothing,      ///< Not proved.
    Inversion,    ///< With the decision inverted the answer is another.
    Step,         ///< A step after the last pivot made or removed the subject.
    Preparation,  ///< It was set aside before the run, or no list names it.
};
/// "nothing", "inversion", "step", "preparation".
std::string_view provedByName(ProvedBy by);

/// The answer to a query about a subject, a failure or a ring.
struct Ledger {
    std::string name;      ///< "point 812", "hole of points 6, 63 and 98", "ring #2 at 137".
    bool present = false;  ///< In the mesh at the end of the run; a failure: true.
    std::string_view where = "in the mesh";  ///< "in the run" of a ring left over.
    std::vector<LedgerLine> lines = {};      ///< In the order of the run.
    /// Position of the deciding line: the one that made the subject, or the last that prevented it;
    /// where the answer is proved, the decision of its proof. Always below lines.size().
    std::size_t cause = 0;
    std::string words = {};   ///< One sentence: the cause.
    std::string answer = {};  ///< One or two sentences that end with the address of the cause.
    /// why() sets only Step and Preparation, provedWhy() also Inversion.
    ProvedBy provedBy = ProvedBy::Nothing;
    /// The what-ifs under which the answer is another: that of the cause, or two of one pivot.
    std::vector<WhatIf> inversions = {};
    /// The rule that is off as well then, since its steps after the last pivot undo them; or null.
    const RuleSetting* undoneBy = nullptr;
    /// The rule or the preparation that prevents a failure, or brings an absent subject in
    /// (addPrevention()). Nothing: none was found, or none was looked for.
    std::optional<FieldValue> preventedBy = {};
};

/// The lines about a subject of one pivot of a run, in order.
std::vector<LedgerLine> linesAt(const PointSet& points, const Params& params,
                                const Subject& subject, const SweptPivot& pivot);

/// The answer of a ledger in words: "Point 812 is not in the mesh", what is said between, and its
/// cause with its address.
std::string answerText(const Ledger& ledger, std::string_view between = ". ");

/// The question why the subject is in the mesh of a run, or why it is not. Fails if its points are
/// not all different and below points.size(). O(run); 43,000 points take a few tenths of a second.
/// Deterministic.
Result<Question<Ledger>> whyQuestion(const PointSet& points, const Params& params,
                                     const Subject& subject);
/// The answer to whyQuestion(). Fails also if cancelled.
Result<Ledger> why(const PointSet& points, const Params& params, const Subject& subject,
                   const Progress& progress = {});

}  // namespace se
