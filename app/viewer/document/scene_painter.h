/// Draws the session into the texture of the view; only changes are drawn again.
#pragma once

#include <memory>

#include "context.h"
#include "layers/layer.h"
#include "new_points.h"
#include "render/renderer.h"
#include "scene/difference.h"
#include "scene/motion.h"

namespace se::view {

class ScenePainter {
  public:
    /// Call with a current OpenGL context.
    void start(std::shared_ptr<Shaders> shaders);

    /// Uploads new data and makes the draw list, if something changed since
    /// the last time. In saved pictures, brief highlights are shown too. `look`: triangles that
    /// another mesh lacks are colored; null: none.
    void fill(CommandContext& context, bool onPaper, const DifferenceLook* look = nullptr);
    /// Uploads the triangles of a file again the next time.
    void forgetStill() { uploadedStill_ = nullptr; }
    /// Fills the list with a finished mesh that is compared with a run.
    void fillStill(const std::shared_ptr<const Model>& model,
                   const std::vector<Triangle>& triangles, const ViewSettings& settings,
                   const DifferenceLook* look);
    /// Fills the list with a state of a trace that is compared with `run`: without what belongs to
    /// a decision. `coming`: triangles of its fan that are not laid yet.
    void fillTrace(const CommandContext& run, const DecisionState& state,
                   const std::vector<Triangle>& triangles, std::span<const Triangle> coming,
                   const DifferenceLook* look);
    /// Fills the list with new points, until fill() is called again.
    void fillParticles(NewPoints& sampling, Theme theme);
    /// Draws the list in the view, or the part of it that a tile of the picture needs; if it, the
    /// camera or the size changed since the last time. False if not.
    bool draw(const CommandContext& context, const Rect& view, float em);
    /// The view has another size, of which there is no picture yet: there is the background.
    bool late() const { return framesToWait_ > 0; }

    const DrawList& list() const { return particles_ ? particleList_ : drawList_; }
    unsigned texture() const { return renderer_->texture(); }
    /// Something in the picture is animated.
    bool moving() const { return motion_.moving(); }
    /// The picture lacks its full finish.
    bool unfinished() const { return finish_ == Finish::Quick; }
    /// Number of animations so far.
    std::size_t motions() const { return motion_.count(); }
    /// The list was made for a saved picture.
    bool onPaper() const { return filled_.moment.kind == Moment::Kind::Paper; }

  private:
    /// Inputs of the list, besides the camera.
    struct Filled {
        std::uint32_t revision = 0;
        LayerSwitches layers;
        Theme theme = Theme::Dark;
        MeshColoring mesh;
        Moment moment;
        std::size_t shapes = 0;              ///< Number of known components.
        std::uint32_t tint = 0;              ///< Of the points, see LayerInput.
        std::size_t noticed = 0;             ///< Number of known failures of this event.
        bool finished = false;               ///< The finished mesh, without its last decision.
        bool faults = false;                 ///< Its faults are known.
        const MeshChange* change = nullptr;  ///< Only compared.
        std::uint32_t difference = 0;        ///< Revision of the look; 0: none.
        friend bool operator==(const Filled&, const Filled&) = default;
    };
    struct Drawn {
        std::uint32_t revision = 0;
        std::uint32_t generation = 0;
        unsigned camera = 0;
        glm::ivec2 size{0};
        PixelRect part;
        LayerSwitches layers;
        Color background;
        float em = 0.0F;
        unsigned fills = 0;
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };

    void upload(const Session& session);
    bool uploadStill(const std::shared_ptr<const Model>& model,
                     const std::vector<Triangle>& triangles);
    Finish finishAt(double clock, const Drawn& next);
    bool waits(glm::ivec2 pixels, int lateFrames);
    MeshColoring coloringOf(const Session& session, MeshStyle style);
    const Moment& lookAtMoment(const CommandContext& context, bool onPaper);

    std::unique_ptr<Renderer> renderer_;
    DrawList drawList_;
    RepairedComponents repairedComponents_;
    Motion motion_;
    Filled filled_;
    Drawn drawn_;
    Finish finish_ = Finish::Full;
    glm::ivec2 pixels_{0};       ///< Size of the picture.
    int framesToWait_ = 0;       ///< PictureLook::lateFrames that are left.
    double movedAt_ = 0.0;       ///< Clock at the last move of the camera.
    LayerSwitches shownLayers_;  ///< Changes at the event of the picture.
    unsigned fills_ = 0;         ///< Number of times the list was made.
    bool particles_ = false;     ///< New points are shown.
    DrawList particleList_;
    std::uint32_t filledParticles_ = 0;  ///< Revision of the points in the list.
    Theme particleTheme_ = Theme::Dark;
    const Model* uploaded_ = nullptr;  ///< Only compared, never dereferenced.
    std::uint32_t uploadedGeneration_ = 0;
    std::uint32_t uploadedDrag_ = 0;       ///< Revision of the point that is being dragged.
    std::shared_ptr<const Model> model_;   ///< Content of the list.
    std::shared_ptr<const Model> still_;   ///< The uploaded mesh; null: a run was uploaded.
    const void* uploadedStill_ = nullptr;  ///< Its triangles.
};

}  // namespace se::view
