/// Feeds arbitrary bytes to the readers of lessons and results: no crash, each fault has a message,
/// and what is complete has valid values. As readers_fuzz.cpp a plain program unless
/// SPIRALING_EDGE_LIBFUZZER is defined.
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz.h"
#include "teach/lesson.h"
#include "teach/lesson_read.h"
#include "teach/lesson_text.h"
#include "teach/result.h"

namespace {

void checkReading(const se::teach::LessonReading& reading) {
    for (const se::teach::LessonFault& fault : reading.faults)
        demand(!fault.message.empty(), "a fault without a message");
    if (!reading.ok()) return;
    demand(!reading.lesson.steps.empty(), "no steps");
    for (std::size_t i = 0; i < reading.lesson.steps.size(); ++i) {
        const se::teach::StepSetting setting = se::teach::settingOf(reading.lesson, i);
        demand(!setting.input.empty() && !setting.at.empty(), "a step without a position");
        demand(se::teach::runSpec(setting).ok(), "a run that is not valid");
        se::teach::plainTextOf(se::teach::textBlocks(reading.lesson.steps[i].text));
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    checkReading(se::teach::readLesson(bytes, "input"));
    const auto result = se::teach::resultFromJson(bytes, "input");
    demand(result.ok() || !result.error().message.empty(), "an error without a message");
    if (!result.ok()) return 0;
    const std::string json = se::teach::resultJson(result.value());
    const auto again = se::teach::resultFromJson(json, "written");
    demand(again.ok() && se::teach::resultJson(again.value()) == json, "another result");
    return 0;
}
