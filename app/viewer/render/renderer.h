/// Draws a DrawList into a picture of its own, which the window then shows.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <span>

#include "gl_objects.h"
#include "line_pass.h"
#include "run/model.h"
#include "scene/camera.h"
#include "scene/draw_list.h"

namespace se::view {

class Renderer {
  public:
    /// Compiles the shaders; from `shaderFolder` unless it is empty. Call with a current OpenGL
    /// context.
    static Result<std::unique_ptr<Renderer>> create(const std::filesystem::path& shaderFolder);

    /// Uploads positions and normals. Discards all triangles.
    void setModel(const Model& model);
    /// Uploads the triangles after those that are uploaded already.
    void setTriangles(const Model& model, std::span<const Triangle> triangles);
    /// Uploads the triangles that differ from the uploaded repaired mesh; null is allowed.
    void setRepaired(const Model& model, std::shared_ptr<const std::vector<Triangle>> triangles);

    /// Uploads the parts of the list that are not uploaded already.
    void setTinted(const Model& model, const DrawList& list);

    /// Draws. Sizes follow the distance of the points on the screen within limits.
    /// `em` is the size of an em in pixels. The result is texture().
    void draw(const DrawList& list, const CameraMatrices& camera, glm::ivec2 size, float em,
              const Color& background);
    /// The last picture drawn, for ImGui::Image (upside down, as in OpenGL).
    unsigned texture() const { return target_.texture(); }

  private:
    Renderer() = default;
    Status loadShaders(const std::filesystem::path& folder);
    void describeBatches();
    void useCamera(Shader& shader, const CameraMatrices& camera, float bias);
    void setZoom(const CameraMatrices& camera);
    void drawMesh(const DrawList& list, const CameraMatrices& camera);
    void uploadStyles(const BlockList<std::uint8_t>& styles);
    void drawCloud(const DrawList& list, const CameraMatrices& camera);
    void drawLines(const DrawList& list, const CameraMatrices& camera);
    void beginGhosts(const DrawList& list);
    void endGhosts();
    void drawSheets(const DrawList& list, const CameraMatrices& camera);
    void drawSpheres(const DrawList& list, const CameraMatrices& camera);
    void drawSprites(const DrawList& list, const CameraMatrices& camera, const Color& background);
    void drawTinted(const DrawList& list);
    void drawStretches(const DrawList& list, std::size_t count);
    void drawFaces(std::span<const Face> faces);

    Shader cloudShader_;
    Shader spriteShader_;
    Shader meshShader_;
    Shader shellShader_;
    Batch cloud_;
    Batch sprites_;
    LinePass lines_;
    Batch mesh_;
    Batch repaired_;
    std::array<Batch, 2> tinted_;
    Batch faces_;
    Batch shell_;
    Target target_;
    std::size_t cloudCount_ = 0;
    BlockList<std::uint8_t> uploadedStyles_;
    std::shared_ptr<const std::vector<Triangle>> uploadedRepaired_;
    std::array<std::shared_ptr<const std::vector<Triangle>>, 2> uploadedTinted_;
    std::size_t meshTriangles_ = 0;
    std::size_t shellVertices_ = 0;
    float spacing_ = 0.05F;
    float em_ = 16.0F;
    float cloudZoom_ = 1.0F;  ///< Points shrink when they are dense on the screen.
    float markZoom_ = 1.0F;
    float dotAlpha_ = 1.0F;  ///< Dots fade where they would cover everything.
    glm::vec2 size_{1.0F};
};

}  // namespace se::view
