/// Reduction of an input to a minimal failing case.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/spec/run_spec.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// A reduced input.
struct Reduced {
    PointFile file;
    std::vector<Index> kept;  ///< Numbers in the input, ascending.
    std::size_t tries = 0;    ///< Number of calls of `fails`.
    bool complete = true;     ///< False: the effort was used up; fewer points may fail, too.
};

/// The outcome of one try.
struct ReduceTry {
    bool fails = false;
    std::uint64_t work = 0;  ///< Cost of the try, in the unit of the effort.
};

/// Test of a piece of the input.
using ReduceTest = std::function<ReduceTry(const PointFile&)>;

/// A reduction that advances by one try, so that a caller can do other things between two. It
/// removes points while `fails` holds: first all but the ball about `place` that still fails, then
/// piece by piece and point by point (delta debugging, Zeller and Hildebrandt 2002), until no
/// single point can be removed. Once the tries have taken `effort` together, no more are made: the
/// result is the best so far, possibly the whole input; tries without work use up no effort. `file`
/// must come from applyFixes(). Deterministic if `fails` is.
class Reduction {
  public:
    Reduction(PointFile file, const Vec3& place, ReduceTest fails, std::uint64_t effort);

    /// Makes the next try. False if there is none left.
    bool advance();
    /// In [0, 1], by the points left.
    double share() const;
    /// The smallest piece that failed so far. Fails if the whole input does not fail.
    Result<Reduced> result() const;

  private:
    enum class Step : std::uint8_t { Whole, Ball, Pieces, Done };

    PointFile subset(const std::vector<Index>& points) const;
    bool stillFails(const std::vector<Index>& points);
    void tryWhole();
    void tryBall();
    void tryPiece();

    PointFile file_;
    ReduceTest fails_;
    std::uint64_t left_;       ///< Remaining effort.
    std::vector<Index> kept_;  ///< By distance from the place, so that a piece is a connected part.
    Step step_ = Step::Whole;
    double ball_ = 8.0;      ///< Number of points of the next ball.
    std::size_t piece_ = 0;  ///< Number of points of a piece.
    std::size_t end_ = 0;    ///< Of the next piece in kept_.
    bool changed_ = false;   ///< A piece of that size was removed.
    std::size_t tries_ = 0;
    bool failed_ = false;  ///< The whole input.
    bool exhausted_ = false;
};

/// Runs a Reduction to its end. `progress` gets its share before each try; it fails if cancelled.
Result<Reduced> reduceInput(const PointFile& file, const Vec3& place, const ReduceTest& fails,
                            std::uint64_t effort, const Progress& progress = {});

/// Effort of reductions by default: about a minute where runs get tangled. In tests of two points
/// or two triangles, as failsAlike() counts them.
inline constexpr std::uint64_t kReduceEffort = 3'000'000'000;

/// A test whether fewer points, prepared and run as `spec` says, end in a failure like `failure` of
/// the mesh of `points`: of its class; a loop, with the same points, since removed points leave a
/// border; triangles back to back, if that one has them (isBackToBack()).
ReduceTest failsAlike(const RunSpec& spec, const Params& params, const PointSet& points,
                      const MeshFailure& failure, std::span<const Triangle> mesh);

/// True if the triangles of a failure are two with the same three points, apart from the rest of
/// the mesh: any three points alone give these, whatever failed before.
bool isBackToBack(const MeshFailure& failure, std::span<const Triangle> mesh);

}  // namespace se
