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
    "pivot other third corner cross faces verdict sector_degrees",
    "point cosine second_half degrees end_degrees verdict rival farther",
    "side from to turn from_degrees to_degrees verdict blocker",
    "point side degrees verdict",
    "point pred succ degrees limit_degrees verdict printed",
    "point plane_normal side pivot_side verdict edges",
    "t q s center radius distance gap_degrees verdict",
    "degrees verdict one_point",
    "verdict a b dropped",
    "pivot first last ring_length least_degrees forced sector_degrees",
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

}  // namespace

py::object readingOrNone(const std::optional<Reading>& reading) {
    if (!reading) return py::none();
    return record("Reading", textOf(reading->quantity), textOf(reading->unit), reading->value,
                  reading->threshold, reading->margin);
}

py::object eventRecord(const Event& event) {
    const StageRow& row = rowOf(event.address.stage);
    const Outcome outcome = outcomeOf(event);
    return record("Event", toString(event.address), event.address.pivot, textOf(row.name),
                  event.address.n, textOf(row.section), describe(event), textOf(endingText(event)),
                  outcome == Outcome::None ? py::none() : valueOf(outcome == Outcome::Taken),
                  indexOrNone(subjectOf(event)), evidenceOf(event));
}

}  // namespace se::python
