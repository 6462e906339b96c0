/// The table of settings, one row each, in the order of the paper, then those beyond it.
#include "spiraling_edge/stepper/rule_settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

namespace se {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The cosine of an angle from 0 to 180 degrees by + - * / alone, so that it is the same on every
/// machine; correctly rounded where rules have their default values.
double cosineOfDegrees(double degrees) {
    struct Known {
        double degrees, cosine;
    };
    constexpr std::array kKnown{
        Known{0.0, 1.0},
        Known{45.0, 0.70710678118654752},
        Known{60.0, 0.5},
        Known{90.0, 0.0},
        Known{105.0, kSheetsCosine},
        Known{120.0, -0.5},
        Known{150.0, -0.8660254037844386},
        Known{180.0, -1.0},
    };
    for (const Known& each : kKnown) {
        if (each.degrees == degrees) return each.cosine;
    }
    // About 90 degrees: cos(90 + x) = -sin(x), |x| <= pi / 2, where the series is short.
    const double x = (degrees - 90.0) * kPi / 180.0;
    double term = x;
    double sine = x;
    for (int n = 1; n <= 12; ++n) {
        term *= -x * x / (2.0 * n * (2.0 * n + 1.0));
        sine += term;
    }
    return -sine;
}

// ---- the makers of rows -------------------------------------------------------------------------

/// The last member of a path: member of the member before it, first of the params.
template <auto... path>
constexpr auto& memberOf(auto& params) {
    return (params.*....*path);
}

/// That member as the number that a setting is.
template <auto... path>
struct Member {
    using Type = std::remove_reference_t<decltype(memberOf<path...>(std::declval<Params&>()))>;
    static double get(const Params& p) { return static_cast<double>(memberOf<path...>(p)); }
    static void set(Params& p, double value) { memberOf<path...>(p) = static_cast<Type>(value); }
};

constexpr std::string_view kOnOff[] = {"off", "on"};

/// A sentence of the paper, and the value of a setting by it.
struct Sentence {
    std::string_view text;
    std::optional<double> value;

