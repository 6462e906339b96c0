#include "palette.h"

#include <algorithm>
#include <array>

#include "run/strings.h"
#include "spiraling_edge/run/reading.h"

namespace se::view {

namespace {

constexpr std::array<std::string_view, 2> kThemeNames = {"dark", "light"};

constexpr Palette kDark = {
    .background = fromHex(0x1E2126),
    .pivot = fromHex(0xF0E442),
    .used = fromHex(0x56B4E9),
    .first = fromHex(0x009E73),
    .last = fromHex(0xCC79A7),
    .test = fromHex(0xE69F00),
    .rejected = fromHex(0xD55E00),
    .unused = fromHex(0xBAC0C6),
    .done = fromHex(0x686E76),
    .mesh = fromHex(0xACAFB1),
    .meshEdge = fromHex(0x2A2E34),
    .panel = fromHex(0x24282E),
    .panelRaised = fromHex(0x2E333A),
    .border = fromHex(0x3A4048),
    .text = fromHex(0xE4E7EB),
    .textDim = fromHex(0xA9B1BA),
    .accent = fromHex(0x3987BF),
    .accentText = fromHex(0xFFFFFF),
};

constexpr Palette kLight = {
    .background = fromHex(0xE8EAED),
    .pivot = fromHex(0x000000),
    .used = fromHex(0x2A7FC0),
    .first = fromHex(0x00694D),
    .last = fromHex(0x8E2C8A),
    .test = fromHex(0xB07800),
    .rejected = fromHex(0xA83A00),
    .unused = fromHex(0x6B7280),
    .done = fromHex(0x7F858D),
    .mesh = fromHex(0xF7F6F3),
    .meshEdge = fromHex(0x757D86),
    .panel = fromHex(0xF4F5F7),
    .panelRaised = fromHex(0xE6E8EC),
    .border = fromHex(0xC9CDD3),
    .text = fromHex(0x1B1F24),
    .textDim = fromHex(0x4E555E),
    .accent = fromHex(0x2A74AE),
    .accentText = fromHex(0xFFFFFF),
};

}  // namespace

std::optional<Theme> themeFromName(std::string_view name) {
    return idNamed<Theme>(kThemeNames, name);
}

std::string_view themeName(Theme theme) { return kThemeNames[static_cast<std::size_t>(theme)]; }

const Palette& paletteOf(Theme theme) { return theme == Theme::Dark ? kDark : kLight; }

Color viridis(float share) {
    // matplotlib's map at nine positions.
    constexpr std::array<Color, 9> kPlaces = {
        fromHex(0x440154), fromHex(0x472D7B), fromHex(0x3B528B),
        fromHex(0x2C728E), fromHex(0x21918C), fromHex(0x28AE80),
        fromHex(0x5EC962), fromHex(0xADDC30), fromHex(0xFDE725)};
    const float at = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kPlaces.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), kPlaces.size() - 2);
    return mix(kPlaces[low], kPlaces[low + 1], at - static_cast<float>(low));
}

std::optional<Color> outcomeColor(const Palette& palette, const Event& event) {
    if (std::holds_alternative<AlertEvidence>(event.evidence)) return palette.rejected;
    const std::optional<Verdict> verdict = verdictOf(event);
    if (!verdict) return std::nullopt;
    // Where start or end is now.
    if (const auto* limit = as<LimitEvidence>(event); limit != nullptr && limit->moves())
        return palette.test;
    const Outcome outcome = rowOf(*verdict).outcome;
    if (outcome == Outcome::Taken) return palette.used;
    if (outcome == Outcome::Refused) return palette.rejected;
    return outcome == Outcome::Unchanged ? palette.textDim : palette.test;
}

}  // namespace se::view
