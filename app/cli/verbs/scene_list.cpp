// spiraling-edge scenes: the built-in inputs.
#include <fmt/format.h>

#include <algorithm>

#include "output/answer.h"
#include "spiraling_edge/scenes/scenes.h"
#include "verbs.h"

namespace se::cli {
namespace {

Json sceneJson(const Scene& scene) {
    return {{"id", scene.id},
            {"title", scene.title},
            {"watch", scene.watch},
            {"points", scene.build().position.size()}};
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

/// Builds every scene for the number of its points.
Json scenesJson() {
    Json json = Json::array();
    for (const Scene& scene : scenes()) {
        json.push_back(sceneJson(scene));
        if (!scene.address.empty()) json.back()["address"] = scene.address;
    }
    for (const FailureScene& each : failureScenes()) {
        json.push_back(sceneJson(each.scene));
        json.back().update({{"failure", each.failure},
                            {"address", each.address},
                            {"section", each.section},
                            {"sentence", each.sentence},
                            {"helps", each.helps}});
    }
    return json;
}

}  // namespace

ExitCode scenesVerb(CLI::App& app, const Arguments& words) {
    bool json = false;
    app.add_flag("--json", json, "As JSON, with the number of points and what to look at");
    if (const auto code = parseArguments(app, words)) return *code;
    print(json ? Answer{"", scenesJson()} : Answer{scenesText(), {}}, json);
    return ExitCode::Good;
}

}  // namespace se::cli
