#include "palette_entries.h"

#include <algorithm>
#include <array>

#include "document/actions.h"
#include "document/document.h"
#include "jobs/open_lesson.h"
#include "panel_state/column.h"
#include "run/model.h"
#include "run/strings.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

namespace {

constexpr std::string_view kPanelNote = "Panel";
constexpr std::string_view kSceneNote = "Scene";

PaletteEntry entryOf(const Scene& scene, std::string_view synonyms) {
    return {PaletteEntry::Kind::Scene, scene.title, kSceneNote, synonyms, scene.id, scene.watch};
}

/// Whether a word of the text begins with `start`. Words are letters and digits, separated by all
bool hasWordStart(std::string_view text, std::string_view start) {
    /// else.
    const auto isInner = [](char sign) {
        return (sign >= 'a' && sign <= 'z') || (sign >= '0' && sign <= '9');
    };
    for (std::size_t at = text.find(start); at != std::string_view::npos;
         at = text.find(start, at + 1)) {
        if (at == 0 || !isInner(text[at - 1])) return true;
    }
    return false;
}

bool hasAll(const std::string& text, std::span<const std::string> words) {
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return hasWordStart(text, word); });
}

/// Quality of a match, the best first.
enum class Fit : std::uint8_t { Named, Title, Synonyms, Elsewhere, None };

Fit fitOf(const PaletteEntry& entry, std::string_view filter, std::span<const std::string> words) {
    std::string text = lowerCase(entry.title);
    if (text == filter) return Fit::Named;
    if (hasAll(text, words)) return Fit::Title;
    text.append(" ").append(entry.synonyms);
    if (hasAll(text, words)) return Fit::Synonyms;
    text.append(" ").append(lowerCase(entry.note));
    text.append(" ").append(entry.id).append(" ").append(lowerCase(entry.help));
    return hasAll(text, words) ? Fit::Elsewhere : Fit::None;
}

}  // namespace

std::vector<PaletteEntry> paletteEntries() {
    std::vector<PaletteEntry> entries;
    for (const Command& each : commands())
        entries.push_back({PaletteEntry::Kind::Action, each.title, each.group, each.synonyms,
                           each.id, each.help});
    for (const PartRow& part : partRows()) {
        const auto all = commands();
        const bool known = std::any_of(
            all.begin(), all.end(), [&](const Command& each) { return each.title == part.title; });
        if (!known)
            entries.push_back({PaletteEntry::Kind::Panel, part.title, kPanelNote, part.synonyms,
                               part.title, "Show this panel."});
    }
    for (const LessonEntry& each : lessonEntries())
        entries.push_back({PaletteEntry::Kind::Lesson, each.title, "Lesson", "teach course open",
                           each.source, each.text});
    for (const Scene& scene : scenes()) entries.push_back(entryOf(scene, "example open"));
    for (const Figure& each : figures()) {
        if (each.sample.empty()) continue;
        entries.push_back(entryOf(each.scene, "example open sample"));
        entries.back().id = each.sample;
    }
    for (const FailureScene& each : failureScenes())
        entries.push_back(entryOf(each.scene, "example open failure gallery wrong"));
    return entries;
}

std::vector<PaletteEntry> matchingEntries(std::span<const PaletteEntry> entries,
                                          std::string_view filter) {
    const std::string low = lowerCase(trimmed(filter));
    const std::vector<std::string> words = io::wordsIn(low);
    std::array<std::vector<PaletteEntry>, static_cast<std::size_t>(Fit::None) + 1> byFit;
    for (const PaletteEntry& each : entries)
        byFit[static_cast<std::size_t>(fitOf(each, low, words))].push_back(each);
    byFit.back().clear();
    std::vector<PaletteEntry> matches;
    for (const auto& list : byFit) matches.insert(matches.end(), list.begin(), list.end());
    return matches;
}

void choose(const PaletteEntry& entry, CommandContext& context) {
    switch (entry.kind) {
        case PaletteEntry::Kind::Action:
            return runCommand(*findCommand(entry.id), context);
        case PaletteEntry::Kind::Panel:
            return actions::openPart(context, entry.id);
        case PaletteEntry::Kind::Scene:
            return context.document.open(isSample(entry.id) ? std::string(entry.id)
                                                            : sceneSource(entry.id));
        case PaletteEntry::Kind::Lesson:
            return context.document.open(std::string(entry.id));
    }
}

}  // namespace se::view
