/// Keys by their names, for tests.
#pragma once

#include "input/keys.h"

namespace se::view::test {

/// `text` must be the name of one, as the key map writes it.
inline KeyChord chord(const char* text) { return keyFromString(text).value(); }

}  // namespace se::view::test
