#include "session_input.h"

#include <utility>

namespace se::view {

const std::string& SessionInput::whatIfProblem(std::size_t i) const {
    static const std::string none;
    return i < whatIfProblems_.size() ? whatIfProblems_[i] : none;
}

double SessionInput::rerunSeconds() const {
    return std::chrono::duration<double>(Clock::now() - rerunSince_).count();
}

void SessionInput::start(RunSpec spec, bool rerun) {
    isRerun_ = rerun;
    opening_ = std::move(spec);
    error_.clear();
    phase_ = SessionPhase::Loading;
}

void SessionInput::open(RunSpec spec) {
    start(std::move(spec), false);
    loader_.start(opening_);
}

void SessionInput::rerun(const RunSpec& rules, std::shared_ptr<const Model> model,
                         CursorPosition cursor) {
    rerunSince_ = Clock::now();
    start(withRulesOf(spec_, rules), true);
    loader_.start(opening_, {std::move(model), spec_, cursor});
}

void SessionInput::fail(std::string why) {
    error_ = std::move(why);
    phase_ = SessionPhase::Failed;
}

void SessionInput::adopt(Opened& opened) {
    spec_ = opening_;
    whatIfProblems_ = std::move(opened.whatIfs);
    if (opened.given) file_ = std::move(opened.given);
    phase_ = SessionPhase::Ready;
}

}  // namespace se::view
