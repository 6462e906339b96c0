#include "paper_text.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <sstream>
#include <utility>

#include "run/embedded_files.h"
#include "run/model.h"
#include "run/strings.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/run/reading.h"

namespace se::view {

namespace {

/// Reads assets/paper_text.txt or paper_words.txt, which describe their form themselves.
std::vector<PaperRule> readRules(std::string_view file) {
    std::vector<PaperRule> rules;
    std::istringstream text{std::string(embeddedFile(file))};
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with('[')) {
            const std::size_t end = line.find("] ");
            rules.push_back({line.substr(1, end - 1), line.substr(end + 2), {}, {}});
        } else if (line.starts_with("    ")) {
            rules.back().code.push_back(line.substr(4));
        } else if (!rules.empty() && !line.empty()) {
            rules.back().words += (rules.back().words.empty() ? "" : " ") + line;
        }
    }
    return rules;
}

/// One line per kind of evidence.
struct LineOfPaper {
    Stage stage;
    std::size_t operator()(const SeedEvidence&) const { return 4; }
    std::size_t operator()(const StrandEvidence&) const { return 3; }
    std::size_t operator()(const PivotEvidence&) const { return 1; }
    std::size_t operator()(const SkipEvidence&) const { return 4; }
    std::size_t operator()(const InsertEvidence& e) const {
        if (e.verdict == Verdict::NoThirdPoint || e.verdict == Verdict::OtherSideOpen) return 4;
        return e.corner ? 3 : 1;
    }
    std::size_t operator()(const SortEvidence& e) const {
        if (e.verdict == Verdict::SameAngle) return 5;
        return e.verdict == Verdict::AlreadyDone || e.verdict == Verdict::OnRingEnd ? 1 : 3;
    }
    std::size_t operator()(const LimitEvidence& e) const {
        if (e.moves()) return 4;
        const bool placed = e.verdict == Verdict::NotConcave || e.verdict == Verdict::HalfTurn ||
                            e.verdict == Verdict::Blocked || isWhatIf(e.verdict);
        return placed ? 3 : 2;
    }
    std::size_t operator()(const DropEvidence& e) const {
        if (stage != Stage::Convex) return 5;
        return isTaken(e.verdict) ? 0 : 1;
    }
    std::size_t operator()(const ReciprocalEvidence&) const { return 2; }
    std::size_t operator()(const HoleEvidence&) const { return 2; }
    std::size_t operator()(const SphereEvidence& e) const {
        if (e.verdict == Verdict::InsideSphere) return 2;
        return isTaken(e.verdict) ? 3 : 4;
    }
    std::size_t operator()(const TwoPointEvidence& e) const { return isTaken(e.verdict) ? 3 : 2; }
    std::size_t operator()(const EmitEvidence&) const { return 1; }
    std::size_t operator()(const RingEvidence& e) const { return e.inserted ? 1 : 0; }
    std::size_t operator()(const CloseEvidence&) const { return 2; }
    std::size_t operator()(const SplitEvidence&) const { return 4; }
    std::size_t operator()(const JoinEvidence& e) const { return e.depthFromTop == kNone ? 4 : 5; }
    std::size_t operator()(const AdvanceEvidence& e) const { return e.popped ? 2 : 0; }
    std::size_t operator()(const GuardEvidence& e) const {
        if (isWhatIf(e.verdict)) return isTaken(e.verdict) ? 1 : 4;
        if (e.dropped != kNone) return 3;
        const bool waits = e.verdict == Verdict::WideGap || e.verdict == Verdict::OverRim ||
                           e.verdict == Verdict::Steep;
        return waits ? 2 : 4;
    }
    std::size_t operator()(const FillEvidence& e) const { return e.forced ? 4 : 3; }
    std::size_t operator()(const ReinsertEvidence&) const { return 3; }
    std::size_t operator()(const FlipEvidence&) const { return 3; }
    std::size_t operator()(const DropPatchEvidence&) const { return 2; }
    std::size_t operator()(const CloseHoleEvidence&) const { return 2; }
    std::size_t operator()(const RemeshEvidence&) const { return 3; }
    std::size_t operator()(const ShelveEvidence&) const { return 2; }
    std::size_t operator()(const FreeEvidence&) const { return 2; }
    std::size_t operator()(const ComponentEvidence&) const { return 3; }
    std::size_t operator()(const FinishedEvidence& e) const { return e.capped ? 3 : 2; }
    template <typename Other>
    std::size_t operator()(const Other&) const {
        return 0;
    }
};

}  // namespace

