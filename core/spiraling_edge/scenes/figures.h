/// The figures of the paper as a table: what to open, where to look, what the points are called,
/// what has to be seen there, and what goes wrong without the rule. why/figure_check.h checks it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/points/point_name.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se {

/// A decision that a figure shows.
struct FigureExpectation {
    std::string_view address;  ///< "9.sphere.2"
    /// The points that the decision is about, by their names: the tested or changed point, or the
    /// corners of a triangle.
    std::string_view points;
    /// The verdict of a test in the words of verdictText(), or of what is done: outcomeText() in
    /// why/figure_check.h.
    std::string_view outcome;
};

/// A rule of ruleSettings(), and the value that stands for its absence.
struct FigureRule {
    std::string_view name;
    double value = 0.0;
};

/// Points and triangles of a row of the paper's Table 1.
struct FigureCounts {
    std::size_t points = 0;
    std::size_t triangles = 0;
};

/// One figure.
struct Figure {
    int number = 0;
    /// Title, caption in our words (`watch`), points, given start and address of the decision. Of a
    /// figure of the paper's results (21 to 25), the title and the caption alone.
    Scene scene;
    Vec3 view{0.0, 0.0, 1.0};     ///< Direction from which it is seen: from its points to the eye.
    std::string_view names = {};  ///< Of points, each after its number: "15 p 20 first".
    std::span<const FigureExpectation> expectations = {};
    FigureRule rule = {};           ///< The rule that it is about.
    std::string_view absence = {};  ///< The effect of its absence,
    /// ... and the decisions that show it; an empty outcome: there is no such decision.
    std::span<const FigureExpectation> without = {};
    /// A class of faults that the mesh has without the rule, and has not with it.
    std::optional<FaultKind> fault = {};
    FigureCounts counts = {};  ///< Of a figure of the results.
    /// Of a figure of the results: the input as the viewer opens it, "sample:hydrogen,n=1516";
    /// empty: it needs a volume that is not part of this program.
    std::string_view sample = {};
    std::string_view volume = {};  ///< File of that volume, "lobster.nhdr".

    /// True if its points are built in.
    bool hasScene() const { return scene.build != nullptr; }
    std::vector<PointName> pointNames() const;
};

/// The figures of the paper, 1 to 25, in their order.
std::span<const Figure> figures();
/// The figure of that number; null if there is none.
const Figure* findFigure(int number);
/// The figure with the scene of that id ("figure-6"), for its names and its view; null if there is
/// none.
const Figure* figureOfScene(std::string_view id);
/// The input in the words of every program: "scene:figure-6", "sample:hydrogen,n=1516"; empty if it
/// needs a volume.
std::string sourceOf(const Figure& figure);

}  // namespace se
