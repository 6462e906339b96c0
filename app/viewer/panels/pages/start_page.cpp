// The start page: recent files, and tiles of the scenes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "document/document.h"
#include "document/ui_state.h"
#include "input/key_routing.h"
#include "panels/widgets/widgets.h"
#include "run/model.h"
#include "scene_tiles.h"
#include "session/session.h"
#include "session/session_file.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

constexpr float kLeastTile = 14.5F;       ///< Width in em.
constexpr float kTilePicture = 7.4F;      ///< Height of the picture in a tile, in em.
constexpr float kLessonTile = 4.0F;       ///< Height of the tile of a lesson, in em.
constexpr std::size_t kEdgesBelow = 500;  ///< Triangles of a picture with edges.
constexpr float kSide = 19.0F;            ///< Width of the column beside the tiles, in em.

bool hasKeyboard() { return ImGui::IsItemFocused() && ImGui::GetIO().NavVisible; }

/// Frame of the item drawn last, which can be opened; stronger with the keyboard focus.
void frameItem(const PanelContext& context, float rounding) {
    const float em = context.em;
    Color color = context.palette.border;
    float width = std::max(1.0F, 0.06F * em);
    if (hasKeyboard()) {
        color = context.palette.pivot;
        width = 0.18F * em;
    } else if (ImGui::IsItemHovered()) {
        color = context.palette.accent;
        width = 0.12F * em;
    }
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        toU32(color), rounding * em, 0, width);
}

void drawPicture(const PanelContext& context, ImDrawList* list, const SceneTile& tile, ImVec2 low,
                 ImVec2 high) {
    const Palette& palette = context.palette;
    const ImVec2 middle(0.5F * (low.x + high.x), 0.5F * (low.y + high.y));
    const float scale = std::min(0.44F * (high.x - low.x) / std::max(0.01F, tile.reach.x),
                                 0.42F * (high.y - low.y) / std::max(0.01F, tile.reach.y));
    const float dot = std::max(1.0F, 0.06F * context.em);
    const auto place = [&](glm::vec2 at) {
        return ImVec2(middle.x + at.x * scale, middle.y - at.y * scale);
    };
    for (const ThumbnailDot& each : tile.dots) {
        const ImVec2 at = place(each.at);
        const float share = 0.45F + 0.55F * std::clamp(each.facing, 0.0F, 1.0F);
        const ImU32 color = toU32(mix(palette.background, palette.done, share));
        list->AddRectFilled({at.x - dot, at.y - dot}, {at.x + dot, at.y + dot}, color, dot);
    }
    for (const ThumbnailFace& each : tile.faces) {
        // Lit from the viewer; the back side is darker.
        const float light = each.facing > 0.0F ? 0.45F + 0.55F * each.facing : 0.3F;
        const Color color =
            mix(palette.background, each.failure ? palette.rejected : palette.used, light);
        const ImVec2 a = place(each.at[0]);
        const ImVec2 b = place(each.at[1]);
        const ImVec2 c = place(each.at[2]);
        list->AddTriangleFilled(a, b, c, toU32(color));
        // Where triangles are large enough to be seen.
        if (tile.faces.size() < kEdgesBelow)
            list->AddTriangle(a, b, c, toU32(palette.background.withAlpha(0.5F)));
    }
    const ImU32 failure = toU32(palette.rejected);
    // The failure shines through what is in front of it.
    for (const ThumbnailFace& each : tile.faces) {
        if (each.failure)
            list->AddTriangle(place(each.at[0]), place(each.at[1]), place(each.at[2]), failure,
                              std::max(1.0F, 0.08F * context.em));
    }
    for (const ThumbnailMark& each : tile.marks) {
        if (each.from != each.to)
            list->AddLine(place(each.from), place(each.to), failure, 0.16F * context.em);
        else
            list->AddCircleFilled(place(each.from), 0.22F * context.em, failure);
    }
}

