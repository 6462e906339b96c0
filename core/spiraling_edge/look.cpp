#include "spiraling_edge/look.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <system_error>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se {
namespace {

/// "[a, b]" of the texts of all items.
template <typename Items, typename Text>
std::string jsonList(const Items& items, Text&& text) {
    std::string list = "[";
    for (const auto& item : items) list.append(list.size() > 1 ? ", " : "").append(text(item));
    return list + "]";
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

/// A value as a session has it: true or false, a number, or a name.
std::string jsonValue(const RuleValue& rule) {
    const std::string text = valueText(*findRuleSetting(rule.name), rule.value);
    if (text == "on" || text == "off") return text == "on" ? "true" : "false";
    return text.find_first_not_of("0123456789.+-e") == std::string::npos ? text : quoted(text);
}

std::string jsonText(const GivenStart& start) {
    const auto number = [](Index p) { return std::to_string(p); };
    const auto points = [&](const auto& list) { return jsonList(list, number); };
    const auto triangle = [&](const Triangle& t) { return points(std::array{t.a, t.b, t.c}); };
    const auto step = [&](const RingStep& s) { return points(std::array{s.from, s.to}); };
    return "{\"triangles\": " + jsonList(start.triangles, triangle) +
           ", \"rings\": " + jsonList(start.rings, points) + ", \"done\": " + points(start.done) +
           ", \"open\": " + jsonList(start.open, step) + "}";
}

/// The points as they are, with their lists.
PointFile fileOf(const PointSet& points) {
    PointFile file;
    file.position = points.position;
    file.normal = points.normal;
    file.positionType = file.normalType = ScalarType::Double;
    file.type = points.type;
    file.neighbors = points.neighbors;
    return file;
}

/// Writes the files into the folder and runs the viewer on them.
Status lookFrom(const std::filesystem::path& folder, const Stepper& stepper,
                const std::string& viewer) {
    const std::string points = "points.ply";
    Status written = writeMeshPly(folder / points, fileOf(stepper.points()), {});
    if (!written) return written;
    const std::filesystem::path session = folder / "run.sesession";
    const std::uint32_t pivots = stepper.state().counters.pivots;
    written = writeFileAtomically(session, sessionText(stepper.params(), points, pivots));
    if (!written) return written;
    const std::string command = shellQuoted(viewer) + " " + shellQuoted(session.string());
    if (std::system(command.c_str()) == 0) return success();  // NOLINT(cert-env33-c): quoted
    return Error{viewer + " ended with an error, or is not installed"};
}

}  // namespace

std::string sessionText(const Params& params, const std::string& points, std::uint32_t pivots) {
    std::string switches;
    for (const RuleValue& rule : differingRules(params, *paramsByName("paper")))
        switches += (switches.empty() ? "" : ", ") + quoted(rule.name) + ": " + jsonValue(rule);
    std::string text =
        "{\"format\": \"spiraling-edge session\", \"version\": 1,\n \"input\": {\"source\": " +
        quoted(points) + "},\n \"options\": {\"rules\": \"paper\", \"keep_opposing\": true, " +
        "\"switches\": {" + switches + "}";
    if (!params.whatIf.empty())
        text += ", \"what_if\": " +
                jsonList(params.whatIf, [](const WhatIf& each) { return quoted(lineOf(each)); });
    if (!params.start.empty()) text += ", \"start\": " + jsonText(params.start);
    return text + "},\n \"address\": " + quoted(std::to_string(pivots)) + "}\n";
}

Status look(const Stepper& stepper, const std::string& viewer) {
    std::error_code error;
    std::random_device random;
    const std::string name = "spiraling-edge-" + std::to_string(random());
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error) / name;
    if (error || !std::filesystem::create_directory(folder, error))
        return Error{folder.string() + ": the folder for temporary files cannot be made"};
    const Status looked = lookFrom(folder, stepper, viewer);
    std::filesystem::remove_all(folder, error);
    return looked;
}

}  // namespace se
