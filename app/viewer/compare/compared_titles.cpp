#include "compared_titles.h"

#include "run/number_format.h"
#include "run/strings.h"

namespace se::view {

namespace {

/// The position of a run, and the number of triangles only in it.
std::string runNote(const Session& session, std::size_t only) {
    const bool placed = session.ready() && session.event() != nullptr;
    return (placed ? toString(session.address()) : "start") + "   " + grouped(only) + " only here";
}

}  // namespace

std::array<ComparedTitle, 2> comparedTitles(const Session& run, const Comparison* now) {
    ComparedTitle a{"A", run.ready() ? runTitle(run.input().spec()) : "", "", &Palette::used};
    ComparedTitle b{"B", "nothing yet", "", &Palette::last};
    const Compared* found = now != nullptr ? now->result() : nullptr;
    if (found != nullptr) a.note = runNote(run, found->meshes.onlyA);
    if (now == nullptr || !now->chosen()) return {a, b};
    if (now->with().isFile()) {
        b.name = fileTitle(now->with());
        if (found != nullptr) b.note = grouped(found->meshes.onlyB) + " only here";
    } else if (run.ready()) {
        b.name = differenceText(run.input().spec(), now->with().run);
        if (found != nullptr && now->other() != nullptr)
            b.note = runNote(*now->other(), found->meshes.onlyB);
    }
    return {a, b};
}

}  // namespace se::view
