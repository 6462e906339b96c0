/// Opens an input in a thread of its own, up to the first picture of its run, so that the window
/// stays responsive. A cancelled job finishes in the background.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "run/same_position.h"
#include "runner.h"

namespace se::view {

/// The model to draw from a pivot on.
struct MovedModel {
    std::uint32_t from = 0;
    std::shared_ptr<const Model> model;
};

/// An input, and its run at the start; the runner's first answer is ready to be taken.
struct Opened {
    std::shared_ptr<const Model> model;
    std::unique_ptr<Runner> runner;
    std::shared_ptr<const PointFile> file;  ///< As read; null: unchanged.
    /// Reason why each what-if has no effect; an empty text if it has one.
    std::vector<std::string> whatIfs = {};
    /// Models with the points moved by what-ifs, each from a pivot on; for drawing.
    std::vector<MovedModel> moved = {};
    /// Cursor position after a re-run of an open run. The runner has moved there.
    std::optional<SamePosition> place = std::nullopt;
    std::shared_ptr<const PointFile> given = nullptr;  ///< See Loaded; null: unchanged.
};

/// An open run to be re-run, with the position of its cursor.
struct Rerun {
    std::shared_ptr<const Model> model;
    RunSpec spec;
    CursorPosition cursor;
};

class Loader {
  public:
    Loader() = default;
    /// Cancels, and waits until the thread has ended. Reading watches LoadProgress, not the query.
    ~Loader() { cancel(); }
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;

    /// Opens another input; an opening in progress is cancelled.
    void start(const RunSpec& spec);
    /// Opens the same input under other rules or with other what-ifs; points that stay the same are
    /// not prepared again. Fails if a new what-if is refused.
    void start(const RunSpec& spec, const Rerun& rerun);
    void cancel();
    /// An input is being opened, or waits to be taken.
    bool busy() const { return query_.busy(); }
    double share() const { return busy() ? progress_->share.load() : 0.0; }
    LoadPart part() const { return busy() ? progress_->part.load() : LoadPart::Reading; }
    /// The opened input or the error; once.
    std::optional<Result<Opened>> take();
    /// Blocks until there is a result to take.
    void waitUntilDone() { query_.waitUntilDone(); }

  private:
    void start(const RunSpec& spec, std::optional<Rerun> rerun);

    std::shared_ptr<LoadProgress> progress_;  ///< Shared with the thread.
    BackgroundQuery<Opened> query_;
};

}  // namespace se::view
