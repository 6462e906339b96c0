#include "state_dump.h"

#include <imgui.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "application.h"
#include "document/alert_actions.h"
#include "jobs/questions.h"
#include "panels/widgets/widgets.h"
#include "session/selection_facts.h"
#include "session/view_position.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/run/event_text.h"
#include "teach/json_text.h"

namespace se::view {

namespace {

std::string_view nameOf(GrowthPhase phase) {
    constexpr std::array<std::string_view, 6> kNames = {"idle",   "finding", "spreading",
                                                        "paused", "done",    "failed"};
    static_assert(kNames.size() == static_cast<std::size_t>(GrowthPhase::Failed) + 1);
    return kNames[static_cast<std::size_t>(phase)];
}

std::string_view nameOf(KeyStop stop) {
    constexpr std::array<std::string_view, kKeyStopCount> kNames = {
        "view", "rail", "content", "steps", "rings", "ring points", "files", "scenes"};
    return kNames[static_cast<std::size_t>(stop)];
}

using nlohmann::json;

const auto kBegan = test::OpeningTimes::Clock::now();

json indexOrNull(Index index) { return index == kNone ? json(nullptr) : json(index); }

json addressOrNull(const std::optional<Address>& address) {
    return address ? json(toString(*address)) : json(nullptr);
}

const char* phaseName(SessionPhase phase) {
    constexpr std::array<const char*, 4> kNames = {"empty", "loading", "ready", "failed"};
    static_assert(kNames.size() == static_cast<std::size_t>(SessionPhase::Failed) + 1);
    return kNames[static_cast<std::size_t>(phase)];
}

/// Position in the run, as the tree of steps and the strips show it.
void dumpNavigation(json& out, const Navigation& nav, const Session& session) {
    const StepTree& tree = nav.steps;
    out["tree"] = {{"rows", tree.rowCount()},
                   {"filter", nav.stepFilter.data()},
                   {"cursor", nullptr},
                   {"pivots", session.overview().pivots.size()},
                   {"components", session.overview().components.size()}};
    if (const auto row = tree.rowOfCursor()) out["tree"]["cursor"] = *row;
    out["strip"] = {{"from", nav.strip.from()},
                    {"to", nav.strip.to()},
                    {"whole", nav.strip.whole()},
                    {"lanes", lanesAt(session.overview().laneChanges, session.record().pivot)}};
    out["highlighted_ring"] = indexOrNull(session.highlights().chosenRing());
    out["lit_ring"] = indexOrNull(session.highlights().litRing());
    out["strips"] = nav.stripFolded ? "folded" : "open";
}

/// Lines with the known number of hits; expressions with their values here.
void dumpStops(json& out, const UiState& ui, const Session& session) {
    out["breakpoints"] = out["breakpoint_hits"] = json::array();
    out["watches"] = out["watch_values"] = json::array();
    out["watch_stopped"] = session.watches().cancelled();
    for (const Breakpoint& each : ui.breakpoints) {
        const LineHits* known = session.hits().of(each.line);
        out["breakpoints"].push_back(each.line);
        out["breakpoint_hits"].push_back(
            known != nullptr && known->complete ? json(known->list.total) : json(nullptr));
    }
    for (const std::string& each : ui.watch.expressions) {
        const WatchSeries* series = session.watches().of(each);
        const std::size_t pivot = session.place().pivot;
        const bool there = series != nullptr && pivot < series->values.size();
        out["watches"].push_back(each);
        out["watch_values"].push_back(there ? json(series->values[pivot]) : json(nullptr));
    }
}

/// Derived data, as shown in the panels.
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

void dumpDrag(json& out, const PointDrag& drag) {
    out["dragged"] = indexOrNull(drag.active() ? drag.point() : kNone);
    out["drag_turns"] = drag.turn().has_value();
}

/// The open input and the position of the cursor. Requires session.ready().
void dumpRun(json& out, const Session& session) {
    assert(session.ready());
    out["input"] = session.model().name;
    out["points"] = session.model().points.size();
    out["pivot"] = session.record().pivot;
    out["event"] = session.cursor();
    out["decision"] =
        session.event() != nullptr ? describe(*session.event(), session.names()) : std::string{};
    out["triangles"] = session.picture().finishedTriangles + session.picture().newTriangles.size();
    out["rings"] = session.picture().rings.size();
    out["selected"] = indexOrNull(session.selected());
    dumpDrag(out, session.drag());
    out["selection"] = std::string(kindName(session.selection().kind));
    const auto corners = session.selection().corners();
    out["selection_points"] = std::vector<Index>(corners.begin(), corners.end());
    if (!corners.empty()) out["selection_present"] = factsOf(session, session.selection()).present;
    out["marked"] = session.highlights().marked().size();
    out["hovered"] = indexOrNull(session.highlights().hovered());
    out["busy"] = session.moves().busy();
}

/// Facts of the whole run, left out while a question is open.
void dumpFindings(json& out, const Session& session) {
    out["events"] = session.record().events.size();
    out["at_end"] = session.atEnd();
    const DoctorJob& doctorJob = session.doctorJob();
    out["doctor"] = doctorJob.done() ? "done" : doctorJob.busy() ? "busy" : "waiting";
    out["findings"] = json::array();
    for (const Finding& finding : doctorJob.findings())
        out["findings"].push_back(finding.check->name);
    out["cures"] = session.input().spec().fixes;
    out["rules"] = session.input().spec().rules;
    out["choices"] = json::array();
    for (const RuleValue& each : session.input().spec().choices)
        out["choices"].push_back(lineOf(each));
    out["what_if"] = json::array();
    for (const WhatIf& each : session.input().spec().whatIf) out["what_if"].push_back(lineOf(each));
    out["mended"] = session.model().fixesDone;
    out["aside"] = json::object();
    for (const AsidePoints& each : session.model().aside) out["aside"][nameOf(each)] = each.count;
    const RunAlerts& alerts = session.alerts();
    out["alert_search"] = alerts.done()                 ? "done"
                          : alerts.busy()               ? "busy"
                          : alerts.stopped()            ? "stopped"
                          : !alerts.complaint().empty() ? "failed"
                                                        : "waiting";
    out["alerts_complete"] = alerts.complete();
    out["alerts"] = alerts.failures().size();
    out["verdict"] = alerts.done() ? verdictText(alerts) : "";
    out["place"] = session.alerts().place() ? *session.alerts().place() + 1 : 0;
    out["alert"] = session.alerts().chosen() ? alertName(alerts, *session.alerts().chosen()) : "";
    const TrialJob& trials = session.trials();
    out["trials_ended"] = trials.ended() || alerts.sound();
    out["trial_best"] = trials.best() != nullptr ? wordsOf(trials.best()->change) : "";
    out["noticed"] = session.noticedHere().size();
    dumpDerived(out, session.model().report);
}

/// Queries about the run, and the answers.
void dumpQuestions(json& out, const Session& session) {
    const Questions& questions = session.questions();
    out["asking"] = questions.busy();
    out["ledger"] = {{"subject", questions.subjectName()},
                     {"complaint", questions.ledger().complaint()}};
    if (const Ledger* ledger = questions.why()) {
        out["ledger"]["answer"] = ledger->answer;
        out["ledger"]["present"] = ledger->present;
        out["ledger"]["lines"] = ledger->lines.size();
        out["ledger"]["cause"] = toString(ledger->lines[ledger->cause].event.address);
    }
    out["query"] = {{"line", questions.line()}, {"found", nullptr}};
    if (const FoundDecisions* found = questions.found().answer()) {
        out["query"]["found"] = found->total;
        if (!found->lines.empty())
            out["query"]["first"] = toString(found->lines.front().event.address);
    }
    if (const ClosestAnswer* closest = questions.closest().answer())
        out["closest"] = closest->lines.size();
}

/// The counterpart of the comparison, and the positions of both.
void dumpComparison(json& out, const Session& run, const ComparePage& page) {
    const Comparison* now = page.now;
    out["compare_with"] = nullptr;
    if (now == nullptr || !now->chosen()) return;
    constexpr std::array kKinds = {"", "run", "mesh", "trace"};
    out["compare_with"] = kKinds[static_cast<std::size_t>(now->with().kind)];
    if (!now->with().isFile() && run.ready())
        out["compare_other"] = differenceText(run.input().spec(), now->with().run);
    out["compare_working"] = now->working();
    out["compare_complaint"] = now->complaint();
    out["compare_refusal"] = now->refusal();
    if (const Session* other = now->other()) {
        out["other_address"] =
            other->event() != nullptr ? toString(other->address()) : std::string("start");
        out["other_decision"] =
            other->event() != nullptr ? describe(*other->event(), other->names()) : std::string{};
        out["other_rules"] = other->input().spec().rules;
    }
    if (page.why) out["compare_why"] = selectionText(*page.why);
    if (page.why && now->other() != nullptr) {
        const Ledger* answer = now->other()->questions().why();
        out["compare_why_other"] = answer != nullptr ? answer->answer : std::string{};
    }
    const Compared* found = now->result();
    out["compare_done"] = found != nullptr;
    if (found == nullptr) return;
    const auto addressOf = [](const DifferenceSide& side) {
        return side.line ? json(toString(side.line->event.address)) : json(nullptr);
    };
    if (found->runs.first) {
        out["difference_a"] = addressOf(found->runs.first->a);
        out["difference_b"] = addressOf(found->runs.first->b);
    }
    if (found->trace) {
        const ComparedTrace& traced = *found->trace;
        out["trace_sentence"] = traced.replay.sentence(now->tracePosition(run));
        out["trace_difference"] = teach::differenceText(traced.comparison);
        out["trace_guess"] = traced.guess;
    }
    out["only_a"] = found->meshes.onlyA;
    out["only_b"] = found->meshes.onlyB;
    out["in_both"] = found->meshes.both;
    out["regions"] = found->meshes.regions.size();
    out["region"] = page.region ? json(*page.region + 1) : json(nullptr);
}

/// New points, while their page is open.
void dumpGrowth(json& out, const GrowthPage& page, const Growth& growth) {
    const GrowthPicture none;
    const GrowthPicture& n = growth.picture() != nullptr ? *growth.picture() : none;
    out["growth"] = std::string(nameOf(growth.phase()));
    out["growth_page"] = page.open;
    if (!page.open) return;
    out["growth_source"] = growth.hasPoints() ? sampleSource(growth.spec()) : "";
    out["growth_step"] = n.step;
    out["growth_points"] = n.points ? n.points->position.size() : 0;
    out["growth_walls"] = n.onWalls;
    out["growth_corners"] = n.corners;
    out["growth_spacing"] = n.quality.spacing;
    out["growth_variation"] = n.quality.variation;
    out["growth_off"] = n.quality.off;
    out["growth_complaint"] = page.complaint;
    out["growth_message"] = page.message;
}

/// The dialog Save mesh, and the command that was copied.
void dumpMeshForm(json& out, const UiState& ui, const FinishedMesh* mesh) {
    const MeshForm& form = ui.mesh;
    out["mesh_dialog"] = ui.fileBrowser && ui.browser == BrowserTask::SaveMesh;
    out["mesh_name"] = ui.browsing.path;
    out["mesh_format"] = std::string(meshFormats()[form.format].extension);
    out["mesh_used_only"] = form.usedOnly;
    out["mesh_fault_fields"] = form.faultFields;
    out["mesh_triangles"] = mesh != nullptr ? json(mesh->triangles->size()) : json(nullptr);
    out["mesh_saving"] = form.saving;
    out["mesh_question"] = ui.browsing.overwrite.empty() ? "" : ui.browsing.error;
    out["mesh_complaint"] = form.complaint;
}

/// The open lesson, without answers that are not shown.
void dumpLesson(json& out, const LessonPanel& panel, const LessonPlayer& player) {
    const LessonWalk& walk = panel.walk;
    out["lesson"] = walk.isOpen() ? walk.lesson().title : "";
    out["lesson_opening"] = player.opening().busy();
    out["lesson_complaint"] = player.opening().complaint();
    if (!walk.isOpen()) return;
    out["lesson_step"] = walk.step() + 1;
    out["lesson_title"] = walk.shownStep().title;
    out["lesson_away"] = panel.away;
    out["question"] = walk.question() == nullptr ? "none" : walk.asks() ? "open" : "shown";
    out["given"] = walk.question() != nullptr ? walk.state().typed : "";
    out["tries"] = walk.state().tries;
    if (walk.state().grade) out["answered_right"] = walk.state().grade->right;
    if (walk.question() != nullptr && !walk.asks()) out["right_answer"] = walk.right().text;
}

/// The dialog Export, and its work.
void dumpExportForm(json& out, const UiState& ui) {
    const ExportForm& form = ui.exported;
    out["export_dialog"] = ui.fileBrowser && ui.browser == BrowserTask::Export;
    out["export_format"] = std::string(exportFormats()[form.format].extension);
    out["export_working"] = form.working;
    out["export_made"] = form.made;
    out["export_complaint"] = form.complaint;
    out["export_question"] = ui.browsing.overwrite.empty() ? "" : ui.browsing.error;
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

namespace test {

std::string stateDump(Application& app, const InputProgress& input, const OpeningTimes& times) {
    const CommandContext& c = app.context();
    const UiState& ui = c.ui;
    const Session& session = c.session;
    const Playback& playback = c.playback;
    json out{{"input_events", input.events},
             {"settled", input.settled && !ui.cameraMove.active()},
             {"phase", phaseName(session.input().phase())},
             {"message", session.messages().last()},
             {"notice", session.messages().notice()},
             {"playing", playback.playing()},
             {"unit", std::string(unitName(playback.unit()))},
             {"rate", playback.rate()},
             {"theme", std::string(themeName(ui.settings.theme))},
             {"layout", std::string(rowOf(ui.layoutPreset).name)},
             {"blank", ui.blank != BlankScreen::None},
             {"first_frame_seconds", times.firstFrame()},
             {"first_window_seconds", times.firstWindow()},
             {"longest_opening_seconds", times.longest()},
             {"start_page", session.startPage()},
             {"recent", ui.recent.size()},
             {"session_file", ui.sessionPath},
             {"bookmarks", json::array()},
             {"notes", ui.notes},
             {"unsaved", !ui.unsaved.empty()},
             {"title", app.title()},
             {"undo", c.history.undoDepth()},
             {"redo", c.history.redoDepth()},
             {"em", app.em()},
             {"key_editor", ui.help == HelpPage::ChangeKeys},
             {"changed_keys", ui.settings.keys.changes().size()},
             {"cheat_sheet", ui.help == HelpPage::Keys},
             {"file_browser", ui.fileBrowser},
             {"palette", ui.palette.open},
             {"palette_typed", ui.palette.filter.data()},
             {"query_typed", ui.query.typed},
             {"ledger_typed", ui.ledger.typed},
             {"typing", ImGui::GetIO().WantTextInput},
             {"asks", ui.leaving.asked},
             {"keyboard", nameOf(ui.walk.at())},
             {"click_waits", ui.click.waiting()},
             {"task", std::string(rowOf(ui.column.task).title)},
             {"part", ui.column.part},
             {"address_line",
              ui.where.contains("address line") ? addressAndSection(session) : std::string()},
             {"pivot_arrow", ui.where.count("pivot arrow") > 0},
             {"layers", json::array()},
             {"pins", json::object()},
             {"before", session.showsBefore()},
             {"shown_state", session.showsEarlierMesh() ? "earlier mesh"
                             : session.showsBefore()    ? "before"
                                                        : "after"},
             {"blinking", ui.look.blinking()},
             {"follow", ui.follow == Follow::EachDecision},
             {"section_degrees", ui.section.turnDegrees},
             {"moving", app.painter().moving() || app.painter().unfinished()},
             {"motions", app.painter().motions()},
             {"tinted", app.drawn().tinted[0].count + app.drawn().tinted[1].count}};
    out["prepare"] = ui.prepare.open;
    out["piece_tool"] = ui.piece.on;
    out["piece_inside"] = ui.piece.inside.size();
    dumpGrowth(out, ui.growth, c.sampling.growth());
    out["copied"] = ui.clipboard.copied();
    dumpMeshForm(out, ui, c.mesh.mesh());
    dumpExportForm(out, ui);
    dumpComparison(out, session, ui.compare);
    dumpLayers(out, ui.settings.layers, session.stage());
    out["point_tint"] = std::string(rowOf(ui.settings.pointTint).name);
    out["mesh_style"] = std::string(rowOf(ui.settings.meshStyle).name);
    out["unlimited"] = playback.unlimited();
    out["loop"] = {{"from", addressOrNull(playback.loop.from)},
                   {"to", addressOrNull(playback.loop.to)}};
    for (const auto& [name, rect] : ui.where) {
        out["where"][name] = {std::lround(rect.min.x), std::lround(rect.min.y),
                              std::lround(rect.size.x), std::lround(rect.size.y)};
    }
    for (const Bookmark& each : ui.bookmarks) out["bookmarks"].push_back(toString(each.address));
    dumpLesson(out, ui.lesson, c.lesson);
    const bool hides = ui.lesson.hides();
    if (!hides) dumpStops(out, ui, session);
    const ViewPosition place{session.event() != nullptr ? toString(session.address()) : "",
                             c.camera.pose()};
    out.update(json::parse(toText(place)));
    if (session.ready()) {
        dumpRun(out, session);
        if (hides) return teach::jsonText(out);
        dumpFindings(out, session);
        dumpNavigation(out, ui.navigation, session);
        dumpQuestions(out, session);
    }
    return teach::jsonText(out);
}

}  // namespace test

Status Application::writeState(const InputProgress& input) {
    const char* file = std::getenv("SPIRALING_EDGE_STATE");
    if (file == nullptr) return success();
    static test::OpeningTimes times(kBegan);
    times.noteFrame(*this);
    const std::string state = test::stateDump(*this, input, times);
    return readText(file) == state ? success() : writeFileAtomically(file, state);
}

}  // namespace se::view
