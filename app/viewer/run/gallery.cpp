#include "gallery.h"

#include <algorithm>

#include "model.h"

namespace se::view {

const FailureScene* galleryScene(std::string_view idOrSource) {
    if (isScene(idOrSource)) idOrSource.remove_prefix(kScenePrefix.size());
    const auto all = failureScenes();
    const auto found = std::find_if(all.begin(), all.end(), [&](const FailureScene& each) {
        return each.scene.id == idOrSource;
    });
    return found == all.end() ? nullptr : &*found;
}

std::string_view openingAddress(std::string_view source) {
    return isScene(source) ? addressOfScene(source.substr(kScenePrefix.size())) : "";
}

}  // namespace se::view
