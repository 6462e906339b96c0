/// The points kept of an input, as text and in JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "input.h"

namespace se::cli {

/// "12345 of 1000000 points: crop, thin 0.5"; empty for a whole file.
std::string keptSentence(const KeptPoints& points);
/// The same with the box; null for a whole file.
nlohmann::ordered_json keptJson(const KeptPoints& points);

}  // namespace se::cli
