#include "prepared_input.h"

#include <fmt/format.h>

#include <utility>

#include "output/output.h"
#include "output/piece_text.h"
#include "progress.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se::cli {

void InputArguments::addTo(CLI::App& app) {
    app.add_option("IN", input_, "File with points, - or scene:ID")->required();
    piece_.addTo(app);
    rules_.addTo(app);
    start_.addTo(app);
    neighbors_.addTo(app);
    derived_.addTo(app);
    addByteLimit(app, limit_);
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_lnames().empty() && option->get_lnames().front() != "help")
            options_.push_back(option);
    }
}

std::vector<GivenOption> InputArguments::given() const {
    std::vector<GivenOption> given;
    for (const CLI::Option* option : options_) {
        if (option->count() == 0) continue;
        GivenOption each{option->get_lnames().front(), {}};
        const std::string word = "--" + each.name;
        if (option->get_expected_max() == 0) each.words.push_back(word);
        if (option->get_expected_max() != 0) {
            for (const std::string& value : option->results())
                each.words.insert(each.words.end(), {word, value});
        }
        given.push_back(std::move(each));
    }
    return given;
}

std::vector<std::string> InputArguments::options() const {
    std::vector<std::string> texts;
    for (const GivenOption& option : given()) {
        if (option.words.size() == 1) texts.push_back(option.words.front());
        for (std::size_t i = 1; i < option.words.size(); i += 2)
            texts.push_back(option.words[i - 1] + ' ' + option.words[i]);
    }
    return texts;
}

Params InputArguments::params() const { return paramsFrom(rules_, neighbors_); }

void InputArguments::requireWhole(const GivenStart& start) const {
    for (const GivenOption& each : given()) {
        if (each.name == "crop" || each.name == "thin") requireNoStart(start, "--" + each.name);
    }
}

PrepareOptions InputArguments::prepareOptions(const PointFile& file) const {
    return prepareOptionsFrom(params(), neighbors_, derived_, file);
}

PointFile InputArguments::read(const ProgressLine& line) const {
    InputPiece read = readPiece(input_, piece_.piece(), limit_);
    const std::string kept = keptSentence(read.points);
    if (line.isWanted() && !kept.empty())
        printNote(fmt::format("{}: kept {}\n", printable(input_), kept));
    return std::move(read.file);
}

PreparedInput InputArguments::prepare(ProgressLine& line) const {
    return prepare(read(line), line);
}

PreparedInput InputArguments::prepare(PointFile file, ProgressLine& line) const {
    const PrepareOptions options = prepareOptions(file);
    Prepared prepared = runWithProgress("preparing", input_, line, [&](const Progress& progress) {
        return se::prepare(file, options, progress);
    });
    Params rules = params();
    rules.start = start_.start(input_);
    requireWhole(rules.start);
    start_.require(prepared.points, rules.start, input_);
    requirePossible(prepared.points, rules);
    file.normal = prepared.points.normal;
    file.type = prepared.points.type;
    return {applyFixes(file).file, std::move(prepared.points), rules};
}

}  // namespace se::cli
