#include "piece_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "exit_code.h"
#include "input.h"
#include "options.h"
#include "output/sentences.h"
#include "spiraling_edge/points/wall_types.h"

namespace se::cli {
namespace {

Box cropFromText(const std::string& text) {
    const std::optional<SixNumbers> numbers = sixNumbersFromText(text);
    if (!numbers) {
        throw Failure(ExitCode::Usage,
                      fmt::format("--crop {}: expected six numbers separated by commas: "
                                  "X0,Y0,Z0,X1,Y1,Z1",
                                  text));
    }
    Box box(numbers->first);
    box.high = numbers->second;
    for (int i = 0; i < 3; ++i) {
        if (box.low[i] <= box.high[i]) continue;
        throw Failure(ExitCode::Usage,
                      fmt::format("--crop {0}: expected the lower corner first; {1}0 = {2} is "
                                  "above {1}1 = {3}",
                                  text, "XYZ"[i], box.low[i], box.high[i]));
    }
    return box;
}

/// "(0, -1, 2.5)", with as many digits as the file has.
std::string cornerText(const Vec3& x, ScalarType type) {
    if (type == ScalarType::Double) return fmt::format("({}, {}, {})", x.x, x.y, x.z);
    const glm::vec3 rounded(x);
    return fmt::format("({}, {}, {})", rounded.x, rounded.y, rounded.z);
}

/// Message for a box without points, with the box of all points.
std::string emptyBoxText(const std::string& input, const PointFile& file) {
    const WallBox bounds = boxAround(file.position);
    const std::string count = counted(file.position.size(), "point");
    const auto finite = std::find_if(file.position.begin(), file.position.end(), isFinite);
    if (finite == file.position.end())
        return fmt::format("{}: the position of none of its {} is finite", input, count);
    return fmt::format(
        "--crop: the box holds 0 of the {} of {}, which lie between {} and {}; give a box that "
        "meets these bounds",
        count, input, cornerText(bounds.low, file.positionType),
        cornerText(bounds.high, file.positionType));
}

}  // namespace

void PieceArguments::addTo(CLI::App& app) {
    app.add_option("--crop", crop_,
                   "Only the points in this box, X0,Y0,Z0,X1,Y1,Z1; the output has their numbers "
                   "in the file as index")
        ->type_name("BOX");
    app.add_option("--thin", thin_,
                   "Then only points not nearer than this to one kept before, in the order of the "
                   "file")
        ->type_name("SPACING");
}

Piece PieceArguments::piece() const {
    Piece piece;
    if (!crop_.empty()) piece.crop = cropFromText(crop_);
    if (thin_) {
        if (!(*thin_ > 0.0) || !std::isfinite(*thin_))
            throw Failure(ExitCode::Usage, "--thin: must be greater than 0");
        piece.thin = *thin_;
    }
    return piece;
}

InputPiece readPiece(const std::string& input, const Piece& piece) {
    InputPiece read{readInput(input), {piece, 0, 0}};
    PointFile& file = read.file;
    read.points.inFile = file.position.size();
    if (piece.crop && read.points.inFile > 0) {
        // Not after the cut, since the message has the bounds of the file.
        const std::vector<bool> keep = pointsIn(file.position, {piece.crop, 0.0});
        if (std::find(keep.begin(), keep.end(), true) == keep.end())
            throw Failure(ExitCode::Usage, emptyBoxText(nameOfInput(input), file));
    }
    file = pieceOf(std::move(file), piece);
    read.points.kept = file.position.size();
    return read;
}

}  // namespace se::cli
