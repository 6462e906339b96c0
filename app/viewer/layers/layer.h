/// Layers turn (input, picture, selection) into plain things to draw. A file has those of one
/// subject; the table has their names for the panel, the keys and the settings, and the stages that
/// show them.
#pragma once

#include <array>
#include <bitset>
#include <glm/geometric.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "run/model.h"
#include "run/overview.h"
#include "run/repair_diff.h"
#include "run/selection.h"
#include "scene/draw_list.h"
#include "scene/mesh_index.h"
#include "scene/motion.h"
#include "scene/palette.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/run/live_check.h"
#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/why/failure_moments.h"

namespace se::view {

struct LayerInput {
    const Model& model;
    const DecisionState& picture;
    const Palette& palette;
    Index selected = kNone;
    Index highlightedRing = kNone;
    Index hovered = kNone;
    /// Triangles of the run so far; for layers beyond the pivot's surroundings.
    std::span<const Triangle> triangles = {};
    std::size_t componentBegin = 0;  ///< The first triangle of the current component.
    /// The component that is complete here; null if unknown.
    const ComponentShape* component = nullptr;
    Selection selection{};  ///< A point, an edge or a triangle.
    bool selectionPresent = true;
    MeshColoring mesh{};
    std::span<const Index> marked{};              ///< Points that are highlighted,
    std::span<const EvidenceLine> markedLines{};  ///< and lines.
    Moment moment{};
    const MeshIndex* meshIndex = nullptr;  ///< Index of `triangles`.
    Index seedBefore = kNone;              ///< The first point of the ring before this one.
    /// Least margin per point, to color the points by; empty: by status.
    std::span<const double> leastMargin = {};
    std::uint32_t tint = 0;  ///< Revision of the margins; 0 for none.
    Theme theme = Theme::Dark;

    const RunFailure* alert = nullptr;  ///< The chosen alert.
    bool finished = false;              ///< The finished mesh is shown, without its last decision.
    const RunFailureSearch* faults = nullptr;  ///< Of the finished mesh, once they are known.
    std::span<const LiveFailure> noticed{};    ///< Failures at this event.
    std::span<const PointName> names{};        ///< Names of points; others have their numbers.
    std::span<const Index> labeled{};          ///< Points whose names are always shown.
    /// Change of the finished mesh to show on it, in place of the filled faults; null: none.
    const MeshChange* change = nullptr;

