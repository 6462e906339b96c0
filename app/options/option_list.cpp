#include "options/option_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace se {
namespace {

using Json = nlohmann::ordered_json;

Json namesOf(const CLI::Option& option) {
    Json names = Json::array();
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

Json namesOf(const std::set<CLI::Option*>& options) {
    Json names = Json::array();
    for (const CLI::Option* each : options) names.push_back(each->get_name());
    std::sort(names.begin(), names.end());
    return names;
}

Json fieldsOf(const CLI::Option& option) {
    Json fields;
    if (option.get_positional()) {
        fields["name"] = option.get_name(true);
    } else {
        fields["names"] = namesOf(option);
    }
    // As help shows it: the placeholder, and after a colon what a check takes. A flag has none.
    if (option.get_items_expected_max() > 0) fields["value"] = option.get_type_name();
    fields["help"] = option.get_description();
    if (option.get_required()) fields["required"] = true;
    if (!option.get_needs().empty()) fields["needs"] = namesOf(option.get_needs());
    if (!option.get_excludes().empty()) fields["excludes"] = namesOf(option.get_excludes());
    return fields;
}

/// Adds the options of `app`, and of the groups within it.
void addOptions(const CLI::App& app, Json& list) {
    for (const CLI::Option* each : app.get_options()) {
        if (each->get_group().empty()) continue;
        list[each->get_positional() ? "positionals" : "options"].push_back(fieldsOf(*each));
    }
    for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
        addOptions(*group, list);
}

}  // namespace

bool asksForOptionList(std::span<const std::string> arguments) {
    const std::set<std::string> words(arguments.begin(), arguments.end());
    return arguments.size() == 2 && words == std::set<std::string>{"--help", "--json"};
}

std::string optionList(const CLI::App& app, std::string_view version) {
    Json list{{"name", app.get_name()},
              {"description", app.get_description()},
              {"positionals", Json::array()},
              {"options", Json::array()}};
    if (!version.empty()) list["version"] = version;
    addOptions(app, list);
    list["footer"] = app.get_footer();
    return list.dump() + "\n";
}

}  // namespace se
