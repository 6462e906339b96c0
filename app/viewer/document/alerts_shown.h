/// Shows the alert of the command line, that of the session, or the finished mesh with its faults,
/// once the alerts of a run are known. Independent of window and OpenGL.
#pragma once

#include <string>

#include "document.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

class AlertsShown {
  public:
    explicit AlertsShown(CommandContext& context) : c_(context) {}

    /// Takes the alert of the command line. Pictures without a user open where their options say.
    void begin(const Options& options);
    /// Once the alerts are known: goes to what to show; after a run of the same input with other
    /// rules, says what has become of the faults.
    void poll();
    /// True once, if a newly opened input opened on its finished mesh.
    bool takeOpened() { return std::exchange(opened_, false); }
    /// Error if the alert of the command line does not exist.
    const Status& status() const { return status_; }

  private:
    void chooseOfGallery();
    void fixWhenTried();
    void reportChange();
    void startTrials();
    void showAsked();

    CommandContext& c_;
    std::string asked_;        ///< By the command line, until it was shown.
    std::string source_;       ///< The input of the last known alerts.
    std::string verdict_;      ///< Of that input; empty before any was known.
    RunSpec rules_;            ///< Of the last known alerts.
    bool interactive_ = true;  ///< A user is present.
    bool opened_ = false;
    Status status_ = success();
};

}  // namespace se::view
