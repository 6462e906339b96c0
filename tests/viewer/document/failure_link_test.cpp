#include "document/link_actions.h"

#include <doctest/doctest.h>

#include <string>

#include "document/alert_actions.h"
#include "document/link.h"
#include "headless_app.h"
#include "run/packed_file.h"
#include "session/session.h"

using namespace se;
using namespace se::view;

namespace {

struct FailureApp : test::HeadlessApp {
    AlertsShown alerts{context};

    explicit FailureApp(const char* source, const char* alert) : test::HeadlessApp("failure-link") {
        openInstead(source);
        settle();
        const auto found = alertNamed(session.alerts(), alert);
        REQUIRE(found);
        session.alerts().choose(found);
    }
    void settle() {
        waitUntilDone();
        session.alerts().waitUntilDone();
        session.poll();
        alerts.poll();
    }
};

}  // namespace

TEST_CASE("A link to a failure holds the fewest points that still end in it") {
    FailureApp app("scene:noise", "lost_points");
    const std::size_t whole = app.session.model().points.size();
    actions::copyFailureLink(app.context);
    CHECK(reasonAgainstFailureLink(app.context) == "The points are being reduced.");
    app.settle();
    const std::string link = app.ui.clipboard.copied();
    CAPTURE(link);
    CHECK(link.size() < 8000);
    const Result<Options> read = optionsFromLink(link);
    REQUIRE(read.ok());
    CHECK(read.value().alert == "lost_points:1");
    CHECK(isPacked(read.value().input.source));
    CHECK(read.value().input.choices == app.session.input().spec().choices);

    FailureApp reader(read.value().input.source.c_str(), "lost_points");
    CHECK(reader.session.model().points.size() < whole / 4);
    CHECK(app.session.messages().notice() ==
          "Link copied: " + std::to_string(reader.session.model().points.size()) +
              " points still end in: lost point.");
}

TEST_CASE("Without an alert there is no link to a failure, and a reason") {
    FailureApp app("scene:noise", "lost_points");
    app.session.alerts().choose({});
    CHECK(reasonAgainstFailureLink(app.context) == "Choose an alert first.");
    actions::copyFailureLink(app.context);
    CHECK(app.session.messages().notice() == "Choose an alert first.");
    CHECK_FALSE(app.session.alerts().reduction().busy());
}

TEST_CASE("A link is to the alert that was shown when its reduction began") {
    FailureApp app("scene:noise", "lost_points");
    actions::copyFailureLink(app.context);
    app.session.alerts().choose({});
    app.settle();
    CHECK(app.ui.clipboard.copied().find("&alert=lost_points:1") != std::string::npos);
}
