// Runs decision by decision: the cursor of a run, the stepper, and the reasons.
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "arrays.h"
#include "bindings.h"
#include "calls.h"
#include "paint/figures.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/run_cursor.h"
#include "spiraling_edge/why/proof.h"

namespace se::python {
namespace {

using namespace py::literals;

/// The record RingPoints of a neighbor ring.
py::object ringPoints(const std::vector<RingPoint>& ring) {
    std::vector<Index> points;
    std::vector<double> degrees;
    for (const RingPoint& each : ring) {
        points.push_back(each.point);
        degrees.push_back(each.degrees);
    }
    return record("RingPoints", arrayOf(std::move(points)), arrayOf(std::move(degrees)));
}

/// Edge rings as records.
py::list ringList(const std::vector<RingPath>& rings) {
    py::list list;
    for (const RingPath& each : rings) {
        std::vector<std::uint8_t> open(each.open.begin(), each.open.end());
        const py::object marks = arrayOf(std::move(open)).attr("view")("bool");
        list.append(
            record("Ring", arrayOf(each.points), marks, each.active, ringName(each.number)));
    }
    return list;
}

/// A decision that has been looked at, by which its record is drawn.
struct SeenDecision {
    SharedRun run;
    Params params;
    DecisionState state;
};

/// The record State of a decision; `before`: that just before it, or None, and of that one
/// `following`, the address of the decision.
py::object stateRecord(const SeenDecision& seen, const py::object& prepared,
                       const py::object& before, const py::object& following) {
    const DecisionState& state = seen.state;
    const PointSet& points = *seen.run->points;
    std::optional<Reading> reading;
    if (state.event) reading = readingOf(*state.event, {points, seen.params, state.pivot});
    py::list candidates;
    for (const CandidateMark& each : state.candidates)
        candidates.append(record("Candidate", each.point, each.degrees,
                                 each.state == CandidateState::Kept,
                                 textOf(verdictText(each.verdict)), textOf(stageName(each.stage))));
    std::vector<PointStatus> status(state.status.size());
    for (std::size_t i = 0; i < status.size(); ++i) status[i] = state.status[i];
    return record("State", state.event ? eventRecord(*state.event) : py::none(),
                  readingOrNone(reading), indexOrNone(state.pivot), indexOrNone(state.first),
                  indexOrNone(state.last), indexOrNone(state.start), indexOrNone(state.end),
                  indexOrNone(state.underTest), state.sectorDegrees, state.complete,
                  ringPoints(state.neighborRing()), ringPoints(state.fan()), candidates,
                  ringList(state.rings), arrayOf(state.newTriangles), state.finishedTriangles,
                  arrayOf(std::move(status)), prepared, before, following, seen);
}

/// The records Line of a ledger.
py::list lineList(const std::vector<LedgerLine>& lines) {
    py::list list;
    for (const LedgerLine& each : lines)
        list.append(record("Line", eventRecord(each.event), textOf(roleName(each.role)),
                           indexOrNone(each.pivot), readingOrNone(each.reading)));
    return list;
}

/// A cursor at a decision of a run.
class Cursor {
  public:
    /// `prepared`: the record.
    explicit Cursor(py::object prepared)
        : prepared_(std::move(prepared)),
          run_(prepared_.attr("_core").cast<SharedRun>()),
          params_(possibleParams(*run_)),
          cursor_(run_->points, params_) {}

    /// False if the run has no such decision. Throws if `text` is no address.
    bool goTo(const std::string& text) {
        const auto address = addressFromString(text);
        if (!address)
            throw std::invalid_argument(text + ": expected an address such as 137.sphere.3");
        return moved([&] { return cursor_.goTo(*address); });
    }
    py::object forward(const std::string& unit) {
        return stateIf(moved([&, by = unitFrom(unit)] { return cursor_.forward(by); }));
    }
    py::object back(const std::string& unit) {
        return stateIf(moved([&, by = unitFrom(unit)] { return cursor_.back(by); }));
    }
    py::object next(const std::string& line) {
        const DecisionQuery query = queryFrom(line);
        if (query.needsFailures())
            throw std::invalid_argument(line + ": conditions on failures need find()");
        return stateIf(moved([&] { return cursor_.runUntil(query); }));
    }
    py::object state() const {
        turn_.requireReadable();
        py::object address = py::none();
        if (const Event* event = cursor_.event()) address = textOf(toString(event->address));
        const auto before =
            stateRecord({run_, params_, cursor_.stateBefore()}, prepared_, py::none(), address);
        return stateRecord({run_, params_, cursor_.state()}, prepared_, before, py::none());
    }
    py::list events() const {
        turn_.requireReadable();
        py::list list;
        for (const Event& each : cursor_.pivot().events) list.append(eventRecord(each));
        return list;
    }
    py::object find(const std::string& line, std::size_t most, const py::object& report) const {
        const DecisionQuery query = queryFrom(line);
        const auto found =
            require<std::invalid_argument>(longCall(report, [&](const Progress& progress) {
                return findDecisions(*run_->points, params_, query, most, progress);
            }));
        return record("Found", lineList(found.lines), found.total);
    }