void drawSentence(const PanelContext& context, ImDrawList* list, const SceneTile& tile, ImVec2 at,
                  float width) {
    ImGui::PushFont(context.fonts.small);
    for (const std::string& line : wrapped(std::string(tile.watch), width)) {
        list->AddText(at, toU32(context.palette.textDim), line.c_str());
        at.y += ImGui::GetTextLineHeight();
    }
    ImGui::PopFont();
}

/// Height of the tiles of scenes, from the longest sentence.
float sentenceHeight(const PanelContext& context, const StartPage& page, float width) {
    ImGui::PushFont(context.fonts.small);
    std::size_t lines = 1;
    for (const SceneTile& tile : page.tiles) {
        if (tile.minutes > 0.0) continue;
        lines = std::max(lines, wrapped(std::string(tile.watch), width).size());
    }
    const float height = static_cast<float>(lines) * ImGui::GetTextLineHeight();
    ImGui::PopFont();
    return height;
}

/// The item of a tile: a click opens it.
void offerTile(const PanelContext& context, const SceneTile& tile, ImVec2 size) {
    const std::string source = sourceOf(tile);
    if (ImGui::InvisibleButton(source.c_str(), size)) context.document().open(source);
    const bool first = &tile == &context.state<StartPage>().tiles.front();
    if (first && context.state<KeyWalk>().offer(KeyStop::Scenes)) takeKeyboard();
    const std::string name = (hasKeyboard() ? "chosen " : "tile ") + std::string(tile.id);
    nameItem(context, name,
             std::string(tile.title) + " (" + source + ")\n" + std::string(tile.watch));
}

/// Background of the picture and, beside or below it, of the text.
void drawTilePlates(const PanelContext& context, const Rect& tile, const Rect& picture) {
    const bool beside = picture.size.x < tile.size.x;
    ImDrawList* list = ImGui::GetWindowDrawList();
    fill(list, tile, context.palette.panelRaised, 0.3F * context.em);
    list->AddRectFilled(toVec2(picture.min), toVec2(picture.max()),
                        toU32(context.palette.background), 0.3F * context.em,
                        beside ? ImDrawFlags_RoundCornersLeft : ImDrawFlags_RoundCornersTop);
}

/// A tile with its picture in the upper left corner; true if any of it is in sight.
bool drawTile(const PanelContext& context, const SceneTile& tile, ImVec2 size, glm::vec2 pictured) {
    offerTile(context, tile, size);
    if (!ImGui::IsItemVisible()) return false;
    const Rect picture{lastItem().min, pictured};
    drawTilePlates(context, lastItem(), picture);
    drawPicture(context, ImGui::GetWindowDrawList(), tile, toVec2(picture.min),
                toVec2(picture.max()));
    frameItem(context, 0.3F);
    return true;
}

/// A scene: its picture above title and sentence.
void drawSceneTile(const PanelContext& context, const SceneTile& tile, ImVec2 size) {
    const float em = context.em;
    if (!drawTile(context, tile, size, {size.x, kTilePicture * em})) return;
    const Rect area = lastItem();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float room = size.x - 1.0F * em;
    const float y = area.min.y + kTilePicture * em;
    ImGui::PushFont(context.fonts.strong);
    list->AddText({area.min.x + 0.5F * em, y + 0.35F * em}, toU32(context.palette.text),
                  fitted(std::string(tile.title), room).c_str());
    ImGui::PopFont();
    drawSentence(context, list, tile, {area.min.x + 0.5F * em, y + 1.65F * em}, room);
}

/// A lesson: its picture beside title and length.
void drawLessonTile(const PanelContext& context, const SceneTile& tile, ImVec2 size) {
    const float em = context.em;
    if (!drawTile(context, tile, size, {1.3F * size.y, size.y})) return;
    const Rect area = lastItem();
    ImDrawList* list = ImGui::GetWindowDrawList();
    glm::vec2 at(area.min.x + 1.3F * size.y + 0.6F * em, area.min.y + 0.45F * em);
    ImGui::PushFont(context.fonts.strong);
    std::vector<std::string> lines =
        wrapped(std::string(tile.title), area.max().x - at.x - 0.4F * em);
    if (lines.size() > 2) lines.resize(2);
    for (const std::string& line : lines) {
        list->AddText(toVec2(at), toU32(context.palette.text), line.c_str());
        at.y += ImGui::GetTextLineHeight();
    }
    ImGui::PopFont();
    const std::string minutes = sixDigits(std::max(1.0, std::round(tile.minutes))) + " min";
    list->AddText({at.x, at.y + 0.15F * em}, toU32(context.palette.textDim), minutes.c_str());
}

