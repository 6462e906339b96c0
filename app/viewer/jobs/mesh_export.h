/// The mesh at the end of the run with its points, and its export: each in a thread of its own.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "runner.h"

namespace se::view {

/// Destination of a mesh, and the choice of its points.
struct MeshTarget {
    std::string path;          ///< Its extension names the format (core's write_mesh.h).
    bool usedOnly = false;     ///< Without the points that are in no triangle.
    bool faultFields = false;  ///< With core's setFaultFields(), where the format holds columns.

    bool writesFaultFields() const;
};

/// The mesh at the end of a run, and the points that it is written with.
struct FinishedMesh {
    std::shared_ptr<const PointFile> points;  ///< Those of the input, with what was derived.
    std::shared_ptr<const std::vector<Triangle>> triangles;
    std::size_t usedPoints = 0;
    bool capped = false;  ///< Stopped at more triangles than a surface can have (rule `cap`).

    /// Number of points that are written.
    std::size_t pointsFor(const MeshTarget& target) const {
        return target.usedOnly ? usedPoints : points->position.size();
    }
};

/// A file that was written.
struct SavedMesh {
    MeshTarget target;
    std::size_t triangles = 0;
    std::size_t points = 0;
    bool capped = false;
    /// The offset that positions in the file are relative to, see shiftOf().
    std::optional<Vec3> shift = std::nullopt;
};

class MeshExport {
  public:
    /// Prepares the mesh at the end of the run of `model` once there is that end, unless it is
    /// ready or in progress; to be called in every frame. The mesh of another run is discarded, and
    /// with it a pending write. `input` is the file that prepare() took.
    void make(std::shared_ptr<const Model> model, std::shared_ptr<const PointFile> input,
              std::shared_ptr<const RunEnd> end);
    /// Discards the mesh, and a pending write. A write in progress completes.
    void discard();
    /// Writes a file as soon as the mesh is ready. Ignored while another one is written.
    void save(const MeshTarget& target);
    /// Cancels save(); too late once the file is being written.
    void cancel() { order_.reset(); }
    /// Takes the results of the threads. True if there was anything new.
    bool poll();
    /// Blocks until no work is in progress.
    void waitUntilDone();

    /// Null before the mesh is made.
    const FinishedMesh* mesh() const { return mesh_.answer(); }
    bool making() const { return mesh_.busy(); }
    /// A file waits for the mesh, or is being written.
    bool saving() const { return order_.has_value() || writing(); }
    bool writing() const { return file_.busy(); }
    bool busy() const { return making() || saving(); }
    /// The outcome of save(), once.
    std::optional<Result<SavedMesh>> takeOutcome() { return std::exchange(outcome_, std::nullopt); }

  private:
    void startWriting();

    std::shared_ptr<const Model> model_;  ///< Model of the mesh; null: none.
    bool begun_ = false;                  ///< The mesh of model_ is ready or in progress.
    BackgroundQuery<FinishedMesh> mesh_;
    BackgroundQuery<SavedMesh> file_;
    std::optional<MeshTarget> order_;  ///< Waits for the mesh.
    std::optional<Result<SavedMesh>> outcome_;
};

/// The mesh that `spiraling-edge run` makes of the same input with the same options: that of the
/// end of the run, with its points.
FinishedMesh finishMesh(const Model& model, const PointFile& input,
                        const std::shared_ptr<const RunEnd>& end);
/// Writes the mesh that `model` ends with as `spiraling-edge run -o` does. Fails with a sentence
/// that names the file.
Result<SavedMesh> saveMesh(const Model& model, const FinishedMesh& mesh, const MeshTarget& target);

}  // namespace se::view
