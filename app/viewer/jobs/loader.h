/// Opens an input in a thread of its own, up to the first picture of its run: whatever that costs,
/// the window stays awake. What is cancelled is left to itself; nobody waits for it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "background_query.h"
#include "run/model.h"
#include "run/same_position.h"
#include "runner.h"

namespace se::view {

/// What is to be drawn from a pivot on.
struct MovedModel {
    std::uint32_t from = 0;
    std::shared_ptr<const Model> model;
};

/// An input, and its run at the start: the runner's first answer is there to be taken.
struct Opened {
    std::shared_ptr<const Model> model;
    std::unique_ptr<Runner> runner;
    std::shared_ptr<const PointFile> file;  ///< As it was read; null: as it was before.
    /// Why a what-if has no effect, one for each; empty texts: it has.
    std::vector<std::string> whatIfs = {};
    /// The model as what-ifs move its points, each from a pivot on: for drawing.
    std::vector<MovedModel> moved = {};
    /// If an open run was begun anew: where its cursor belongs. The runner has gone there.
    std::optional<SamePlace> place = std::nullopt;
    std::shared_ptr<const PointFile> given = nullptr;  ///< See Loaded; null: as it was before.
};

/// What is begun anew, with the place of its cursor.
struct RunAnew {
    std::shared_ptr<const Model> model;
    InputSpec spec;
    CursorPlace cursor;
};

class Loader {
  public:
    /// Opens another input; what was being opened is cancelled.
    void begin(const InputSpec& spec);
    /// Opens the same input under other rules or with other what-ifs; points that stay as they are
    /// are not made again. Fails if a new what-if is refused.
    void begin(const InputSpec& spec, const RunAnew& anew);
    void cancel();
    /// Something is being opened, or waits to be taken.
    bool busy() const { return query_.busy(); }
    double share() const { return busy() ? progress_->share.load() : 0.0; }
    LoadPart part() const { return busy() ? progress_->part.load() : LoadPart::Reading; }
    /// What was opened, or why not; once.
    std::optional<Result<Opened>> take();
    /// Blocks until there is something to take.
    void finish() { query_.finish(); }

  private:
    void begin(const InputSpec& spec, std::optional<RunAnew> anew);

    std::shared_ptr<LoadProgress> progress_;  ///< Shared with the thread.
    Inquiry<Opened> query_;
};

}  // namespace se::view
