#include "spiraling_edge/spec/spec_fields.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "spiraling_edge/spec/session_text.h"

using namespace se;

namespace {

using Options = std::vector<std::string>;

/// A spec in which every field of the table has a value.
RunSpec full() {
    return changed({}, specChange({{"crop", "-1,0,0.5,1000,2,3"},
                                   {"thin", "0.1"},
                                   {"scale", "74310,111132,0.001"},
                                   {"left_out", "3..9,40"},
                                   {"doctor", "duplicates"},
                                   {"rules", "robust"},
                                   {"switches", "fill=off"},
                                   {"switches", "maxgap=100"},
                                   {"what_if", "137.sphere keep 812"},
                                   {"reach", "2.5"},
                                   {"symmetric", "on"},
                                   {"normals", "derived"},
                                   {"scanner", "-1,2,0.25"},
                                   {"box", "auto"},
                                   {"rim", "on"}}));
}

std::string faultOf(std::string_view key, std::string_view text) {
    RunSpec spec;
    const Status set = setField(*findSpecField(key), spec, text);
    return set ? "none" : set.error().message;
}

}  // namespace

TEST_CASE("spec fields: what is set reads back as it is, from texts and from words") {
    const RunSpec spec = full();
    CHECK(changed({}, valuesOf(spec)) == spec);
    CHECK(valuesOf({}).empty());
    RunSpec typed = spec;
    typed.leftOut = {};
    typed.fixes.clear();
    Options words;
    for (const FieldValue& each : valuesOf(typed)) {
        words.emplace_back(each.field->option.substr(each.field->option.find(',') + 1));
        if (!each.field->value.empty()) words.push_back(each.text);
    }
    CHECK(changed({}, changeFromWords(words).value()) == typed);
}

TEST_CASE("spec fields: keys and options name one field each") {
    std::set<std::string_view> options;
    for (const SpecField& field : specFields()) {
        CAPTURE(field.key);
        CHECK((field.option.empty() || options.insert(field.option).second));
        CHECK((field.key.empty() || findSpecField(field.key)->key == field.key));
        CHECK_FALSE(field.expected.empty());
        // An option is explained, and has a value or stands for one.
        if (!field.option.empty()) CHECK_FALSE(field.help.empty());
        if (!field.option.empty()) CHECK(field.value.empty() != field.flag.empty());
    }
}

TEST_CASE("spec fields: a value that is not valid is an error that says what was expected") {
    CHECK(faultOf("radius", "-1") == "expected a number > 0");
    CHECK(faultOf("radius", "nan") == "expected a number > 0");
    CHECK(faultOf("neighbors", "0") == "expected a whole number from 1 to 1000000");
    CHECK(faultOf("neighbors", "1.5") == "expected a whole number from 1 to 1000000");
    CHECK(faultOf("rules", "sturdy") ==
          "no such set; the sets are paper, printed, corrected, robust");
    CHECK(faultOf("switches", "sturdy=on").starts_with("there is no rule \"sturdy\""));
    CHECK(faultOf("box", "0,0,0,1,1,0").starts_with("expected auto, or six numbers"));
    CHECK(faultOf("crop", "0,3,0,4,-1,0") ==
          "expected the lower corner first; Y0 = 3 is above Y1 = -1");
    for (const char* bad : {"", "1,2,3,4,5", "0,0,0,1,1,1,1", "0,0,0,1,1,nan", "0,0,0,1,1,x"}) {
        CAPTURE(bad);
        CHECK(faultOf("crop", bad) ==
              "expected six numbers separated by commas, the lower corner first: "
              "X0,Y0,Z0,X1,Y1,Z1");
    }
    CHECK(faultOf("crop", " -1, 0,0.5 ,1e3,2,3") == "none");
    for (const char* bad : {"", "2", "1,2", "1,1,0", "1,-1,1", "1,1,inf", "1,1,1,1"}) {
        CAPTURE(bad);
        CHECK(faultOf("scale", bad) == "expected three numbers > 0 separated by commas: X,Y,Z");
    }
    CHECK(faultOf("doctor", "sturdy") != "none");
    RunSpec spec;
    CHECK(applyChange({{findSpecField("thin"), "0"}}, spec).error().message ==
          "--thin 0: expected a number > 0");
}

TEST_CASE("spec fields: a change in words and as options of run") {
    const SpecChange change =
        specChange({{"doctor", "two_layers"}, {"rules", "robust"}, {"neighbors", "10"}});
    CHECK(wordsOf(change) == "the fix of two layers, robust rules, 10 neighbors");
    CHECK(optionsOf(change) == Options{"--rules robust", "--neighbors 10"});
    CHECK(wordsOf(SpecChange{}) == "no change");
    CHECK(
        optionsOf(specChange({{"switches", "fill=off"}, {"normals", "derived"}, {"rim", "on"}})) ==
        Options{"--rule fill=off", "--derive-normals", "--derive-rim"});
    CHECK(optionsText(full(), {SpecGroup::Reading}) ==
          " --crop=-1,0,0.5,1000,2,3 --thin 0.1 --scale-by 74310,111132,0.001");
    CHECK(optionsText(full(), {SpecGroup::Derived}) ==
          " --derive-normals --scanner=-1,2,0.25 --box auto --derive-rim");
}

