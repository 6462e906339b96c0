/// A decision of a ledger in words, for rows, tooltips and the clipboard.
#pragma once

#include <span>
#include <string>

#include "spiraling_edge/explain/ledger.h"

namespace se::view {

/// "angle 120.9° against 211.4°, margin +1.6".
std::string readingText(const Reading& reading);
/// "angle 120.9° against 211.4°", or without the name of the quantity.
std::string comparisonText(const Reading& reading, bool named);
/// "+1.6", "-3.2e-05", "0".
std::string marginText(double margin);
/// Address, role, pivot, section, sentence and reading, in two lines at most.
std::string lineText(const LedgerLine& line);
/// The answer and all lines; the decisive one has a mark.
std::string ledgerText(const std::string& answer, std::span<const LedgerLine> lines,
                       std::size_t cause);

}  // namespace se::view
