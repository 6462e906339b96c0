// Runs decision by decision: the cursor of a run, the stepper, and the reasons.
#include <pybind11/stl.h>

#include <array>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "arrays.h"
#include "bindings.h"
#include "calls.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/run_cursor.h"
#include "spiraling_edge/why/proof.h"

namespace se::python {
namespace {

using namespace py::literals;

/// Points and angles of a neighbor ring.
py::tuple ringPoints(const std::vector<RingPoint>& ring) {
    std::vector<Index> points;
    std::vector<double> degrees;
    for (const RingPoint& each : ring) {
        points.push_back(each.point);
        degrees.push_back(each.degrees);
    }
    return py::make_tuple(arrayOf(std::move(points)), arrayOf(std::move(degrees)));
}

/// Edge rings: of each its points, the open marks of its steps, whether it is active, its name.
py::list ringList(const std::vector<RingPath>& rings) {
    py::list list;
    for (const RingPath& each : rings) {
        std::vector<std::uint8_t> open(each.open.begin(), each.open.end());
        const py::object marks = arrayOf(std::move(open)).attr("view")("bool");
        list.append(
            py::make_tuple(arrayOf(each.points), marks, each.active, ringName(each.number)));
    }
    return list;
}

/// The fields of the record State of the package.
py::dict stateDict(const DecisionState& state, const PointSet& points, const Params& params) {
    std::optional<Reading> reading;
    if (state.event) reading = readingOf(*state.event, {points, params, state.pivot});
    py::list candidates;
    for (const CandidateMark& each : state.candidates)
        candidates.append(
            py::make_tuple(each.point, each.degrees, each.state == CandidateState::Kept,
                           textOf(verdictText(each.verdict)), textOf(stageName(each.stage))));
    std::vector<PointStatus> status(state.status.size());
    for (std::size_t i = 0; i < status.size(); ++i) status[i] = state.status[i];
    return py::dict(
        "event"_a = state.event, "reading"_a = readingDict(reading),
        "pivot"_a = indexOrNone(state.pivot), "first"_a = indexOrNone(state.first),
        "last"_a = indexOrNone(state.last), "start"_a = indexOrNone(state.start),
        "end"_a = indexOrNone(state.end), "under_test"_a = indexOrNone(state.underTest),
        "sector_degrees"_a = state.sectorDegrees, "complete"_a = state.complete,
        "neighbor_ring"_a = ringPoints(state.neighborRing()), "fan"_a = ringPoints(state.fan()),
        "candidates"_a = candidates, "rings"_a = ringList(state.rings),
        "new_triangles"_a = arrayOf(state.newTriangles),
        "finished_triangles"_a = state.finishedTriangles, "status"_a = arrayOf(std::move(status)));
}

py::list lineList(const std::vector<LedgerLine>& lines) {
    py::list list;
    for (const LedgerLine& each : lines)
        list.append(py::dict("event"_a = each.event, "role"_a = textOf(roleName(each.role)),
                             "pivot"_a = indexOrNone(each.pivot),
                             "reading"_a = readingDict(each.reading)));
    return list;
}

/// A cursor at a decision of a run.
class Cursor {
  public:
    explicit Cursor(SharedRun run)
        : run_(std::move(run)), params_(possibleParams(*run_)), cursor_(run_->points, params_) {}

    /// False if the run has no such decision. Throws if `text` is no address.
    bool goTo(const std::string& text) {
        const auto address = addressFromString(text);
        if (!address)
            throw std::invalid_argument(text + ": expected an address such as 137.sphere.3");
        return moved([&] { return cursor_.goTo(*address); });
    }
    bool step(const std::string& unit, bool back) {
        if (unit != "decision" && unit != "phase" && unit != "pivot")
            throw std::invalid_argument(unit + ": expected decision, phase or pivot");
        const StepUnit by = unit == "phase"   ? StepUnit::Phase
                            : unit == "pivot" ? StepUnit::Pivot
                                              : StepUnit::Decision;
        return moved([&] { return back ? cursor_.back(by) : cursor_.forward(by); });
    }
    bool runUntil(const std::string& line) {
        const DecisionQuery query = queryFrom(line);
        if (query.needsFailures())
            throw std::invalid_argument(line + ": conditions on failures need find()");
        return moved([&] { return cursor_.runUntil(query); });
    }
    py::dict state(bool before) const {
        turn_.requireReadable();
        return stateDict(before ? cursor_.stateBefore() : cursor_.state(), *run_->points, params_);
    }
    std::vector<Event> events() const {
        turn_.requireReadable();
        return cursor_.pivot().events;
    }
    py::tuple find(const std::string& line, std::size_t most, const py::object& report) const {
        const DecisionQuery query = queryFrom(line);
        const auto found =
            require<std::invalid_argument>(longCall(report, [&](const Progress& progress) {
                return findDecisions(*run_->points, params_, query, most, progress);
            }));
        return py::make_tuple(lineList(found.lines), found.total);
    }

