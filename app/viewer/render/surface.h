/// Mesh and points of the input, as uploaded: what changes little from step to step. Drawn block by
/// block, so that a small part of the picture costs little.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "gl_objects.h"
#include "run/model.h"
#include "scene/draw_list.h"
#include "scene/screen_rect.h"

namespace se::view {

/// The part of a picture to draw, and sizes in it.
struct SurfaceView {
    CameraMatrices camera;
    glm::ivec2 size{1};
    PixelRect rect;     ///< The part.
    float em = 16.0F;   ///< Pixels.
    float dots = 8.0F;  ///< Distance of the points, in pixels.
    Color background;
    glm::ivec2 corner{0};  ///< Of a part of a larger picture: its place there.
    friend bool operator==(const SurfaceView&, const SurfaceView&) = default;
};

/// Where surfaces and points of a list differ from those of the list before.
struct SurfaceChanges {
    Bounds mesh;
    Bounds points;
};

class Surface {
  public:
    /// Call with a current OpenGL context.
    explicit Surface(Shaders& shaders);

    /// Uploads positions and normals. Discards all triangles.
    void setModel(const Model& model);
    /// Uploads the new place of one point, and the corners there of the uploaded triangles, which
    /// are the first of `triangles`.
    void movePoint(const Model& model, Index point, std::span<const Triangle> triangles);
    /// Uploads the triangles after those that are uploaded already.
    void setTriangles(const Model& model, std::span<const Triangle> triangles);
    /// Uploads the triangles that differ from the uploaded repaired mesh; null is allowed.
    void setRepaired(const Model& model, std::shared_ptr<const std::vector<Triangle>> triangles);
    /// Uploads the parts of the list that are not uploaded already.
    void setTinted(const Model& model, const DrawList& list);

    /// Where the list differs from the one before.
    SurfaceChanges takeChanges(const DrawList& list);

    /// Draws triangles, and points that are too close together for shapes. Opaque.
    void drawSolid(const DrawList& list, const SurfaceView& view);
    /// Draws the triangles that hide the decision, faintly, over the others: drawSolid() leaves
    /// them out. Needs depth and blending.
    void drawGhosts(const DrawList& list, SurfaceView view);
    /// Draws the points with their shapes, over the shaded surfaces.
    void drawShapes(const DrawList& list, const SurfaceView& view);

    /// Draws transparent shapes, unlit.
    void drawSheets(const std::vector<Sheet>& sheets, const CameraMatrices& camera);

    float spacing() const { return spacing_; }

  private:
    void useMesh(const DrawList& list, const SurfaceView& view);
    void drawFinished(const DrawList& list, const SurfaceView& view);
    std::size_t meshCount(const DrawList& list) const;
    void drawStretches(const DrawList& list, const SurfaceView& view);
    void drawTinted(const DrawList& list);
    void drawFaces(const std::vector<Face>& faces);
    void drawPoints(Shader& shader, const DrawList& list, const SurfaceView& view);
    Bounds uploadStyles(const BlockList<std::uint8_t>& styles);

    Shaders& shaders_;
    Batch cloud_;
    Batch mesh_;
    Batch repaired_;
    std::array<Batch, 2> tinted_;
    Batch faces_;
    std::vector<glm::vec3> places_;
    BlockBounds cloudBounds_;
    BlockBounds meshBounds_;
    BlockBounds repairedBounds_;
    SurfaceChanges changed_;  ///< By uploads, since the last list.
    MeshLooks looks_;
    bool repairedShown_ = false;
    std::array<PointStyle, CloudStyles::kCount> pointLooks_{};
    bool pointsShown_ = false;
    std::size_t drawnTriangles_ = 0;
    std::vector<Face> drawnFaces_;
    glm::vec4 ghost_{0.0F};  ///< Sphere of the decision whose cover is faint; radius 0: none.
    BlockList<std::uint8_t> uploadedStyles_;
    std::shared_ptr<const std::vector<Triangle>> uploadedRepaired_;
    std::array<std::shared_ptr<const std::vector<Triangle>>, 2> uploadedTinted_;
    std::size_t meshTriangles_ = 0;
    float spacing_ = 0.05F;
};

/// A color for a shader.
inline glm::vec4 colorVector(const Color& c) { return {c.r, c.g, c.b, c.a}; }

/// Sets the camera of a shader. `bias`: view units by which it moves points toward the eye.
void useCamera(Shader& shader, const CameraMatrices& camera, float bias);

}  // namespace se::view
