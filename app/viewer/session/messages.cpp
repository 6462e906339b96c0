#include "messages.h"

#include <utility>

namespace se::view {

namespace {

/// A notice of at most kShortNotice bytes is shown this long; each further byte adds kSignTime.
constexpr std::chrono::milliseconds kNoticeTime{3000};
constexpr std::chrono::milliseconds kSignTime{40};
constexpr std::size_t kShortNotice = 80;

}  // namespace

void Messages::say(std::string message) {
    message_ = std::move(message);
    saidAt_ = Clock::now();
}

void Messages::sayIfAny(std::string complaint) {
    if (!complaint.empty()) say(std::move(complaint));
}

void Messages::miss(std::string message) {
    missed_ = true;
    say(std::move(message));
}

void Messages::clear() {
    message_.clear();
    missed_ = false;
}

std::string Messages::notice(Clock::time_point now) const {
    // A long message takes longer to read.
    const std::size_t more = message_.size() > kShortNotice ? message_.size() - kShortNotice : 0;
    return now - saidAt_ < kNoticeTime + more * kSignTime ? message_ : std::string{};
}

}  // namespace se::view
