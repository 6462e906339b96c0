#include "failure_choice.h"

#include <fmt/format.h>

#include "exit_code.h"
#include "output/sentences.h"
#include "progress.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::cli {

void noSuchFailure(std::span<const ClassTotal> totals, const FailureChoice& wanted,
                   const std::string& input) {
    const ClassTotal& total = totals[rankOf(*wanted.kind)];
    const std::string has = total.all() ? counted(total.total, "failure")
                                        : "only the " + amountText(total) + " failures listed";
    throw Failure(
        ExitCode::CheckFailed,
        "{}: the run has {} of class {}; spiraling-edge why {} --failures lists those it has",
        input, has, wanted.kind->name, shellPath(input));
}

FailureChoice failureChoiceFrom(const std::string& text) {
    const std::size_t colon = text.find(':');
    FailureChoice wanted{findFailureClass(text.substr(0, colon)), 1};
    if (wanted.kind == nullptr) {
        refuse("--failure {}: no such class; the classes are {}", text,
               listText(failureClasses(), &FailureClass::name, ""));
    }
    if (colon == std::string::npos) return wanted;
    const std::string digits = text.substr(colon + 1);
    const auto number = numberIn<std::size_t>(digits);
    if (!number || *number == 0 || digits.size() > 9)
        refuse("--failure {}: expected a number >= 1 after the colon", text);
    wanted.number = *number;
    return wanted;
}

}  // namespace se::cli
