#include "settings.h"

#include <cstdlib>

#include "run/model.h"
#include "run/sample_spec.h"
#include "run/strings.h"
#include "session/playback.h"
#include "session/session_file.h"
#include "spiraling_edge/base/atomic_file.h"
#include "teach/json_text.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Of a file that the program keeps for itself, only what changed is written back: fields of others,
// and values that it does not understand, stay. A file that it cannot read is never lost.

constexpr int kKeptVersion = 1;

enum class KeptFate { None, Read, Damaged, Newer, Unreadable };

struct KeptContent {
    KeptFate fate = KeptFate::None;
    std::string text;
    json object = json::object();
    std::string reason;  ///< Why it was not read, without a period.
};

KeptContent contentOf(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (path.empty() || status.type() == fs::file_type::not_found) return {};
    const std::string name = path.filename().string();
    const auto unreadable = [&](const char* why) {
        return KeptContent{KeptFate::Unreadable, {}, json::object(), name + why};
    };
    if (!fs::is_regular_file(status)) return unreadable(" is no regular file");
    std::optional<std::string> text = readText(path);
    if (!text) return unreadable(" cannot be read");
    // A file without content has nothing that could be lost.
    if (trimmed(*text, kBlanks).empty()) return {};
    const auto damaged = [&](std::string why) {
        return KeptContent{KeptFate::Damaged, *text, json::object(), std::move(why)};
    };
    Result<json> read = teach::jsonFromText<json>(*text, name);
    if (!read) return damaged(read.error().message);
    json& object = read.value();
    if (!object.is_object()) return damaged(name + ": expected a JSON object");
    const auto version = object.find("version");
    if (version == object.end() || *version == kKeptVersion)
        return {KeptFate::Read, *text, std::move(object), {}};
    if (!version->is_number() || *version < kKeptVersion)
        return damaged(name + ": \"version\": expected " + std::to_string(kKeptVersion));
    return {KeptFate::Newer, *text, json::object(), name + " was written by a newer version"};
}

/// The file that keeps a damaged one: the first that is free, or has these bytes.
fs::path badPath(const fs::path& path, const std::string& text) {
    for (int i = 1;; ++i) {
        fs::path bad = path;
        bad += (i == 1 ? "" : "." + std::to_string(i)) + ".bad";
        std::error_code ignored;
        const bool isFree = fs::symlink_status(bad, ignored).type() == fs::file_type::not_found;
        if (isFree || (fs::is_regular_file(bad, ignored) && readText(bad) == text)) return bad;
    }
}

/// The merge patch (RFC 7396) that makes `after` of `before`. An object that is missing in `after`
/// counts as an empty one, so that fields of others in it stay.
json patchOf(const json& before, const json& after) {
    json patch = json::object();
    for (const auto& [key, value] : before.items()) {
        if (!after.contains(key))
            patch[key] = value.is_object() ? patchOf(value, json::object()) : json();
    }
    for (const auto& [key, value] : after.items()) {
        const auto old = before.find(key);
        if (old != before.end() && *old == value) continue;
        const bool both = old != before.end() && old->is_object() && value.is_object();
        patch[key] = both ? patchOf(*old, value) : value;
    }
    return patch;
}

/// The object in a file; an empty one if there is no file, or none that this version can read.
json readKept(const fs::path& path) { return contentOf(path).object; }

/// The reason why readKept() did not read an existing file, and what becomes of it, in sentences;
/// empty if there is none.
std::string keptComplaint(const fs::path& path) {
    const KeptContent content = contentOf(path);
    if (content.fate == KeptFate::None || content.fate == KeptFate::Read) return {};
    if (content.fate == KeptFate::Damaged)
        return content.reason + ". The defaults are used; before the file is written again, " +
               "it is kept as " + badPath(path, content.text).filename().string() + ".";
    return content.reason +
           ": it is left as it is, the defaults are used, and changes are not kept.";
}

