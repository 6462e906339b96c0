/// Links to a place in the program: what is opened, by which rules, where in the run, seen from
/// where. `BASE#name=value&name=value`: all stands after `#`, so that it reaches no server.
///
///     https://example.org/spiraling-edge/#scene=torus&goto=137.sphere.3
///
/// The names are those of linkParts(), and the keys of the fields of a run (spec_fields.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "start_options.h"

namespace se::view {

/// One row of the table of names, which links and the command line share.
struct LinkPart {
    enum class Kind : std::uint8_t {
        Input,   ///< It says what is opened: a link has one of these.
        Option,  ///< The command line has an option of that name, with the same values.
        Link,    ///< Of links alone.
    };
    std::string_view name;   ///< "scene"
    std::string_view value;  ///< Name of its value in the manual; empty: it has none.
    std::string_view help;   ///< One sentence.
    Kind kind;

    /// Puts the value into the options. Fails with a sentence.
    Status (*set)(Options& options, std::string_view text);
    /// The value that the options have, as a text that set() reads; empty: none.
    std::optional<std::string> (*text)(const Options& options);
};

/// All names but the keys of the fields of a run, in the order in which a link has them.
std::span<const LinkPart> linkParts();

/// True for a text that begins with `#`, or has one that a known name follows.
bool isLink(std::string_view text);

/// Options from a whole link, or from its part after `#`, with or without that sign. A lesson is
/// in Options::lesson, a packed session in Options::session; a file is named in input.source and is
/// not read. Fails with a sentence.
Result<Options> optionsFromLink(std::string_view text);

/// The part of a link after `#` that optionsFromLink() turns into these options again; the camera
/// has four digits. Options that no link has are left out.
std::string linkText(const Options& options);

/// File of the program as one page.
inline constexpr std::string_view kPageName = "spiraling-edge.html";

/// The address of the page that the build names; empty: none.
std::string_view webAddress();
/// Where links begin: webAddress(), or the file of the page beside the reader.
std::string_view linkBase();

}  // namespace se::view
