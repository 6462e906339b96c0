// spiraling-edge scenes: the built-in inputs.
#include <fmt/format.h>

#include <algorithm>

#include "output/output.h"
#include "spiraling_edge/scenes/scenes.h"
#include "verbs.h"

namespace se::cli {
namespace {

/// All scenes, those that fail last; as JSON with the number of points, for which each is built.
Answer scenesAnswer(bool asJson) {
    std::size_t width = 0;
    for (const Scene& scene : scenes()) width = std::max(width, scene.id.size());
    for (const FailureScene& each : failureScenes()) width = std::max(width, each.scene.id.size());
    Answer answer{"", Json::array()};
    const auto add = [&](const Scene& scene, const std::string& end, const Json& more) {
        answer.text += fmt::format("scene:{:<{}}  {}{}\n", scene.id, width, scene.title, end);
        if (!asJson) return;
        answer.json.push_back({{"id", scene.id},
                               {"title", scene.title},
                               {"watch", scene.watch},
                               {"points", scene.build().position.size()}});
        answer.json.back().update(more);
    };
    for (const Scene& scene : scenes())
        add(scene, "", scene.address.empty() ? Json::object() : Json{{"address", scene.address}});
    for (const FailureScene& each : failureScenes())
        add(each.scene, fmt::format(": {}, at {}", each.failure, each.address),
            {{"failure", each.failure},
             {"address", each.address},
             {"section", each.section},
             {"sentence", each.sentence},
             {"helps", each.helps}});
    return answer;
}

}  // namespace

ExitCode scenesVerb(CLI::App& app, const Arguments& words) {
    bool json = false;
    app.add_flag("--json", json, "As JSON, with the number of points and what to look at");
    if (const auto code = parseArguments(app, words)) return *code;
    print(scenesAnswer(json), json);
    return ExitCode::Good;
}

}  // namespace se::cli