/// Changes the file as it is on disk by the difference between two objects, or writes `after` if
/// there is none; makes the folder if necessary. A damaged file is kept beside it before, as
/// NAME.bad or, if another is there, NAME.2.bad and so on. One of a newer version, and one that
/// cannot be read, is left as it is. An empty path has no effect.
Status writeKept(const fs::path& path, const json& before, const json& after) {
    KeptContent content = contentOf(path);
    const bool leaves =
        content.fate == KeptFate::Newer || content.fate == KeptFate::Unreadable || path.empty();
    if (leaves) return success();
    if (content.fate == KeptFate::Damaged) {
        const Status kept = writeFileAtomically(badPath(path, content.text), content.text);
        if (!kept) return kept;
    }
    // What is usual is not written: it may be another in another version, or in another page.
    json object = content.fate == KeptFate::Read ? content.object : json::object();
    object.merge_patch(patchOf(before, after));
    object["version"] = kKeptVersion;
    if (content.fate == KeptFate::Read && object == content.object) return success();
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) return Error{"Cannot make the folder " + path.parent_path().string() + "."};
    return writeFileAtomically(path, teach::jsonText(object));
}

template <typename T>
T fieldIn(const json& object, const char* name, T low, T high, T otherwise) {
    const auto found = object.find(name);
    if (found == object.end() || !found->is_number()) return otherwise;
    const auto value = found->template get<double>();
    return value >= low && value <= high ? static_cast<T>(value) : otherwise;
}