  private:
    py::object stateIf(bool moved) const { return moved ? state() : py::none(); }
    static StepUnit unitFrom(const std::string& unit) {
        constexpr std::array<std::string_view, 3> kUnits{"decision", "phase", "pivot"};
        const auto found = std::find(kUnits.begin(), kUnits.end(), unit);
        if (found == kUnits.end())
            throw std::invalid_argument(unit + ": expected decision, phase or pivot");
        return static_cast<StepUnit>(found - kUnits.begin());
    }
    DecisionQuery queryFrom(const std::string& line) const {
        const std::string missing = missingPointIn(line, run_->points->size());
        if (!missing.empty()) throw std::invalid_argument(missing);
        return require<std::invalid_argument>(DecisionQuery::parse(line));
    }
    template <typename Move>
    bool moved(const Move& move) {
        return turn_.take([&] {
            const Unlocked unlocked;
            return move();
        });
    }

    py::object prepared_;
    SharedRun run_;
    Params params_;
    RunCursor cursor_;
    Turn turn_;
};

/// Why a point, an edge or a triangle is in the mesh of a run or not.
py::object whyOf(const SharedRun& run, const std::vector<Index>& points, bool more,
                 const py::object& report) {
    const Params params = possibleParams(*run);
    const Subject subject = points.size() == 1 ? Subject::point(points[0])
                            : points.size() == 2
                                ? Subject::edge(points[0], points[1])
                                : Subject::triangle(points.at(0), points.at(1), points.at(2));
    const Ledger ledger =
        require<std::invalid_argument>(longCall(report, [&](const Progress& progress) {
            ProofScope scope = more ? ProofScope::wide() : ProofScope{};
            scope.alternatives = [&](const Progress& part) -> Result<Alternatives> {
                return alternativesOf(*run->file, run->spec, judgeOf(*run, part), run->leaveOut);
            };
            return provedWhy(*run->points, params, subject, scope, progress);
        }));
    std::vector<std::string> inversions;
    inversions.reserve(ledger.inversions.size());
    for (const WhatIf& each : ledger.inversions) inversions.push_back(lineOf(each));
    std::optional<std::string> without;
    std::optional<std::string> change;
    if (ledger.undoneBy != nullptr) without = std::string(ledger.undoneBy->name) + "=off";
    if (ledger.preventedBy) change = optionsOf({*ledger.preventedBy}).front();
    return record("Answer", ledger.name, ledger.present, ledger.answer,
                  toString(ledger.lines[ledger.cause].event.address),
                  textOf(provedByName(ledger.provedBy)), inversions, without, change,
                  lineList(ledger.lines));
}

/// Names in the order of Phase: those of their stages where they have one.
constexpr std::array<std::string_view, static_cast<std::size_t>(Phase::Finished) + 1> kPhases{
    "seed",        "pivot",    "sort",       "limits", "convex", "reciprocal", "hole",    "sphere",
    "twopoint",    "guard",    "emit",       "ring",   "link",   "fill",       "advance", "fans",
    "droppatches", "reinsert", "closeholes", "flip",   "repair", "finished"};
constexpr std::array<const char*, 4> kReasons{"finished", "condition", "observer", "capped"};

/// A stepper whose observer and conditions are functions of Python.
class PythonStepper {
  public:
    PythonStepper(SharedRun run, py::object observer)
        : run_(std::move(run)),
          observer_(std::move(observer)),
          stepper_(run_->points, possibleParams(*run_)) {
        if (!observer_.is_none())
            stepper_.setObserver([this](const Event& event) {
                return asks(observer_, [&] { return eventRecord(event); });
            });
    }
    PythonStepper(const PythonStepper&) = delete;
    PythonStepper& operator=(const PythonStepper&) = delete;
    ~PythonStepper() = default;

