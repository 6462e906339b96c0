#include "piece_input.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "exit_code.h"
#include "input.h"

namespace se::cli {
void PieceArguments::addTo(CLI::App& app) {
    app.add_option("--crop", crop_,
                   "Only the points in this box, X0,Y0,Z0,X1,Y1,Z1; the output has their numbers "
                   "in the file as index")
        ->type_name("BOX");
    app.add_option(
           "--thin", thin_,
           "Then only points no nearer than this to one before; lists in the file get shorter "
           "(-k: new ones)")
        ->type_name("SPACING");
}

Piece PieceArguments::piece() const {
    Piece piece;
    if (!crop_.empty()) {
        const Result<Box> crop = cropFromText(crop_);
        if (!crop)
            throw Failure(ExitCode::Usage,
                          fmt::format("--crop {}: {}", crop_, crop.error().message));
        piece.crop = crop.value();
    }
    if (thin_) {
        if (!(*thin_ > 0.0) || !std::isfinite(*thin_))
            throw Failure(ExitCode::Usage, "--thin: must be greater than 0");
        piece.thin = *thin_;
    }
    return piece;
}

InputPiece readPiece(const std::string& input, const Piece& piece, const ByteLimit& limit) {
    InputPiece read{readInput(input, limit), {piece, 0, 0}};
    read.points.inFile = read.file.position.size();
    Result<PointFile> cut = cutPiece(std::move(read.file), piece, nameOfInput(input));
    if (!cut) throw Failure(ExitCode::Usage, "--crop: " + cut.error().message);
    read.file = std::move(cut.value());
    read.points.kept = read.file.position.size();
    return read;
}

}  // namespace se::cli
