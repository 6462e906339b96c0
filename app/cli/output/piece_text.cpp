#include "piece_text.h"

#include <fmt/format.h>

#include "sentences.h"

namespace se::cli {

using Json = nlohmann::ordered_json;

std::string keptSentence(const KeptPoints& points) {
    const Piece& piece = points.piece;
    if (piece.isWhole()) return {};
    std::string how;
    if (piece.crop) appendPart(how, "crop");
    if (piece.thin > 0.0) appendPart(how, fmt::format("thin {}", piece.thin));
    return fmt::format("{} of {}: {}", points.kept, counted(points.inFile, "point"), how);
}

Json keptJson(const KeptPoints& points) {
    const Piece& piece = points.piece;
    if (piece.isWhole()) return {};
    Json json = {{"crop", Json()}, {"thin", Json()}};
    if (piece.crop) {
        const Vec3& low = piece.crop->low;
        const Vec3& high = piece.crop->high;
        json["crop"] = {low.x, low.y, low.z, high.x, high.y, high.z};
    }
    if (piece.thin > 0.0) json["thin"] = piece.thin;
    json["kept"] = points.kept;
    json["points_in_file"] = points.inFile;
    return json;
}

}  // namespace se::cli
