/// A piece of an input: the options that choose it, and its reading.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/prepare/piece.h"

namespace se::cli {

/// Options for a piece of the input: --crop, --thin.
class PieceArguments {
  public:
    void addTo(CLI::App& app);
    /// Throws Failure if the box or the spacing is malformed.
    Piece piece() const;

  private:
    std::string crop_;
    std::optional<double> thin_;
};

/// Number of points that the options for a piece kept.
struct KeptPoints {
    Piece piece;
    std::size_t kept = 0;
    std::size_t inFile = 0;
};

/// The points read from an input, and their number.
struct InputPiece {
    PointFile file;
    KeptPoints points;
};

/// Reads the piece. Throws Failure(Input) if the input is missing or malformed, Failure(Usage) if
/// the box holds none of its points.
InputPiece readPiece(const std::string& input, const Piece& piece, const ByteLimit& limit);

}  // namespace se::cli