TEST_CASE("spec fields: the difference of two runs names what was set, and what no longer is") {
    const RunSpec plain;
    CHECK(differenceText(plain, plain) == "the same");
    const RunSpec robust = withSet(plain, "robust");
    CHECK(differenceText(plain, robust) == "robust rules");
    CHECK(differenceText(robust, plain) == "paper rules");
    CHECK(differenceText(robust, withRule(robust, "fill", 0.0)) == "fill off");
    CHECK(differenceText(withRule(robust, "fill", 0.0), robust) == "fill on");
    const RunSpec nine = changed(plain, specChange({{"neighbors", "9"}, {"symmetric", "on"}}));
    CHECK(differenceText(plain, nine) == "9 neighbors, symmetric lists");
    CHECK(differenceText(nine, plain) == "neighbors of the input, lists not made symmetric");
    const RunSpec within = changed(plain, specChange({{"radius", "0.5"}}));
    CHECK(differenceText(nine, within) == "neighbors within 0.5, lists not made symmetric");
    CHECK(differenceText(changed(plain, specChange({{"normals", "oriented"}})),
                         changed(plain, specChange({{"normals", "derived"}}))) ==
          "normals derived");
    RunSpec many = plain;
    for (const char* rule : {"sphere", "reciprocal", "limits", "halfturn"})
        many = withRule(many, rule, 0.0);
    CHECK(differenceText(plain, many) == "4 rules differ");
}

TEST_CASE("spec fields: another run takes a set of rules instead of single rules") {
    const RunSpec spec = changed({}, specChange({{"switches", "fill=on"}, {"neighbors", "9"}}));
    const RunSpec other = otherRun(spec, specChange({{"rules", "robust"}, {"radius", "2"}}));
    CHECK(other.choices.empty());
    CHECK(other.neighbors.reach == changed({}, specChange({{"radius", "2"}})).neighbors.reach);
    CHECK(otherRun(spec, specChange({{"switches", "flip=on"}})).choices.size() == 2);
}

TEST_CASE("spec fields: words that are no options are errors that name them") {
    const auto fault = [](const Options& words) {
        const Result<SpecChange> change = changeFromWords(words);
        return change ? "none" : change.error().message;
    };
    CHECK(fault({"--sturdy"}) ==
          "--sturdy: no such option of a run's points and rules; docs/command-line.md lists them "
          "as shared options");
    CHECK(fault({"--radius"}) == "--radius: its value is missing");
    CHECK(fault({"--radius", "x"}) == "--radius x: expected a number > 0");
    CHECK(fault({"-k", "9", "--scanner=-1,0,0", "--symmetric"}) == "none");
    CHECK(fault({"-k", "9", "--radius", "1"}) == "--radius: not together with --neighbors");
    CHECK(fault({"--derive-normals", "--orient"}) ==
          "--derive-normals: not together with --orient");
    // In the order of the table, in which they are applied.
    const SpecChange sorted =
        changeFromWords(Options{"--rule", "fill=on", "--rules", "paper"}).value();
    CHECK(sorted.front().field->key == "rules");
}

TEST_CASE("spec fields: options are written in JSON by type") {
    CHECK(optionsJson({}) == "{\"rules\": \"paper\"}");
    RunSpec spec = full();
    spec.start.triangles = {{0, 2, 3}};
    CHECK(optionsJson(spec) ==
          "{\"rules\": \"robust\", \"crop\": [-1.0, 0.0, 0.5, 1000.0, 2.0, 3.0], \"thin\": 0.1, "
          "\"scale\": [74310.0, 111132.0, 0.001], "
          "\"left_out\": \"3..9,40\", \"doctor\": [\"duplicates\"], "
          "\"switches\": {\"fill\": false, \"maxgap\": 100}, "
          "\"what_if\": [\"137.sphere keep 812\"], \"reach\": 2.5, \"symmetric\": true, "
          "\"normals\": \"derived\", \"scanner\": [-1.0, 2.0, 0.25], \"box\": \"auto\", "
          "\"rim\": true, \"start\": {\"triangles\": [[0, 2, 3]]}}");
    CHECK(jsonQuoted("a\"b\\c\n") == "\"a\\\"b\\\\c\\u000a\"");
}

TEST_CASE("session text: a file whose name has a colon is no scene") {
    CHECK(sessionText({"a:b.ply", {}, "3.sphere"}).find("\"source\": \"./a:b.ply\"") !=
          std::string::npos);
    CHECK(
        sessionText({"b.ply", {}, "3.sphere", "holes:1", "Note"}).find("\"alert\": \"holes:1\"") !=
        std::string::npos);
}
