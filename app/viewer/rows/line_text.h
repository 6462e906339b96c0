/// A decision of a ledger in words, for rows, tooltips and the clipboard.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/why/ledger.h"

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

/// The terms that complete the last word of a line; all of them after a space, or if it is none.
std::vector<const QueryTerm*> termsFor(std::string_view line);
/// The line with its last word replaced by the beginning of a term: "stage=sphere mar" and
/// margin<X give "stage=sphere margin<".
std::string completed(std::string_view line, const QueryTerm& term);

}  // namespace se::view
