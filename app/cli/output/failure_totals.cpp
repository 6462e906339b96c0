#include "failure_totals.h"

#include "sentences.h"

namespace se::cli {

std::string totalText(std::span<const ClassTotal> totals) {
    std::size_t all = 0;
    bool exact = true;
    for (const ClassTotal& each : totals) {
        all += each.total;
        exact = exact && each.exact;
    }
    if (all == 0) return "nothing found";
    return (exact ? "" : "at least ") + counted(all, "failure");
}

void addTotals(std::span<const ClassTotal> totals, std::span<const FailureClass> classes,
               nlohmann::ordered_json& json) {
    using Json = nlohmann::ordered_json;
    Json listed = Json::object();
    Json atLeast = Json::array();
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const std::string name(classes[i].name);
        json["counts"][name] = totals[i].total;
        listed[name] = totals[i].listed;
        if (!totals[i].exact) atLeast.push_back(name);
    }
    if (isComplete(totals)) return;
    json["complete"] = false;
    json["listed"] = std::move(listed);
    json["at_least"] = std::move(atLeast);
}

}  // namespace se::cli
