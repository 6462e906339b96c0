/// What the questions about a run ask of its events (ledger, moments of a failure, query lines).
#pragma once

#include "spiraling_edge/ledger.h"

namespace se {

/// The event as a line, its role by what became of the test.
LedgerLine lineOf(const Event& event, const ReadingContext& context);

/// Left out of the sort as a fact, not by a test: DONE, or first or last itself.
bool wasSettledBefore(const Event& event);

/// A step after the last pivot, which changes the mesh without saying which triangles.
bool mendsMesh(const Event& event);

}  // namespace se
