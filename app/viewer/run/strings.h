/// Helpers for strings and files, shared by several rooms. ASCII, independent of the locale.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/outside_text.h"

namespace se::view {

/// Lower case of A to Z; all other bytes unchanged.
std::string lowerCase(std::string_view text);
/// Text without spaces and tabs at both ends.
std::string trimmed(std::string_view text);
/// Text formatted as by printf; at most 119 bytes.
std::string formatted(const char* format, double a, double b = 0.0, double c = 0.0);
/// 12345 as "12 345", with a thin space.
std::string grouped(std::size_t number);
/// Prints text as printableLines(). A message of one line is passed through printable() before.
void printLines(std::FILE* stream, std::string_view text);
/// All bytes of a file; empty if it cannot be read.
std::optional<std::string> readText(const std::filesystem::path& path);

}  // namespace se::view