/// Empty if there is no such text.
std::string wordIn(const json& object, const char* name) {
    const auto found = object.find(name);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

bool flagIn(const json& object, const char* name, bool otherwise) {
    const auto found = object.find(name);
    return found != object.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

/// An empty object if there is none.
json objectIn(const json& object, const char* name) {
    const auto found = object.find(name);
    return found != object.end() && found->is_object() ? *found : json::object();
}

/// "keys": {"step.pivot.next": "F10 ."}
KeyMap keysIn(const json& object, std::vector<std::string>& complaints) {
    KeyMap map;
    KeyMap::Changes wanted;
    const json chosen = objectIn(object, "keys");
    for (const auto& [id, keys] : chosen.items()) {
        if (keys.is_string()) wanted[id] = keys.get<std::string>();
    }
    complaints = map.load(wanted);
    return map;
}

PanelSizes panelSizesIn(const json& object) {
    const json panels = objectIn(object, "panels");
    return {fieldIn(panels, "column", 1.0F, 1000.0F, 0.0F), flagIn(panels, "columnFolded", false)};
}

/// The sizes that the user has changed, no others.
json toJson(const PanelSizes& sizes) {
    json object = json::object();
    if (sizes.column > 0.0F) object["column"] = sizes.column;
    if (sizes.folded) object["columnFolded"] = true;
    return object;
}

FoldedParts foldedPartsIn(const json& object) {
    FoldedParts parts;
    const json all = objectIn(object, "parts");
    for (const PartRow& part : partRows()) {
        const auto open = all.find(std::string(part.title));
        if (open != all.end() && open->is_boolean()) setOpen(parts, part, open->get<bool>());
    }
    return parts;
}

ViewSettings settingsFrom(const json& object, Theme usualTheme) {
    ViewSettings s;
    s.theme = usualTheme;
    s.theme = themeFromName(wordIn(object, "theme")).value_or(s.theme);
    s.uiScale = fieldIn(object, "uiScale", 0.75, 3.0, s.uiScale);
    s.width = fieldIn(object, "width", 320, 16384, s.width);
    s.height = fieldIn(object, "height", 240, 16384, s.height);
    s.playRate = fieldIn(object, "playRate", Playback::kSlowest, Playback::kFastest, s.playRate);
    s.legend = flagIn(object, "legend", s.legend);
    s.names = flagIn(object, "names", s.names);
    s.panels = panelSizesIn(object);
    s.parts = foldedPartsIn(object);
    s.keys = keysIn(object, s.complaints);
    s.up = upAxisFromName(wordIn(object, "up"));
    // The default of the program that wrote the file was not chosen; that of 0.1.0 was flat.
    const std::string style = wordIn(object, "meshStyle");
    const std::string usual = wordIn(object, "usualMeshStyle");
    if (style != (usual.empty() ? "flat" : usual))
        s.meshStyle = meshStyleFromName(style).value_or(s.meshStyle);
    s.pointTint = pointTintFromName(wordIn(object, "pointTint")).value_or(s.pointTint);
    if (const auto modes = object.find("layers"); modes != object.end()) {
        const ReadLayers read = layersFromJson(*modes);
        s.layers = read.modes;
        if (!read.unknown.empty()) s.complaints.push_back("settings.json: " + read.complaint());
    }
    return s;
}

json toJson(const ViewSettings& s) {
    json object = {{"version", 1},       {"theme", themeName(s.theme)},     {"width", s.width},
                   {"height", s.height}, {"playRate", s.playRate},          {"legend", s.legend},
                   {"names", s.names},   {"layers", layersToJson(s.layers)}};
    if (!s.keys.changes().empty()) object["keys"] = s.keys.changes();
    if (const json panels = toJson(s.panels); !panels.empty()) object["panels"] = panels;
    if (!s.parts.empty()) object["parts"] = s.parts;
    object["meshStyle"] = rowOf(s.meshStyle).name;
    object["usualMeshStyle"] = rowOf(ViewSettings{}.meshStyle).name;
    object["pointTint"] = rowOf(s.pointTint).name;
    if (s.up) object["up"] = upAxisName(*s.up);
    if (s.uiScale > 0.0) object["uiScale"] = s.uiScale;
    return object;
}

KeptState keptStateFrom(const json& object) {
    KeptState state;
    state.layout = layoutPresetFromName(wordIn(object, "layout")).value_or(state.layout);
    const json lessons = objectIn(object, "lessons");
    for (const auto& [source, step] : lessons.items()) {
        if (step.is_number_unsigned()) state.lessons[source] = step.get<std::size_t>();
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

json toJson(const KeptState& state) {
    json object = {{"version", 1},
                   {"layout", std::string(rowOf(state.layout).name)},
                   {"recent", state.recent}};
    if (!state.lessons.empty()) object["lessons"] = state.lessons;
    return object;
}

/// The file in the folder named by the variable, or `below` the home folder. Empty if there is no
/// home.
fs::path xdgFile(const char* variable, const char* below, const char* file) {
    // The XDG standard: relative paths are ignored.
    const auto named = [](const char* folder) { return folder != nullptr && folder[0] == '/'; };
    const char* folder = std::getenv(variable);
    const char* home = std::getenv("HOME");
    if (!named(folder) && !named(home)) return {};
    return (named(folder) ? fs::path(folder) : fs::path(home) / below) / "spiraling-edge" / file;
}

}  // namespace

fs::path settingsPath() { return xdgFile("XDG_CONFIG_HOME", ".config", "settings.json"); }

Result<ViewSettings> settingsFromJson(std::string_view text) {
    const Result<json> object = teach::jsonFromText<json>(text, "The settings");
    if (!object) return object.error();
    if (!object.value().is_object()) return Error{"The settings are not a JSON object."};
    return settingsFrom(object.value(), Theme::Dark);
}

std::string settingsToJson(const ViewSettings& s) { return teach::jsonText(toJson(s)); }

ViewSettings readSettings(const fs::path& path, Theme usual) {
    ViewSettings settings = settingsFrom(readKept(path), usual);
    const std::string complaint = keptComplaint(path);
    if (!complaint.empty()) settings.complaints.push_back(complaint);
    return settings;
}

Status writeSettings(const fs::path& path, const ViewSettings& before,
                     const ViewSettings& settings) {
    json old = toJson(before);
    const json now = toJson(settings);
    // A style that is chosen is written with the default of this version (settingsFrom()).
    if (old["meshStyle"] != now["meshStyle"]) old.erase("usualMeshStyle");
    return writeKept(path, old, now);
}

void remember(KeptState& state, const std::string& path) {
    if (path.empty() || isScene(path)) return;
    std::string source = path;
    if (isSample(path)) {
        const Result<SampleSpec> spec = sampleFromSource(path);
        if (!spec) return;
        source = sampleSource(spec.value());
    }
    const std::string whole = movedSource(source, wholePath);
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

fs::path statePath() { return xdgFile("XDG_STATE_HOME", ".local/state", "state.json"); }

KeptState keptStateFromJson(std::string_view text) {
    const Result<json> object = teach::jsonFromText<json>(text, "The state");
    return object && object.value().is_object() ? keptStateFrom(object.value()) : KeptState{};
}

std::string keptStateToJson(const KeptState& state) { return teach::jsonText(toJson(state)); }

KeptState readKeptState(const fs::path& path) { return keptStateFrom(readKept(path)); }

std::string KeptFile::complaint() const { return keptComplaint(path_); }

Status KeptFile::change(const std::function<void(KeptState&)>& change) const {
    if (!isOpen()) return success();
    const KeptState before = read();
    KeptState state = before;
    change(state);
    return writeKept(path_, toJson(before), toJson(state));
}

}  // namespace se::view
