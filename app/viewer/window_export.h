/// The export of the window: connects the dialog, the open run and the work.
#pragma once

#include <memory>

#include "document/context.h"

namespace se::view {

class ExportRun;

class WindowExport {
  public:
    explicit WindowExport(CommandContext& context);
    ~WindowExport();
    WindowExport(const WindowExport&) = delete;
    WindowExport& operator=(const WindowExport&) = delete;

    /// Begins, continues or ends the work as the dialog says. Once per frame of the window, with
    /// its OpenGL context.
    void advance();
    bool busy() const { return run_ != nullptr; }

  private:
    void begin();
    void end();

    CommandContext& c_;
    std::unique_ptr<ExportRun> run_;
};

}  // namespace se::view
