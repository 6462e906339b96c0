/// The file formats of the tables, as text for options and messages: "PLY, OBJ or OFF".
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se {

/// Names or extensions (`text`) of the formats that `keeps` is true for, as wordList() joins them:
/// listText(pointFormats(), &PointFormat::name, "or", &PointFormat::faces).
template <typename Format, typename Keeps>
std::string listText(std::span<const Format> formats, std::string_view Format::*text,
                     std::string_view conjunction, Keeps keeps) {
    std::vector<std::string_view> words;
    for (const Format& each : formats) {
        if (std::invoke(keeps, each)) words.push_back(each.*text);
    }
    return wordList(words, conjunction);
}

/// Names or extensions of all formats.
template <typename Format>
std::string listText(std::span<const Format> formats, std::string_view Format::*text,
                     std::string_view conjunction) {
    return listText(formats, text, conjunction, [](const Format&) { return true; });
}

}  // namespace se