/// The heading above a tile and those like it.
std::string_view partOf(const SceneTile& tile) {
    if (tile.minutes > 0.0) return "Lessons";
    if (tile.figure != nullptr) return "Figures of the paper";
    return galleryScene(tile.id) != nullptr ? "What goes wrong, and why" : "Scenes";
}

/// The tiles above a margin at the bottom.
void drawTiles(const PanelContext& context, float below) {
    const float em = context.em;
    heading(context, "Start here");
    if (!context.rects.phone) {
        ImGui::SameLine(0.0F, context.em);
        ImGui::TextDisabled(
            "A click opens a lesson, a figure of the paper at its decision, or a scene.");
    }
    StartPage& page = context.state<StartPage>();
    page.prepare();
    page.poll();
    if (ImGui::BeginChild("##tiles", {0, -below}, false, ImGuiWindowFlags_NavFlattened)) {
        const float gap = 0.7F * em;
        const float width = ImGui::GetContentRegionAvail().x;
        const int columns = std::max(1, static_cast<int>((width + gap) / (kLeastTile * em + gap)));
        const float share = (width + gap) / static_cast<float>(columns) - gap;
        const float sentence = sentenceHeight(context, page, std::floor(share) - 1.0F * em);
        const ImVec2 size(std::floor(share), std::round((kTilePicture + 2.1F) * em + sentence));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
        int column = 0;
        std::string_view part;
        for (const SceneTile& tile : page.tiles) {
            if (const std::string_view next = partOf(tile); std::exchange(part, next) != next) {
                if (column > 0) ImGui::Spacing();
                column = 0;
                heading(context, std::string(next).c_str());
            }
            if (column++ % columns != 0) ImGui::SameLine();
            if (tile.minutes > 0.0) {
                drawLessonTile(context, tile, {size.x, kLessonTile * em});
            } else {
                drawSceneTile(context, tile, size);
            }
        }
        ImGui::PopStyleVar();
    }
    ImGui::EndChild();
}

void drawDropHint(const PanelContext& context) {
    struct Part {
        ImFont* font;
        std::string text;
        Color ink;
    };
    const float em = context.em;
    const Palette& palette = context.palette;
    const Part parts[] = {
        {context.fonts.strong, "Drop a file here", palette.text},
        {context.fonts.text, "or click to choose one (" + context.key("file.open") + ")",
         palette.textDim},
        {context.fonts.small,
         listText(pointFormats(), &PointFormat::name, "") + "; " + std::string(kSessionExtension),
         palette.textDim}};
    const float width = ImGui::GetContentRegionAvail().x;
    const float margin = 0.8F * em;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList* list = ImGui::GetWindowDrawList();
    float y = low.y + margin;
    for (const Part& part : parts) {
        ImGui::PushFont(part.font);
        for (const std::string& line : wrapped(part.text, width - margin)) {
            const float extent = ImGui::CalcTextSize(line.c_str()).x;
            list->AddText({low.x + 0.5F * (width - extent), y}, toU32(part.ink), line.c_str());
            y += ImGui::GetTextLineHeight();
        }
        ImGui::PopFont();
        y += 0.2F * em;
    }
    const ImVec2 size(width, y - low.y + margin - 0.2F * em);
    if (ImGui::InvisibleButton("##drop", size)) context.run("file.open");
    if (context.state<KeyWalk>().offer(KeyStop::Files)) takeKeyboard();
    frameItem(context, 0.4F);
}

