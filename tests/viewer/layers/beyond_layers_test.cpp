// Drawings of the rules beyond the paper (docs/robust.md), and of alerts.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "layers/layer.h"
#include "open_session.h"

using namespace se;
using namespace se::view;

namespace {

RunSpec spec(const char* scene, const char* rules) { return withSet({scene}, rules); }

/// Lists of that many neighbors, instead of those of the scene.
RunSpec spec(const char* scene, const char* rules, Index neighbors) {
    RunSpec made = withSet({scene}, rules);
    made.neighbors = {KNearest{neighbors}, true, 0, true};
    return made;
}

/// A session at the first event of a run with evidence of a kind for which `wanted` holds.
struct RunAt {
    Session session;

    template <typename Kind>
    static std::unique_ptr<RunAt> at(
        const RunSpec& input, Stage stage,
        bool (*wanted)(const Kind&) = [](const Kind&) { return true; }) {
        auto place = std::make_unique<RunAt>();
        place->session.open(input);
        place->session.waitUntilDone();
        const std::vector<PivotSummary> pivots = place->session.overview().pivots;
        for (std::uint32_t i = 0; i < pivots.size(); ++i) {
            if ((pivots[i].found & findingOf(stage)).none()) continue;
            place->session.moves().goTo({i + 1, stage, 0});
            place->session.waitUntilDone();
            const std::vector<Event> events = place->session.record().events;
            for (std::size_t e = 0; e < events.size(); ++e) {
                const auto* kind = std::get_if<Kind>(&events[e].evidence);
                if (kind == nullptr || !wanted(*kind)) continue;
                place->session.moves().goToEvent(e);
                place->session.waitUntilDone();
                return place;
            }
        }
        return nullptr;
    }

    LayerInput input() const {
        LayerInput in{session.model(), session.picture(), paletteOf(Theme::Dark)};
        in.triangles = session.triangles();
        in.meshIndex = session.picture().repaired ? nullptr : &session.meshIndex();
        return in;
    }
    DrawList drawn(void (*add)(const LayerInput&, DrawList&)) const {
        DrawList list;
        add(input(), list);
        return list;
    }
    template <typename Kind>
    const Kind& evidence() const {
        return std::get<Kind>(session.event()->evidence);
    }
    const glm::vec3& at(Index point) const { return session.model().place[point]; }
};

bool says(const DrawList& list, std::string_view part) {
    return std::any_of(list.labels.begin(), list.labels.end(), [&](const Label& label) {
        return label.text.find(part) != std::string::npos;
    });
}

const Line* lineOf(const DrawList& list, const glm::vec3& a, const glm::vec3& b) {
    const auto found = std::find_if(list.lines.begin(), list.lines.end(), [&](const Line& line) {
        return (line.from == a && line.to == b) || (line.from == b && line.to == a);
    });
    return found == list.lines.end() ? nullptr : &*found;
}

std::size_t count(const DrawList& list, view::Shape shape) {
    return static_cast<std::size_t>(
        std::count_if(list.sprites.begin(), list.sprites.end(),
                      [&](const Sprite& s) { return s.style.shape == shape; }));
}

const Palette& kColors = paletteOf(Theme::Dark);

}  // namespace

TEST_CASE("Drawn for flip: the old edge dashed, the new one bold, two triangles, four names") {
    // The first step after the last pivot: it edits the triangles of the run themselves.
    const auto place = RunAt::at<FlipEvidence>(spec("scene:small-torus", "robust"), Stage::Flip);
    REQUIRE(place != nullptr);
    const auto& e = place->evidence<FlipEvidence>();
    const DrawList list = place->drawn(addRepairs);
    const Line* before = lineOf(list, place->at(e.u), place->at(e.v));
    const Line* after = lineOf(list, place->at(e.x), place->at(e.y));
    REQUIRE(before != nullptr);
    REQUIRE(after != nullptr);
    CHECK(before->dash > 0.0F);
    CHECK(after->dash == 0.0F);
    CHECK(after->width > before->width);
    for (const auto& [a, b] :
         {std::pair{e.u, e.x}, std::pair{e.x, e.v}, std::pair{e.v, e.y}, std::pair{e.y, e.u}}) {
        REQUIRE(lineOf(list, place->at(a), place->at(b)) != nullptr);
        CHECK(lineOf(list, place->at(a), place->at(b))->width < after->width);
    }
    for (const Index point : {e.u, e.v, e.x, e.y}) CHECK(says(list, std::to_string(point)));
    CHECK(says(list, "least angle"));
    REQUIRE(list.faces.size() == 2);
    for (const Face& face : list.faces) CHECK(face.hatched);
    CHECK(place->drawn(addTriangles).faces.empty());
}

TEST_CASE("Drawn for reinsert: the point, its new edges and the triangles it is put into") {
    RunSpec input = spec("scene:long-lists", "robust", 16);
    input.choices.push_back({"opposingfrom", 90.0});
    const auto place = RunAt::at<ReinsertEvidence>(input, Stage::Reinsert);
    REQUIRE(place != nullptr);
    const Index point = place->evidence<ReinsertEvidence>().point;
    const DecisionState& picture = place->session.picture();
    const DrawList list = place->drawn(addRepairs);
    CHECK(count(list, view::Shape::RingedDisc) == 1);
    CHECK(says(list, std::to_string(point)));
    // An event before it in the same step shows the old mesh.
    const PivotRecord& record = place->session.record();
    REQUIRE(record.events.size() == 2);
    CHECK(place->session.replay().after(0).newTriangles.empty());
    CHECK(place->session.replay().after(0).repaired == record.before.repaired);
    CHECK(list.sheets.size() == picture.goneTriangles.size());
    REQUIRE_FALSE(picture.newTriangles.empty());
    for (const Triangle& t : picture.newTriangles) {
        for (const Index corner : {t.a, t.b, t.c}) {
            if (corner == point) continue;
            const Line* edge = lineOf(list, place->at(point), place->at(corner));
            REQUIRE(edge != nullptr);
            CHECK(edge->color == kColors.used);
            CHECK(edge->dash == 0.0F);
        }
    }
}

