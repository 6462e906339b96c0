/// Actions for alerts. No ImGui.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "context.h"
#include "document.h"
#include "session/session.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

/// The moments of an alert, as the panel lists them.
enum class AlertMoment : std::uint8_t { Created, Decided, Touched };
inline constexpr std::array<AlertMoment, 3> kAlertMoments{
    AlertMoment::Created, AlertMoment::Decided, AlertMoment::Touched};
/// "created", "decided", "first touched".
std::string_view momentName(AlertMoment moment);
const LedgerLine& momentOf(const RunFailure& alert, AlertMoment moment);

/// The faulty triangle, edge or point; empty for a hole or a ring, which is asked about as a whole.
Selection subjectOf(const RunFailure& alert);
/// "intersecting triangles"
std::string titleOf(const FailureClass& kind);

/// Reason why some failures, or all, are not reported during stepping; empty if all are.
std::string watchNote(std::size_t points, std::size_t noticed);

/// Chooses an alert, goes to one of its moments if given, selects its subject and
/// frames it. Requires a place in session.alerts().failures().
void showAlert(CommandContext& context, std::size_t alert, std::optional<AlertMoment> moment);
/// Shows a place with faults on the finished mesh: chooses it, goes to the end of the run, selects
/// the subject of its most severe fault, frames it, and says what is there. Requires a position in
/// session.alerts().places().
void showPlace(CommandContext& context, std::size_t place);
/// The most severe fault that a point, an edge or a triangle is part of, by its alert; empty if
/// there is none, or none that was followed.
std::optional<std::size_t> alertAt(const RunAlerts& alerts, const Selection& what);
/// The next (+1) or previous (-1) place, from the most severe on.
void nextPlace(CommandContext& context, int direction);
/// "the mesh has faults at 12 places: 2 of holes, 10 of lost points", "the mesh is sound". Requires
/// a search that is done.
std::string verdictText(const RunAlerts& alerts);
/// "Place 1 of 31: 1 hole of 3 edges." of the place that is shown, else "The run is finished; the
/// mesh is sound." Requires a search that is done.
std::string verdictSentence(const RunAlerts& alerts);
/// "3 places" with faults, "sound"; before the end of the run "at end: 3 places". Requires a
/// search that is done.
std::string endText(const Session& session);
/// True where the finished mesh is shown with its faults, and without its last decision.
bool showsFinishedMesh(const CommandContext& context);
/// Runs the input again with a change, to its end: the place of the defect is visible there. If it
/// is a rule, selection and camera stay.
void runWith(CommandContext& context, const FieldValue& change);
/// True if Fix has something to do: the mesh is not sound, and other settings can be tried, or one
/// of those tried is better.
bool canFix(const CommandContext& context);
/// Runs the input again, to its end, with the best settings when all have been tried or the user
/// has ended the trials: the result is the same whenever it is called. Requires canFix().
void fixByTrials(CommandContext& context);
/// "Run again, to the end: robust rules. 812 of 25 950 triangles go, 850 come, in 31 regions".
/// Requires canFix().
std::string fixText(const TrialJob& job);
/// The triangles that Fix would change, while the pointer is on it and the finished mesh is shown;
/// null otherwise.
const MeshChange* shownChange(const CommandContext& context);
/// Loops that stay open: "5 open, up to 0.0178 across", in the unit of the file; empty if none do.
std::string openText(const OpenLoops& loops);
/// Runs the input again, to its end, with holes and openings closed up to a width in the unit of
/// the file; 0: as the rules say. With the robust rules if those of the input close no holes.
void closeHoles(CommandContext& context, double width);
/// Opens the layout Compare: the run as it is, and the one with that change, at this position.
void showBeside(CommandContext& context, const FieldValue& change);

// Shows the alert of the command line, that of the session, or the finished mesh with its faults,
// once the alerts of a run are known. Independent of window and OpenGL.

class AlertsShown {
  public:
    explicit AlertsShown(CommandContext& context) : c_(context) {}

    /// Takes the alert of the command line. Pictures without a user open where their options say.
    void begin(const Options& options);
    /// Once the alerts are known: goes to what to show; after a run of the same input with other
    /// rules, says what has become of the faults.
    void poll();
    /// True once, if a newly opened input opened on its finished mesh.
    bool takeOpened() { return std::exchange(opened_, false); }
    /// Error if the alert of the command line does not exist.
    const Status& status() const { return status_; }

  private:
    void chooseOfGallery();
    void fixWhenTried();
    void reportChange();
    void startTrials();
    void showAsked();

    CommandContext& c_;
    std::string asked_;                   ///< By the command line, until it was shown.
    std::string source_;                  ///< The input of the last known alerts.
    std::optional<MeshVerdict> verdict_;  ///< Of that input; empty before any was known.
    RunSpec rules_;                       ///< Of the last known alerts.
    bool interactive_ = true;             ///< A user is present.
    bool opened_ = false;
    Status status_ = success();
};

}  // namespace se::view
