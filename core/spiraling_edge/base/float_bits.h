/// The bytes of a number read as another type of the same size, as std::bit_cast does, which the
/// compiler of the browser build does not have.
#pragma once

#include <cstring>

namespace se {

template <typename To, typename From>
To bitsAs(const From& from) {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(&to, &from, sizeof(to));
    return to;
}

}  // namespace se
