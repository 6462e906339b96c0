/// Draw lists of layers, for tests of them.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <string_view>

#include "layers/layer.h"
#include "open_session.h"
#include "spiraling_edge/run/pivot_record.h"

namespace se::view::test {

/// The draw list at an address, with only the given layers.
inline DrawList drawn(OpenSession& open, const Address& address, std::initializer_list<LayerId> ids,
                      Index selected = kNone) {
    open.session.moves().goTo(address);
    open.session.waitUntilDone();
    LayerSwitches on;
    for (const LayerId id : ids) on.set(static_cast<std::size_t>(id));
    LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark), selected,
                  kNone};
    in.marked = open.session.highlights().marked();
    in.labeled = open.session.highlights().labeled();
    in.names = open.session.names();
    DrawList list;
    fillDrawList(in, on, list);
    return list;
}

/// One layer of the session's picture, at a moment of its motion.
inline DrawList drawnAt(const OpenSession& open, const Moment& moment,
                        void (*add)(const LayerInput&, DrawList&)) {
    LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark)};
    in.triangles = open.session.triangles();
    in.meshIndex = &open.session.meshIndex();
    in.moment = moment;
    DrawList list;
    add(in, list);
    return list;
}

inline constexpr Moment kPaper{Moment::Kind::Paper, 0.0, false};

inline constexpr Address kWhole{30, Stage::Pivot, 0};

inline std::size_t count(const DrawList& list, Shape shape) {
    return static_cast<std::size_t>(
        std::count_if(list.sprites.begin(), list.sprites.end(),
                      [&](const Sprite& s) { return s.style.shape == shape; }));
}

inline bool says(const DrawList& list, std::string_view part) {
    return std::any_of(list.labels.begin(), list.labels.end(), [&](const Label& label) {
        return label.text.find(part) != std::string::npos;
    });
}

inline bool hasLine(const DrawList& list, const glm::vec3& from, const glm::vec3& to) {
    return std::any_of(list.lines.begin(), list.lines.end(), [&](const Line& line) {
        return (glm::distance(line.from, from) < 1e-5F && glm::distance(line.to, to) < 1e-5F) ||
               (glm::distance(line.from, to) < 1e-5F && glm::distance(line.to, from) < 1e-5F);
    });
}

/// The address of the first event of a run for which `wanted` is true.
template <typename Kind>
Address firstWhere(OpenSession& open, bool (*wanted)(const Kind&)) {
    Timeline timeline(open.session.model().points, open.session.model().params);
    for (std::uint32_t pivot = 1; pivot < 130; ++pivot) {
        const auto record = timeline.record(pivot);
        for (const Event& event : record->events) {
            const auto* evidence = std::get_if<Kind>(&event.evidence);
            if (evidence != nullptr && wanted(*evidence)) return event.address;
        }
    }
    return {};
}

}  // namespace se::view::test
