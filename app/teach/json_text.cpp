#include "json_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "spiraling_edge/base/text_scan.h"

namespace se::teach {
namespace {

/// "line 3, column 14"; columns are counted in characters.
std::string placeOf(std::string_view text, std::size_t offset, std::size_t line) {
    const std::string_view before = text.substr(0, offset);
    const std::size_t start = before.rfind('\n') + 1;  // 0 in the first line.
    const auto isFirstByte = [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
    };
    line += static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const auto column = std::count_if(before.begin() + static_cast<std::ptrdiff_t>(start),
                                      before.end(), isFirstByte);
    return io::lineText(line) + ", column " + std::to_string(column + 1);
}

/// The byte after the string that begins at `at`.
std::size_t endOfString(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
    return std::min(at + 1, text.size());
}

std::string numberFault(std::span<const std::string_view> keys, std::string_view digits) {
    std::string trail;  // "options.reach"
    for (const std::string_view key : keys) {
        if (!key.empty()) trail.append(trail.empty() ? "" : ".").append(key);
    }
    return (trail.empty() ? "" : inQuotes(trail) + ": ") +
           "expected a number within the range of double, up to 1.79e308, got " + inQuotes(digits);
}

/// Stands for a value that an object lacks.
const nlohmann::json kMissing;

bool isPoint(const nlohmann::json& json, std::size_t count) {
    return json.is_number_unsigned() && json.get<std::uint64_t>() < count;
}

}  // namespace

// Walks over the tokens without recursion.
std::string jsonLimitFault(std::string_view text, std::size_t line) {
    std::array<std::string_view, kMaxJsonLevels> keys;  // The latest key of each open object.
    std::size_t depth = 0;
    std::string_view string;  // The latest one.
    for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
        const char c = text[at];
        end = at + 1;
        if (c == '"') {
            end = endOfString(text, at);
            string = text.substr(at + 1, end - at - 2);
        } else if (c == '-' || (c >= '0' && c <= '9')) {
            end = std::min(text.find_first_not_of("0123456789+-.eE", at), text.size());
            const std::string_view digits = text.substr(at, end - at);
            if (!numberIn<double>(digits))
                return placeOf(text, at, line) + ": " + numberFault({keys.data(), depth}, digits);
        } else if (c == '[' || c == '{') {
            if (depth == kMaxJsonLevels)
                return placeOf(text, at, line) + ": expected at most " +
                       std::to_string(kMaxJsonLevels) + " levels of lists and objects";
            keys[depth++] = {};
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        } else if (c == ':' && depth > 0) {
            keys[depth - 1] = string;
        }
    }
    return {};
}

std::string jsonSyntaxFault(std::string_view text, std::size_t byte) {
    const std::size_t offset = std::min(byte > 0 ? byte - 1 : 0, text.size());
    const std::string_view rest = text.substr(offset);
    return placeOf(text, offset, 1) + ": expected JSON, found " +
           (rest.empty() ? "the end" : inQuotes(rest.substr(0, rest.find('\n'))));
}

void JsonEntry::fail(std::string_view expected) const {
    const bool isMissing = &json_ == &kMissing;
    const auto replace = nlohmann::json::error_handler_t::replace;
    throw Error{
        file_ + (path_.empty() ? "" : ": " + path_) + ": expected " + std::string(expected) +
        (isMissing ? ", it is missing" : ", got " + excerpt(json_.dump(-1, ' ', false, replace)))};
}

bool JsonEntry::has(std::string_view key) const { return json_.is_object() && json_.contains(key); }

JsonEntry JsonEntry::at(std::string_view key) const {
    if (!json_.is_object()) fail("an object");
    const auto found = json_.find(key);
    return {found != json_.end() ? *found : kMissing, file_,
            (path_.empty() ? "" : path_ + ".") + std::string(key)};
}

std::vector<JsonEntry> JsonEntry::items(std::string_view expected) const {
    if (!json_.is_array()) fail(expected);
    std::vector<JsonEntry> all;
    for (std::size_t i = 0; i < json_.size(); ++i)
        all.emplace_back(json_[i], file_, path_ + "[" + std::to_string(i) + "]");
    return all;
}

std::string JsonEntry::text() const {
    if (!json_.is_string()) fail("a text");
    return json_.get<std::string>();
}

double JsonEntry::number() const {
    const double number = json_.is_number() ? json_.get<double>() : -1.0;
    if (!(number >= 0.0) || !std::isfinite(number)) fail("a number from 0 on");
    return number;
}

std::size_t JsonEntry::count() const {
    if (!json_.is_number_unsigned()) fail("a whole number from 0 on");
    return json_.get<std::size_t>();
}

bool JsonEntry::truth() const {
    if (!json_.is_boolean()) fail("true or false");
    return json_.get<bool>();
}

std::vector<std::string> JsonEntry::texts() const {
    std::vector<std::string> texts;
    for (const JsonEntry& each : items("a list of texts")) texts.push_back(each.text());
    return texts;
}

Index JsonEntry::point(std::size_t count) const {
    if (isPoint(json_, count)) return json_.get<Index>();
    fail("the number of a point, from 0" +
         (count < kNone ? " to " + std::to_string(count - 1) : std::string()));
}

std::vector<Index> JsonEntry::points(std::string_view expected, std::size_t count) const {
    if (!json_.is_array()) fail(expected);
    std::vector<Index> points;
    points.reserve(json_.size());
    // Entries are made for messages only: a trace has millions of points.
    for (const nlohmann::json& each : json_)
        points.push_back(isPoint(each, count) ? each.get<Index>()
                                              : items(expected)[points.size()].point(count));
    return points;
}

}  // namespace se::teach