    constexpr Sentence() = default;
    template <typename Value>
    constexpr Sentence(std::string_view words, Value byIt)
        : text(words), value(static_cast<double>(byIt)) {}
};

/// A switch, or one of several ways if `options` names them.
template <auto... path>
constexpr RuleSetting choice(std::string_view name, std::string_view section,
                             std::string_view summary, const Sentence& paper = {},
                             std::span<const std::string_view> options = kOnOff) {
    using M = Member<path...>;
    constexpr bool kIsSwitch = std::is_same_v<typename M::Type, bool>;
    const double high = static_cast<double>(options.size()) - 1.0;
    constexpr SettingKind kKind = kIsSwitch ? SettingKind::Switch : SettingKind::Option;
    return {name, section, false, summary, paper.text, paper.value, kKind,
            0.0,  high,    "",    options, M::get,     M::set,      false};
}

/// A number from `low` to `high`; a whole one if the member is.
template <auto... path>
constexpr RuleSetting number(std::string_view name, std::string_view section,
                             std::string_view summary, double low, double high,
                             std::string_view unit, const Sentence& paper = {}) {
    using M = Member<path...>;
    constexpr bool kIsWhole = std::is_integral_v<typename M::Type>;
    constexpr SettingKind kKind = kIsWhole ? SettingKind::Whole : SettingKind::Number;
    return {name, section, false, summary, paper.text, paper.value, kKind,
            low,  high,    unit,  {},      M::get,     M::set,      false};
}

/// An angle from `low` to 180 degrees; held as its cosine.
template <auto... path>
constexpr RuleSetting angle(std::string_view name, std::string_view section,
                            std::string_view summary, double low, const Sentence& paper = {}) {
    RuleSetting row = number<path...>(name, section, summary, low, 180.0, "degrees", paper);
    row.get = [](const Params& p) { return degreesOf(Member<path...>::get(p)); };
    row.set = [](Params& p, double value) { Member<path...>::set(p, cosineOfDegrees(value)); };
    return row;
}

constexpr RuleSetting beyondPaper(RuleSetting row) {
    row.beyondPaper = true;
    return row;
}
constexpr RuleSetting ruleSwitch(RuleSetting row) {
    row.isRuleSwitch = true;
    return row;
}

/// A switch of the paper's own, or one of several ways to read it.
template <auto member>
constexpr RuleSetting rule(std::string_view name, std::string_view section,
                           std::string_view summary, const Sentence& paper,
                           std::span<const std::string_view> options = kOnOff) {
    return choice<&Params::paper, member>(name, section, summary, paper, options);
}
/// A reading of the paper; off is the sentence.
template <bool Readings::*member>
constexpr RuleSetting reading(std::string_view name, std::string_view section,
                              std::string_view summary, std::string_view paper) {
    return ruleSwitch(
        choice<&Params::readings, member>(name, section, summary, Sentence(paper, false)));
}
/// A rule beyond the paper.
template <bool RobustRules::*member>
constexpr RuleSetting robust(std::string_view name, std::string_view section,
                             std::string_view summary) {
    return ruleSwitch(beyondPaper(choice<&Params::robust, member>(name, section, summary)));
}
constexpr auto kThresholds = &Params::thresholds;

// ---- the table ----------------------------------------------------------------------------------

constexpr std::string_view kTies[] = {"nearest", "farthest", "both"};
constexpr std::string_view kTurns[] = {"counterclockwise", "clockwise"};
constexpr std::string_view kOnSphere[] = {"removed", "kept"};
constexpr std::string_view kTwoPoints[] = {"over", "from", "off"};
constexpr std::string_view kInstances[] = {"sector", "first"};
constexpr std::string_view kActives[] = {"end", "other", "longer", "shorter"};
constexpr std::string_view kStacks[] = {"last", "first"};
constexpr std::string_view kNexts[] = {"end", "start"};

// Sentences of the paper that several rows quote.
constexpr std::string_view kLimitsWords =
    "The algorithm then advances the start pointer to point to q. ... Similarly, the algorithm "
    "moves the end pointer when it adds t to the neighbor ring.";
constexpr std::string_view kSplitWords =
    "If the other instance is in the active edge ring, the edge ring is split into two rings and "
    "one of the rings is pushed onto a stack.";

constexpr auto kSettings = std::to_array<RuleSetting>({
    choice<&Params::dropOpposingNormals>(
        "opposing", "3", "neighbors with an opposing normal are left out of the lists",
        {"... this extra information consists of an estimated normal at each point, a list of each "
         "point's neighbors, ...",
         false}),

    rule<&PaperRules::tie>(
        "tie", "6.1", "which of two neighbors at the same angle stays",
        {"If two neighboring points are found to have the same angle, the point closest to p is "
         "included in the ring and the other point is eliminated from consideration.",
         TieRule::Nearest},
        kTies),
    number<&Params::sameAngle>("sameangle", "6.1", "angles nearer than this are the same", 0.0,
                               0.01, "1 - cos"),
    // "The cross product of z and p's normals" leaves the order open; the second sentence does not.
    rule<&PaperRules::turn>(
        "turn", "6.1", "the side to which angles grow: n = normal x z, or z x normal",
        {"... taking the cross product of z and p's normals, producing the normal of the plane "
         "slicing the ring at 180 degrees. ... The edges are created in a counterclockwise "
         "direction with respect to the surface normal.",
         TurnRule::Counterclockwise},
        kTurns),
    rule<&PaperRules::maxAngle>(
        "maxangle", "6.1", "no neighbor beyond the angle of last",
        {"The algorithm uses the angle between z and the vector between the pivot point and the "
         "last point as the maximum allowable angle.",
         true}),
    rule<&PaperRules::limits>("limits", "6.1", "start and end advance along the edge ring",
                              {kLimitsWords, true}),
    reading<&Readings::limitsFirst>(
        "limitsfirst", "6.1", "start and end advance before other neighbors are looked at",
        "If as the algorithm adds in q, it finds that q is already on the "
        "edge ring ..."),
    reading<&Readings::belowHalfTurn>(
        "halfturn", "6.1", "start and end do not advance across 180 degrees or more at the pivot",
        "There are situations that arise that require the algorithm to change the starting and/or "
        "ending angle that it established using first and last."),
    rule<&PaperRules::concave>(
        "concave", "6.1", "start and end advance only where the edge ring is concave",
        {"... q is adjacent to the point pointed to by start, and the edge ring is concave at this "
         "point. The algorithm then advances the start pointer to point to q.",
         true}),
    rule<&PaperRules::convex>(
        "convex", "6.1", "a ring point next to a convex start or end is dropped",
        {"The convexity test eliminates point 2 from the neighbor ring because point 2 is the next "
         "point on the edge list after the point pointed to by start (point 1) and 1 is convex.",
         true}),
    rule<&PaperRules::convexShared>(
        "convexshared", "6.1",
        "the convexity test also drops points with several ring entries, and keeps what lies next "
        "to a concave start or end",
        {"The convexity test only applies to points in the edge ring that are adjacent to the "
         "points pointed to by start or end.",
         true}),
    rule<&PaperRules::reciprocal>(
        "reciprocal", "6.1", "a USED point stays only if p could be in its neighbor ring",
        {"If p could be included in e's hypothetical neighbor ring, then e is included in p's "
         "neighbor ring.",
         true}),
    reading<&Readings::freeSector>(
        "freesector", "6.1", "the reciprocal test looks at the free side of the ring",
        "... the angles formed by the preceding and succeeding points on "
        "the edge list (elast and efirst) are calculated."),
    number<&Params::paper, &PaperRules::holeSize>(
        "holesize", "6.2", "largest number of edges of a hole that is known; below 3: none", 0.0,
        8.0, "edges",
        {"Note that the algorithm will not recognize a hole formed by more than three points. ... "
         "Although checks for larger holes could be made, it would be a case of diminishing "
         "returns.",
         3}),
    reading<&Readings::realHole>(
        "realhole", "6.2", "a hole of three has three mesh edges and under 180 degrees",
        "First the algorithm checks for the special case of filling a hole "
        "formed by p, first, and last."),
    rule<&PaperRules::sphere>(
        "sphere", "6.3", "neighbors outside the circumsphere are removed",
        {"If q falls inside the circumsphere or its removal would create an angle difference "
         "between s and t of more than 120 degrees, q must be kept. Otherwise, q is removed from "
         "the neighbor ring.",
         true}),
    angle<&Params::maxGapCosine>(
        "maxgap", "6.3", "a neighbor is kept if without it the gap would exceed this", 90.0,
        {"... or its removal would create an angle difference between s and t of more than 120 "
         "degrees, q must be kept.",
         120}),
    rule<&PaperRules::onSphere>(
        "onsphere", "6.3", "what becomes of a neighbor exactly on the sphere",
        {"If q falls inside the circumsphere ... q must be kept.", OnSphereRule::Removed},
        kOnSphere),
    rule<&PaperRules::twoPoint>(
        "twopoint", "6.4", "two-point rings are discarded over 180 degrees, from 180 on, or never",
        {"... if the neighbor ring consists of only two points and the angle they form around the "
         "pivot point is greater than 180 degrees, the resulting triangle will overlap existing "
         "triangles. In this case, the neighbor ring will be discarded.",
         TwoPointRule::Over},
        kTwoPoints),
    reading<&Readings::closeTwo>("closetwo", "6.5",
                                 "an edge with triangles on both sides leaves the ring",
                                 "Each time the edge ring becomes empty, a disconnected surface "
                                 "component has finished triangulation."),
    // The sentence leaves open where in the ring the search begins: EdgeRings::firstInstance().
    rule<&PaperRules::instance>(
        "instance", "6.5",
        "the other instance: the first whose sector holds p, or the first at all",
        {"If a point is encountered that is already USED, the first other instance of the point in "
         "the edge ring is located.",
         InstanceRule::First},
        kInstances),
    // Which part stays follows from the sentence of `next`: end is on it.
    rule<&PaperRules::active>("active", "6.5",
                              "which part of a split ring stays active; the other is pushed",
                              {kSplitWords, ActiveRule::End}, kActives),
    rule<&PaperRules::stack>("stack", "6.5", "which stacked ring is taken up next",
                             {"... the stack of edge rings is searched in top down order so that "
                              "the most recently split edge ring will be found first.",
                              StackRule::Last},
                             kStacks),
    rule<&PaperRules::next>("next", "6.5", "where the traversal goes on after triangles",
                            {"Once the edge ring is finished being updated, the new point is the "
                             "point that had been the end particle in the neighbor ring.",
                             NextRule::End},
                            kNexts),
    rule<&PaperRules::walls>(
        "walls", "7", "boundary points are passed over as pivots",
        {"First, we avoid using boundary points as pivot points with only a few exceptions.",
         true}),
    reading<&Readings::openSteps>(
        "opensteps", "7", "ring steps that are no mesh edges are known as open",
        "If the algorithm does remove p, the removal would either fragment "
        "the edge ring or cause nonadjacent points to be adjacent in the "
        "edge ring."),
    reading<&Readings::keepSeeds>(
        "keepseeds", "7",
        "a seed without a triangle costs no point if all its neighbors are UNUSED",
        "Then the algorithm marks the boundary points as DONE and frees the edge ring so that it "
        "can start a new disconnected surface component."),
    rule<&PaperRules::thirdPoint>(
        "thirdpoint", "7.1", "a third point joins an edge ring of two boundary points",
        {"So prior to calling the neighbor ring routine, the algorithm searches p's neighbors for "
         "a third point that is UNUSED and has a boundary edge in common with p.",
         true}),
    rule<&PaperRules::stayInside>(
        "stayinside", "7.1", "a third point never opens a sector that leads out of the box",
        {"The third point is inserted before p if one of two conditions exists. Either p lies on a "
         "minimum surface boundary and the corresponding component of the cross product vector is "
         "negative, or p lies on a maximum surface boundary and the corresponding component of the "
         "cross product vector is positive. Otherwise, the third point is inserted after p.",
         false}),
    // The sentence leaves open which side; Figures 18 and 19 have r before p where a corner is
    // ahead, after it where a corner lies back.
    rule<&PaperRules::corners>(
        "corners", "7.2", "a third point joins the ring where it passes from wall to wall",
        {"The algorithm uses the same approach as before, inserting another UNUSED boundary point "
         "into the edge ring either before or after p.",
         true}),

    beyondPaper(number<&Params::maxTrianglesPerPoint>(
        "cap", "8", "the run stops above this many triangles per point", 2.0, 64.0, "per point")),
    beyondPaper(angle<&Params::opposingCosine>("opposingfrom", "3",
                                               "normals oppose from this angle on", 90.0)),
    beyondPaper(choice<&Params::setNoiseAside>(
        "noise", "3", "points are set aside where noise is as wide as their spacing")),
    beyondPaper(
        choice<&Params::setStraysAside>("strays", "4", "points far from all others are set aside")),
    robust<&RobustRules::tangent>("tangent", "6.1",
                                  "angles are measured in the tangent plane of the pivot"),
    robust<&RobustRules::unblocked>("unblocked", "6.1",
                                    "start and end do not pass over an UNUSED neighbor"),
    robust<&RobustRules::stepBack>("stepback", "6.3",
                                   "after a removal the point before it is looked at again"),
    robust<&RobustRules::wallsDone>("wallsdone", "7",
                                    "boundary points complete along their walls are no candidates"),
    robust<&RobustRules::bothWalls>(
        "bothwalls", "7.2", "no third point beside a boundary point open at its other side"),
    robust<&RobustRules::guard>("guard", "6.4",
                                "no directed edge twice: always an oriented manifold"),
    robust<&RobustRules::gap>("gap", "6.4", "no fan with a gap of 180 degrees or more"),
    robust<&RobustRules::noPillow>("nopillow", "6.4",
                                   "no second triangle on the same three points"),
    robust<&RobustRules::noCross>("nocross", "6.4", "no new edge across a ring edge nearby"),
    robust<&RobustRules::noFold>("nofold", "6.4",
                                 "no triangle against its normals or folded onto another"),
    beyondPaper(angle<kThresholds, &RobustThresholds::foldCosine>(
        "foldangle", "6.4", "nofold: normals of two triangles at an edge are no farther apart",
        90)),
    robust<&RobustRules::noMeet>("nomeet", "6.4", "no triangle that meets a finished one nearby"),
    robust<&RobustRules::noLayer>("nolayer", "6.4",
                                  "no triangle that is a second layer of a finished one nearby"),
    beyondPaper(angle<kThresholds, &RobustThresholds::flatCosine>(
        "flatangle", "6.4",
        "nomeet, nolayer look only where normals about the pivot are farther apart", 0)),
    robust<&RobustRules::rim>(
        "rim", "7", "rims are found, and the surface ends where neighbors leave a wide gap"),
    beyondPaper(angle<kThresholds, &RobustThresholds::rimGapCosine>(
        "rimgap", "7", "rim: the surface ends where neighbors leave more", 60)),
    beyondPaper(angle<kThresholds, &RobustThresholds::rimAngleCosine>(
        "rimangle", "7", "rim: no triangle over more than this where the surface ends", 60)),
    beyondPaper(number<kThresholds, &RobustThresholds::openingWidth>(
        "openingwidth", "7", "rim: a ring where the surface ends is an opening from this width on",
        0.0, 64.0, "of its edges")),
    robust<&RobustRules::delay>("delay", "6.5", "fans with steep triangles wait for a circuit"),
    beyondPaper(angle<kThresholds, &RobustThresholds::steepCosine>(
        "steepangle", "6.5", "delay: steep is farther than this off a corner's normal", 0)),
    robust<&RobustRules::shelve>("shelve", "6.5",
                                 "rings without a triangle wait until no seed is left"),
    robust<&RobustRules::fill>("fill", "6.5", "rings that are no openings are closed by ears"),
    beyondPaper(number<&Params::maxFillLength>("filllength", "6.5",
                                               "fill closes rings of at most this many entries",
                                               3.0, 4096.0, "entries")),
    beyondPaper(number<&Params::maxFillWidth>("fillwidth", "6.5", "... and of at most this width",
                                              1.0, 4096.0, "spacings")),
    robust<&RobustRules::dropPatches>("droppatches", "4",
                                      "small components and extra fans at points are taken out"),
    robust<&RobustRules::reinsert>("reinsert", "4",
                                   "stranded points take the place of triangles nearby"),
    robust<&RobustRules::closeHoles>("closeholes", "6.5", "holes of the finished mesh are filled"),
    beyondPaper(number<&Params::maxHoleWidth>(
        "holewidth", "6.5",
        "holes up to this width are closed, openings of the scan too; wider ones stay; 0: by the "
        "rules",
        0.0, 1e12, "in the file's unit")),
    beyondPaper(number<&Params::maxHoleEdges>("holeedges", "6.5",
                                              "... and of at most this many edges; 0: by the rules",
                                              0.0, 64.0, "edges")),
    robust<&RobustRules::flip>("flip", "6.3",
                               "edges that are better the other way round are flipped"),
    beyondPaper(number<kThresholds, &RobustThresholds::flipFlatCosine>(
        "flipflat", "6.3", "flip: two triangles are flat if their normals agree more than this",
        -1.0, 1.0, "cosine")),
    beyondPaper(number<kThresholds, &RobustThresholds::flipNarrowCosine>(
        "flipnarrow", "6.3",
        "flip: a triangle is narrow if its least angle has this cosine or more", 0.5, 1.0,
        "cosine")),
    robust<&RobustRules::remesh>("remesh", "6.3",
                                 "triangles about a faulty one are replaced by others"),
});

}  // namespace

double degreesOf(double cosine) {
    constexpr double kDigits = 1e9;  // Rounded to nine digits after the point for display.
    return std::round(std::acos(cosine) * 180.0 / kPi * kDigits) / kDigits;
}
std::span<const RuleSetting> ruleSettings() { return kSettings; }
std::span<const RuleSetting> ruleSwitches() {
    static const std::vector<RuleSetting> switches = [] {
        std::vector<RuleSetting> rows;
        std::copy_if(kSettings.begin(), kSettings.end(), std::back_inserter(rows),
                     [](const RuleSetting& each) { return each.isRuleSwitch; });
        return rows;
    }();
    return switches;
}

}  // namespace se
