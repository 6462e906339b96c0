#include "spiraling_edge/spec/session_text.h"

#include <fstream>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/outside_text.h"

namespace se {

bool looksLikeSession(const std::filesystem::path& path) {
    if (lowerExtension(path) == kSessionExtension) return true;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    char first = 0;
    return (file >> first) && first == '{';
}

std::string sessionText(const SessionStart& start) {
    // Else "scene:a.ply" would be taken for a scene.
    const bool isPlain = start.points.find(':') == std::string::npos;
    std::string text =
        "{\"format\": \"spiraling-edge session\", \"version\": 1,\n \"input\": {\"source\": " +
        jsonQuoted(isPlain ? start.points : "./" + start.points) +
        "},\n \"options\": " + optionsJson(start.spec) +
        ",\n \"address\": " + jsonQuoted(start.address);
    if (!start.alert.empty()) text += ",\n \"alert\": " + jsonQuoted(start.alert);
    if (!start.notes.empty()) text += ",\n \"notes\": " + jsonQuoted(start.notes);
    return printableJson(text + "}\n");
}

}  // namespace se
