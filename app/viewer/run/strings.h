/// Helpers for text, numbers and files, shared by several rooms. ASCII, independent of the locale.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/points/wall_types.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// Text without these signs at both ends, by default spaces and tabs.
std::string trimmed(std::string_view text, std::string_view signs = " \t");
/// With ends of lines.
inline constexpr std::string_view kBlanks = " \t\r\n";
/// Text formatted as by printf; at most 119 bytes.
std::string formatted(const char* format, double a, double b = 0.0, double c = 0.0);
/// 12345 as "12 345", with a thin space.
std::string grouped(std::size_t number);
/// "1 pivot", "12 345 pivots".
std::string withS(std::size_t number, std::string_view noun);
/// Prints text as printableLines(). A message of one line is passed through printable() before.
void printLines(std::FILE* stream, std::string_view text);
/// All bytes of a file; empty if it cannot be read.
std::optional<std::string> readText(const std::filesystem::path& path);
/// The path as it holds in any folder; as given if the present folder is not known.
std::string wholePath(const std::string& path);

// Numbers and boxes as text, the same in the view, on the dial and in Inspect, independent of the
// locale. A number that rounds to zero has no sign: never "-0".

/// The shortest text that reads back as the same number.
std::string exact(double value);

/// "x0,y0,z0,x1,y1,z1", with the character `between` instead of the commas.
std::string boxText(const WallBox& box, char between);
/// Six numbers, the lower corner first.
std::optional<WallBox> boxFromText(std::string_view text, char between);

/// Four significant digits.
std::string numberText(double value);
/// Four significant digits with a sign, for values compared with zero.
std::string signedText(double value);
/// "96.1 degrees", with the sign of degrees.
std::string degreesText(double degrees);
/// A sentence with at most four significant digits per decimal fraction, and none after the
/// decimal point if four come before it. Whole numbers and addresses stay as they are.
std::string withShortNumbers(std::string_view sentence);
/// describe() with short numbers: for panels, which are read and compared. Traces, copies and
/// tooltips use describe() itself.
std::string shortSentence(const Event& event);
/// "1.5, 0, -2"
std::string numbersText(const Vec3& values);
/// "+3.4 %" for 0.034.
std::string percentText(double share);
/// "0.91 ms", "2.5 s".
std::string durationText(double seconds);

}  // namespace se::view