    const glm::vec3& at(Index point) const { return model.place[point]; }
    std::array<glm::vec3, 3> cornersOf(const Triangle& t) const { return model.cornersOf(t); }
    glm::vec3 middleOf(const Triangle& t) const { return (at(t.a) + at(t.b) + at(t.c)) / 3.0F; }
    glm::vec3 middleOf(Index a, Index b) const { return 0.5F * (at(a) + at(b)); }
    /// Along the normal of the triangle, as long as twice its area.
    glm::vec3 acrossOf(const Triangle& t) const {
        return glm::cross(at(t.b) - at(t.a), at(t.c) - at(t.a));
    }
};

void addPoints(const LayerInput& in, DrawList& out);
void addAside(const LayerInput& in, DrawList& out);
void addTriangles(const LayerInput& in, DrawList& out);
void addFaults(const LayerInput& in, DrawList& out);
void addChange(const LayerInput& in, DrawList& out);
void addMeshEdges(const LayerInput& in, DrawList& out);
void addEdgeRing(const LayerInput& in, DrawList& out);
void addStackedRings(const LayerInput& in, DrawList& out);
void addNeighborRing(const LayerInput& in, DrawList& out);
void addSector(const LayerInput& in, DrawList& out);
void addCircumsphere(const LayerInput& in, DrawList& out);
void addNormals(const LayerInput& in, DrawList& out);
void addLinks(const LayerInput& in, DrawList& out);
void addLabels(const LayerInput& in, DrawList& out);
// Those of one stage each.
void addSeed(const LayerInput& in, DrawList& out);
void addWalls(const LayerInput& in, DrawList& out);
void addSortAngles(const LayerInput& in, DrawList& out);
void addLimits(const LayerInput& in, DrawList& out);
void addConvexity(const LayerInput& in, DrawList& out);
void addReciprocal(const LayerInput& in, DrawList& out);
void addHolePlane(const LayerInput& in, DrawList& out);
void addTwoPoint(const LayerInput& in, DrawList& out);
void addFan(const LayerInput& in, DrawList& out);
void addRingChange(const LayerInput& in, DrawList& out);
void addExchange(const LayerInput& in, DrawList& out);
void addAdvance(const LayerInput& in, DrawList& out);
void addComponent(const LayerInput& in, DrawList& out);
// Beyond the paper.
void addGuard(const LayerInput& in, DrawList& out);
void addHoleFill(const LayerInput& in, DrawList& out);
void addRepairs(const LayerInput& in, DrawList& out);
// Chosen by the user.
void addSelection(const LayerInput& in, DrawList& out);
void addMarked(const LayerInput& in, DrawList& out);
void addAlerts(const LayerInput& in, DrawList& out);

enum class LayerId : std::uint8_t {
    Points,
    Triangles,
    MeshEdges,
    EdgeRing,
    StackedRings,
    Sector,
    NeighborRing,
    Spheres,
    Normals,
    Links,
    Labels,
    Seed,
    Walls,
    SortAngles,
    Limits,
    Convexity,
    Reciprocal,
    HolePlane,
    TwoPoint,
    Fan,
    RingChange,
    Exchange,
    Advance,
    Component,
    Selection,
    Marked,
    Guard,
    HoleFill,
    Repairs,
    Aside,
    Alerts,
};
inline constexpr std::size_t kLayerCount = static_cast<std::size_t>(LayerId::Alerts) + 1;

/// The stages that show a layer by themselves, one bit each.
using StageMask = std::uint32_t;
inline constexpr StageMask kNoStage = 0;
inline constexpr StageMask kEveryStage = ~StageMask{0};  ///< Also where there is no event.
template <typename... Stages>
constexpr StageMask during(Stages... stages) {
    return ((StageMask{1} << static_cast<unsigned>(stages)) | ...);
}

struct Layer {
    LayerId id;
    std::string_view name;   ///< In settings and command names.
    std::string_view title;  ///< Name for the user.
    StageMask stages;        ///< Stages that show it automatically.
    void (*add)(const LayerInput& in, DrawList& out);
};

/// In drawing order.
std::span<const Layer> layers();
const Layer& rowOf(LayerId id);

using LayerSwitches = std::bitset<kLayerCount>;

/// The user's choice for a layer: a pin holds it in every stage.
enum class LayerMode : std::uint8_t { Automatic, PinnedOn, PinnedOff };
using LayerModes = std::array<LayerMode, kLayerCount>;
/// "auto", "on", "off".
std::string_view layerModeName(LayerMode mode);
std::optional<LayerMode> layerModeFromName(std::string_view name);
LayerMode& modeOf(LayerModes& modes, LayerId id);

/// The layers to draw at an event of `stage` (empty: at the beginning).
LayerSwitches shownLayers(const LayerModes& modes, std::optional<Stage> stage);
/// Shows a hidden layer and hides a shown one: by removing its pin if that is enough, otherwise by
/// a pin.
void toggleLayer(LayerModes& modes, LayerId id, std::optional<Stage> stage);

/// Fills `out` with all layers that are on. The result depends on nothing else.
void fillDrawList(const LayerInput& in, const LayerSwitches& on, DrawList& out);

struct ReadLayers {
    LayerModes modes{};
    /// "layer \"hologram\"", "mode \"maybe\" of layer \"points\"".
    std::vector<std::string> unknown;

    /// A sentence about the skipped names; empty if there are none.
    std::string complaint() const;
};

/// `object`: {"normals": "on"}. Earlier versions wrote true and false.
ReadLayers layersFromJson(const nlohmann::json& object);
/// All layers, whatever their mode.
nlohmann::json layersToJson(const LayerModes& modes);

}  // namespace se::view
