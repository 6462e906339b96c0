/// The options of both programs that describe a run: those of the table of fields (spec_fields.h).
#pragma once

#include <CLI/CLI.hpp>
#include <deque>
#include <initializer_list>
#include <string>
#include <vector>

#include "spiraling_edge/spec/spec_fields.h"

namespace se {

/// Options bound to a command line. Must outlive the parsing, and is never copied.
class SpecOptions {
  public:
    SpecOptions() = default;
    SpecOptions(const SpecOptions&) = delete;
    SpecOptions& operator=(const SpecOptions&) = delete;

    /// Adds the options of these groups, in the order of the table.
    void addTo(CLI::App& app, std::initializer_list<SpecGroup> groups);
    /// Adds the option of one field.
    void addTo(CLI::App& app, const SpecField& field);

    /// What was given, in the order of the table.
    SpecChange given() const;
    /// True if the option of that key was given.
    bool has(std::string_view key) const { return !textOf(given(), key).empty(); }

  private:
    struct Bound {
        const SpecField* field;
        CLI::Option* option = nullptr;
        bool on = false;
        std::string text{};
        std::vector<std::string> texts{};
    };
    std::deque<Bound> bound_;
};

/// Adds an option with a value, which the help calls `value`.
template <typename Value>
CLI::Option* addOption(CLI::App& app, const std::string& names, const std::string& value,
                       Value& bound, const std::string& help) {
    return app.add_option(names, bound, help)->type_name(value);
}

/// A check for whole numbers from `least` on, of 64 bits at most: a larger one is not cut, and a
/// negative one does not wrap around.
CLI::Validator wholeNumber(std::uint64_t least);

/// Adds --most-bytes alone, for verbs that read other things than points.
void addByteLimit(CLI::App& app, ByteLimit& limit);

/// The names of the rules with what they do, for the end of a help.
std::string rulesHelp();

}  // namespace se
