#include "spiraling_edge/stepper/what_if.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/text_scan.h"

namespace se {
namespace {

/// By WhatIfKind.
constexpr std::array<std::string_view, 5> kVerbs{"keep", "drop", "pivot", "move", "list"};
static_assert(kVerbs.size() == static_cast<std::size_t>(WhatIfKind::List) + 1);

Error expected(std::string_view text) {
    return Error{inQuotes(text) +
                 " is no what-if. Write 137.sphere keep 812, 137.sphere drop 812, 137.advance "
                 "pivot 640, 137 move 812 X Y Z, or 137 list 812 5 7 9."};
}

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> found;
    io::Fields fields(text, ',');
    for (auto word = fields.next(); !word.empty(); word = fields.next()) found.push_back(word);
    return found;
}

bool readIndex(std::string_view word, Index& out) {
    std::int64_t value = 0;
    if (!io::parseInteger(word, value) || value < 0 || value >= kNone) return false;
    out = static_cast<Index>(value);
    return true;
}

bool readPosition(const std::vector<std::string_view>& parts, Vec3& out) {
    if (parts.size() != 6) return false;
    std::size_t word = 3;
    for (double* value : {&out.x, &out.y, &out.z}) {
        if (!io::parseDouble(parts[word++], *value) || !std::isfinite(*value)) return false;
    }
    return true;
}

bool readList(const std::vector<std::string_view>& parts, std::vector<Index>& out) {
    for (std::size_t i = 3; i < parts.size(); ++i) {
        if (!readIndex(parts[i], out.emplace_back())) return false;
    }
    return true;
}

/// Reads the words after the verb; false if they or the place do not fit it.
bool readRest(const std::vector<std::string_view>& parts, Stage stage, WhatIf& out) {
    switch (out.kind) {
        case WhatIfKind::Keep:
        case WhatIfKind::Drop:
            out.stage = stage;
            return parts.size() == 3 && rowOf(stage).tests != StageTests::None;
        case WhatIfKind::Pivot:
            out.stage = Stage::Advance;
            return parts.size() == 3 && (stage == Stage::Advance || stage == Stage::Pivot);
        case WhatIfKind::Move:
            return stage == Stage::Pivot && readPosition(parts, out.to);
        case WhatIfKind::List:
            return stage == Stage::Pivot && readList(parts, out.list);
    }
    return false;
}

std::string pointText(const WhatIf& what) { return "point " + std::to_string(what.point); }

}  // namespace

std::string lineOf(const WhatIf& what) {
    std::string text = std::to_string(what.pivot);
    if (what.stage != Stage::Pivot) text += "." + std::string(stageName(what.stage));
    text += " " + std::string(kVerbs[static_cast<std::size_t>(what.kind)]) + " " +
            std::to_string(what.point);
    for (int i = 0; what.kind == WhatIfKind::Move && i < 3; ++i) {
        text += ' ';
        appendNumber(text, what.to[i]);
    }
    for (const Index q : what.list) text += " " + std::to_string(q);
    return text;
}

std::string describe(const WhatIf& what) {
    const std::string pivot = "pivot " + std::to_string(what.pivot);
    const std::string stage(stageName(what.stage));
    switch (what.kind) {
        case WhatIfKind::Keep:
            if (what.stage == Stage::TwoPoint) return "At " + pivot + " the triangle is made.";
            if (what.stage == Stage::Limits)
                return "At " + pivot + " start or end advances to " + pointText(what) + ".";
            if (what.stage == Stage::Guard)
                return "At " + pivot + " the rules on fans do not apply to " + pointText(what) +
                       ".";
            return "At " + pivot + ", " + stage + ": " + pointText(what) + " is kept.";
        case WhatIfKind::Drop:
            if (rowOf(what.stage).tests == StageTests::OfFans)
                return "At " + pivot + " no triangle is made.";
            return "At " + pivot + ", " + stage + ": " + pointText(what) +
                   (what.stage == Stage::Limits ? " is not advanced to." : " is dropped.");
        case WhatIfKind::Pivot:
            return "After " + pivot + " the run continues at " + pointText(what) + ".";
        case WhatIfKind::Move:
            return "From " + pivot + " on " + pointText(what) + " is elsewhere.";
        case WhatIfKind::List:
            return "From " + pivot + " on " + pointText(what) + " has another list, of " +
                   std::to_string(what.list.size()) + ".";
    }
    return {};
}

Result<WhatIf> whatIfFromText(std::string_view text) {
    const std::vector<std::string_view> parts = words(text);
    if (parts.size() < 3) return expected(text);
    const auto place = addressFromString(parts[0]);
    const auto verb = std::find(kVerbs.begin(), kVerbs.end(), parts[1]);
    WhatIf what;
    if (!place || place->pivot == 0 || verb == kVerbs.end() || !readIndex(parts[2], what.point)) {
        return expected(text);
    }
    what.kind = static_cast<WhatIfKind>(verb - kVerbs.begin());
    what.pivot = place->pivot;
    if (!readRest(parts, place->stage, what)) return expected(text);
    return what;
}

Address placeOf(const WhatIf& what) { return {what.pivot, what.stage, 0}; }

}  // namespace se
