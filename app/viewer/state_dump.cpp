#include <cmath>
#include <nlohmann/json.hpp>

#include "application.h"
#include "session/place.h"
#include "session/selection_facts.h"
#include "spiraling_edge/io.h"

namespace se::view {

namespace {

using nlohmann::json;

json indexOrNull(Index index) { return index == kNone ? json(nullptr) : json(index); }

json addressOrNull(const std::optional<Address>& address) {
    return address ? json(toString(*address)) : json(nullptr);
}

const char* phaseName(SessionPhase phase) {
    switch (phase) {
        case SessionPhase::Empty:
            return "empty";
        case SessionPhase::Loading:
            return "loading";
        case SessionPhase::Ready:
            return "ready";
        case SessionPhase::Failed:
            return "failed";
    }
    return "";
}

/// Where one is in the run, as the tree of steps and the strips show it.
void dumpNavigation(json& out, const Navigation& nav, const Session& session) {
    const StepTree& tree = nav.steps;
    out["tree"] = {{"rows", tree.rowCount()},
                   {"filter", tree.filterText()},
                   {"cursor", nullptr},
                   {"pivots", session.overview().pivots.size()},
                   {"components", session.overview().components.size()}};
    if (const auto row = tree.rowOfCursor()) out["tree"]["cursor"] = *row;
    out["strip"] = {{"from", nav.strip.from()},
                    {"to", nav.strip.to()},
                    {"whole", nav.strip.whole()},
                    {"lanes", lanesAt(session.overview().laneChanges, session.record().pivot)}};
    out["highlighted_ring"] = indexOrNull(session.highlightedRing());
    out["lit_ring"] = indexOrNull(session.litRing());
    out["drawer"] = nav.drawerFolded ? "folded" : "open";
}

/// What was derived, as far as it stands in the panels.
void dumpDerived(json& out, const PrepareReport& report) {
    out["derived"] = json::array();
    if (report.neighborsComputed) out["derived"].push_back("neighbors");
    if (report.derived.normals) out["derived"].push_back("normals");
    if (report.derived.orientation && !report.derived.normals) {
        out["derived"].push_back("orientation");
    }
    if (report.derived.types) out["derived"].push_back("types");
    if (report.derived.rim) out["derived"].push_back("rim");
}

/// What is open and where the cursor stands. Requires session.ready().
void dumpRun(json& out, const Session& session) {
    out["input"] = session.model().name;
    out["points"] = session.model().points.size();
    out["pivot"] = session.record().pivot;
    out["event"] = session.cursor();
    out["events"] = session.record().events.size();
    out["triangles"] = session.picture().finishedTriangles + session.picture().newTriangles.size();
    out["rings"] = session.picture().rings.size();
    out["selected"] = indexOrNull(session.selected());
    out["selection"] = std::string(kindName(session.selection().kind));
    const auto corners = session.selection().corners();
    out["selection_points"] = std::vector<Index>(corners.begin(), corners.end());
    if (!corners.empty()) {
        out["selection_present"] = factsOf(session, session.selection()).present;
    }
    const Checkup& checkup = session.checkup();
    out["doctor"] = checkup.done() ? "done" : checkup.busy() ? "busy" : "waiting";
    out["findings"] = json::array();
    for (const Finding& finding : checkup.findings())
        out["findings"].push_back(finding.check->name);
    out["cures"] = session.spec().cures;
    out["mended"] = session.model().mended;
    out["marked"] = session.marked().size();
    out["hovered"] = indexOrNull(session.hovered());
    out["busy"] = session.busy();
    dumpDerived(out, session.model().report);
}

/// New points, while their page is open.
void dumpGrowth(json& out, const GrowthPage& page) {
    const GrowthNumbers& n = page.numbers;
    out["growth"] = std::string(growthPhaseName(page.phase));
    out["growth_page"] = page.open;
    if (!page.open) return;
    out["growth_source"] = page.hasPoints() ? sampleSource(page.made) : "";
    out["growth_step"] = n.step;
    out["growth_points"] = n.points;
    out["growth_walls"] = n.onWalls;
    out["growth_corners"] = n.corners;
    out["growth_spacing"] = n.quality.spacing;
    out["growth_variation"] = n.quality.variation;
    out["growth_off"] = n.quality.off;
    out["growth_complaint"] = page.complaint;
    out["growth_said"] = page.said;
}

void dumpLayers(json& out, const LayerModes& modes, std::optional<Stage> stage) {
    const LayerSwitches shown = shownLayers(modes, stage);
    for (const Layer& layer : layers()) {
        const auto place = static_cast<std::size_t>(layer.id);
        const LayerMode mode = modes[place];
        if (shown.test(place)) out["layers"].push_back(std::string(layer.name));
        if (mode != LayerMode::Automatic) {
            out["pins"][std::string(layer.name)] = layerModeName(mode);
        }
    }
}

}  // namespace

Status Application::writeState() {
    if (options_.stateDump.empty()) return success();
    std::string state = stateDump();
    if (state == writtenState_) return success();
    const Status written = writeFileAtomically(options_.stateDump, state);
    if (written) writtenState_ = std::move(state);
    return written;
}

std::string Application::stateDump() const {
    json out{{"phase", phaseName(session_.phase())},
             {"message", session_.message()},
             {"notice", session_.notice()},
             {"playing", playback_.playing()},
             {"unit", std::string(unitName(playback_.unit()))},
             {"rate", playback_.rate()},
             {"theme", std::string(themeName(ui_.settings.theme))},
             {"layout", std::string(rowOf(ui_.arrangement).name)},
             {"first_frame_seconds", firstFrameSeconds_},
             {"first_window_seconds", firstWindowSeconds_},
             {"longest_opening_seconds", longestOpeningSeconds_},
             {"start_page", session_.startPage()},
             {"recent", ui_.recent.size()},
             {"session_file", ui_.sessionPath},
             {"bookmarks", json::array()},
             {"notes", ui_.notes},
             {"unsaved", ui_.unsaved},
             {"title", title()},
             {"undo", undo_.undoDepth()},
             {"redo", undo_.redoDepth()},
             {"em", imgui_ ? imgui_->em() : 0.0F},
             {"key_editor", ui_.keyEditor},
             {"changed_keys", ui_.settings.keys.changes().size()},
             {"cheat_sheet", ui_.cheatSheet},
             {"file_browser", ui_.fileBrowser},
             {"palette", ui_.palette.open},
             {"asks", ui_.leaving.asked},
             {"keyboard", keyStopName(ui_.walk.at())},
             {"click_waits", ui_.click.waiting()},
             {"open_tab", ui_.openTab},
             {"address_line", ui_.addressLine},
             {"pivot_arrow", ui_.where.count("pivot arrow") > 0},
             {"layers", json::array()},
             {"pins", json::object()},
             {"before", session_.showsBefore()},
             {"shown_state", session_.showsBefore() ? "before" : "after"},
             {"blinking", ui_.look.blinking()},
             {"moving", painter_.moving()}};
    out["prepare"] = ui_.prepare.open;
    dumpGrowth(out, ui_.growth);
    dumpLayers(out, ui_.settings.layers, session_.stage());
    out["mesh_style"] = std::string(rowOf(ui_.settings.meshStyle).name);
    out["unlimited"] = playback_.unlimited();
    out["loop"] = {{"from", addressOrNull(playback_.loop.from)},
                   {"to", addressOrNull(playback_.loop.to)}};
    for (const auto& [name, rect] : ui_.where) {
        out["where"][name] = {std::lround(rect.min.x), std::lround(rect.min.y),
                              std::lround(rect.size.x), std::lround(rect.size.y)};
    }
    for (const Bookmark& each : ui_.bookmarks) out["bookmarks"].push_back(toString(each.address));
    const Place place{session_.event() != nullptr ? toString(session_.address()) : "",
                      camera_.pose()};
    out.update(json::parse(toText(place)));
    if (session_.ready()) {
        dumpRun(out, session_);
        dumpNavigation(out, ui_.navigation, session_);
    }
    return out.dump(2) + "\n";
}

}  // namespace se::view
