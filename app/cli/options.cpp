#include "options.h"

#include <fmt/format.h>

#include "options/option_list.h"
#include "output/output.h"

namespace se::cli {

std::optional<ExitCode> parseArguments(CLI::App& app, const Arguments& arguments) {
    if (asksForOptionList(arguments)) {
        printText(optionList(app));
        return ExitCode::Good;
    }
    Arguments reversed(arguments.rbegin(), arguments.rend());  // in the order that CLI11 expects
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        printText(app.help());
        return ExitCode::Good;
    } catch (const CLI::ParseError& problem) {
        throw Failure(ExitCode::Usage, "{}; see {} --help", problem.what(), app.get_name());
    }
    return std::nullopt;
}

RunSpec specOf(const SpecChange& given, RunSpec spec) {
    require(applyChange(given, spec), ExitCode::Usage);
    return spec;
}

}  // namespace se::cli
