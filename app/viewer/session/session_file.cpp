#include "session_file.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>

#include "run/packed_file.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/volume.h"
#include "spiraling_edge/spec/spec_fields.h"
#include "teach/json_text.h"
#include "teach/spec_json.h"

namespace se::view {

namespace {

Bookmarks::const_iterator placeOf(const Bookmarks& bookmarks, const Address& address) {
    return std::lower_bound(
        bookmarks.begin(), bookmarks.end(), address,
        [](const Bookmark& mark, const Address& to) { return isBefore(mark.address, to); });
}

}  // namespace

std::optional<std::size_t> bookmarkAt(const Bookmarks& bookmarks, const Address& address) {
    const auto found = placeOf(bookmarks, address);
    if (found == bookmarks.end() || found->address != address) return std::nullopt;
    return static_cast<std::size_t>(found - bookmarks.begin());
}

bool toggleBookmark(Bookmarks& bookmarks, const Address& address,
                    const std::optional<CameraPose>& camera) {
    const auto place = placeOf(bookmarks, address);
    if (place != bookmarks.end() && place->address == address) {
        bookmarks.erase(place);
        return false;
    }
    bookmarks.insert(place, {address, {}, camera});
    return true;
}

const Bookmark* nextBookmark(const Bookmarks& bookmarks, const Address& address, int direction) {
    const auto place = placeOf(bookmarks, address);  // The first not before the address.
    if (direction < 0) return place == bookmarks.begin() ? nullptr : &*std::prev(place);
    const bool here = place != bookmarks.end() && place->address == address;
    const auto next = here ? std::next(place) : place;
    return next == bookmarks.end() ? nullptr : &*next;
}

void insertBookmark(Bookmarks& bookmarks, Bookmark bookmark) {
    auto place = placeOf(bookmarks, bookmark.address);
    if (bookmarkAt(bookmarks, bookmark.address)) place = bookmarks.erase(place);
    bookmarks.insert(place, std::move(bookmark));
}

std::string differenceOf(const Annotations& a, const Annotations& b) {
    std::vector<std::string> kinds;
    if (a.bookmarks != b.bookmarks) kinds.push_back("bookmarks");
    if (a.notes != b.notes) kinds.push_back("notes");
    if (a.breakpoints != b.breakpoints) kinds.push_back("breakpoints");
    if (a.watches != b.watches) kinds.push_back("watches");
    return wordList(kinds, "and");
}

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Problem of a part of the file; empty if there is none.
using Complaint = std::optional<std::string>;

Complaint expected(const std::string& field, const std::string& what) {
    return "\"" + field + "\": expected " + what;
}

const json* find(const json& object, const char* name) {
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
}

/// Reads a field, text or true and false, if it is present. False: it has another type.
template <typename Value>
bool readField(const json& object, const char* name, Value& out) {
    const json* field = find(object, name);
    if (field == nullptr) return true;
    const bool fits = std::is_same_v<Value, bool> ? field->is_boolean() : field->is_string();
    if (fits) out = field->get<Value>();
    return fits;
}

/// Writes a field; if it is not `given`, an older one is removed.
template <typename Value>
void writeField(json& object, const char* name, bool given, const Value& value) {
    object.erase(name);
    if (given) object[name] = value;
}

/// Reads "options" of a session, or of its comparison.
Complaint readOptions(const json& object, RunSpec& out) {
    const json* options = find(object, "options");
    if (options == nullptr) return std::nullopt;
    if (!options->is_object()) return expected("options", "an object");
    const Status read = teach::readOptions(*options, out);
    return read ? std::nullopt : Complaint(read.error().message);
}

/// Options as JSON, with the unknown fields of `options` kept.
json optionsToJson(const RunSpec& input, json options) {
    for (const SpecField& field : specFields()) options.erase(std::string(field.key));
    options.erase("start");
    options.update(json::parse(optionsJson(input)));
    return options;
}

constexpr int kFileVersion = 1;
constexpr std::string_view kFormat = "spiraling-edge session";

Complaint readHeader(const json& object) {
    const json* format = find(object, "format");
    if (format == nullptr || *format != kFormat) {
        return expected("format",
                        "\"" + std::string(kFormat) + "\"; this is a different kind of file");
    }
    const json* version = find(object, "version");
    if (version == nullptr || !version->is_number_integer()) {
        return expected("version", "a whole number");
    }
    if (*version < 1) return expected("version", "a whole number >= 1");
    if (*version > kFileVersion) {
        return expected("version", "at most " + std::to_string(kFileVersion) +
                                       "; the file was written by a newer version");
    }
    return std::nullopt;
}

Complaint unfit(const std::string& field, const fs::path& path) {
    return expected(field, "a regular file; " + path.string() + " is none");
}

Complaint readInput(const json& object, const fs::path& folder, SessionFile& out) {
    const json* input = find(object, "input");
    const json* source = input != nullptr && input->is_object() ? find(*input, "source") : nullptr;
    if (source == nullptr || !source->is_string() || source->get<std::string>().empty()) {
        return expected("input",
                        "an object with \"source\": a path relative to the session file, "
                        "scene:ID or sample:SHAPE,n=N");
    }
    std::optional<fs::path> file;
    out.input.source = movedSource(source->get<std::string>(), [&](const std::string& path) {
        file = (folder / path).lexically_normal();
        return file->string();
    });
    if (file && isUnfit(*file)) return unfit("input.source", *file);
    if (!readField(*input, "hash", out.inputHash)) return expected("input.hash", "text");
    return std::nullopt;
}

Complaint readPosition(const json& object, SessionFile& out) {
    const json* address = find(object, "address");
    json place{{"address", address != nullptr ? *address : json("0")}};
    if (const json* camera = find(object, "camera"); camera != nullptr) place["camera"] = *camera;
    const Result<ViewPosition> read = viewPositionFromText(place.dump());
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
    out.selected = Selection::of(list.get<std::vector<Index>>());
    return std::nullopt;
}

Complaint readLooks(const json& object, SessionFile& out) {
    if (!readField(object, "alert", out.alert)) return expected("alert", "a class and a number");
    if (const json* on = find(object, "layers"); on != nullptr) {
        const ReadLayers read = layersFromJson(*on);
        out.layers = read.modes;
        out.leftOut = read.complaint();
    }
    if (const json* layout = find(object, "layout"); layout != nullptr) {
        if (layout->is_string()) {
            out.layout = layoutPresetFromName(layout->get<std::string>());
            out.lessons = opensLessons(layout->get<std::string>());
        }
        if (!out.layout)
            return expected("layout", "\"debug\", \"learn\", \"present\" or \"compare\"");
    }
    return readSelection(object, out);
}

/// The other run by its options, or a mesh or trace by its path.
Complaint readComparison(const json& object, const fs::path& folder, SessionFile& out) {
    const json* with = find(object, "compare");
    if (with == nullptr || with->is_null()) return std::nullopt;
    const Complaint wrong =
        expected("compare", "an object with \"options\", \"mesh\" or \"trace\"");
    if (!with->is_object()) return wrong;
    for (const auto& [kind, name] :
         {std::pair{CompareWith::Kind::Mesh, "mesh"}, {CompareWith::Kind::Trace, "trace"}}) {
        const json* file = find(*with, name);
        if (file == nullptr) continue;
        const std::string field = std::string("compare.") + name;
        if (!file->is_string()) return expected(field, "a path");
        const fs::path path = (folder / file->get<std::string>()).lexically_normal();
        if (isUnfit(path)) return unfit(field, path);
        out.with = {kind, {}, path.string()};
        return std::nullopt;
    }
    if (find(*with, "options") == nullptr) return wrong;
    RunSpec spec;
    spec.source = out.input.source;
    if (Complaint c = readOptions(*with, spec)) return "\"compare\": " + *c;
    out.with = CompareWith::otherRun(std::move(spec));
    return std::nullopt;
}

bool readCount(const json& object, const char* name, std::uint32_t least, std::uint32_t& out) {
    const json* count = find(object, name);
    if (count == nullptr) return true;
    if (!count->is_number_unsigned() || *count > std::numeric_limits<std::uint32_t>::max() ||
        *count < least)
        return false;
    out = count->get<std::uint32_t>();
    return true;
}

bool readBreakpoint(const json& object, Breakpoint& out) {
    return object.is_object() && object.contains("line") && readField(object, "line", out.line) &&
           readField(object, "name", out.name) && readField(object, "on", out.on) &&
           readField(object, "log_only", out.logOnly) && readCount(object, "skip", 0, out.skip) &&
           readCount(object, "every", 1, out.every);
}

/// Reads breakpoints and watches. A line that is not understood is kept unchanged; the panel
/// reports it.
Complaint readStops(const json& object, Annotations& out) {
    if (const json* list = find(object, "breakpoints"); list != nullptr) {
        const bool good =
            list->is_array() && std::all_of(list->begin(), list->end(), [&](const json& each) {
                return readBreakpoint(each, out.breakpoints.emplace_back());
            });
        if (!good)
            return expected("breakpoints",
                            "a list of objects with \"line\" and optionally \"name\", \"skip\", "
                            "\"every\" (from 1), \"on\" and \"log_only\"");
    }
    const json* list = find(object, "watches");
    if (list == nullptr) return std::nullopt;
    const bool good =
        list->is_array() &&
        std::all_of(list->begin(), list->end(), [](const json& each) { return each.is_string(); });
    if (!good) return expected("watches", "a list of texts");
    out.watches = list->get<std::vector<std::string>>();
    return std::nullopt;
}

void stopsToJson(const Annotations& annotations, json& object) {
    object["breakpoints"] = json::array();
    for (const Breakpoint& each : annotations.breakpoints) {
        object["breakpoints"].push_back({{"line", each.line},
                                         {"name", each.name},
                                         {"skip", each.skip},
                                         {"every", each.every},
                                         {"on", each.on},
                                         {"log_only", each.logOnly}});
    }
    object["watches"] = annotations.watches;
}

Complaint readNotes(const json& object, SessionFile& out) {
    if (!readField(object, "notes", out.annotations.notes)) return expected("notes", "text");
    if (!readField(object, "query", out.query)) return expected("query", "text");
    const json* list = find(object, "bookmarks");
    if (list == nullptr) return std::nullopt;
    if (!list->is_array()) return expected("bookmarks", "a list");
    for (const json& each : *list) {
        std::string text;
        std::string note;
        const bool good =
            each.is_object() && readField(each, "address", text) && readField(each, "note", note);
        const std::optional<Address> address = addressFromString(text);
        if (!good || !address)
            return expected("bookmarks",
                            "objects with \"address\" and optionally \"note\", both text");
        const Result<ViewPosition> view = viewPositionFromText(each.dump());
        if (!view) return expected("bookmarks", "a \"camera\" as Ctrl+C copies it, or none");
        insertBookmark(out.annotations.bookmarks, {*address, note, view.value().camera});
    }
    return std::nullopt;
}

Complaint readAll(const json& object, const fs::path& folder, SessionFile& out) {
    if (!object.is_object()) return "expected a JSON object as written by Ctrl+S";
    if (Complaint c = readHeader(object)) return c;
    if (Complaint c = readInput(object, folder, out)) return c;
    if (Complaint c = readOptions(object, out.input)) return c;
    if (Complaint c = readPosition(object, out)) return c;
    if (Complaint c = readLooks(object, out)) return c;
    if (Complaint c = readStops(object, out.annotations)) return c;
    if (Complaint c = readComparison(object, folder, out)) return c;
    return readNotes(object, out);
}

/// An object at `name`, with its previous fields.
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

json comparisonToJson(const CompareWith& with, const fs::path& folder) {
    const char* file = with.kind == CompareWith::Kind::Trace ? "trace" : "mesh";
    if (with.isFile()) return {{file, relativePath(with.path, folder)}};
    return {{"options", optionsToJson(with.run, json::object())}};
}

}  // namespace