const PaperRule& paperRule(Stage stage) {
    static const std::vector<PaperRule> rules = readRules("paper_text.txt");
    const PaperRule* found = rowWhere(rules, [&](const PaperRule& rule) {
        return isAmong(stageName(stage), io::wordsIn(rule.stages));
    });
    assert(found != nullptr);
    return *found;
}

std::size_t presentLine(const Event& event) {
    return std::visit(LineOfPaper{event.address.stage}, event.evidence);
}

std::string liveNumbers(const Event& event) {
    const Overloaded numbers{
        [](const SeedEvidence& e) { return formatted("distance %.4g", e.distance); },
        [](const PivotEvidence& e) { return formatted("free: %.1f\xC2\xB0", e.sectorDegrees); },
        [](const SortEvidence& e) {
            return formatted("angle %.1f\xC2\xB0, end %.1f\xC2\xB0", e.degrees, e.endDegrees);
        },
        [](const LimitEvidence& e) {
            return isMeasured(e) ? formatted("turn %+.3g (concave if > 0)", e.turn) : std::string();
        },
        [](const ReciprocalEvidence& e) {
            return formatted("a = %.1f\xC2\xB0, free to %.1f\xC2\xB0", e.degrees, e.limitDegrees);
        },
        [](const HoleEvidence& e) {
            return formatted("side %+.3g, that of the pivot %+.3g", e.side, e.pivotSide);
        },
        [](const SphereEvidence& e) {
            return hasSphere(e) ? formatted("|q - c| = %.4g, r = %.4g, gap %.1f\xC2\xB0",
                                            e.distance, e.radius, e.gapDegrees)
                                : formatted("in line; gap %.1f\xC2\xB0", e.gapDegrees);
        },
        [](const TwoPointEvidence& e) { return formatted("angle %.1f\xC2\xB0", e.degrees); },
        [](const FillEvidence& e) { return formatted("least angle %.1f\xC2\xB0", e.leastDegrees); },
        [](const auto&) { return std::string{}; },
    };
    std::string text = std::visit(numbers, event.evidence);
    if (const auto verdict = verdictOf(event); verdict && isWhatIf(*verdict))
        text = std::string(verdictText(*verdict)) + (text.empty() ? "" : "; " + text);
    return text;
}

namespace {

const std::vector<PaperWord>& words() {
    static const std::vector<PaperWord> read = [] {
        std::vector<PaperWord> words;
        for (PaperRule& each : readRules("paper_words.txt"))
            words.push_back({std::move(each.title), std::move(each.stages), std::move(each.words)});
        return words;
    }();
    return read;
}

bool same(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

/// True if `word` is one of those between the bars.
bool isNamed(const PaperWord& row, std::string_view word) {
    for (std::string_view rest = row.words; !rest.empty();) {
        const std::size_t bar = std::min(rest.find('|'), rest.size());
        if (same(rest.substr(0, bar), word)) return true;
        rest.remove_prefix(std::min(bar + 1, rest.size()));
    }
    return false;
}

}  // namespace

std::span<const PaperWord> paperWords() { return words(); }

std::string definitionOf(std::string_view word) {
    const PaperWord* found =
        rowWhere(words(), [&](const PaperWord& row) { return isNamed(row, word); });
    if (found == nullptr) return {};
    return found->words.substr(0, found->words.find('|')) + " (paper, " + found->section +
           "): " + found->sentence;
}

}  // namespace se::view
