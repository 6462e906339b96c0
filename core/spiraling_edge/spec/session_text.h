/// The text of a session file (docs/file-formats.md): the one writer of its options.
#pragma once

#include <string>

#include "spiraling_edge/spec/spec_fields.h"

namespace se {

/// The content of a session: points, run, and the place to open at.
struct SessionStart {
    std::string points;   ///< Path of the points, relative to the session.
    RunSpec spec;         ///< Its source is not used.
    std::string address;  ///< Of the decision to open at.
    std::string alert{};  ///< "holes:1"; empty: none.
    std::string notes{};
};

/// The session as JSON.
std::string sessionText(const SessionStart& start);

}  // namespace se
