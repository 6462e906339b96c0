#include "lesson_skeleton.h"

#include <array>
#include <cassert>
#include <optional>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/why/figure_check.h"

namespace se::teach {
namespace {

/// A step of the skeleton: the first decision that meets the condition.
struct SkeletonStep {
    std::string_view title;
    std::string_view text;
    bool (*matches)(const Event&);
};

bool isRefused(const Event& event) { return outcomeOf(event) == Outcome::Refused; }

constexpr std::array kSkeletonSteps{
    SkeletonStep{"The first two points",
                 "The edge ring begins with a point and its nearest neighbor.",
                 [](const Event& e) { return e.address.stage == Stage::Seed; }},
    SkeletonStep{"A neighbor is left out", "Each neighbor is tested; this one is refused.",
                 isRefused},
    SkeletonStep{"The first triangle", "Its first corner is the pivot.",
                 [](const Event& e) { return e.address.stage == Stage::Emit; }},
    SkeletonStep{
        "Start or end moves", "The edge ring is concave beside the pivot.",
        [](const Event& e) { return isA<LimitEvidence>(e) && as<LimitEvidence>(e)->moves(); }},
    SkeletonStep{
        "A point on the finished side", "Seen from it, the pivot could be no neighbor.",
        [](const Event& e) { return e.address.stage == Stage::Reciprocal && isRefused(e); }},
    SkeletonStep{"The edge ring splits", "It meets itself: one point stands on it twice.",
                 [](const Event& e) { return e.address.stage == Stage::Split; }},
    SkeletonStep{"Two rings join", "A point of another ring is reached.",
                 [](const Event& e) { return e.address.stage == Stage::Join; }},
};

void addKey(std::string& text, std::string_view key, const std::string& value) {
    text += std::string(key) + " = \"" + value + "\"\n";
}

/// A text as TOML can hold it between double quotes.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c == '\n' ? std::string("\\n") : std::string(1, c);
    }
    return printableJson(out);
}

void addStep(std::string& text, const SkeletonStep& step, const Event& event) {
    text += "\n## " + std::string(step.title) + "\n\n" + std::string(step.text) + " " +
            describe(event) + "\n\n";
    text += "```se step\n";
    text += "minutes = 1\n";
    addKey(text, "at", toString(event.address));
    if (const std::string outcome = outcomeText(event); !outcome.empty())
        addKey(text, "expect", escaped(outcome));
    text += "```\n";
}

/// The question for the points that the circumsphere removes at a pivot.
void addQuestion(std::string& text, std::uint32_t pivot, const Address& last) {
    const std::string number = std::to_string(pivot);
    text +=
        "\n## Which neighbors go?\n\n"
        "For each neighbor in turn: a circle through the pivot and the two beside it. A neighbor\n"
        "outside of the sphere around that circle goes, unless a gap over 120 degrees would be\n"
        "left. Which of them go?\n\n";
    text += "```se step\n";
    text += "minutes = 2\n```\n\n";
    text += "```se ask\n";
    addKey(text, "kind", "points");
    addKey(text, "at", number + ".pivot.1");
    addKey(text, "until", toString(last));
    addKey(text, "answer", "refused");
    addKey(text, "why", number + ".sphere.1");
    text += "```\n";
}

/// The decisions that the skeleton shows.
struct SkeletonFinds {
    std::array<std::optional<Event>, kSkeletonSteps.size()> events;
    std::optional<Address> lastTest;  ///< Of the first pivot that removes and keeps points.
};

/// Notes the first matches of one pivot.
void takePivot(std::span<const Event> events, SkeletonFinds& finds) {
    bool removes = false, keeps = false;
    std::optional<Address> last;
    for (const Event& event : events) {
        for (std::size_t i = 0; i < kSkeletonSteps.size(); ++i) {
            if (!finds.events[i] && kSkeletonSteps[i].matches(event)) finds.events[i] = event;
        }
        if (event.address.stage != Stage::Sphere) continue;
        (outcomeOf(event) == Outcome::Refused ? removes : keeps) = true;
        last = event.address;
    }
    if (!finds.lastTest && removes && keeps) finds.lastTest = last;
}

SkeletonFinds findsOf(const PreparedRun& run) {
    SkeletonFinds finds;
    sweep(*run.points, run.params,
          [&](const SweptPivot& pivot) { takePivot(pivot.events, finds); });
    return finds;
}

/// `key = ["a", "b"]`; nothing for an empty list.
void addList(std::string& text, std::string_view key, const std::vector<std::string>& values) {
    if (values.empty()) return;
    std::string list;
    for (const std::string& each : values)
        list += (list.empty() ? "\"" : ", \"") + escaped(each) + '"';
    text += std::string(key) + " = [" + list + "]\n";
}

/// `options = { neighbors = 16 }`; nothing for the lists of the input.
void addOptions(std::string& text, const RunSpec& spec) {
    std::string list;
    for (const auto& [field, value] : valuesOf(spec)) {
        if (field->group != SpecGroup::Lists) continue;
        const bool on = field->type == SpecType::Switch;
        list.append(list.empty() ? "" : ", ").append(field->key).append(" = ");
        list += on ? "true" : value;
    }
    if (!list.empty()) text += "options = { " + list + " }\n";
}

/// The title of a lesson and its block, which is still open.
std::string beginningOf(const std::string& input) {
    std::string text = "# A lesson on " + printable(input) + "\n\n";
    text += "```se lesson\n";
    text += "version = 1\n";
    addKey(text, "input", escaped(input));
    return text;
}

/// A heading is one line without marks of its own.
std::string headingOf(const NotedPosition& position) {
    if (position.note.empty()) return position.address;
    std::string line = position.note.substr(0, position.note.find('\n'));
    const std::size_t first = line.find_first_not_of("# ");
    return first == std::string::npos ? position.address : line.substr(first);
}

}  // namespace

std::string lessonOfNotes(const std::string& input, const RunSpec& spec, const std::string& intro,
                          const std::vector<NotedPosition>& notes) {
    assert(!notes.empty());
    std::string text = beginningOf(input);
    addOptions(text, spec);
    if (spec.rules != RunSpec{}.rules) addKey(text, "rules", spec.rules);
    addList(text, "rule", findSpecField("switches")->texts(spec));
    text += "```\n";
    if (!intro.empty()) text += "\n" + intro + "\n";
    for (const NotedPosition& each : notes) {
        text += "\n## " + headingOf(each) + "\n\n";
        text += "```se step\n";
        addKey(text, "at", each.address);
        if (!each.camera.empty()) text += "camera = '" + each.camera + "'\n";
        addList(text, "what_if", findSpecField("what_if")->texts(spec));
        text += "```\n";
    }
    return text;
}

Result<std::string> lessonSkeleton(const std::string& input, const PreparedRun& run) {
    const SkeletonFinds finds = findsOf(run);
    std::string steps;
    for (std::size_t i = 0; i < kSkeletonSteps.size(); ++i) {
        if (finds.events[i]) addStep(steps, kSkeletonSteps[i], *finds.events[i]);
        if (i == 0 && finds.lastTest) addQuestion(steps, finds.lastTest->pivot, *finds.lastTest);
    }
    if (steps.empty()) return Error{input + ": the run has no decision to show"};
    return beginningOf(input) + "```\n\nSay here what the lesson shows, and for whom.\n" + steps;
}

}  // namespace se::teach
