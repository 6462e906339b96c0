/// Keys by their names, for tests.
#pragma once

#include "input/key_map.h"

namespace se::view::test {

/// `text` must be the name of a key, as in the key map.
inline KeyChord chord(const char* text) { return keyFromString(text).value(); }

}  // namespace se::view::test
