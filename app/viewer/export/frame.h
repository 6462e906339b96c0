/// One frame of an export: its pixels, its shapes and its words.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "paint/drawn_label.h"
#include "rows/pivot_dial.h"
#include "run/model.h"
#include "scene/camera.h"
#include "scene/draw_list.h"
#include "scene/picture.h"
#include "session/compare_with.h"
#include "teach/lesson_runs.h"

namespace se::view {

/// What is drawn in a frame, for formats of shapes. It refers to what it was made from.
struct FrameShapes {
    const DrawList& list;
    const DrawList* other = nullptr;  ///< The same frame in the other theme; null: not needed.
    const Model& model;
    std::span<const Triangle> triangles;  ///< Finished ones, from the first.
    CameraMatrices camera;
    glm::vec2 size{1.0F};  ///< Pixels.
    float em = 16.0F;      ///< Pixels.
    std::span<const DrawnLabel> labels{};
    glm::vec2 corner{0.0F};  ///< Upper left one of the view in the frame.
    Theme theme = Theme::Dark;
    Rect bar{};                            ///< Of `title`, in the frame.
    const ComparedTitle* title = nullptr;  ///< Of one of two views; null: there is one.
};

/// The dial of the pivot, beside the view.
struct FrameDial {
    Dial dial;
    Rect area;  ///< In the frame.
    std::span<const PointName> names;
};

/// The step of a lesson that a frame shows.
struct FrameStep {
    const teach::Lesson& lesson;
    std::size_t step = 0;  ///< From 0.
    std::vector<teach::NamedPoint> names;
    std::filesystem::path folder;               ///< Of the lesson's images.
    const teach::RightAnswer* right = nullptr;  ///< Of its question; null: none.
};

/// One frame, valid while it is added to a file.
struct ExportFrame {
    std::string address;  ///< Of the decision; empty: the start of the run.
    std::string title;    ///< Of a step of a lesson; else empty.
    std::string caption;  ///< Sentence of the decision.
    Picture pixels;       ///< Empty for formats of shapes.
    /// One view, or two that are compared; empty for formats of pixels.
    std::span<const FrameShapes> shapes{};
    const FrameDial* dial = nullptr;  ///< Null: not in the frame, or formats of pixels.
    glm::vec2 size{1.0F};             ///< Pixels, for formats of shapes.
    bool answer = false;              ///< The answer to the question of the frame before.
    const FrameStep* step = nullptr;  ///< Null: of a run.
    /// The link to the program at an address of the run; null: there are no links.
    std::function<std::string(const std::string& address)> link;
};

}  // namespace se::view
