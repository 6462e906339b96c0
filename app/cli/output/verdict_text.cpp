#include "verdict_text.h"

#include <nlohmann/json.hpp>
#include <string>

namespace se::cli {

nlohmann::ordered_json verdictJson(const MeshVerdict& verdict) {
    nlohmann::ordered_json json = {{"sound", verdict.isSound()},
                                   {"headline", headlineOf(verdict)},
                                   {"stopped", verdict.stopped},
                                   {"triangles", verdict.triangles},
                                   {"faults", faultCount(verdict.totals)},
                                   {"exact", isExact(verdict.totals)},
                                   {"places", verdict.places},
                                   {"all_places", verdict.allPlaces}};
    json["worst_classes"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < verdict.placesOf.size(); ++i) {
        if (verdict.placesOf[i] == 0) continue;
        json["worst_classes"].push_back(
            {{"class", failureClasses()[i].name}, {"places", verdict.placesOf[i]}});
    }
    for (const VerdictCount& count : verdictCounts())
        json[std::string(count.name)] = count.of(verdict);
    json["stray_points"] = verdict.strays;
    json["noise_points"] = verdict.noise;
    json["twin_points"] = verdict.twins;
    json["pieces"] = verdict.pieces;
    json["pieces_of_points"] = verdict.piecesOfPoints;
    json["openings"] = verdict.openings;
    json["covered"] = verdict.covered();
    json["greatest_distance"] = verdict.fidelity.greatestDistance;
    json["mean_distance"] = verdict.fidelity.meanDistance;
    return json;
}

}  // namespace se::cli
