// Decisions of a run as values of Python.
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>

#include "arrays.h"
#include "bindings.h"
#include "spiraling_edge/run/event_text.h"

namespace se::python {
namespace {

/// Names of the members of each kind of evidence, in their order and that of the variant.
constexpr std::array<std::string_view, std::variant_size_v<Evidence>> kNames{
    "first second distance",
    "point isolated unseeded",
    "pivot first last ring_length sector_degrees",
    "pivot type",
    "pivot other third corner cross faces verdict",
    "point cosine second_half degrees end_degrees verdict rival farther",
    "side from to turn from_degrees to_degrees verdict blocker",
    "point side degrees verdict",
    "point pred succ degrees limit_degrees verdict printed",
    "point plane_normal side pivot_side verdict edges",
    "t q s center radius distance gap_degrees verdict",
    "degrees verdict one_point",
    "verdict a b dropped",
    "pivot first last ring_length least_degrees forced",
    "point triangles kept",
    "point replaced",
    "first second length",
    "u v x y for_angles",
    "faulty",
    "triangle corners",
    "point inserted status",
    "point active_length stacked_length stack_depth",
    "point depth_from_top length",
    "a b rest depth_from_top",
    "to circuit popped what_if shelved",
    "length shelved",
    "to rings",
    "length interior seed",
    "component triangles",
    "kind point",
    "triangles components unused loops capped"};

/// Stands for any member of an aggregate, to count them.
struct AnyMember {
    template <typename Member>
    operator Member() const;  // NOLINT(google-explicit-constructor)
};
template <typename Kind, typename... Members>
constexpr std::size_t memberCount() {
    if constexpr (requires { Kind{Members{}..., AnyMember{}}; })
        return memberCount<Kind, Members..., AnyMember>();
    else
        return sizeof...(Members);
}

/// True if each kind has as many names as members.
template <std::size_t... Kinds>
constexpr bool allNamed(std::index_sequence<Kinds...> /*kinds*/) {
    return ((std::count(kNames[Kinds].begin(), kNames[Kinds].end(), ' ') + 1 ==
             memberCount<std::variant_alternative_t<Kinds, Evidence>>()) &&
            ...);
}
static_assert(allNamed(std::make_index_sequence<kNames.size()>()));

/// The members of an aggregate.
template <typename Kind>
auto membersOf(const Kind& kind) {
    constexpr std::size_t kCount = memberCount<Kind>();
    static_assert(kCount >= 1 && kCount <= 8);
    // clang-format off
    if constexpr (kCount == 1) { const auto& [a] = kind; return std::tie(a); }
    else if constexpr (kCount == 2) { const auto& [a, b] = kind; return std::tie(a, b); }
    else if constexpr (kCount == 3) { const auto& [a, b, c] = kind; return std::tie(a, b, c); }
    else if constexpr (kCount == 4) { const auto& [a, b, c, d] = kind; return std::tie(a, b, c, d); }
    else if constexpr (kCount == 5) { const auto& [a, b, c, d, e] = kind; return std::tie(a, b, c, d, e); }
    else if constexpr (kCount == 6) { const auto& [a, b, c, d, e, f] = kind; return std::tie(a, b, c, d, e, f); }
    else if constexpr (kCount == 7) { const auto& [a, b, c, d, e, f, g] = kind; return std::tie(a, b, c, d, e, f, g); }
    else { const auto& [a, b, c, d, e, f, g, h] = kind; return std::tie(a, b, c, d, e, f, g, h); }
    // clang-format on
}

py::object valueOf(Index n) { return indexOrNone(n); }
py::object valueOf(const Vec3& x) { return py::make_tuple(x.x, x.y, x.z); }
py::object valueOf(const Triangle& t) { return py::make_tuple(t.a, t.b, t.c); }
py::object valueOf(Verdict verdict) { return textOf(verdictText(verdict)); }
py::object valueOf(Side side) { return textOf(side == Side::Start ? "start" : "end"); }
py::object valueOf(AlertKind kind) { return textOf(alertName(kind)); }
template <typename Value>
py::object valueOf(const Value& value) {
    return py::cast(value);
}

py::dict evidenceOf(const Event& event) {
    py::dict fields;
    std::string_view names = kNames[event.evidence.index()];
    const auto add = [&](const auto& value) {
        const std::size_t end = names.find(' ');
        fields[textOf(names.substr(0, end))] = valueOf(value);
        names.remove_prefix(end == std::string_view::npos ? names.size() : end + 1);
    };
    std::visit(
        [&](const auto& kind) {
            std::apply([&](const auto&... members) { (add(members), ...); }, membersOf(kind));
        },
        event.evidence);
    return fields;
}

py::object takenOf(const Event& event) {
    const Outcome outcome = outcomeOf(event);
    return outcome == Outcome::None ? py::none() : valueOf(outcome == Outcome::Taken);
}

}  // namespace

py::dict readingDict(const std::optional<Reading>& reading) {
    using namespace py::literals;
    if (!reading) return {};
    return py::dict("quantity"_a = textOf(reading->quantity), "unit"_a = textOf(reading->unit),
                    "value"_a = reading->value, "threshold"_a = reading->threshold,
                    "margin"_a = reading->margin);
}

void bindEvents(py::module_& module) {
    const auto row = [](const Event& e) -> const StageRow& { return rowOf(e.address.stage); };
    const char* const help =
        "One decision of a run: its address \"pivot.stage.n\" with the section of the paper "
        "(empty\n"
        "beyond it), one sentence, the verdict of a test in words, whether the tested point was\n"
        "taken (None: no test), the point. evidence: the members of its kind in\n"
        "core/spiraling_edge/stepper/event.h, in snake case; lengths in the unit of the points,\n"
        "angles in degrees.";
    py::class_<Event>(module, "Event", help)
        .def_property_readonly("address", [](const Event& e) { return toString(e.address); })
        .def_property_readonly("pivot", [](const Event& e) { return e.address.pivot; })
        .def_property_readonly("stage", [=](const Event& e) { return textOf(row(e).name); })
        .def_property_readonly("n", [](const Event& e) { return e.address.n; })
        .def_property_readonly("section", [=](const Event& e) { return textOf(row(e).section); })
        .def_property_readonly("sentence", [](const Event& e) { return describe(e); })
        .def_property_readonly("verdict", [](const Event& e) { return textOf(endingText(e)); })
        .def_property_readonly("taken", takenOf)
        .def_property_readonly("point", [](const Event& e) { return indexOrNone(subjectOf(e)); })
        .def_property_readonly("evidence", evidenceOf)
        .def("__repr__", [](const Event& e) {
            return "<Event " + toString(e.address) + ": " + describe(e) + ">";
        });
}

}  // namespace se::python
