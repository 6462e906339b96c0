#include "stop_text.h"

#include <limits>
#include <nlohmann/json.hpp>

namespace se::view {

namespace {

using nlohmann::json;

/// Reads a field of a breakpoint, if present and of the right type. False: it has another type.
bool readText(const json& object, const char* name, std::string& out) {
    const auto found = object.find(name);
    if (found == object.end()) return true;
    if (!found->is_string()) return false;
    out = found->get<std::string>();
    return true;
}
bool readSwitch(const json& object, const char* name, bool& out) {
    const auto found = object.find(name);
    if (found == object.end()) return true;
    if (!found->is_boolean()) return false;
    out = found->get<bool>();
    return true;
}
bool readCount(const json& object, const char* name, std::uint32_t least, std::uint32_t& out) {
    const auto found = object.find(name);
    if (found == object.end()) return true;
    if (!found->is_number_unsigned() || *found > std::numeric_limits<std::uint32_t>::max() ||
        *found < least)
        return false;
    out = found->get<std::uint32_t>();
    return true;
}

bool readBreakpoint(const json& object, Breakpoint& out) {
    return object.is_object() && object.contains("line") && readText(object, "line", out.line) &&
           readText(object, "name", out.name) && readSwitch(object, "on", out.on) &&
           readSwitch(object, "log_only", out.logOnly) && readCount(object, "skip", 0, out.skip) &&
           readCount(object, "every", 1, out.every);
}

}  // namespace

std::optional<std::string> readStops(const json& object, std::vector<Breakpoint>& breakpoints,
                                     std::vector<std::string>& watches) {
    if (const auto list = object.find("breakpoints"); list != object.end()) {
        bool good = list->is_array();
        for (std::size_t i = 0; good && i < list->size(); ++i)
            good = readBreakpoint((*list)[i], breakpoints.emplace_back());
        if (!good)
            return "\"breakpoints\": expected a list of objects with \"line\" and optionally "
                   "\"name\", \"skip\", \"every\" (from 1), \"on\" and \"log_only\"";
    }
    if (const auto list = object.find("watches"); list != object.end()) {
        bool good = list->is_array();
        for (std::size_t i = 0; good && i < list->size(); ++i) {
            good = (*list)[i].is_string();
            if (good) watches.push_back((*list)[i].get<std::string>());
        }
        if (!good) return "\"watches\": expected a list of texts";
    }
    return std::nullopt;
}

void stopsToJson(const std::vector<Breakpoint>& breakpoints,
                 const std::vector<std::string>& watches, json& object) {
    object["breakpoints"] = json::array();
    for (const Breakpoint& each : breakpoints) {
        object["breakpoints"].push_back({{"line", each.line},
                                         {"name", each.name},
                                         {"skip", each.skip},
                                         {"every", each.every},
                                         {"on", each.on},
                                         {"log_only", each.logOnly}});
    }
    object["watches"] = watches;
}

}  // namespace se::view
