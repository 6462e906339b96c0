/// Small lessons as text, for tests.
#pragma once

#include <string>

namespace se::teach {

/// A block fenced as `se WORD`.
inline std::string fenced(const std::string& word, const std::string& toml) {
    return "```se " + word + "\n" + toml + "\n```\n";
}

/// A lesson on Figure 8 with these steps.
inline std::string lessonWith(const std::string& steps) {
    return "# Figure 8\n\n" + fenced("lesson", "version = 1\ninput = \"scene:figure-8\"") + "\n" +
           steps;
}

/// A step with one block.
inline std::string stepWith(const std::string& word, const std::string& toml) {
    return "## A step\n\nText.\n\n" + fenced(word, toml);
}

/// The question of Figure 8 with this answer.
inline std::string figure8Question(const std::string& answer) {
    return lessonWith(stepWith("ask",
                               "kind = \"points\"\nat = \"9.limits.2\"\n"
                               "until = \"9.sphere.4\"\nanswer = " +
                                   answer + "\nwhy = \"9.sphere.2\""));
}

}  // namespace se::teach
