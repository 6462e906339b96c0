// Starts as JSON: {"triangles": [[0, 2, 3]], "rings": [[0, 2, 3]], "done": [], "open": [[3, 0]]}.
#include "start_file.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "exit_code.h"
#include "input.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::cli {
namespace {

using StartJson = nlohmann::json;

/// A value of a start file, with the entry that names it in messages.
struct StartEntry {
    const StartJson& json;
    std::string name;  ///< "start.json: rings[1][3]"

    [[noreturn]] void fail(std::string_view expected) const {
        throw Failure(ExitCode::Input,
                      fmt::format("{}: expected {}, got {}", name, expected,
                                  json.dump(-1, ' ', false, StartJson::error_handler_t::replace)));
    }
    std::vector<StartEntry> items(std::string_view expected) const {
        if (!json.is_array()) fail(expected);
        std::vector<StartEntry> all;
        for (std::size_t i = 0; i < json.size(); ++i)
            all.push_back({json[i], fmt::format("{}[{}]", name, i)});
        return all;
    }
    Index point() const {
        if (!json.is_number_unsigned() || json.get<std::uint64_t>() >= kNone)
            fail("the number of a point, from 0");
        return json.get<Index>();
    }
    std::vector<Index> points(std::string_view expected, std::size_t count = 0) const {
        const std::vector<StartEntry> all = items(expected);
        if (count > 0 && all.size() != count) fail(expected);
        std::vector<Index> points;
        points.reserve(all.size());
        for (const StartEntry& each : all) points.push_back(each.point());
        return points;
    }
};

void readTriangles(const StartEntry& entry, GivenStart& start) {
    for (const StartEntry& each : entry.items("a list of triangles")) {
        const std::vector<Index> p = each.points("a triangle, such as [0, 1, 2]", 3);
        start.triangles.push_back({p[0], p[1], p[2]});
    }
}
void readRings(const StartEntry& entry, GivenStart& start) {
    for (const StartEntry& each : entry.items("a list of rings"))
        start.rings.push_back(each.points("a ring, such as [0, 1, 2, 3]"));
}
void readDone(const StartEntry& entry, GivenStart& start) {
    start.done = entry.points("a list of points");
}
void readOpen(const StartEntry& entry, GivenStart& start) {
    for (const StartEntry& each : entry.items("a list of steps")) {
        const std::vector<Index> p = each.points("a step of a ring, such as [0, 1]", 2);
        start.open.push_back({p[0], p[1]});
    }
}

/// An entry of the file.
struct StartKey {
    std::string_view name;
    void (*read)(const StartEntry&, GivenStart&);
};
constexpr std::array kStartKeys{StartKey{"triangles", readTriangles}, StartKey{"rings", readRings},
                                StartKey{"done", readDone}, StartKey{"open", readOpen}};

void readKey(const std::string& path, const std::string& name, const StartJson& value,
             GivenStart& start) {
    for (const StartKey& key : kStartKeys) {
        if (key.name != name) continue;
        key.read({value, fmt::format("{}: {}", path, name)}, start);
        return;
    }
    throw Failure(ExitCode::Input,
                  fmt::format("{}: \"{}\": no such entry; expected triangles, rings, done or open",
                              path, name));
}

}  // namespace

GivenStart readStartFile(const std::string& path) {
    const Result<std::string> bytes = readBytes(path);
    if (!bytes) throw Failure(ExitCode::Input, bytes.error().message);
    StartJson json;
    try {
        json = StartJson::parse(bytes.value());
    } catch (const StartJson::parse_error& problem) {
        throw Failure(ExitCode::Input, fmt::format("{}: expected JSON, {}", path, problem.what()));
    }
    if (!json.is_object()) StartEntry{json, path}.fail("an object with triangles and rings");
    GivenStart start;
    for (const auto& [name, value] : json.items()) readKey(path, name, value, start);
    if (start.empty()) {
        throw Failure(ExitCode::Input,
                      path + ": expected triangles, rings or done points, there are none");
    }
    return start;
}

std::string startFileText(const GivenStart& start) {
    StartJson json = StartJson::object();
    for (const Triangle& t : start.triangles) json["triangles"].push_back({t.a, t.b, t.c});
    if (!start.rings.empty()) json["rings"] = start.rings;
    if (!start.done.empty()) json["done"] = start.done;
    for (const RingStep& step : start.open) json["open"].push_back({step.from, step.to});
    return json.dump() + "\n";
}

void StartArguments::addTo(CLI::App& app) {
    app.add_option("--start", path_,
                   "Begin with the triangles and edge rings of this JSON file "
                   "(docs/file-formats.md)")
        ->type_name("FILE");
}

GivenStart StartArguments::start(const std::string& input) const {
    if (!path_.empty()) return readStartFile(path_);
    constexpr std::string_view kScene = "scene:";
    return input.starts_with(kScene) ? startOfScene(input.substr(kScene.size())) : GivenStart{};
}

void StartArguments::require(const PointSet& points, const GivenStart& start,
                             const std::string& input) const {
    const Status status = requireStart(points, start);
    if (!status) {
        throw Failure(ExitCode::Input,
                      (path_.empty() ? nameOfInput(input) : path_) + ": " + status.error().message);
    }
}

void requireNoStart(const GivenStart& start, const std::string& what) {
    if (start.empty()) return;
    throw Failure(ExitCode::Usage,
                  what + ": the run begins with given triangles, which name points by numbers");
}

}  // namespace se::cli
