/// The open input, and the one that is being opened.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jobs/background_job.h"
#include "jobs/runner.h"
#include "moves.h"
#include "run/model.h"
#include "spiraling_edge/spec/run_spec.h"

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

enum class SessionPhase : std::uint8_t { Empty, Loading, Ready, Failed };

/// Opens an input in a thread of its own, up to the first picture of its run, so that the window
/// stays responsive. A cancelled job finishes in the background.
class SessionInput {
  public:
    using Clock = std::chrono::steady_clock;

    SessionInput() = default;
    /// Cancels, and waits until the thread has ended. Reading watches LoadProgress, not the query.
    ~SessionInput() { cancel(); }
    SessionInput(const SessionInput&) = delete;
    SessionInput& operator=(const SessionInput&) = delete;

    SessionPhase phase() const { return phase_; }
    double loadShare() const { return query_.busy() ? progress_->share.load() : 0.0; }
    LoadPart loadPart() const { return query_.busy() ? progress_->part.load() : LoadPart::Reading; }
    /// Why the last opening failed.
    const std::string& error() const { return error_; }
    /// Specification of the open input.
    const RunSpec& spec() const { return spec_; }
    /// Specification of the last opening, which may have failed.
    const RunSpec& opening() const { return opening_; }
    /// The spec with the rules of the open input, or of the one that is being opened.
    const RunSpec& rules() const { return isRerunning() ? opening_ : spec_; }
    /// Reason why a what-if of spec() has no effect; empty if it has one.
    const std::string& whatIfProblem(std::size_t i) const;
    /// Input of prepare(), with which a mesh is written.
    std::shared_ptr<const PointFile> file() const { return file_; }

    /// The last opening is a re-run of the open input.
    bool isRerun() const { return isRerun_; }
    /// The open input is being re-run.
    bool isRerunning() const { return isRerun_ && phase_ == SessionPhase::Loading; }
    /// Seconds since the re-run began.
    double rerunSeconds() const;

    // Changes, by the session.
    /// Opens another input; an opening in progress is cancelled.
    void open(RunSpec spec);
    /// Opens the same input under other rules or with other what-ifs; points that stay the same are
    /// not prepared again. Fails if a new what-if is refused.
    void rerun(const RunSpec& rules, std::shared_ptr<const Model> model, CursorPosition cursor);
    /// Cancels an opening in progress: what is open stays.
    void cancel();
    /// Returns to the input that was open before, or to none.
    void dismiss(bool ready) { phase_ = ready ? SessionPhase::Ready : SessionPhase::Empty; }
    void fail(std::string why);
    /// The opened input, or the error; once.
    std::optional<Result<Opened>> take();
    /// The input that was being opened is open.
    void adopt(Opened& opened);
    /// Blocks until there is a result to take.
    void waitUntilDone() { query_.waitUntilDone(); }

  private:
    void start(RunSpec spec, std::optional<Rerun> rerun);

    RunSpec spec_;
    RunSpec opening_;
    SessionPhase phase_ = SessionPhase::Empty;
    std::string error_;
    bool isRerun_ = false;
    Clock::time_point rerunSince_;
    std::vector<std::string> whatIfProblems_;
    std::shared_ptr<const PointFile> file_;
    std::shared_ptr<LoadProgress> progress_;  ///< Shared with the thread.
    BackgroundQuery<Opened> query_;
};

}  // namespace se::view
