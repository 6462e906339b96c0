/// The open input, and the one that is being opened.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jobs/loader.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

enum class SessionPhase : std::uint8_t { Empty, Loading, Ready, Failed };

class SessionInput {
  public:
    using Clock = std::chrono::steady_clock;

    SessionPhase phase() const { return phase_; }
    double loadShare() const { return loader_.share(); }
    LoadPart loadPart() const { return loader_.part(); }
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
    void open(RunSpec spec);
    void rerun(const RunSpec& rules, std::shared_ptr<const Model> model, CursorPosition cursor);
    void cancel() { loader_.cancel(); }
    /// Returns to the input that was open before, or to none.
    void dismiss(bool ready) { phase_ = ready ? SessionPhase::Ready : SessionPhase::Empty; }
    void fail(std::string why);
    /// The opened input, or the error; once.
    std::optional<Result<Opened>> take() { return loader_.take(); }
    /// The input that was being opened is open.
    void adopt(Opened& opened);
    void waitUntilDone() { loader_.waitUntilDone(); }

  private:
    void start(RunSpec spec, bool rerun);

    RunSpec spec_;
    RunSpec opening_;
    SessionPhase phase_ = SessionPhase::Empty;
    std::string error_;
    bool isRerun_ = false;
    Clock::time_point rerunSince_;
    std::vector<std::string> whatIfProblems_;
    std::shared_ptr<const PointFile> file_;
    Loader loader_;
};

}  // namespace se::view
