/// When the alerts of a run are known: the one that was asked for, that a session looked at, or the
/// first. Knows neither window nor OpenGL.
#pragma once

#include <string>

#include "document.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

class Alerting {
  public:
    Alerting(CommandContext& context, Filing& filing) : c_(context), filing_(filing) {}

    /// What the command line asks for. A picture without a person opens where it was told to.
    void begin(const Options& options);
    /// Once the alerts are known: goes where one is to look.
    void poll();
    /// True once, if the input has just opened on its first alert.
    bool takeOpened() { return std::exchange(opened_, false); }
    /// Why the alert of the command line does not exist, if so.
    const Status& status() const { return status_; }

  private:
    void chooseOfGallery();
    void showAsked();

    CommandContext& c_;
    Filing& filing_;
    std::string asked_;   ///< By the command line, until it was shown.
    std::string source_;  ///< The input whose alerts were seen last.
    bool person_ = true;  ///< Somebody looks on.
    bool opened_ = false;
    Status status_ = success();
};

}  // namespace se::view