std::string movedSource(const std::string& source,
                        const std::function<std::string(const std::string&)>& move) {
    if (isScene(source) || isPractice(source) || isPacked(source)) return source;
    if (!isSample(source)) return move(source);
    Result<SampleSpec> sample = sampleFromSource(source);
    // Errors in the path are reported when it is opened.
    if (!sample || !isVolumePath(sample.value().surface)) return source;
    sample.value().surface = move(sample.value().surface);
    return sampleSource(sample.value());
}

Result<SessionFile> sessionFromJson(std::string_view text, const std::string& name,
                                    const fs::path& folder) {
    const Result<json> parsed = teach::jsonFromText<json>(text, name);
    if (!parsed) return parsed.error();
    const json& object = parsed.value();
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
    object["version"] = kFileVersion;
    json& input = objectAt(object, "input");
    input["source"] = relativeSource(session.input.source, folder);
    writeField(input, "hash", !session.inputHash.empty(), session.inputHash);
    object["options"] = optionsToJson(session.input, objectAt(object, "options"));
    object.erase("camera");
    object.update(json::parse(toText(session.place)));
    if (session.place.address.empty()) object["address"] = "0";
    if (session.layers) objectAt(object, "layers").update(layersToJson(*session.layers));
    if (session.layout) object["layout"] = rowOf(*session.layout).name;
    writeField(object, "compare", session.with.kind != CompareWith::Kind::Nothing,
               comparisonToJson(session.with, folder));
    const auto corners = session.selected.corners();
    const json points(std::vector<Index>(corners.begin(), corners.end()));
    writeField(object, "selected", !corners.empty(), corners.size() == 1 ? points[0] : points);
    writeField(object, "alert", !session.alert.empty(), session.alert);
    object["bookmarks"] = json::array();
    for (const Bookmark& each : session.annotations.bookmarks) {
        json mark = json::parse(toText(ViewPosition{toString(each.address), each.camera}));
        mark["note"] = each.note;
        object["bookmarks"].push_back(std::move(mark));
    }
    object["notes"] = session.annotations.notes;
    writeField(object, "query", !session.query.empty(), session.query);
    stopsToJson(session.annotations, object);
    return teach::jsonText(object);
}

Result<SessionFile> readSessionFile(const fs::path& path) {
    if (isUnfit(path)) return Error{path.string() + ": expected a regular file."};
    const Result<std::string> text = readBytes(path, kTextLimit);
    if (!text) return Error{text.error().message + "."};
    return sessionFromJson(text.value(), path.string(), path.parent_path());
}

Status writeSessionFile(const fs::path& path, const SessionFile& session) {
    return writeFileAtomically(path, sessionToJson(session, path.parent_path()));
}

}  // namespace se::view
