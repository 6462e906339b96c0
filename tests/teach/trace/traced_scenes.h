/// Scenes and their traces for tests.
#pragma once

#include <string>
#include <string_view>

#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "teach/trace/setrace.h"

namespace se::teach {

/// A scene as its run gets it.
struct TracedScene {
    SharedPoints points;
    Params params;
};

inline TracedScene tracedScene(std::string_view id) {
    TracedScene scene{SharedPoints(prepare(findScene(id)->build(), {}).value().points), {}};
    scene.params.start = startOfScene(id);
    return scene;
}

/// `params` with single rules: "limits=off".
inline Params withRule(Params params, std::string_view rule) {
    const RuleValue value = ruleValueFromText(rule).value();
    findRuleSetting(value.name)->set(params, value.value);
    return params;
}

/// The text of the trace of a run.
inline std::string traceText(const SharedPoints& points, const Params& params,
                             TraceDetail detail = TraceDetail::Fans) {
    Stepper stepper(points, params);
    std::string text = traceHeader(*points);
    while (true) {
        const TraceStep step = stepTraced(stepper, detail);
        if (step.pivot) text += traceLine(*step.pivot);
        if (!step.ran) return text;
    }
}

}  // namespace se::teach
