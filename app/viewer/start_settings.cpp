#include "start_settings.h"

#include "application.h"

namespace se::view {

ViewSettings keptSettings(const Options& options, Theme usual) {
    if (!options.noConfig && !options.onPaper()) return readSettings(settingsPath(), usual);
    ViewSettings settings;
    settings.theme = usual;
    return settings;
}

ViewSettings settingsFor(const Options& options, ViewSettings settings) {
    if (options.size) {
        settings.width = options.size->x;
        settings.height = options.size->y;
    }
    if (options.theme) settings.theme = *options.theme;
    if (options.meshStyle) settings.meshStyle = *options.meshStyle;
    if (options.pointTint) settings.pointTint = *options.pointTint;
    if (options.uiScale > 0.0) settings.uiScale = options.uiScale;
    return settings;
}

ViewSettings settingsToKeep(const Options& options, const Application& application,
                            const ViewSettings& before) {
    ViewSettings keep = application.settings();
    const Looks& linked = application.document().linkedLooks();
    if (options.theme || keep.theme == linked.theme) keep.theme = before.theme;
    if (options.meshStyle || keep.meshStyle == linked.meshStyle) keep.meshStyle = before.meshStyle;
    if (options.pointTint || keep.pointTint == linked.pointTint) keep.pointTint = before.pointTint;
    if (options.uiScale > 0.0) keep.uiScale = before.uiScale;
    if (options.session && options.session->layers) keep.layers = before.layers;
    if (options.size) keep.width = before.width;
    if (options.size) keep.height = before.height;
    return keep;
}

}  // namespace se::view
