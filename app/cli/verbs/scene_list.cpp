// spiraling-edge scenes: the built-in inputs.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "options.h"
#include "output/output.h"
#include "spiraling_edge/scenes/scenes.h"
#include "teach/json_text.h"
#include "verbs.h"

namespace se::cli {
namespace {

std::string scenesJson() {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Scene& scene : scenes()) {
        list.push_back({{"id", scene.id},
                        {"title", scene.title},
                        {"watch", scene.watch},
                        {"points", scene.build().position.size()}});
        if (!scene.address.empty()) list.back()["address"] = scene.address;
    }
    for (const FailureScene& each : failureScenes()) {
        list.push_back({{"id", each.scene.id},
                        {"title", each.scene.title},
                        {"watch", each.scene.watch},
                        {"points", each.scene.build().position.size()},
                        {"failure", each.failure},
                        {"address", each.address},
                        {"section", each.section},
                        {"sentence", each.sentence},
                        {"helps", each.helps}});
    }
    return teach::jsonText(list);
}

std::string scenesText() {
    std::size_t width = 0;
    for (const Scene& scene : scenes()) width = std::max(width, scene.id.size());
    for (const FailureScene& each : failureScenes()) width = std::max(width, each.scene.id.size());
    std::string text;
    for (const Scene& scene : scenes())
        text += fmt::format("scene:{:<{}}  {}\n", scene.id, width, scene.title);
    for (const FailureScene& each : failureScenes())
        text += fmt::format("scene:{:<{}}  {}: {}, at {}\n", each.scene.id, width, each.scene.title,
                            each.failure, each.address);
    return text;
}

}  // namespace

ExitCode scenesVerb(const Arguments& words) {
    CLI::App app(
        "Lists the built-in scenes, the default first, then those that fail, with the class "
        "of "
        "the failure and the address of the decision that causes it.",
        "spiraling-edge scenes");
    bool json = false;
    app.add_flag("--json", json, "As JSON, with the number of points and what to look at");
    if (const auto code = parseArguments(app, words)) return *code;
    printText(json ? scenesJson() : scenesText());
    return ExitCode::Good;
}

}  // namespace se::cli
