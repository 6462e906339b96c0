#include "failure_totals.h"

#include "sentences.h"

namespace se::cli {

std::string faultTotalText(std::span<const ClassTotal> totals) {
    if (isSound(totals)) return "sound";
    if (faultCount(totals) == 0) return "no fault found, but the search ended early";
    return (isExact(totals) ? "" : "at least ") + counted(faultCount(totals), "fault");
}

nlohmann::ordered_json failureRow(const MeshFailure& failure) {
    nlohmann::ordered_json row = {{"class", failure.kind->name},
                                  {"points", failure.points},
                                  {"triangles", failure.triangles},
                                  {"at", {failure.place.x, failure.place.y, failure.place.z}}};
    if (isLoop(failure)) {
        row["length"] = failure.length;
        row["area"] = failure.area;
    }
    return row;
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
