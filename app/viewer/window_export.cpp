#include "window_export.h"

#include <utility>

#include "document/document.h"
#include "document/link.h"
#include "document/ui_state.h"
#include "export_run.h"
#include "lesson/lesson_frames.h"

namespace se::view {

namespace {

bool isExportOpen(const UiState& ui) { return ui.fileBrowser && ui.browser == BrowserTask::Export; }

}  // namespace

WindowExport::WindowExport(CommandContext& context) : c_(context) {}

WindowExport::~WindowExport() = default;

void WindowExport::advance() {
    ExportForm& form = c_.ui.exported;
    if (form.working && !run_) {
        form.working = c_.session.ready();
        if (form.working) begin();
    }
    if (!run_) return;
    // A closed dialog cancels as its button does.
    if (!form.working || !isExportOpen(c_.ui)) {
        form.complaint = "Cancelled.";
        c_.session.messages().say("The export was cancelled.");
        return end();
    }
    run_->advance(false);
    form.made = run_->made();
    form.total = run_->total();
    if (!run_->done()) return;
    if (const auto& failure = run_->failure()) {
        form.complaint = failure->message;
    } else {
        c_.ui.fileBrowser = false;
        c_.session.messages().say(run_->doneText());
    }
    end();
}

/// Begins with the input, position, camera and layers of the window, or with the open lesson.
void WindowExport::begin() {
    ExportForm& form = c_.ui.exported;
    const Session& session = c_.session;
    const LessonWalk& walk = c_.ui.lesson.walk;
    const std::string address = session.event() != nullptr ? toString(session.address()) : "";
    Result<ExportOrder> order = form.order(
        address, walk.isOpen()
                     ? std::make_shared<const LessonFile>(LessonFile{walk.lesson(), walk.folder()})
                     : nullptr);
    form.complaint = order ? "" : order.error().message;
    form.working = order.ok();
    if (!order) return;
    ViewSettings settings = c_.ui.settings;
    Options options;
    options.noConfig = true;
    if (order.value().lesson) {
        settings.layers = layersWithout(settings.layers, walk.shownStep());
    } else {
        options.session = captureSession(c_);
        options.session->with = {};
        options.session->alert.clear();
        options.input = options.session->input;
    }
    options.exported = std::move(order.value());
    options.exported->viewer = webAddress();
    settings.width = pictureSize(form.size)->x;
    settings.height = pictureSize(form.size)->y;
    settings.uiScale = 0.0;
    run_ = std::make_unique<ExportRun>(options, settings);
    form.made = form.total = 0;
}

void WindowExport::end() {
    run_.reset();
    c_.ui.exported.working = false;
}

}  // namespace se::view
