/// Draws what the session shows into the texture of the view; only what changed is made anew.
#pragma once

#include <filesystem>
#include <memory>

#include "commands/commands.h"
#include "layers/layer.h"
#include "render/renderer.h"
#include "sampling.h"
#include "scene/difference.h"
#include "scene/motion.h"

namespace se::view {

class ScenePainter {
  public:
    /// Requires a current OpenGL context. An empty folder: the shaders that are built in.
    Status start(const std::filesystem::path& shaders);

    /// Uploads what is new and makes the list of what is to be drawn, if something changed since
    /// the last time. On paper, what only passes by is there to be seen. `look`: what another mesh
    /// has not is colored; null: nothing is.
    void fill(CommandContext& context, bool onPaper, const DifferenceLook* look = nullptr);
    /// A mesh that lies there finished, as it is compared with a run.
    void fillStill(const std::shared_ptr<const Model>& model,
                   const std::vector<Triangle>& triangles, const ViewSettings& settings,
                   const DifferenceLook* look);
    /// The same for new points, until fill() is called again.
    void fillParticles(Growing& growing, Theme theme);
    /// Draws the list, if it, the camera or the size changed since the last time.
    void draw(const CommandContext& context, glm::ivec2 size, float em);

    const DrawList& list() const { return particles_ ? particleList_ : drawList_; }
    unsigned texture() const { return renderer_->texture(); }
    /// Something in the picture moves by itself.
    bool moving() const { return motion_.moving(); }
    /// The list was made for a picture that is kept.
    bool onPaper() const { return filled_.moment.kind == Moment::Kind::Paper; }

  private:
    /// What the list is made from, besides what the camera sees.
    struct Filled {
        std::uint32_t revision = 0;
        LayerSwitches layers;
        Theme theme = Theme::Dark;
        MeshColoring mesh;
        Moment moment;
        std::size_t shapes = 0;        ///< Components that were known.
        std::uint32_t tint = 0;        ///< Of the points, see LayerInput.
        std::size_t noticed = 0;       ///< Failures of this event that were known.
        std::uint32_t difference = 0;  ///< Revision of the look; 0: none.
        friend bool operator==(const Filled&, const Filled&) = default;
    };
    struct Drawn {
        std::uint32_t revision = 0;
        std::uint32_t generation = 0;
        unsigned camera = 0;
        glm::ivec2 size{0};
        LayerSwitches layers;
        Theme theme = Theme::Dark;
        float em = 0.0F;
        unsigned fills = 0;
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };

    void upload(const Session& session);
    MeshColoring coloringOf(const Session& session, MeshStyle style);
    const Moment& lookAtMoment(const CommandContext& context, bool onPaper);

    std::unique_ptr<Renderer> renderer_;
    DrawList drawList_;
    MendedComponents mendedComponents_;
    Motion motion_;
    Filled filled_;
    Drawn drawn_;
    LayerSwitches shownLayers_;  ///< At the event that the picture shows.
    unsigned fills_ = 0;         ///< How often the list was made.
    bool particles_ = false;     ///< New points are in sight.
    DrawList particleList_;
    std::uint32_t filledParticles_ = 0;  ///< Revision of those in the list.
    Theme particleTheme_ = Theme::Dark;
    const Model* uploaded_ = nullptr;  ///< Only compared.
    std::uint32_t uploadedGeneration_ = 0;
    std::shared_ptr<const Model> model_;  ///< What is in sight.
    std::shared_ptr<const Model> still_;  ///< Of the mesh that was uploaded; null: a run was.
    const void* uploadedStill_ = nullptr;
};

}  // namespace se::view
