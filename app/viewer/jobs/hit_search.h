/// Hits of the breakpoint lines, searched in a thread of its own: one run for all new lines.
/// Results are kept until another run is open.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kept_pass.h"
#include "run/model.h"
#include "spiraling_edge/run/breakpoint.h"

namespace se::view {

/// Maximum number of hits of a log-only line that keep their sentences.
inline constexpr std::size_t kMaxLogged = 10000;

/// Results for a line.
struct LineHits {
    HitList list;
    /// The sentences of the first hits; fewer than hits if the line is not a log-only one.
    std::vector<std::string> sentences;
    /// Nothing is missing up to this pivot.
    std::uint32_t knownTo = 0;
    bool complete = false;
};

/// The pivots with hits that the breakpoint picks, at most one for each of `columns` stretches of
/// the range from `window.first` to `window.second`; for marks. O(columns log hits).
std::vector<std::uint32_t> stopPivots(const Breakpoint& breakpoint, const HitList& list,
                                      std::pair<double, double> window, std::size_t columns);

/// A hit of a line of the search in progress.
struct FoundHit {
    std::size_t line;
    se::Hit hit;
    std::string sentence;
};

/// The lines of enabled breakpoints are searched.
class HitSearch : public KeptPass<Breakpoint, LineHits, FoundHit> {
  public:
    bool poll() override;
    void cancel() override;

    /// Whether the result of stop() is final.
    enum class Known : std::uint8_t { Yes, NotYet, GivenUp };
    struct Answer {
        Known known = Known::Yes;
        std::optional<Stop> stop;  ///< Its breakpoint is the position in the wanted list.
    };
    /// The next (1) or previous (-1) stop from `here`.
    Answer stop(RunPosition here, int direction) const;

  private:
    struct Line {
        std::string text;
        DecisionQuery query;
        bool listed = false;  ///< Lines with sentences.
    };
    static PivotVisitor visitorFor(const Model& model, const std::vector<Line>& lines,
                                   BackgroundJob<FoundHit>::Results& results);
    std::vector<Line> missing() const;
    void startNext() override;
    bool take();

    std::vector<Line> sought_;  ///< Current search.
};

}  // namespace se::view