  private:
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

    SharedRun run_;
    Params params_;
    RunCursor cursor_;
    Turn turn_;
};

/// Why a point, an edge or a triangle is in the mesh of a run or not; `more`: as why --more.
py::dict whyOf(const SharedRun& run, const std::vector<Index>& points, bool more,
               const py::object& report) {
    const Params params = possibleParams(*run);
    const Subject subject = points.size() == 1 ? Subject::point(points[0])
                            : points.size() == 2
                                ? Subject::edge(points[0], points[1])
                                : Subject::triangle(points.at(0), points.at(1), points.at(2));
    const ProofLimits limits = more ? ProofLimits{200, 100.0} : ProofLimits{};
    const Ledger ledger =
        require<std::invalid_argument>(longCall(report, [&](const Progress& progress) {
            return provedWhy(*run->points, params, subject, limits, progress);
        }));
    std::optional<std::string> inverse;
    if (ledger.inverse) inverse = lineOf(*ledger.inverse);
    std::optional<std::string> rule;
    if (ledger.preventedBy != nullptr)
        rule = lineOf(RuleValue{std::string(ledger.preventedBy->name)});
    return py::dict("subject"_a = ledger.name, "present"_a = ledger.present,
                    "sentence"_a = ledger.answer,
                    "cause"_a = toString(ledger.lines[ledger.cause].event.address),
                    "proved_by"_a = textOf(provedByName(ledger.provedBy)), "what_if"_a = inverse,
                    "rule"_a = rule, "lines"_a = lineList(ledger.lines));
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
            stepper_.setObserver([this](const Event& event) { return asks(observer_, event); });
    }
    PythonStepper(const PythonStepper&) = delete;
    PythonStepper& operator=(const PythonStepper&) = delete;
    ~PythonStepper() = default;

    const Stepper& stepper() const {
        turn_.requireReadable();
        return stepper_;
    }
    const State& state() const { return stepper().state(); }
    /// One phase, or one pivot: a short step, with the lock.
    bool step(bool pivot) {
        return called(Call(), [&] { return pivot ? stepper_.stepPivot() : stepper_.advance(); });
    }
    /// `condition`: called with `self` between two pivots; None: runs to the end.
    const char* runUntil(const py::object& self, const py::object& condition,
                         const py::object& report) {
        return kReasons[static_cast<std::size_t>(called(Call(report), [&] {
            const Unlocked unlocked;
            return stepper_.runUntil([&](const State& now) {
                const auto goOn = [&](double share) { return call_->goOn(share); };
                return !goOnAt(now, goOn) || (!condition.is_none() && asks(condition, self));
            });
        }))];
    }
    /// Start, candidates and end, of the pivot that is being worked on; empty otherwise.
    py::tuple neighborRing() const {
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
        return !call_->attempt([&] { return !py::bool_(function(argument)); });
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
    py::class_<Cursor>(module, "Cursor")
        .def(py::init<SharedRun>())
        .def("go_to", &Cursor::goTo)
        .def("step", &Cursor::step)
        .def("run_until", &Cursor::runUntil)
        .def("state", &Cursor::state)
        .def("events", &Cursor::events)
        .def("find", &Cursor::find);
    module.def("why", whyOf);
    py::class_<PythonStepper>(module, "Stepper")
        .def(py::init<SharedRun, py::object>())
        .def("step", &PythonStepper::step)
        .def("run_until",
             [](PythonStepper& stepper, const py::object& self, const py::object& condition,
                const py::object& report) { return stepper.runUntil(self, condition, report); })
        .def("neighbor_ring", &PythonStepper::neighborRing)
        .def("rings", [](const PythonStepper& s) { return ringList(ringPaths(s.state().rings)); })
        .def("status", [](const PythonStepper& s) { return arrayOf(s.state().status); })
        .def("triangles", [](const PythonStepper& s) { return arrayOf(s.state().mesh()); })
        .def("counters", [](const PythonStepper& s) { return countersDict(s.state().counters); })
        .def("pivots", [](const PythonStepper& s) { return s.state().counters.pivots; })
        .def("phase", [](const PythonStepper& s) {
            return textOf(kPhases[static_cast<std::size_t>(s.state().phase)]);
        });
}

}  // namespace se::python
