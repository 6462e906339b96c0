// Starts as JSON: {"triangles": [[0, 2, 3]], "rings": [[0, 2, 3]], "done": [], "open": [[3, 0]]}.
#include "start_file.h"

#include <array>
#include <vector>

#include "spiraling_edge/base/files.h"
#include "teach/json_text.h"

namespace se::teach {
namespace {

using StartJson = nlohmann::json;

/// Thrown where an entry is wrong; caught in startFromText().
struct StartFault {
    std::string text;
};

/// A value of a start file, with the entry that names it in messages.
struct StartEntry {
    const StartJson& json;
    std::string name;  ///< "start.json: rings[1][3]"

    [[noreturn]] void fail(std::string_view expected) const {
        throw StartFault{name + ": expected " + std::string(expected) + ", got " +
                         jsonExcerpt(json)};
    }
    std::vector<StartEntry> items(std::string_view expected) const {
        if (!json.is_array()) fail(expected);
        std::vector<StartEntry> all;
        for (std::size_t i = 0; i < json.size(); ++i)
            all.push_back({json[i], name + "[" + std::to_string(i) + "]"});
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

void readStartKey(const std::string& file, const std::string& name, const StartJson& value,
                  GivenStart& start) {
    for (const StartKey& key : kStartKeys) {
        if (key.name != name) continue;
        std::string where = file;
        where.append(": ").append(name);
        key.read({value, where}, start);
        return;
    }
    throw StartFault{file + ": " + inQuotes(name) +
                     ": no such entry; expected triangles, rings, done or open"};
}

}  // namespace

Result<GivenStart> startFromText(std::string_view text, const std::string& name) {
    const Result<StartJson> read = jsonFromText<StartJson>(text, name);
    if (!read) return read.error();
    GivenStart start;
    try {
        const StartJson& json = read.value();
        if (!json.is_object()) StartEntry{json, name}.fail("an object with triangles and rings");
        for (const auto& [key, value] : json.items()) readStartKey(name, key, value, start);
    } catch (const StartFault& fault) {
        return Error{fault.text};
    }
    if (start.empty())
        return Error{name + ": expected triangles, rings or done points, there are none"};
    return start;
}

Result<GivenStart> readStartFile(const std::string& path) {
    const Result<std::string> bytes = readBytes(path, kTextLimit);
    return bytes ? startFromText(bytes.value(), path) : Result<GivenStart>(bytes.error());
}

}  // namespace se::teach
