/// The options of a program or verb as data, for man pages and completions
/// (app/packaging/pages.py).
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>

namespace se {

/// True for `--help` and `--json` in the arguments: the options are to be listed as JSON.
bool asksForOptionList(std::span<const std::string> arguments);

/// The name, the description, the positional arguments, the options and the lists after them
/// (`footer`) as an object of JSON in one line; of a program with its version. Options that no help
/// shows are left out.
std::string optionList(const CLI::App& app, std::string_view version = {});

}  // namespace se
