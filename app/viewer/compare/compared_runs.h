/// The layout Compare: connects its page, the comparison and the drawing of the other run.
/// Independent of window and Dear ImGui.
#pragma once

#include <memory>
#include <utility>

#include "comparison.h"
#include "document/context.h"
#include "document/scene_painter.h"

namespace se::view {

class ComparedRuns {
  public:
    explicit ComparedRuns(CommandContext& context);

    /// Sets the shaders of the second view. To be called before fill().
    void setShaders(std::shared_ptr<Shaders> shaders) { shaders_ = std::move(shaders); }
    /// Sets the counterpart, with which the next open input is compared.
    void beginWith(CompareWith with) { waiting_ = std::move(with); }
    /// Takes the results of the threads. True if there is something new to draw.
    bool poll();
    /// Blocks until no work is in progress.
    void waitUntilDone();
    bool moving() const {
        return comparison_.working() || otherBusy() || (shown_ && painter_->unfinished());
    }

    void begin(CompareWith with);
    /// Compares with the most informative rules beside those of the run.
    void beginUsual();
    void stop();
    /// The open run and the other run change places.
    void swap();
    /// Both runs go to the first decision in which they differ, or to the first that differs
    /// without a consequence.
    void toFirstDifference();
    void toFirstHarmless();
    void goTo(const ComparedAddresses& addresses);
    void showRegion(std::size_t number);
    void toNextRegion() { stepRegion(1); }
    void toPreviousRegion() { stepRegion(-1); }
    /// Asks both runs.
    void askWhy(const Selection& what);

    /// Colors of the difference in the view of the open run; null: none.
    const DifferenceLook* look();
    /// Makes the list of the second view. Call with a current OpenGL context.
    void fill(bool onPaper);
    /// As ScenePainter::draw().
    bool draw(const Rect& view, float em);
    /// As ScenePainter::late().
    bool late() const { return shown_ && painter_->late(); }
    /// True if the second view has something to show.
    bool shows() const { return shown_; }
    const DrawList& list() const { return painter_->list(); }
    unsigned texture() const { return painter_->texture(); }
    /// The other run; null if there is none, or a file.
    Session* other() { return comparison_.other(); }
    const Comparison& comparison() const { return comparison_; }

  private:
    bool otherBusy() const;
    bool inLayout() const { return c_.ui.compare.isIn(c_.ui.layoutPreset); }
    void rememberBefore();
    void reportRefusal();
    void fillFile(const DifferenceLook* look);
    void goToTraced(const std::optional<teach::TraceDifference>& difference);
    void shareSelection();
    void shareNames();
    void takeResult();
    void makeShades();
    void start(CompareWith with);
    bool isReady();
    void stepRegion(int direction);
    void toDifference(const std::optional<RunDifference>& difference, const char* nothing);
    std::vector<Triangle> ghostsOf(const std::vector<Index>& region,
                                   const std::vector<Triangle>& mesh) const;

    CommandContext& c_;
    Comparison comparison_;
    std::optional<CompareWith> waiting_;
    std::string reportedRefusal_;
    std::shared_ptr<Shaders> shaders_;
    std::unique_ptr<ScenePainter> painter_;
    bool shown_ = false;
    std::optional<DecisionState> tracedState_;  ///< Of the trace in shaded_, at tracedAt_.
    TracePosition tracedAt_;
    std::shared_ptr<const Compared> shaded_;  ///< Comparison that the colors are of.
    std::array<DifferenceShade, 2> shades_;
    std::array<std::vector<Triangle>, 2> ghosts_;  ///< For the views of A and B.
    std::array<DifferenceLook, 2> looks_;
    std::uint32_t lookRevision_ = 0;
    Theme theme_ = Theme::Dark;
    Selection selected_{};
    std::uint32_t generation_ = 0;
    std::optional<RunSpec> spec_;  ///< Options of the run that was open before.
};

}  // namespace se::view
