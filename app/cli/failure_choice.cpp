#include "failure_choice.h"

#include <fmt/format.h>

#include "exit_code.h"
#include "output/sentences.h"
#include "progress.h"
#include "spiraling_edge/base/shell_word.h"

namespace se::cli {

namespace {

std::string classNames() {
    std::string names;
    for (const FailureClass& each : failureClasses()) appendPart(names, std::string(each.name));
    return names;
}

[[noreturn]] void noSuchFailure(std::span<const ClassTotal> totals, const FailureChoice& wanted,
                                const std::string& input) {
    const auto& total = totals[static_cast<std::size_t>(wanted.kind - failureClasses().data())];
    const std::string has = total.all() ? counted(total.total, "failure")
                                        : "only the " + amountText(total) + " failures listed";
    throw Failure(
        ExitCode::CheckFailed,
        "{}: the run has {} of class {}; spiraling-edge why {} --failures lists those it has",
        input, has, wanted.kind->name, shellPath(input));
}

}  // namespace

FailureChoice failureChoiceFrom(const std::string& text) {
    const std::size_t colon = text.find(':');
    FailureChoice wanted{findFailureClass(text.substr(0, colon)), 1};
    if (wanted.kind == nullptr) {
        throw Failure(ExitCode::Usage, "--failure {}: no such class; the classes are {}", text,
                      classNames());
    }
    if (colon == std::string::npos) return wanted;
    const std::string digits = text.substr(colon + 1);
    const bool number = !digits.empty() && digits.size() < 10 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
    if (!number || digits.find_first_not_of('0') == std::string::npos)
        throw Failure(ExitCode::Usage, "--failure {}: expected a number >= 1 after the colon",
                      text);
    wanted.number = std::stoul(digits);
    return wanted;
}

MeshFailure pickFailure(const MeshInspection& found, const FailureChoice& wanted,
                        const std::string& input) {
    std::size_t seen = 0;
    for (const MeshFailure& failure : found.failures) {
        if (failure.kind == wanted.kind && ++seen == wanted.number) return failure;
    }
    noSuchFailure(found.totals, wanted, input);
}

RunFailure pickFailure(const RunFailureSearch& found, const FailureChoice& wanted,
                       const std::string& input) {
    std::size_t seen = 0;
    for (const RunFailure& each : found.failures) {
        if (each.failure.kind == wanted.kind && ++seen == wanted.number) return each;
    }
    noSuchFailure(found.verdict.totals, wanted, input);
}

}  // namespace se::cli
