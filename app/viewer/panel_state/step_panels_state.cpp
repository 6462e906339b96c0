#include "step_panels_state.h"

namespace se::view {

bool CursorWatch::moved(std::uint32_t generation, std::uint32_t pivot, std::size_t cursor) {
    if (generation_ != generation || pivot_ != pivot || cursor_ != cursor) again_ = 2;
    generation_ = generation;
    pivot_ = pivot;
    cursor_ = cursor;
    return again_ > 0 && again_-- > 0;
}

}  // namespace se::view
