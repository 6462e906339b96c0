#include "failures.h"

#include <fmt/format.h>

#include <algorithm>

#include "sentences.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::cli {

std::string classText(const FailureClass& kind, const ClassTotal& total) {
    const bool isOne = total.all() && total.total == 1;
    std::string name = isOne ? nounFor(kind, 1) : std::string(kind.name);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
    return fmt::format("{:>7} {}", amountText(total), name);
}

std::string placesText(std::span<const FaultPlace> places, std::span<const MeshFailure> failures,
                       std::size_t limit) {
    std::string text;
    for (std::size_t i = 0; i < std::min(limit, places.size()); ++i) {
        const Vec3& at = places[i].center;
        text += fmt::format("{:>7} {}; at ({:.6g}, {:.6g}, {:.6g})\n", "#" + std::to_string(i + 1),
                            describe(places[i], failures), at.x, at.y, at.z);
    }
    if (places.size() > limit)
        text += fmt::format("        ... and {} more by --json\n", places.size() - limit);
    return text;
}

void addPlaces(std::span<const FaultPlace> places, std::span<const MeshFailure> failures,
               std::span<const std::optional<std::size_t>> rowOf, std::size_t limit, Json& json) {
    json["places_total"] = places.size();
    json["places"] = Json::array();
    for (const FaultPlace& place : places.first(std::min(limit, places.size()))) {
        Json rows = Json::array();
        for (const std::size_t fault : place.faults) {
            if (fault < rowOf.size() && rowOf[fault]) rows.push_back(*rowOf[fault]);
        }
        json["places"].push_back({{"what", describe(place, failures)},
                                  {"at", place.center},
                                  {"radius", place.radius},
                                  {"faults", place.faults.size()},
                                  {"rows", std::move(rows)}});
    }
}

Json failureRow(const MeshFailure& failure) {
    Json row = {{"class", failure.kind->name},
                {"points", failure.points},
                {"triangles", failure.triangles},
                {"at", failure.place}};
    if (isLoop(failure)) {
        row["length"] = failure.length;
        row["area"] = failure.area;
    }
    return row;
}

void addTotals(std::span<const ClassTotal> totals, std::span<const FailureClass> classes,
               Json& json) {
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

Json verdictJson(const MeshVerdict& verdict) {
    Json json = {{"sound", verdict.isSound()},
                 {"headline", headlineOf(verdict)},
                 {"stopped", verdict.stopped},
                 {"triangles", verdict.triangles},
                 {"faults", faultCount(verdict.totals)},
                 {"exact", isExact(verdict.totals)},
                 {"places", verdict.places},
                 {"all_places", verdict.allPlaces}};
    json["worst_classes"] = Json::array();
    for (std::size_t i = 0; i < verdict.placesOf.size(); ++i) {
        if (verdict.placesOf[i] == 0) continue;
        json["worst_classes"].push_back(
            {{"class", failureClasses()[i].name}, {"places", verdict.placesOf[i]}});
    }
    for (const VerdictCount& count : verdictCounts())
        json[std::string(count.name)] = count.of(verdict);
    json["points_amiss"] = verdict.amiss;
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

void noSuchFailure(std::span<const ClassTotal> totals, const FailureChoice& wanted,
                   const std::string& input) {
    const ClassTotal& total = totals[rankOf(*wanted.kind)];
    const std::string has = total.all() ? counted(total.total, "failure")
                                        : "only the " + amountText(total) + " failures listed";
    throw Failure(
        ExitCode::CheckFailed,
        "{}: the run has {} of class {}; spiraling-edge why {} --failures lists those it has",
        input, has, wanted.kind->name, shellPath(input));
}

FailureChoice failureChoiceFrom(const std::string& text) {
    const std::size_t colon = text.find(':');
    FailureChoice wanted{findFailureClass(text.substr(0, colon)), 1};
    if (wanted.kind == nullptr) {
        refuse("--failure {}: no such class; the classes are {}", text,
               listText(failureClasses(), &FailureClass::name, ""));
    }
    if (colon == std::string::npos) return wanted;
    const std::string digits = text.substr(colon + 1);
    const auto number = numberIn<std::size_t>(digits);
    if (!number || *number == 0 || digits.size() > 9)
        refuse("--failure {}: expected a number >= 1 after the colon", text);
    wanted.number = *number;
    return wanted;
}

}  // namespace se::cli
