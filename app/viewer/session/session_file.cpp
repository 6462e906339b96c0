#include "session_file.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "layer_text.h"
#include "run/text.h"
#include "spiraling_edge/io.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kVersion = 1;
constexpr std::string_view kFormat = "spiraling-edge session";

/// What is wrong with a part of the file; nothing if all is well.
using Complaint = std::optional<std::string>;

Complaint expected(const std::string& field, const std::string& what) {
    return "\"" + field + "\": expected " + what;
}

const json* find(const json& object, const char* name) {
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
}

Complaint readHeader(const json& object) {
    const json* format = find(object, "format");
    if (format == nullptr || *format != kFormat) {
        return expected("format", "\"" + std::string(kFormat) + "\"; this is another kind of file");
    }
    const json* version = find(object, "version");
    if (version == nullptr || !version->is_number_integer()) {
        return expected("version", "a whole number");
    }
    if (*version > kVersion) {
        return expected("version", "at most " + std::to_string(kVersion) +
                                       "; a newer program has written it: use that one");
    }
    return std::nullopt;
}

/// A source with its path, if it has one, changed by `move`.
template <typename Move>
std::string movedSource(const std::string& source, const Move& move) {
    if (isScene(source)) return source;
    if (!isSample(source)) return move(source);
    Result<SampleSpec> sample = sampleFromSource(source);
    // What is wrong with it is told where it is opened.
    if (!sample || !isVolumePath(sample.value().surface)) return source;
    sample.value().surface = move(sample.value().surface);
    return sampleSource(sample.value());
}

Complaint readInput(const json& object, const fs::path& folder, SessionFile& out) {
    const json* input = find(object, "input");
    const json* source = input != nullptr && input->is_object() ? find(*input, "source") : nullptr;
    if (source == nullptr || !source->is_string() || source->get<std::string>().empty()) {
        return expected("input",
                        "an object with \"source\": a path relative to the session file, "
                        "scene:ID or sample:SHAPE,n=N");
    }
    out.input.source = movedSource(source->get<std::string>(), [&folder](const std::string& path) {
        return (folder / path).lexically_normal().string();
    });
    if (const json* hash = find(*input, "hash"); hash != nullptr) {
        if (!hash->is_string()) return expected("input.hash", "a text");
        out.inputHash = hash->get<std::string>();
    }
    return std::nullopt;
}

Complaint readReach(const json& options, NeighborOptions& out) {
    if (const json* count = find(options, "neighbors"); count != nullptr) {
        if (!count->is_number_integer() || *count < 1 || *count > 1000) {
            return expected("options.neighbors", "a whole number from 1 to 1000");
        }
        out = {KNearest{count->get<std::size_t>()}, true, 0, true};
    }
    if (const json* radius = find(options, "radius"); radius != nullptr) {
        if (!radius->is_number() || !(radius->get<double>() > 0.0)) {
            return expected("options.radius", "a number above 0");
        }
        out = {WithinRadius{radius->get<double>()}, true, 0, true};
    }
    return std::nullopt;
}

Complaint readCures(const json& options, Cures& out) {
    const json* cures = find(options, "doctor");
    if (cures == nullptr) return std::nullopt;
    const Complaint wrong =
        expected("options.doctor", "a list of checks of the doctor that can be cured");
    if (!cures->is_array()) return wrong;
    for (const json& name : *cures) {
        const DoctorCheck* check =
            name.is_string() ? findDoctorCheck(name.get<std::string>()) : nullptr;
        if (check == nullptr || !canCure(*check)) return wrong;
        out.push_back(name.get<std::string>());
    }
    return std::nullopt;
}

Complaint readSwitch(const json& options, const std::string& name, bool& out) {
    const json* on = find(options, name.c_str());
    if (on == nullptr) return std::nullopt;
    if (!on->is_boolean()) return expected("options." + name, "true or false");
    out = on->get<bool>();
    return std::nullopt;
}

Complaint readBox(const json& options, WallChoice& out) {
    const json* box = find(options, "box");
    if (box == nullptr) return std::nullopt;
    if (*box == "auto") {
        out = {WallChoice::From::Around, {}};
        return std::nullopt;
    }
    std::vector<double> at;
    if (box->is_array()) {
        for (const json& each : *box) {
            if (each.is_number()) at.push_back(each.get<double>());
        }
    }
    const bool good =
        at.size() == 6 && box->size() == 6 && at[0] < at[3] && at[1] < at[4] && at[2] < at[5];
    if (!good) return expected("options.box", "\"auto\", or six numbers, the lower corner first");
    out = {WallChoice::From::Box, {{at[0], at[1], at[2]}, {at[3], at[4], at[5]}}};
    return std::nullopt;
}

