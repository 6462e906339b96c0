#include "bookmarked_lesson.h"

#include <utility>
#include <variant>
#include <vector>

#include "run/packed_file.h"
#include "session/view_position.h"
#include "teach/lesson_skeleton.h"

namespace se::view {

namespace {

/// The input as it stands in a lesson in `folder`.
Result<std::string> inputFrom(const std::filesystem::path& folder, const std::string& source) {
    if (isSample(source) || isStandardInput(source) || isPacked(source))
        return Error{"A lesson begins with a scene or a file: save the points first."};
    if (isScene(source) || isPractice(source)) return source;
    const std::string input = std::filesystem::proximate(source, folder).generic_string();
    if (!input.starts_with("..")) return input;
    return Error{"The points of a lesson lie in its folder or below it: save it beside " + source +
                 "."};
}

}  // namespace

Result<std::string> lessonOfBookmarks(const RunSpec& spec, const Annotations& annotations,
                                      const std::filesystem::path& folder) {
    const Result<std::string> input = inputFrom(folder, spec.source);
    if (!input) return input.error();
    std::vector<teach::NotedPosition> positions;
    for (const Bookmark& each : annotations.bookmarks)
        positions.push_back({toString(each.address), each.note,
                             each.camera ? toText(ViewPosition{"", each.camera}) : std::string{}});
    return teach::lessonOfNotes(input.value(), spec, annotations.notes, positions);
}

}  // namespace se::view
