/// Going to what went wrong. No ImGui.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "commands.h"
#include "session/session.h"

namespace se::view {

/// The moments of an alert, as the panel lists them.
enum class AlertMoment : std::uint8_t { Created, Unavoidable, Touched };
inline constexpr std::array<AlertMoment, 3> kAlertMoments{
    AlertMoment::Created, AlertMoment::Unavoidable, AlertMoment::Touched};
/// "created", "unavoidable", "first touched".
std::string_view momentName(AlertMoment moment);
const LedgerLine& momentOf(const RunFailure& alert, AlertMoment moment);

/// What one asks "why?" about: the faulty triangle, edge or point; of a hole the point whose
/// refusal left it.
Selection subjectOf(const RunFailure& alert);
/// "intersecting triangles"
std::string titleOf(const FailureClass& kind);
/// "21, 50, 77, ..."
std::string pointsText(const MeshFailure& failure, std::size_t most);

/// Why nothing, or nothing more, is said of failures while one steps; empty if everything is.
std::string watchNote(std::size_t points, std::size_t noticed);

/// Chooses an alert, goes to one of its moments if there is one, selects what it is about and
/// frames it. Requires a place in session.alerts().failures().
void showAlert(CommandContext& context, std::size_t alert, std::optional<AlertMoment> moment);
/// Puts the alert that is looked at into the middle of the view.
void frameAlert(CommandContext& context);
/// The next (+1) or previous (-1) alert in the order of the run: from the one that is chosen, else
/// from the cursor.
void nextAlert(CommandContext& context, int direction);
/// Runs the input again with one more rule, or another set of rules, to its end: what became of the
/// defect is in sight there, since selection and camera stay.
void switchOn(CommandContext& context, const Remedy& remedy);
/// Opens the layout Compare: the run as it is, and the one with that rule or set, at this place.
void showBeside(CommandContext& context, const Remedy& remedy);

/// Once the alerts of an input are known: an input that was just opened, and that nobody has done
/// anything with yet, opens on the first of them. True if it does.
bool openOnFirstAlert(CommandContext& context);

}  // namespace se::view