/// What is derived from the points.
Complaint readPreparing(const json& options, InputSpec& out) {
    if (const json* normals = find(options, "normals"); normals != nullptr) {
        if (*normals != "derived" && *normals != "oriented") {
            return expected("options.normals", "\"derived\" or \"oriented\"");
        }
        out.normals = *normals == "derived" ? NormalSource::Derived : NormalSource::Oriented;
    }
    if (Complaint c = readBox(options, out.walls)) return c;
    if (Complaint c = readSwitch(options, "symmetric", out.neighbors.symmetric)) return c;
    if (Complaint c = readSwitch(options, "rim", out.rim)) return c;
    if (Complaint c = readSwitch(options, "keep_opposing", out.keepOpposing)) return c;
    return readSwitch(options, "keep_noise", out.keepNoise);
}

Complaint readOptions(const json& object, InputSpec& out) {
    const json* options = find(object, "options");
    if (options == nullptr) return std::nullopt;
    if (!options->is_object()) return expected("options", "an object");
    if (const json* rules = find(*options, "rules"); rules != nullptr) {
        if (!rules->is_string() || !paramsByName(rules->get<std::string>())) {
            return expected("options.rules", "the name of a set of rules, such as \"paper\"");
        }
        out.rules = rules->get<std::string>();
    }
    if (const json* choices = find(*options, "switches"); choices != nullptr) {
        if (!choices->is_object()) return expected("options.switches", "an object of true, false");
        for (const auto& [name, on] : choices->items()) {
            Rules unused;
            if (!on.is_boolean()) return expected("options.switches." + name, "true or false");
            out.choices.push_back({name, on.get<bool>()});
            if (const Status known = applyChoices({out.choices.back()}, unused); !known) {
                return "\"options.switches\": " + known.error().message;
            }
        }
    }
    if (Complaint c = readCures(*options, out.cures)) return c;
    if (Complaint c = readReach(*options, out.neighbors)) return c;
    return readPreparing(*options, out);
}

Complaint readPlace(const json& object, SessionFile& out) {
    const json* address = find(object, "address");
    json place{{"address", address != nullptr ? *address : json("0")}};
    if (const json* camera = find(object, "camera"); camera != nullptr) place["camera"] = *camera;
    const Result<Place> read = placeFromText(place.dump());
    if (read) {
        out.place = read.value();
        return std::nullopt;
    }
    const bool bad = address != nullptr &&
                     (!address->is_string() || !addressFromString(address->get<std::string>()));
    if (bad) return expected("address", "an address such as \"137.sphere.3\"");
    return expected("camera", "target, distance, yaw and pitch as Ctrl+C copies them");
}

/// A point is its index, an edge or triangle the list of its points.
Complaint readSelection(const json& object, SessionFile& out) {
    const json* selected = find(object, "selected");
    if (selected == nullptr) return std::nullopt;
    const json list = selected->is_array() ? *selected : json::array({*selected});
    const auto isPoint = [](const json& p) { return p.is_number_unsigned() && p < kNone; };
    const bool good = list.size() >= 1 && list.size() <= 3 &&
                      std::all_of(list.begin(), list.end(), isPoint) &&
                      std::set<json>(list.begin(), list.end()).size() == list.size();
    if (!good) return expected("selected", "the index of a point, or a list of two or three");
    const auto at = [&list](std::size_t i) { return list[i].get<Index>(); };
    if (list.size() == 1) out.selected = Selection::ofPoint(at(0));
    if (list.size() == 2) out.selected = Selection::ofEdge(at(0), at(1));
    if (list.size() == 3) out.selected = Selection::ofTriangle({at(0), at(1), at(2)});
    return std::nullopt;
}

Complaint readLooks(const json& object, SessionFile& out) {
    if (const json* on = find(object, "layers"); on != nullptr) {
        const ReadLayers read = layersFromJson(*on);
        out.layers = read.modes;
        out.leftOut = read.complaint();
    }
    if (const json* layout = find(object, "layout"); layout != nullptr) {
        if (layout->is_string()) out.layout = arrangementFromName(layout->get<std::string>());
        if (!out.layout) return expected("layout", "\"debug\", \"learn\" or \"present\"");
    }
    return readSelection(object, out);
}

Complaint readNotes(const json& object, SessionFile& out) {
    if (const json* notes = find(object, "notes"); notes != nullptr) {
        if (!notes->is_string()) return expected("notes", "a text");
        out.notes = notes->get<std::string>();
    }
    const json* list = find(object, "bookmarks");
    if (list == nullptr) return std::nullopt;
    if (!list->is_array()) return expected("bookmarks", "a list");
    for (const json& each : *list) {
        const json* text = each.is_object() ? find(each, "address") : nullptr;
        const auto address = text != nullptr && text->is_string()
                                 ? addressFromString(text->get<std::string>())
                                 : std::nullopt;
        const json* note = each.is_object() ? find(each, "note") : nullptr;
        if (!address || (note != nullptr && !note->is_string())) {
            return expected("bookmarks", "objects with \"address\" and, at will, \"note\": texts");
        }
        insertBookmark(out.bookmarks,
                       {*address, note != nullptr ? note->get<std::string>() : std::string{}});
    }
    return std::nullopt;
}

