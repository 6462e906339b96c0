/// Copying a link to what is shown, and following one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "context.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

/// Longest packed file in a copied link: mail and chat programs keep addresses of that length.
inline constexpr std::size_t kMostLetters = 7500;

/// Where copied links begin: at the page that is the program, else as linkBase() says.
std::string_view linkBase(const CommandContext& context);

/// A source as it stands in a link: a file is inside where that stays short.
struct LinkedSource {
    std::string source;
    std::string notice;  ///< What is missing, in a sentence; empty: nothing.
};
LinkedSource linkedSource(const std::string& source);

/// A link to what is shown.
struct PresentLink {
    std::string text;
    std::string notice;  ///< What it lacks, in a sentence; empty: nothing.
};

/// The link, from `base` on: with the open lesson and its step, or with the open input, its
/// options, address and camera. A file is inside the link where that stays short. Requires an open
/// run.
PresentLink linkTo(const CommandContext& context, std::string_view base);

/// Goes to the address and the camera of a link; opens its input first if it is not the open one
/// with the same options. Fails with a sentence.
Status followLink(CommandContext& context, std::string_view text);

namespace actions {

/// Copies a link to what is shown.
void copyLink(CommandContext& c);
/// Copies HTML that shows the place of that link in a frame of a page.
void copyFrame(CommandContext& c);
/// Follows a link, or goes to an address or position.
void follow(CommandContext& c, const std::string& text);
/// Goes to what was typed into the box with the address, or to the address of a link there.
void goToTyped(CommandContext& c);

}  // namespace actions

// A link to a failure: the points of the run, reduced to the fewest that still fail, inside it.

inline constexpr std::string_view kNoAlertShown = "Choose an alert first.";

/// Why the alert that is shown has no link of its own; empty: it can have one.
std::string_view reasonAgainstFailureLink(const CommandContext& context);

/// Copies the link, as soon as the points are reduced. Says in a sentence what came out.
void finishFailureLink(CommandContext& context);

namespace actions {

/// Reduces the points of the run to the fewest that still end in the alert that is shown.
void copyFailureLink(CommandContext& c);

}  // namespace actions

}  // namespace se::view
