/// Lessons that are part of the programs: those of assets/lessons, in teaching order.
#pragma once

#include <span>
#include <string_view>

namespace se::teach {

/// The file of one lesson.
struct EmbeddedLesson {
    std::string_view id;  ///< "tour"
    std::string_view text;
};

/// All lessons.
std::span<const EmbeddedLesson> embeddedLessons();
/// Null if there is none of that id.
const EmbeddedLesson* findEmbeddedLesson(std::string_view id);

}  // namespace se::teach
