#include "mesh_form.h"

#include "file_browser_state.h"
#include "run/strings.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

std::string countText(std::size_t count, const char* one, const char* many) {
    return grouped(count) + " " + (count == 1 ? one : many);
}

}  // namespace

void MeshForm::open() {
    ask = MeshAsk::None;
    complaint.clear();
    note.clear();
    question.clear();
}

bool namesMeshFormat(const fs::path& path) {
    return !lowerExtension(path).empty() && meshFormatOf(path) != nullptr;
}

void MeshForm::followName(const std::string& name) {
    if (!namesMeshFormat(name)) return;
    format = static_cast<std::size_t>(meshFormatOf(name) - meshFormats().data());
}

void MeshForm::choose(std::size_t place, std::string& name) {
    format = place;
    if (namesMeshFormat(name)) {
        name = fs::path(name).replace_extension(meshFormats()[format].extension).string();
    }
}

std::string MeshForm::withFormat(const std::string& typed) const {
    if (namesMeshFormat(typed)) return typed;
    return withExtension(typed, meshFormats()[format].extension).string();
}

std::string sizeText(const MeshSize& size, bool usedOnly) {
    std::string text = countText(size.triangles, "triangle", "triangles") + ", ";
    if (!usedOnly || size.usedPoints == size.points)
        return text + countText(size.points, "point", "points");
    return text + grouped(size.usedPoints) + " of " + countText(size.points, "point", "points");
}

std::string savedText(const SavedMesh& saved) {
    std::string text = "Saved " + countText(saved.triangles, "triangle", "triangles") + " and " +
                       countText(saved.points, "point", "points") + " to " + saved.target.path +
                       ".";
    if (lowerExtension(saved.target.path) == ".stl")
        text = "Saved " + countText(saved.triangles, "triangle", "triangles") + " to " +
               saved.target.path + ".";
    if (saved.shift) {
        text += " Positions are relative to " + shiftText(*saved.shift) +
                ": add this offset to get the input coordinates.";
    }
    if (saved.capped) text += " The run was stopped by the rule cap: the mesh is incomplete.";
    return text;
}

std::string replaceText(const std::string& path, const std::string& source) {
    std::error_code error;
    const std::string name = fs::path(path).filename().string();
    const bool input = fs::equivalent(path, source, error) && !error;
    return name + (input ? " is the input itself. Replace the points by the mesh?"
                         : " exists already. Replace it?");
}

}  // namespace se::view
