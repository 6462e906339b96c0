#include "lesson_keys.h"

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "json_text.h"
#include "lesson.h"
#include "question.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/stepper/event.h"

namespace se::teach {
namespace {

/// Length of the string at the start of `text`, with its quotes. One that is not closed ends with
/// its line, or with the text: toml++ refuses it there.
std::size_t stringLength(std::string_view text) {
    const char quote = text.front();
    const std::string longQuote(3, quote);
    const bool isLong = text.starts_with(longQuote);
    const std::string_view close = isLong ? std::string_view(longQuote) : text.substr(0, 1);
    for (std::size_t i = close.size(); i < text.size(); ++i) {
        if (quote == '"' && text[i] == '\\') {
            ++i;
        } else if (text.substr(i).starts_with(close)) {
            return i + close.size();
        } else if (!isLong && text[i] == '\n') {
            return i;
        }
    }
    return text.size();
}

bool startsString(std::string_view text) { return text.front() == '"' || text.front() == '\''; }

/// Length of what stands at the start of `text`: a string, a comment or one character.
std::size_t tokenLength(std::string_view text) {
    if (startsString(text)) return stringLength(text);
    return text.front() == '#' ? std::min(text.find('\n'), text.size()) : 1;
}

/// The first wrong sign outside of strings and comments; nothing if there is none. A bracket that
/// closes no bracket of its kind, or that begins the header of a table, which no block of a lesson
/// has; or a byte beyond ASCII; or a quotation mark within a word, where no string begins. `line`:
/// of the file, where the text begins.
std::optional<LessonFault> strayTomlSign(std::string_view toml, std::size_t line) {
    constexpr auto kBracket = "a bracket that does not belong there; a table is written as { ... }";
    constexpr auto kLetter =
        "a letter or sign that does not belong there; texts stand in \"quotation marks\"";
    constexpr std::string_view kBeforeString = " \t\r\n=[{,.";
    std::string open;
    bool startsLine = true;
    char before = '\n';
    while (!toml.empty()) {
        const std::size_t length = tokenLength(toml);
        const std::string_view token = toml.substr(0, length);
        if (static_cast<unsigned char>(token.front()) > 0x7F ||
            (startsString(token) && kBeforeString.find(before) == std::string_view::npos))
            return LessonFault{line, "", kLetter};
        if (token == "[" && startsLine && open.empty()) return LessonFault{line, "", kBracket};
        if (token == "[") open += ']';
        if (token == "{") open += '}';
        if (token == "]" || token == "}") {
            if (open.empty() || open.back() != token.front())
                return LessonFault{line, "", kBracket};
            open.pop_back();
        }
        line += static_cast<std::size_t>(std::count(token.begin(), token.end(), '\n'));
        before = token.back();
        startsLine = token == "\n" || (startsLine && (token == " " || token == "\t"));
        toml.remove_prefix(length);
    }
    return {};
}

/// One key of a block: its value goes into `Target`. `read` is false if the value is not what is
/// expected.
template <typename Target>
struct KeyRow {
    std::string_view name;
    std::string_view expected;
    bool (*read)(const toml::node&, Target&);
};

// Each reads a value of one type; false if it is another.
template <typename Value>
bool readValue(const toml::node& node, Value& out) {
    const toml::value<Value>* value = node.as<Value>();
    if (value == nullptr) return false;
    out = value->get();
    return true;
}

bool readValue(const toml::node& node, double& out) {
    if (node.is_integer()) {
        out = static_cast<double>(node.as_integer()->get());
    } else if (node.is_floating_point()) {
        out = node.as_floating_point()->get();
    } else {
        return false;
    }
    return std::isfinite(out) && out >= 0.0;
}

/// A text, or a whole number as text: points may be given as either.
bool readWord(const toml::node& node, std::string& out) {
    if (!node.is_integer()) return readValue(node, out);
    out = std::to_string(node.as_integer()->get());
    return true;
}

/// One word, or a list of words.
bool readValue(const toml::node& node, std::vector<std::string>& out) {
    out.clear();
    if (!node.is_array()) return readWord(node, out.emplace_back());
    return std::all_of(node.as_array()->begin(), node.as_array()->end(),
                       [&](const toml::node& each) { return readWord(each, out.emplace_back()); });
}

/// Names of points and their numbers.
bool readValue(const toml::node& node, std::vector<PointName>& out) {
    if (!node.is_table()) return false;
    for (const auto& [name, value] : *node.as_table()) {
        const auto* number = value.as_integer();
        if (number == nullptr || number->get() < 0 || number->get() >= kNone) return false;
        out.push_back({static_cast<Index>(number->get()), std::string(name.str())});
    }
    return true;
}

/// A key whose value is that of a member.
template <auto Member, typename Target>
bool read(const toml::node& node, Target& target) {
    return readValue(node, target.*Member);
}

bool isFrame(std::string_view word) { return word == "all" || word == "pivot"; }
bool isLayout(std::string_view word) {
    return word == "debug" || word == "learn" || word == "present" || word == "compare";
}
bool isView(std::string_view word) { return findNamed(lessonViews(), word) != nullptr; }
bool isKind(std::string_view word) { return findQuestionKind(word) != nullptr; }

/// An address, a share such as "50%", or "0", the start of the run.
bool isPlace(std::string_view text) {
    if (text == "0") return true;
    if (text.ends_with('%')) {
        const auto share = numberIn<double>(text.substr(0, text.size() - 1));
        return share && *share >= 0.0 && *share <= 100.0;
    }
    return addressFromString(text).has_value();
}

/// A key whose value is a text of this sort, or empty.
template <auto Member, bool (*isOfSort)(std::string_view), typename Target>
bool readSort(const toml::node& node, Target& target) {
    return readValue(node, target.*Member) &&
           ((target.*Member).empty() || isOfSort(target.*Member));
}
template <auto Member, typename Target>
bool readPlace(const toml::node& node, Target& target) {
    return readSort<Member, isPlace>(node, target);
}

/// Values of a field of the run, as words.
bool addWords(const toml::node& node, std::string_view key, SpecChange& change) {
    std::vector<std::string> words;
    if (!readValue(node, words)) return false;
    for (std::string& each : words) change.push_back({findSpecField(key), std::move(each)});
    return true;
}
/// A list of layers.
template <auto Member>
bool readLayers(const toml::node& node, LessonStep& step) {
    return readValue(node, step.*Member) &&
           std::all_of((step.*Member).begin(), (step.*Member).end(),
                       [](const std::string& word) { return isAmong(word, kLayerNames); });
}
template <typename Target>
bool readRules(const toml::node& node, Target& target) {
    return node.is_string() && addWords(node, "rules", target.rules);
}
template <typename Target>
bool readRule(const toml::node& node, Target& target) {
    return addWords(node, "switches", target.rules);
}

bool readVersion(const toml::node& node, Lesson&) {
    return node.is_integer() && node.as_integer()->get() == 1;
}

bool readWhatIfs(const toml::node& node, LessonStep& step) {
    return addWords(node, "what_if", step.rules);
}

/// Lists of words of the text and the claims for them.
bool readFacts(const toml::node& node, LessonStep& step) {
    if (!node.is_array()) return false;
    return std::all_of(node.as_array()->begin(), node.as_array()->end(), [&](const auto& each) {
        LessonFact& fact = step.facts.emplace_back();
        fact.line = step.lines.block + each.source().begin.line;
        if (!each.is_array() || !readValue(each, fact.claims) || fact.claims.size() < 2)
            return false;
        fact.words = fact.claims.front();
        fact.claims.erase(fact.claims.begin());
        return !io::wordsIn(fact.words).empty();
    });
}

/// A list is words as they are; one text is split at blanks.
bool readCompare(const toml::node& node, LessonStep& step) {
    if (!readValue(node, step.compare)) return false;
    if (node.is_array()) return !step.compare.empty();
    step.compare = io::wordsIn(step.compare.front());
    return !step.compare.empty();
}

/// "pivot 2/s"
bool readPlay(const toml::node& node, LessonStep& step) {
    std::string text;
    if (!readValue(node, text)) return false;
    const std::size_t blank = text.find(' ');
    if (blank == std::string::npos || !text.ends_with("/s")) return false;
    PlaySpeed play{text.substr(0, blank), 0.0};
    const std::string digits = text.substr(blank + 1, text.size() - blank - 3);
    if (digits.size() > 4 || digits.find_first_not_of("0123456789.") != std::string::npos)
        return false;
    play.perSecond = numberIn<double>(digits).value_or(0.0);
    step.play = play;
    return play.perSecond > 0.0 &&
           std::find(kPlayUnits.begin(), kPlayUnits.end(), play.unit) != kPlayUnits.end();
}

/// A text that names no answer of the run is the answer itself.
bool readAnswer(const toml::node& node, Question& question) {
    const auto* text = node.as_string();
    if (text != nullptr && (text->get().empty() || findRunAnswer(text->get()) != nullptr))
        return readValue(node, question.answer);
    if (!node.is_floating_point()) return readValue(node, question.typed);
    appendNumber(question.typed.emplace_back(), node.as_floating_point()->get());
    return true;
}

bool readOptions(const toml::node& node, Lesson& lesson);

constexpr std::string_view kPlace = "PIVOT[.STAGE[.N]], such as 9.sphere.2, or a share such as 50%";
constexpr std::string_view kKind = "one of points, point, choice, number, play";
constexpr std::string_view kView = "one of front, back, left, right, top, bottom";
constexpr std::string_view kLayers = "a list of layers, by the names in docs/lessons.md";

constexpr KeyRow<Lesson> kLessonKeys[] = {
    {"version", "1", readVersion},
    {"input", "a text: scene:ID, practice:SEED, or the path of a file", read<&Lesson::input>},
    {"options", "a table of one of neighbors, radius and reach, and symmetric", readOptions},
    {"rules", "the name of a set of rules", readRules<Lesson>},
    {"rule", "a list of NAME=VALUE", readRule<Lesson>},
    {"names", "a table of names and points, { p = 15 }", read<&Lesson::names>},
    {"view", kView, readSort<&Lesson::view, isView>},
    {"layout", "one of debug, learn, present, compare", readSort<&Lesson::layout, isLayout>},
    {"author", "a text", read<&Lesson::author>},
    {"license", "a text", read<&Lesson::license>},
};

constexpr KeyRow<LessonStep> kStepKeys[] = {
    {"minutes", "a number", read<&LessonStep::minutes>},
    {"at", kPlace, readPlace<&LessonStep::at>},
    {"until", kPlace, readPlace<&LessonStep::until>},
    {"play", "a speed such as \"pivot 2/s\" (sub-step, pivot or event)", readPlay},
    {"expect", "the outcome of the decision at `at`, such as \"removed\"",
     read<&LessonStep::expect>},
    {"facts", "a list of lists: words of the text, and claims for them", readFacts},
    {"input", "a text: scene:ID, practice:SEED, or the path of a file", read<&LessonStep::input>},
    {"names", "a table of names and points, { p = 15 }", read<&LessonStep::names>},
    {"rules", "the name of a set of rules", readRules<LessonStep>},
    {"rule", "a list of NAME=VALUE", readRule<LessonStep>},
    {"what_if", "a list of lines such as \"20.reciprocal keep 38\"", readWhatIfs},
    {"compare", "the options in which the other run differs", readCompare},
    {"select", "one to three points", read<&LessonStep::select>},
    {"view", kView, readSort<&LessonStep::view, isView>},
    {"camera", "a camera as Ctrl+C copies it, in '...'", read<&LessonStep::camera>},
    {"frame", "one of all, pivot", readSort<&LessonStep::frame, isFrame>},
    {"pin", kLayers, readLayers<&LessonStep::pin>},
    {"hide", kLayers, readLayers<&LessonStep::hide>},
};

constexpr KeyRow<Question> kAskKeys[] = {
    {"kind", kKind, readSort<&Question::kind, isKind>},
    {"at", kPlace, readPlace<&Question::at>},
    {"until", kPlace, readPlace<&Question::until>},
    {"answer", "a text, a number, or a list of points", readAnswer},
    {"options", "a list of texts, A to D", read<&Question::options>},
    {"verdicts", "for each option the outcome for which it is right", read<&Question::verdicts>},
    {"within", "a number", read<&Question::within>},
    {"why", kPlace, readPlace<&Question::why>},
    {"unchecked", "true or false", read<&Question::unchecked>},
};

/// A value as the text of an option; nothing if it has another type than the field.
std::optional<std::string> textOf(const toml::node& node, const SpecField& field) {
    double number = 0.0;
    bool on = false;
    if (field.type == SpecType::Switch && readValue(node, on)) return on ? "on" : "off";
    if (field.type == SpecType::Whole && node.is_integer())
        return std::to_string(node.as_integer()->get());
    if (field.type != SpecType::Number || !readValue(node, number)) return std::nullopt;
    return plainNumber(number);
}

bool readOptions(const toml::node& node, Lesson& lesson) {
    if (!node.is_table()) return false;
    for (const auto& [key, value] : *node.as_table()) {
        const SpecField* field = findSpecField(key.str());
        const bool isList = field != nullptr && field->group == SpecGroup::Lists;
        const auto text = isList ? textOf(value, *field) : std::nullopt;
        RunSpec spec;
        if (!text || !setField(*field, spec, *text)) return false;
        for (const FieldValue& each : lesson.options) {
            if (!field->excludes.empty() && each.field->excludes == field->excludes) return false;
        }
        lesson.options.push_back({field, *text});
    }
    return true;
}

/// Parses a block and reads each of its keys by its row.
template <typename Target>
void readBlock(const LessonBlock& block, std::span<const KeyRow<Target>> rows, Target& target,
               std::vector<LessonFault>& faults) {
    target.lines.block = block.line;
    if (auto stray = strayTomlSign(block.toml, block.line + 1)) {
        faults.push_back(std::move(*stray));
        return;
    }
    const toml::parse_result parsed = toml::parse(block.toml);
    if (!parsed) {
        faults.push_back({block.line + parsed.error().source().begin.line, "",
                          std::string(parsed.error().description())});
        return;
    }
    for (const auto& [key, value] : parsed.table()) {
        const std::string name(key.str());
        const std::size_t line = block.line + key.source().begin.line;
        const KeyRow<Target>* row = findNamed(rows, name);
        if (row == nullptr) {
            faults.push_back(
                {line, excerpt(name), "no such key; the nearest is " + nearestName(rows, name)});
            continue;
        }
        target.lines.keys.emplace_back(name, line);
        if (!row->read(value, target)) {
            faults.push_back({line, name, "expected " + std::string(row->expected)});
        }
    }
}

/// Faults of one block, by the lines of its keys.
class BlockFaults {
  public:
    BlockFaults(const KeyLines& lines, std::vector<LessonFault>& faults)
        : lines_(lines), faults_(faults) {}
    void add(std::string_view key, std::string message) {
        faults_.push_back({lines_.of(key), std::string(key), std::move(message)});
    }
    void names(const std::vector<PointName>& names) {
        for (const PointName& each : names) {
            const bool isWord = !each.name.empty() && each.name.size() <= 16 &&
                                each.name.find_first_of(" ,\t\n") == std::string::npos;
            if (!isWord) add("names", "a name is a short word, not " + inQuotes(each.name));
        }
    }

