#include "kept_json.h"

#include "run/strings.h"
#include "spiraling_edge/base/atomic_file.h"
#include "teach/json_text.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

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
    if (text->find_first_not_of(" \t\r\n") == std::string::npos) return {};
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

}  // namespace

json readKept(const fs::path& path) { return contentOf(path).object; }

std::string keptComplaint(const fs::path& path) {
    const KeptContent content = contentOf(path);
    const std::string leftAlone =
        content.reason + ": it is left as it is, the defaults are used, and changes are not kept.";
    switch (content.fate) {
        case KeptFate::None:
        case KeptFate::Read:
            return {};
        case KeptFate::Damaged:
            return content.reason + ". The defaults are used; before the file is written again, " +
                   "it is kept as " + badPath(path, content.text).filename().string() + ".";
        case KeptFate::Newer:
        case KeptFate::Unreadable:
            return leftAlone;
    }
    return {};
}

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

}  // namespace se::view