    const State& state() const {
        turn_.requireReadable();
        return stepper_.state();
    }
    py::str phase() const { return textOf(kPhases[static_cast<std::size_t>(state().phase)]); }
    auto pivots() const { return state().counters.pivots; }
    py::array status() const { return arrayOf(state().status); }
    py::array triangles() const { return arrayOf(state().mesh()); }
    py::list rings() const { return ringList(ringPaths(state().rings)); }
    /// A short step, with the lock; so is a pivot.
    bool advance() {
        return called(Call(), [&] { return stepper_.advance(); });
    }
    bool stepPivot() {
        return called(Call(), [&] { return stepper_.stepPivot(); });
    }
    const char* runUntil(const py::object& condition, const py::object& report) {
        const py::object self = py::cast(this);
        return kReasons[static_cast<std::size_t>(called(Call(report), [&] {
            const Unlocked unlocked;
            return stepper_.runUntil([&](const State& now) {
                const auto goOn = [&](double share) { return call_->goOn(share); };
                return !goOnAt(now, goOn) ||
                       (!condition.is_none() && asks(condition, [&] { return self; }));
            });
        }))];
    }
    /// Start, candidates and end, of the pivot that is being worked on; empty otherwise.
    py::object neighborRing() const {
        const State& now = state();
        std::vector<RingPoint> ring;
        if (now.phase > Phase::Sort && now.phase <= Phase::Emit) {
            ring.push_back({now.rings.point(now.pivot.start), now.pivot.startAngle.degrees()});
            for (const Candidate& each : now.pivot.candidates)
                ring.push_back({each.point, each.angle.degrees()});
            ring.push_back({now.rings.point(now.pivot.end), now.pivot.endAngle.degrees()});
        }
        return ringPoints(ring);
    }

  private:
    /// True if a function says so, or has thrown: then the run ends.
    template <typename Argument>
    bool asks(const py::object& function, const Argument& argument) {
        const Locked locked;
        if (call_->isOver()) return true;
        return !call_->attempt([&] { return !py::bool_(function(argument())); });
    }
    /// The value of work(), during which functions are called as a part of `call`.
    template <typename Work>
    std::invoke_result_t<Work> called(Call call, const Work& work) {
        const auto value = turn_.take([&] {
            call_ = &call;
            return work();
        });
        call_ = nullptr;
        call.finish();
        return value;
    }

    SharedRun run_;
    py::object observer_;
    Stepper stepper_;
    Turn turn_;
    Call* call_ = nullptr;
};

}  // namespace

void bindStepping(py::module_& module) {
    py::class_<SeenDecision>(module, "SeenDecision")
        .def("svg", [](const SeenDecision& seen, float width) {
            return view::decisionSvg(*seen.run->points, seen.params, seen.state, width);
        });
    module.def("why", whyOf);
    py::class_<Cursor>(module, "Cursor")
        .def(py::init<py::object>())
        .def("_go_to", &Cursor::goTo)
        .def("forward", &Cursor::forward, "unit"_a = "decision",
             "One \"decision\", \"phase\" or \"pivot\" on; None, unmoved, at the end.")
        .def("back", &Cursor::back, "unit"_a = "decision",
             "One step back, at last to the start; None there.")
        .def("next", &Cursor::next, "line"_a,
             "On to the next decision that a line matches, \"stage=sphere refused margin<0.01\"\n"
             "(spiraling-edge why --help); None, at the end of the run, if there is none.")
        .def("_find", &Cursor::find)
        .def_property_readonly("state", &Cursor::state, "The state at the place of the run.")
        .def_property_readonly("events", &Cursor::events,
                               "All decisions of the pivot at the place of the run, in order.");
    py::class_<PythonStepper>(module, "Stepper")
        .def(py::init<SharedRun, py::object>())
        .def("advance", &PythonStepper::advance,
             "Runs one phase of a pivot. False, doing nothing, if the run is finished.")
        .def("step_pivot", &PythonStepper::stepPivot,
             "Runs to the end of the pivot, or of the next one if between two. False if none was\n"
             "left, or if the observer stopped it.")
        .def("run_until", &PythonStepper::runUntil, "condition"_a = py::none(),
             "progress"_a = py::none(),
             "Runs whole pivots until condition(self) is true between two of them, or to the end:\n"
             "\"condition\", \"observer\", \"finished\", or \"capped\" after too many triangles.")
        .def_property_readonly("phase", &PythonStepper::phase,
                               "The next phase: \"seed\", \"pivot\", \"sort\", ..., \"finished\".")
        .def_property_readonly("pivots", &PythonStepper::pivots,
                               "Number of pivots begun; between two all of them are complete.")
        .def_property_readonly(
            "status", &PythonStepper::status,
            "(n,) int32: UNUSED 0, USED the number of ring entries, DONE -1 (4).")
        .def_property_readonly("triangles", &PythonStepper::triangles,
                               "(t, 3) uint32: the mesh so far (6.4).")
        .def_property_readonly("rings", &PythonStepper::rings,
                               "The active edge ring, then the stack from the top (6.5).")
        .def_property_readonly("neighbor_ring", &PythonStepper::neighborRing,
                               "Start, candidates and end (6.1), from the sort to the triangles.");
}

}  // namespace se::python
