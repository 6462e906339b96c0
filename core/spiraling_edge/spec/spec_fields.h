/// The fields of a RunSpec in one table. Options of the programs and their help, keys of sessions
/// and lessons, differences in words and commands to copy follow from its rows: a new option of a
/// run is a member of RunSpec, a row here, and its use.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se {

enum class Fix : std::uint8_t;  // doctor/doctor.h

/// The subject of a field: a verb that does not run takes only some.
enum class SpecGroup : std::uint8_t {
    Reading,  ///< How much is read, and which part of it.
    Rules,
    Lists,    ///< Neighbor lists.
    Derived,  ///< Normals, walls and rims.
};

/// Type of a field's value in JSON and TOML. As text it is what an option takes.
enum class SpecType : std::uint8_t {
    Switch,   ///< true or false; as text "on" and "off".
    Whole,    ///< A whole number.
    Number,   ///< A number.
    Numbers,  ///< A list of numbers, "1,2,3", or a word.
    Word,     ///< A text.
    Rule,     ///< NAME=VALUE, an entry of an object.
};

/// Maximum number of neighbors that can be set; a larger number is taken for a typing error.
inline constexpr std::size_t kMostNeighbors = 1'000'000;

/// One row of the table.
struct SpecField {
    std::string_view key;       ///< In sessions and lessons: "what_if". Empty: an option alone.
    std::string_view option;    ///< "-k,--neighbors"; empty: it has none.
    std::string_view value;     ///< Name of its value in help; empty: none, it stands for `flag`.
    std::string_view flag;      ///< The text that an option without a value stands for.
    std::string_view help;      ///< One sentence.
    std::string_view expected;  ///< The texts that are valid: "a number > 0".
    /// A value in words, with its text in place of {}: "{} neighbors"; what it is without one.
    std::string_view words, without;
    SpecGroup group;
    SpecType type;
    bool repeats;               ///< A list: set() adds one.
    std::string_view excludes;  ///< Options with the same word here exclude each other.

    Status (*set)(RunSpec& spec, std::string_view text);
    /// The values that are set, as texts that set() reads; none by default.
    std::vector<std::string> (*texts)(const RunSpec& spec);
};

/// All fields, in the order in which they are applied.
std::span<const SpecField> specFields();
/// The field with that key; null if there is none.
const SpecField* findSpecField(std::string_view key);

/// Sets a value. Fails with a sentence, "expected a number > 0".
Status setField(const SpecField& field, RunSpec& spec, std::string_view text);

/// The value of one field.
struct FieldValue {
    const SpecField* field;
    std::string text;
    friend bool operator==(const FieldValue&, const FieldValue&) = default;
};
/// Values to set, in the order of the table: a change of a spec, or what was typed.
using SpecChange = std::vector<FieldValue>;

/// The rule that a value sets; null if it sets something else.
const RuleSetting* ruleOf(const FieldValue& value);

/// {{"rules", "robust"}, {"neighbors", "10"}}. Requires keys of the table, in its order.
SpecChange specChange(std::initializer_list<std::pair<std::string_view, std::string_view>> values);
/// The text that `change` has for a key; empty if it has none.
std::string_view textOf(const SpecChange& change, std::string_view key);

/// The change that makes a fix of the doctor by an option of a run; none for one that changes the
/// file.
SpecChange changeOf(Fix fix);

/// Sets the values. Fails with the first that is not valid, "--radius -1: expected a number > 0";
/// the spec is then changed in part.
Status applyChange(const SpecChange& change, RunSpec& spec);
/// `spec` after a change. Requires valid values.
RunSpec changed(RunSpec spec, const SpecChange& change);
/// The spec of another run, which differs by `change`: a set of rules replaces the single rules.
/// Requires valid values.
RunSpec otherRun(RunSpec spec, const SpecChange& change);
/// All that is set in `spec`.
SpecChange valuesOf(const RunSpec& spec);
/// The values of `to` that `from` does not have. Of rules: of one set those that differ, of another
/// set its choices.
SpecChange differenceOf(const RunSpec& from, const RunSpec& to);

/// "robust rules, 10 neighbors"; "no change" without a value.
std::string wordsOf(const SpecChange& change);
/// Text of no difference, as differenceText() gives it.
inline constexpr std::string_view kNoDifference = "the same";
/// Differences of `to`, also fields that are no longer set: "flip off, lists of the input";
/// kNoDifference if there are none. Many single rules are counted.
std::string differenceText(const RunSpec& from, const RunSpec& to);
/// The options of a change: {"--rules robust", "--neighbors 10"}, as words of a shell. Fields
/// without an option are passed over.
std::vector<std::string> optionsOf(const SpecChange& change);
/// The options of these groups, of all that is set, each after a blank.
std::string optionsText(const RunSpec& spec, std::initializer_list<SpecGroup> groups);

/// Reads options from words, {"--rules", "robust", "--symmetric"}. Fails with the word that is not
/// understood, or with two that exclude each other.
Result<SpecChange> changeFromWords(std::span<const std::string> words);

/// A JSON object of all that is set, under the keys: "options" of a session.
std::string optionsJson(const RunSpec& spec);
/// A text as JSON, in quotes. Bytes that are no UTF-8 stay.
std::string jsonQuoted(std::string_view text);
/// A start in JSON (docs/file-formats.md).
std::string startJson(const GivenStart& start);

}  // namespace se
