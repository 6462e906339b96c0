#include "svg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace se::view {

namespace {

struct ColorClass {
    std::string_view name;
    Color Palette::*color;
};
constexpr std::array kColorClasses{
    ColorClass{"pivot", &Palette::pivot},     ColorClass{"used", &Palette::used},
    ColorClass{"first", &Palette::first},     ColorClass{"last", &Palette::last},
    ColorClass{"test", &Palette::test},       ColorClass{"rejected", &Palette::rejected},
    ColorClass{"unused", &Palette::unused},   ColorClass{"done", &Palette::done},
    ColorClass{"mesh", &Palette::mesh},       ColorClass{"mesh-edge", &Palette::meshEdge},
    ColorClass{"text", &Palette::text},       ColorClass{"text-dim", &Palette::textDim},
    ColorClass{"view", &Palette::background},
};

/// One row per SvgPaint.
struct PaintRow {
    std::string_view property;
    std::string_view suffix;  ///< Of classes named after a meaning.
    char letter;              ///< Of the others.
};
constexpr std::array kPaints{PaintRow{"fill", "", 'f'}, PaintRow{"stroke", "-line", 'l'},
                             PaintRow{"color", "-color", 'c'}};

unsigned byteOf(float share) {
    return static_cast<unsigned>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

}  // namespace

void appendPixels(std::string& out, float value) {
    const long tenths = std::lround(10.0F * std::clamp(value, -1e6F, 1e6F));
    if (tenths < 0) out += '-';
    const long size = std::labs(tenths);
    out += std::to_string(size / 10);
    if (size % 10 != 0) (out += '.') += static_cast<char>('0' + size % 10);
}

void appendPlace(std::string& out, glm::vec2 place) {
    appendPixels(out, place.x);
    out += ' ';
    appendPixels(out, place.y);
}

std::string escapedXml(std::string_view text) {
    std::string out;
    for (const char sign : text) {
        switch (sign) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                // XML has no other control characters.
                if (static_cast<unsigned char>(sign) >= 32 || sign == '\n' || sign == '\t')
                    out += sign;
        }
    }
    return out;
}

std::string nameOfTitle(std::string_view title) {
    std::string name;
    for (const char sign : title) {
        if (sign >= 'A' && sign <= 'Z') {
            name += static_cast<char>(sign - 'A' + 'a');
        } else if ((sign >= 'a' && sign <= 'z') || (sign >= '0' && sign <= '9')) {
            name += sign;
        } else if (!name.empty() && name.back() != '-') {
            name += '-';
        }
    }
    return name;
}

std::string hexColor(const Color& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", byteOf(color.r), byteOf(color.g), byteOf(color.b));
}

std::string SvgClasses::meaningOf(const Color& color) const {
    const Palette& palette = paletteOf(theme_);
    const std::string hex = hexColor(color);
    for (const ColorClass& each : kColorClasses) {
        if (hexColor(palette.*each.color) == hex) return std::string(each.name);
    }
    return {};
}

const std::string& SvgClasses::classOf(const Ink& color, SvgPaint paint) {
    const PaintRow& row = kPaints[static_cast<std::size_t>(paint)];
    std::string key = std::string(row.property) + hexColor(color.color);
    if (both_) key += hexColor(color.other);
    if (const auto found = known_.find(key); found != known_.end())
        return rules_[found->second].name;
    std::string name = meaningOf(color.color);
    if (!name.empty()) name += row.suffix;
    const bool taken = std::any_of(rules_.begin(), rules_.end(),
                                   [&](const Rule& each) { return each.name == name; });
    if (name.empty() || taken) name = row.letter + std::to_string(rules_.size());
    known_.emplace(std::move(key), rules_.size());
    rules_.push_back({std::move(name), color, paint});
    return rules_.back().name;
}

std::string SvgClasses::sheet(bool other) const {
    std::string text;
    for (const Rule& each : rules_) {
        text += fmt::format(".{}{{{}:{}}}", each.name,
                            kPaints[static_cast<std::size_t>(each.paint)].property,
                            hexColor(other ? each.color.other : each.color.color));
    }
    return text;
}

}  // namespace se::view
