/// The visible state of the program as one JSON object, with the rectangles of the items to click
/// on: what a test sees of it. The scenarios in ui/ drive the real window, and wait for states
/// instead of times.
#pragma once

#include <string>

#include "application.h"
#include "opening_times.h"

namespace se::view::test {

/// Requires a started application.
std::string stateDump(Application& app, const InputProgress& input = {},
                      const OpeningTimes& times = OpeningTimes({}));

}  // namespace se::view::test
