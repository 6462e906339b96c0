#include "strings.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

std::string trimmed(std::string_view text, std::string_view signs) {
    const std::size_t from = text.find_first_not_of(signs);
    if (from == std::string_view::npos) return {};
    return std::string(text.substr(from, text.find_last_not_of(signs) - from + 1));
}

std::string formatted(const char* format, double a, double b, double c) {
    char out[120];
    std::snprintf(out, sizeof out, format, a, b, c);
    return out;
}

std::string grouped(std::size_t number) {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, "\xE2\x80\x89");
    return text;
}

std::string withS(std::size_t number, std::string_view noun) {
    return grouped(number).append(" ").append(noun).append(number == 1 ? "" : "s");
}

void printLines(std::FILE* stream, std::string_view text) {
    std::fputs(printableLines(text).c_str(), stream);
}

std::string wholePath(const std::string& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path, error);
    return (error ? std::filesystem::path(path) : whole).lexically_normal().string();
}

std::optional<std::string> readText(const std::filesystem::path& path) {
    Result<std::string> bytes = readBytes(path, kTextLimit);
    return bytes ? std::optional(std::move(bytes.value())) : std::nullopt;
}

namespace {

std::string withoutMinusZero(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    std::string result(text);
    // A sign before zeros only would be misleading.
    const bool zero = result.find_first_of("123456789in") == std::string::npos;
    if (zero && (result[0] == '-' || result[0] == '+')) result.erase(0, 1);
    return result;
}

bool isDigit(char sign) { return sign >= '0' && sign <= '9'; }

/// A decimal fraction in a text, such as "0.0038125" or "1.23457e-05".
struct Fraction {
    std::size_t length = 0;
    std::size_t before = 0;       ///< Digits before the point.
    std::size_t significant = 0;  ///< Digits without leading zeros.
};

std::size_t digitsAt(std::string_view text, std::size_t at) {
    const auto end =
        std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), isDigit);
    return static_cast<std::size_t>(end - text.begin()) - at;
}

/// The fraction that a text begins with; empty if it begins with none, or with an address.
std::optional<Fraction> fractionAt(std::string_view text) {
    Fraction found;
    found.before = digitsAt(text, 0);
    if (found.before == 0 || found.before == text.size() || text[found.before] != '.') return {};
    const std::size_t after = digitsAt(text, found.before + 1);
    if (after == 0) return {};
    found.length = found.before + 1 + after;
    const std::string_view digits = text.substr(0, found.length);
    const std::size_t first = digits.find_first_of("123456789");
    if (first != std::string_view::npos)
        found.significant = found.length - first - (first < found.before ? 1 : 0);
    if (found.length < text.size() && text[found.length] == 'e') {
        const std::size_t sign = found.length + 1;
        const bool hasSign = sign < text.size() && (text[sign] == '-' || text[sign] == '+');
        const std::size_t exponent =
            digitsAt(text, std::min(text.size(), sign + (hasSign ? 1 : 0)));
        if (exponent > 0) found.length = sign + (hasSign ? 1 : 0) + exponent;
    }
    const bool address = found.length + 1 < text.size() && text[found.length] == '.' &&
                         isDigit(text[found.length + 1]);
    return address ? std::nullopt : std::optional(found);
}

}  // namespace

std::string exact(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string boxText(const WallBox& box, char between) {
    std::string text;
    for (const Vec3& corner : {box.low, box.high}) {
        for (int i = 0; i < 3; ++i) {
            if (!text.empty()) text += between;
            text += exact(corner[i]);
        }
    }
    return text;
}

std::optional<WallBox> boxFromText(std::string_view text, char between) {
    std::string commas(text);
    std::replace(commas.begin(), commas.end(), between, ',');
    const auto numbers = numbersIn(commas, 6);
    if (!numbers) return std::nullopt;
    const std::vector<double>& n = *numbers;
    const WallBox box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    const bool ordered = box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z;
    return ordered ? std::optional(box) : std::nullopt;
}

std::string numberText(double value) { return withoutMinusZero("%.4g", value); }

std::string signedText(double value) { return withoutMinusZero("%+.4g", value); }

std::string degreesText(double degrees) { return withoutMinusZero("%.1f", degrees) + "\xC2\xB0"; }

std::string withShortNumbers(std::string_view sentence) {
    constexpr std::size_t kDigits = 4;
    std::string text;
    for (std::size_t at = 0; at < sentence.size();) {
        const bool begins =
            at == 0 || !(std::isalnum(static_cast<unsigned char>(sentence[at - 1])) ||
                         sentence[at - 1] == '.' || sentence[at - 1] == '_');
        const auto found = begins ? fractionAt(sentence.substr(at)) : std::nullopt;
        if (!found) {
            text += sentence[at++];
            continue;
        }
        const std::string number(sentence.substr(at, found->length));
        at += found->length;
        if (found->significant <= kDigits) {
            text += number;
        } else {
            const double value = numberIn<double>(number).value_or(0.0);
            text += withoutMinusZero(found->before >= kDigits ? "%.0f" : "%.4g", value);
        }
    }
    return text;
}

std::string shortSentence(const Event& event) { return withShortNumbers(describe(event)); }

std::string numbersText(const Vec3& values) {
    return numberText(values.x) + ", " + numberText(values.y) + ", " + numberText(values.z);
}

std::string percentText(double share) { return withoutMinusZero("%+.1f", 100.0 * share) + " %"; }

std::string durationText(double seconds) {
    return seconds < 1.0 ? withoutMinusZero(seconds < 0.1 ? "%.2g" : "%.0f", 1e3 * seconds) + " ms"
                         : withoutMinusZero("%.3g", seconds) + " s";
}

}  // namespace se::view