    /// Rules and what-ifs, each of which is valid or not by itself.
    void values(const SpecChange& rules) {
        for (const FieldValue& each : rules) {
            RunSpec trial;
            const Status set = applyChange({each}, trial);
            if (set) continue;
            add(each.field->type == SpecType::Rule ? "rule" : each.field->key, set.error().message);
        }
    }

  private:
    const KeyLines& lines_;
    std::vector<LessonFault>& faults_;
};

void checkOptions(const Question& question, BlockFaults& faults) {
    const std::size_t count = question.options.size();
    if ((count == 0 && question.kind == "choice") || count == 1 || count > 4)
        faults.add("options", "expected two to four answers, A to D");
    const std::set<std::string> different(question.options.begin(), question.options.end());
    if (different.size() < count) faults.add("options", "two of the answers are the same");
    if (!question.verdicts.empty() && question.verdicts.size() != count)
        faults.add("verdicts", "expected one for each of the options");
    std::vector<std::string> verdicts = question.verdicts;
    std::erase(verdicts, "");
    std::sort(verdicts.begin(), verdicts.end());
    if (std::adjacent_find(verdicts.begin(), verdicts.end()) != verdicts.end())
        faults.add("verdicts", "two of them are the same; one option is right, not two");
}

void checkAnswer(const Question& question, const QuestionKind& kind, BlockFaults& faults) {
    if (question.answer.empty() && question.typed.empty())
        faults.add("answer", "missing: " + std::string(kind.answers));
    const RunAnswer* row = findRunAnswer(question.answer);
    if (row != nullptr && row->kind != kind.name) {
        faults.add("answer", question.answer + " is an answer of questions of kind " +
                                 std::string(row->kind));
    }
}

void checkQuestion(const Question& question, std::vector<LessonFault>& all) {
    BlockFaults faults(question.lines, all);
    if (question.kind.empty()) {
        faults.add("kind", "missing: " + std::string(kKind));
        return;
    }
    checkOptions(question, faults);
    if (const QuestionKind* kind = findQuestionKind(question.kind))
        checkAnswer(question, *kind, faults);
}

void checkStep(const LessonStep& step, std::vector<LessonFault>& all) {
    BlockFaults faults(step.lines, all);
    faults.names(step.names);
    if (!step.names.empty() && step.input.empty())
        faults.add("names", "needs input, whose points they name; those of the lesson hold on");
    faults.values(step.rules);
    if (step.select.size() > 3) faults.add("select", "expected one to three points");
    const auto camera = jsonFromText<nlohmann::json>(
        step.camera, "expected JSON, as Ctrl+C copies it in the viewer");
    if (!step.camera.empty() && !camera) faults.add("camera", camera.error().message);
    if (step.play && step.until.empty()) faults.add("play", "needs until, where it ends");
    if (!step.compare.empty()) {
        const Result<SpecChange> other = changeFromWords(step.compare);
        if (!other) faults.add("compare", other.error().message);
    }
    for (const LessonLink& link : step.links) {
        if (!isPlace(link.address)) {
            all.push_back(
                {link.line, "",
                 "se:" + excerpt(link.address) + ": expected an address, such as se:9.sphere.2"});
        }
    }
    if (step.question) checkQuestion(*step.question, all);
}

}  // namespace

void readLessonBlock(const LessonBlock& block, Lesson& lesson, std::vector<LessonFault>& faults) {
    readBlock<Lesson>(block, kLessonKeys, lesson, faults);
}

void readStepBlock(const LessonBlock& block, LessonStep& step, std::vector<LessonFault>& faults) {
    readBlock<LessonStep>(block, kStepKeys, step, faults);
}

void readAskBlock(const LessonBlock& block, Question& question, std::vector<LessonFault>& faults) {
    readBlock<Question>(block, kAskKeys, question, faults);
}

std::vector<std::string_view> lessonKeys() {
    std::vector<std::string_view> names;
    const auto add = [&](const auto& rows) {
        for (const auto& row : rows) names.push_back(row.name);
    };
    add(kLessonKeys);
    add(kStepKeys);
    add(kAskKeys);
    return names;
}

std::vector<LessonFault> syntaxFaults(const Lesson& lesson) {
    std::vector<LessonFault> all;
    BlockFaults faults(lesson.lines, all);
    if (lesson.lines.of("version") == lesson.lines.block)
        faults.add("version", "missing: write version = 1");
    if (lesson.input.empty()) faults.add("input", "missing: scene:ID, or the path of a file");
    faults.names(lesson.names);
    faults.values(lesson.rules);
    for (const LessonStep& step : lesson.steps) checkStep(step, all);
    return all;
}

}  // namespace se::teach
