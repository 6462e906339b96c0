/// Opens an input in a thread of its own, up to the first picture of its run, so that the window
/// stays responsive. A cancelled job finishes in the background.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "model.h"
#include "runner.h"
#include "same_place.h"

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
    std::optional<SamePlace> place = std::nullopt;
    std::shared_ptr<const PointFile> given = nullptr;  ///< See Loaded; null: unchanged.
};

/// An open run to be re-run, with the position of its cursor.
struct RunAnew {
    std::shared_ptr<const Model> model;
    InputSpec spec;
    CursorPlace cursor;
};

class Loader {
  public:
    Loader() = default;
    /// Cancels, and waits until all threads have ended.
    ~Loader();
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;

    /// Opens another input; an opening in progress is cancelled.
    void begin(const InputSpec& spec);
    /// Opens the same input under other rules or with other what-ifs; points that stay the same are
    /// not prepared again. Fails if a new what-if is refused.
    void begin(const InputSpec& spec, const RunAnew& anew);
    void cancel();
    /// An input is being opened, or waits to be taken.
    bool busy() const { return job_ != nullptr; }
    double share() const { return job_ ? job_->progress.share.load() : 0.0; }
    LoadPart part() const { return job_ ? job_->progress.part.load() : LoadPart::Reading; }
    /// The opened input or the error; once.
    std::optional<Result<Opened>> take();
    /// Blocks until there is a result to take.
    void finish();

  private:
    struct Job {
        InputSpec spec;
        std::optional<RunAnew> anew;
        LoadProgress progress;
        std::atomic<bool> done = false;
        std::optional<Result<Opened>> result;
        std::jthread thread;  // last: it uses all members above
    };
    void begin(const InputSpec& spec, std::optional<RunAnew> anew);
    static Result<Opened> work(Job& job);

    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> cancelled_;  ///< Until they have ended.
};

}  // namespace se::view
