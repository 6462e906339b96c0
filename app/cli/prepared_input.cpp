#include "prepared_input.h"

#include <fmt/format.h>

#include <utility>

#include "input.h"
#include "progress_work.h"
#include "spiraling_edge/doctor.h"

namespace se::cli {

void InputArguments::addTo(CLI::App& app) {
    app.add_option("IN", input_, "File with points, - or scene:ID")->required();
    rules_.addTo(app);
    neighbors_.addTo(app);
    derived_.addTo(app);
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_lnames().empty() && option->get_lnames().front() != "help")
            given_.push_back(option);
    }
}

std::vector<std::string> InputArguments::options() const {
    std::vector<std::string> words;
    for (const CLI::Option* option : given_) {
        if (option->count() == 0) continue;
        const std::string name = "--" + option->get_lnames().front();
        if (option->get_expected_max() == 0) {
            words.push_back(name);
            continue;
        }
        for (const std::string& value : option->results())
            words.push_back(fmt::format("{} {}", name, value));
    }
    return words;
}

Params InputArguments::params() const { return paramsFrom(rules_, neighbors_); }

PrepareOptions InputArguments::prepareOptions(const PointFile& file) const {
    return prepareOptionsFrom(params(), neighbors_, derived_, file);
}

PreparedInput InputArguments::prepare(ProgressLine& line) const {
    PointFile file = readInput(input_);
    const PrepareOptions options = prepareOptions(file);
    Prepared prepared = workedOut("preparing", input_, line, [&](const Progress& progress) {
        return se::prepare(file, options, progress);
    });
    file.normal = prepared.points.normal;
    file.type = prepared.points.type;
    return {treat(file).file, std::move(prepared.points), params()};
}

}  // namespace se::cli
