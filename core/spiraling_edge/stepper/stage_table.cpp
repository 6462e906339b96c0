#include "spiraling_edge/stepper/stage_table.h"

#include <algorithm>
#include <array>

namespace se {
namespace {

constexpr StageTests kNoTests = StageTests::None;
constexpr StageTests kOfPoints = StageTests::OfPoints;
constexpr StageTests kOfFans = StageTests::OfFans;

// clang-format off
constexpr std::array<StageRow, kStageCount> kStageTable{{
    {Stage::Seed, "seed", "4", kNoTests},
    {Stage::Strand, "strand", "4", kNoTests},
    {Stage::Pivot, "pivot", "6", kNoTests},
    {Stage::Skip, "skip", "7", kNoTests},
    {Stage::Insert, "insert", "7.1", kNoTests},
    {Stage::Sort, "sort", "6.1", kOfPoints},
    {Stage::Limits, "limits", "6.1", kOfPoints},
    {Stage::Convex, "convex", "6.1", kOfPoints},
    {Stage::Reciprocal, "reciprocal", "6.1", kOfPoints},
    {Stage::Hole, "hole", "6.2", kOfPoints},
    {Stage::Sphere, "sphere", "6.3", kOfPoints},
    {Stage::TwoPoint, "twopoint", "6.4", kOfFans},
    {Stage::Guard, "guard", "", kOfFans},
    {Stage::Fill, "fill", "", kNoTests},
    {Stage::Emit, "emit", "6.4", kNoTests},
    {Stage::Ring, "ring", "6.5", kNoTests},
    {Stage::Split, "split", "6.5", kNoTests},
    {Stage::Join, "join", "6.5", kNoTests},
    {Stage::Advance, "advance", "6.5", kNoTests},
    {Stage::Reinsert, "reinsert", "", kNoTests},
    {Stage::Flip, "flip", "", kNoTests},
    {Stage::RemoveFolded, "reseat", "", kNoTests},
    {Stage::Done, "done", "7", kNoTests},
}};
// clang-format on

constexpr bool stagesAreInOrder() {
    for (std::size_t i = 0; i < kStageCount; ++i) {
        if (kStageTable[i].id != static_cast<Stage>(i)) return false;
    }
    return true;
}
static_assert(stagesAreInOrder());

}  // namespace

std::span<const StageRow> stageTable() { return kStageTable; }

const StageRow& rowOf(Stage stage) { return kStageTable[static_cast<std::size_t>(stage)]; }

std::string_view stageName(Stage stage) { return rowOf(stage).name; }

std::string_view stageSection(Stage stage) { return rowOf(stage).section; }

std::optional<Stage> stageFromName(std::string_view name) {
    const auto found = std::find_if(kStageTable.begin(), kStageTable.end(),
                                    [&](const StageRow& row) { return row.name == name; });
    if (found == kStageTable.end()) return std::nullopt;
    return found->id;
}

}  // namespace se