TEST_CASE("Drawn for fill: the rim of the hole bold, its best ear hatched") {
    RunSpec input = spec("scene:sphere", "paper", 24);
    input.choices.push_back({"fill", true});
    const auto place = RunAt::at<FillEvidence>(input, Stage::Fill);
    REQUIRE(place != nullptr);
    const auto& e = place->evidence<FillEvidence>();
    const DrawList list = place->drawn(addHoleFill);
    const auto rim = std::count_if(list.lines.begin(), list.lines.end(), [](const Line& line) {
        return line.color == kColors.last && line.depth == Depth::XRay;
    });
    CHECK(rim == static_cast<long>(e.ringLength));
    CHECK(lineOf(list, place->at(e.first), place->at(e.last)) != nullptr);
    CHECK_FALSE(list.sheets.empty());
    CHECK(says(list, "hole of " + std::to_string(e.ringLength)));
}

TEST_CASE("Drawn for guard: the triangle that a rule objects to, and its measure") {
    const auto place = RunAt::at<GuardEvidence>(
        spec("scene:small-torus", "robust"), Stage::Guard,
        [](const GuardEvidence& e) { return e.verdict == Verdict::Steep; });
    REQUIRE(place != nullptr);
    const auto& e = place->evidence<GuardEvidence>();
    const DrawList list = place->drawn(addGuard);
    REQUIRE_FALSE(list.sheets.empty());
    CHECK(list.sheets[0].color == kColors.rejected.withAlpha(list.sheets[0].color.a));
    CHECK(lineOf(list, place->at(e.a), place->at(e.b)) != nullptr);
    CHECK(says(list, std::string(verdictText(e.verdict))));
    CHECK(says(list, "limit 60.0\xC2\xB0"));
}

TEST_CASE("Drawn for an alert: the ring that was freed, bold, in the color of errors") {
    for (const AlertKind kind : {AlertKind::Hole, AlertKind::LostSeed}) {
        const auto place =
            kind == AlertKind::Hole
                ? RunAt::at<AlertEvidence>(
                      spec("scene:sphere", "paper", 24), Stage::Done,
                      [](const AlertEvidence& e) { return e.kind == AlertKind::Hole; })
                : RunAt::at<AlertEvidence>(
                      spec("scene:genus-2", "printed", 24), Stage::Done,
                      [](const AlertEvidence& e) { return e.kind == AlertKind::LostSeed; });
        REQUIRE(place != nullptr);
        REQUIRE(place->session.picture().freed.has_value());
        const FreedRingState& ring = *place->session.picture().freed;
        REQUIRE(ring.evidence.has_value());
        CHECK(ring.alert == kind);
        CHECK(ring.path.points.size() == ring.evidence->length);
        const DrawList list = place->drawn(addComponent);
        REQUIRE(list.lines.size() == ring.path.points.size());
        for (std::size_t i = 0; i < list.lines.size(); ++i) {
            CHECK(list.lines[i].color == kColors.rejected);
            CHECK((list.lines[i].dash > 0.0F) == ring.path.open[i]);
        }
        CHECK(says(list, kind == AlertKind::Hole ? "a hole stays open" : "got no triangle"));
    }
}

TEST_CASE("Drawn for a ring that is freed on a wall: bold in the color of the end, no alert") {
    const auto place = RunAt::at<FreeEvidence>(spec("scene:sheet", "paper"), Stage::Done);
    REQUIRE(place != nullptr);
    REQUIRE(place->session.picture().freed.has_value());
    CHECK_FALSE(place->session.picture().freed->alert.has_value());
    const DrawList list = place->drawn(addComponent);
    CHECK(list.lines.size() == place->evidence<FreeEvidence>().length);
    for (const Line& line : list.lines) CHECK(line.color == kColors.last);
}

TEST_CASE("A repaired mesh has a color for each component as well") {
    Session session;
    session.open(spec("scene:linked-tori", "robust"));
    session.waitUntilDone();
    session.moves().toEnd();
    session.waitUntilDone();
    REQUIRE(session.picture().repaired != nullptr);
    MeshColoring mesh = meshColoring(MeshStyle::Component, session.overview(), 0);
    RepairedComponents components;
    mesh.repaired = components.of(session.picture().repaired, session.triangles(), mesh.starts,
                                  session.model().points.size());
    LayerInput in{session.model(), session.picture(), kColors};
    in.mesh = mesh;
    DrawList list;
    addTriangles(in, list);
    CHECK(list.meshStyle == MeshStyle::Component);
    REQUIRE(list.meshStretches.size() >= 2);
    CHECK(list.components == 2);
    for (const MeshStretch& stretch : list.meshStretches) {
        CHECK((stretch.color == componentColor(0) || stretch.color == componentColor(1)));
    }
    CHECK_FALSE(list.meshStretches[0].color == list.meshStretches[1].color);
}