void drawNew(const PanelContext& context) {
    heading(context, "New points");
    for (const char* id : {"file.new.shape", "file.new.volume"}) {
        const Command& command = *findCommand(id);
        const std::string key = context.key(command);
        if (ImGui::Button(std::string(command.title).c_str(), {-1.0F, 0.0F})) context.run(id);
        nameItem(context, std::string(hasKeyboard() ? "chosen " : "start ") + id,
                 std::string(command.help) + (key.empty() ? "" : " (" + key + ")"));
    }
    ImGui::Spacing();
}

void drawRecentFiles(const PanelContext& context) {
    heading(context, "Recent files");
    const std::vector<std::string>& recent = context.ui().recent;
    if (recent.empty()) dimText("Files that you open are listed here.");
    const float width = ImGui::GetContentRegionAvail().x;
    std::string chosen;
    int place = 0;
    for (const std::string& path : recent) {
        const std::string label = fittedName(recentName(path), width) + "##" + path;
        if (ImGui::Selectable(label.c_str())) chosen = path;
        const std::string what = hasKeyboard() ? "chosen recent " : "recent ";
        nameItem(context, what + std::to_string(++place), path);
    }
    if (!chosen.empty()) context.document().open(chosen);
    ImGui::Spacing();
}

void drawKeys(const PanelContext& context) {
    heading(context, "Three keys");
    for (const char* id : {"step.event.next", "step.pivot.next", "help.keys"}) {
        const Command& command = *findCommand(id);
        textIn(context.fonts.mono, context.key(command));
        ImGui::SameLine(5.0F * context.em);
        ImGui::TextUnformatted(std::string(command.title).c_str());
    }
    ImGui::Spacing();
}

void drawMessage(const PanelContext& context) {
    const std::string& message = context.session().messages().last();
    if (message.empty()) return;
    wrappedText("! " + message, context.palette.rejected);
    ImGui::Spacing();
}

void drawSide(const PanelContext& context) {
    if (ImGui::BeginChild("##startSide", {0, 0}, false, ImGuiWindowFlags_NavFlattened)) {
        drawMessage(context);
        heading(context, "Bring my scan");
        drawDropHint(context);
        ImGui::Spacing();
        drawNew(context);
        drawKeys(context);
        drawRecentFiles(context);
    }
    ImGui::EndChild();
}

/// The ways to bring points in, beside the tiles.
void drawBesides(const PanelContext& context, float side) {
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.6F * context.em, 0.0F});
    if (ImGui::BeginTable("##page", 2, 0, ImGui::GetContentRegionAvail())) {
        ImGui::TableSetupColumn("side", ImGuiTableColumnFlags_WidthFixed, side);
        ImGui::TableSetupColumn("tiles", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableNextColumn();
        drawSide(context);
        ImGui::TableNextColumn();
        drawTiles(context, 0.0F);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

/// In a phone's shape the tiles come first, and nothing is said about keys and dropping.
void drawBelow(const PanelContext& context) {
    drawMessage(context);
    const float button = ImGui::GetFrameHeight();
    drawTiles(context, button + ImGui::GetStyle().ItemSpacing.y);
    if (ImGui::Button("Open a file...", {-1.0F, button})) context.run("file.open");
    nameItem(
        context, hasKeyboard() ? "chosen start file.open" : "start file.open",
        listText(pointFormats(), &PointFormat::name, "") + "; " + std::string(kSessionExtension));
    if (context.state<KeyWalk>().offer(KeyStop::Files)) takeKeyboard();
}

}  // namespace

void drawStartPage(const PanelContext& context) {
    const float em = context.em;
    const glm::vec2 screen = context.rects.window;
    const float top = std::max(context.rects.menu.max().y, ImGui::GetFrameHeight());
    const Rect area{{0.0F, top}, {screen.x, screen.y - top}};
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.2F * em, 0.9F * em});
    const bool open = beginRegion("##start", area);
    ImGui::PopStyleVar();
    if (open) {
        wrappedIn(context.fonts.large,
                  "Watch the Spiraling Edge triangulate points, decision by decision");
        ImGui::Spacing();
        context.rects.phone ? drawBelow(context)
                            : drawBesides(context, std::min(kSide * em, 0.4F * area.size.x));
    }
    ImGui::End();
}

}  // namespace se::view
