#include "recent.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run/model.h"
#include "run/number_format.h"
#include "run/sample_spec.h"
#include "run/strings.h"
#include "settings.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string absolutePath(const std::string& path) {
    std::error_code error;
    return fs::absolute(path, error).lexically_normal().string();
}

/// Absolute path, valid in any folder; empty if there is none.
std::string fromAnywhere(const std::string& source) {
    if (!isSample(source)) return absolutePath(source);
    Result<SampleSpec> spec = sampleFromSource(source);
    if (!spec) return {};
    if (isVolumePath(spec.value().surface))
        spec.value().surface = absolutePath(spec.value().surface);
    return sampleSource(spec.value());
}

}  // namespace

void remember(KeptState& state, const std::string& path) {
    if (path.empty() || isScene(path)) return;
    const std::string whole = fromAnywhere(path);
    if (whole.empty()) return;
    std::vector<std::string>& list = state.recent;
    std::erase(list, whole);
    list.insert(list.begin(), whole);
    if (list.size() > kMaxRecent) list.resize(kMaxRecent);
}

std::string recentName(const std::string& path) {
    const Result<SampleSpec> spec = sampleFromSource(path);
    if (!isSample(path) || !spec) return fs::path(path).filename().string();
    const SampleSpec& made = spec.value();
    std::string name = made.count > 0 ? sampleTitle(made, made.count)
                                      : sampleStem(made, 0) + ", " + exact(made.spacing) + " apart";
    if (made.steps > 0) name += ", step " + std::to_string(made.steps);
    return name;
}

fs::path statePath() {
    const fs::path folder = xdgFolder("XDG_STATE_HOME", ".local/state");
    return folder.empty() ? folder : folder / "spiraling-edge" / "state.json";
}

KeptState keptStateFromJson(std::string_view text) {
    KeptState state;
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object()) return state;
    if (const auto layout = object.find("layout"); layout != object.end() && layout->is_string()) {
        state.layout = layoutPresetFromName(layout->get<std::string>()).value_or(state.layout);
    }
    const auto recent = object.find("recent");
    if (recent == object.end() || !recent->is_array()) return state;
    for (const json& each : *recent) {
        if (each.is_string() && state.recent.size() < kMaxRecent) {
            state.recent.push_back(each.get<std::string>());
        }
    }
    return state;
}

std::string keptStateToJson(const KeptState& state) {
    const json object = {{"version", 1},
                         {"layout", std::string(rowOf(state.layout).name)},
                         {"recent", state.recent}};
    return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

KeptState readKeptState(const fs::path& path) {
    const std::optional<std::string> text = readText(path);
    return text ? keptStateFromJson(*text) : KeptState{};
}

Status writeKeptState(const fs::path& path, const KeptState& state) {
    return writeKept(path, keptStateToJson(state));
}

}  // namespace se::view
