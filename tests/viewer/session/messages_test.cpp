#include <doctest/doctest.h>

#include "open_session.h"

using namespace se;
using namespace se::view;
using test::OpenSession;

TEST_CASE("A notice goes away after a while, the message is kept until the next move") {
    using namespace std::chrono_literals;
    OpenSession open;
    open.session.messages().say("Saved.");
    const auto now = Messages::Clock::now();
    CHECK(open.session.messages().notice(now) == "Saved.");
    CHECK(open.session.messages().notice(now + 4s).empty());
    CHECK(open.session.messages().last() == "Saved.");
    open.session.messages().say(std::string(200, 'x'));
    CHECK_FALSE(open.session.messages().notice(Messages::Clock::now() + 4s).empty());
    open.session.moves().stepEvent(1);
    CHECK(open.session.messages().notice().empty());
}
