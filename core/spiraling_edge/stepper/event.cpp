#include "spiraling_edge/stepper/event.h"

#include <algorithm>
#include <tuple>

#include "spiraling_edge/base/text_scan.h"

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
    {Stage::DropPatch, "droppatches", "", kNoTests},
    {Stage::Reinsert, "reinsert", "", kNoTests},
    {Stage::CloseHole, "closeholes", "", kNoTests},
    {Stage::Flip, "flip", "", kNoTests},
    {Stage::Remesh, "remesh", "", kNoTests},
    {Stage::Done, "done", "7", kNoTests},
    {Stage::Finished, "finished", "3", kNoTests},
}};
// clang-format on

static_assert(isInOrder(kStageTable));

/// Removes the part before the first dot from `text` and returns it.
std::string_view takePart(std::string_view& text) {
    const std::size_t dot = std::min(text.find('.'), text.size());
    const std::string_view part = text.substr(0, dot);
    text.remove_prefix(std::min(dot + 1, text.size()));
    return part;
}

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

bool isBefore(const Address& a, const Address& b) {
    return std::tie(a.pivot, a.stage, a.n) < std::tie(b.pivot, b.stage, b.n);
}

std::string toString(const Address& address) {
    std::string text = std::to_string(address.pivot);
    text += '.';
    text += stageName(address.stage);
    if (address.n > 0) text += '.' + std::to_string(address.n);
    return text;
}

std::optional<Address> addressFromString(std::string_view text) {
    if (text.empty() || text.back() == '.') return std::nullopt;
    const auto pivot = numberIn<std::uint32_t>(takePart(text));
    if (!pivot) return std::nullopt;
    Address address{*pivot, Stage::Pivot, 0};
    if (text.empty()) return address;
    const auto stage = stageFromName(takePart(text));
    if (!stage) return std::nullopt;
    address.stage = *stage;
    if (text.empty()) return address;
    const auto n = numberIn<std::uint32_t>(text);
    if (!n) return std::nullopt;
    address.n = *n;
    return address;
}

void EventLog::add(std::uint32_t pivot, Stage stage, const Evidence& evidence) {
    if (pivot != pivot_) {
        pivot_ = pivot;
        counts_ = {};
    }
    events_.push_back({{pivot, stage, ++counts_[static_cast<std::size_t>(stage)]}, evidence});
}

void EventLog::clear() {
    events_.clear();
    pivot_ = 0;
    counts_ = {};
}

}  // namespace se