Complaint readAll(const json& object, const fs::path& folder, SessionFile& out) {
    if (!object.is_object()) return "expected a JSON object, as Ctrl+S writes it";
    if (Complaint c = readHeader(object)) return c;
    if (Complaint c = readInput(object, folder, out)) return c;
    if (Complaint c = readOptions(object, out.input)) return c;
    if (Complaint c = readPlace(object, out)) return c;
    if (Complaint c = readLooks(object, out)) return c;
    return readNotes(object, out);
}

/// An object at `name`, with what was there before.
json& objectAt(json& object, const char* name) {
    json& part = object[name];
    if (!part.is_object()) part = json::object();
    return part;
}

std::string relativePath(const std::string& source, const fs::path& folder) {
    std::error_code error;
    const fs::path file = fs::absolute(source, error);
    const fs::path from = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
    const fs::path way = file.lexically_normal().lexically_relative(from.lexically_normal());
    return way.empty() ? file.generic_string() : way.generic_string();
}

std::string relativeSource(const std::string& source, const fs::path& folder) {
    return movedSource(source,
                       [&folder](const std::string& path) { return relativePath(path, folder); });
}

/// What is derived from the points, as far as it is not as usual.
void preparingToJson(const InputSpec& input, json& options) {
    for (const char* name : {"normals", "box", "symmetric", "rim", "keep_opposing", "keep_noise"}) {
        options.erase(name);
    }
    if (input.normals == NormalSource::Derived) options["normals"] = "derived";
    if (input.normals == NormalSource::Oriented) options["normals"] = "oriented";
    if (input.walls.from == WallChoice::From::Around) options["box"] = "auto";
    if (input.walls.from == WallChoice::From::Box) {
        const WallBox& b = input.walls.box;
        options["box"] = {b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z};
    }
    if (input.neighbors.symmetric) options["symmetric"] = true;
    if (input.rim) options["rim"] = true;
    if (input.keepOpposing) options["keep_opposing"] = true;
    if (input.keepNoise) options["keep_noise"] = true;
}

json optionsToJson(const InputSpec& input, json options) {
    options["rules"] = input.rules;
    options.erase("switches");
    options.erase("neighbors");
    options.erase("radius");
    options.erase("doctor");
    if (!input.cures.empty()) options["doctor"] = input.cures;
    preparingToJson(input, options);
    for (const RuleChoice& choice : input.choices) options["switches"][choice.name] = choice.on;
    if (!input.neighbors.recompute) return options;
    if (const auto* nearest = std::get_if<KNearest>(&input.neighbors.reach)) {
        options["neighbors"] = nearest->k;
    } else {
        options["radius"] = std::get<WithinRadius>(input.neighbors.reach).radius;
    }
    return options;
}

}  // namespace

bool looksLikeSession(const fs::path& path) {
    if (lowerExtension(path) == kSessionExtension) return true;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    char first = 0;
    return (file >> first) && first == '{';
}

Result<SessionFile> sessionFromJson(std::string_view text, const std::string& name,
                                    const fs::path& folder) {
    json object;
    try {
        object = json::parse(text);
    } catch (const json::parse_error& error) {
        return Error{name + ": byte " + std::to_string(error.byte) +
                     ": expected JSON, as Ctrl+S writes it."};
    }
    SessionFile session;
    session.original = text;
    if (const Complaint complaint = readAll(object, folder, session)) {
        return Error{name + ": " + *complaint + "."};
    }
    if (!session.leftOut.empty()) {
        session.leftOut = fs::path(name).filename().string() + ": " + session.leftOut;
    }
    return session;
}

std::string sessionToJson(const SessionFile& session, const fs::path& folder) {
    json object = json::parse(session.original, nullptr, false);
    if (!object.is_object()) object = json::object();
    object["format"] = kFormat;
    object["version"] = kVersion;
    json& input = objectAt(object, "input");
    input["source"] = relativeSource(session.input.source, folder);
    input["hash"] = session.inputHash;
    if (session.inputHash.empty()) input.erase("hash");
    object["options"] = optionsToJson(session.input, objectAt(object, "options"));
    object.erase("camera");
    object.update(json::parse(toText(session.place)));
    if (session.place.address.empty()) object["address"] = "0";
    if (session.layers) {
        objectAt(object, "layers").update(layersToJson(*session.layers));
    }
    if (session.layout) object["layout"] = rowOf(*session.layout).name;
    object.erase("selected");
    const auto corners = session.selected.corners();
    if (corners.size() == 1) object["selected"] = corners[0];
    if (corners.size() > 1) object["selected"] = std::vector<Index>(corners.begin(), corners.end());
    object["bookmarks"] = json::array();
    for (const Bookmark& each : session.bookmarks) {
        object["bookmarks"].push_back({{"address", toString(each.address)}, {"note", each.note}});
    }
    object["notes"] = session.notes;
    return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<SessionFile> readSessionFile(const fs::path& path) {
    const std::optional<std::string> text = readText(path);
    if (!text) return Error{path.string() + ": cannot be read."};
    return sessionFromJson(*text, path.string(), path.parent_path());
}

Status writeSessionFile(const fs::path& path, const SessionFile& session) {
    return writeFileAtomically(path, sessionToJson(session, path.parent_path()));
}

}  // namespace se::view
