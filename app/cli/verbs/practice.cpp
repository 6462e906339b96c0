// spiraling-edge practice: a pivot to play by hand, drawn from a seed, and the grade of a try.
#include <fmt/format.h>

#include <algorithm>

#include "input.h"
#include "spiraling_edge/base/files.h"
#include "teach/practice.h"
#include "verbs.h"

namespace se::cli {
namespace {

using teach::PlayMove;
using teach::PracticeGrade;
using teach::PracticeTask;

struct PracticeArguments {
    std::uint64_t seed = 1;
    std::string answer;
    std::string result;
    bool solution = false;
    bool json = false;
    ForceOption force;

    void addTo(CLI::App& app) {
        addOption(app, "--seed", "N", seed, "Number of the task")
            ->capture_default_str()
            ->check(wholeNumber(0));
        auto* answered = addOption(app, "--answer", "FILE", answer,
                                   "Grade the moves of this file, or -: exit with 1 if one "
                                   "is wrong");
        addOutputOption(app, "--result", "TEXT", result,
                        "With --answer: write the result to this file, for lesson results")
            ->needs(answered);
        force.addTo(app);
        app.add_flag("--solution", solution, "Print the moves of the run with their decisions")
            ->excludes(answered);
        app.add_flag("--json", json, "As JSON");
    }
};

std::string_view statusText(const PracticeTask& task, Index point) {
    const auto has = [&](const std::vector<Index>& points) {
        return std::find(points.begin(), points.end(), point) != points.end();
    };
    if (has(task.done)) return "DONE";
    const bool isUsed = has(task.ring) || std::any_of(task.stack.begin(), task.stack.end(), has);
    return isUsed ? "USED" : "UNUSED";
}

std::string taskText(const PracticeTask& task) {
    const PointSet& points = *task.points;
    std::string text = fmt::format(
        "Task {}: play pivot {} of a run under the set paper.\n\n"
        "Pivot p = {} between first = {} and last = {}\n"
        "Neighbors of {}, nearest first: {}\n"
        "Edge ring from p on: {}\n",
        task.seed, task.address.pivot, task.p, task.first, task.last, task.p,
        fmt::join(points.neighbors[task.p], " "), fmt::join(task.ring, " "));
    for (const std::vector<Index>& ring : task.stack)
        text += fmt::format("Stacked edge ring: {}\n", fmt::join(ring, " "));
    text +=
        "All steps of the rings are edges of the mesh. All normals are (0, 0, 1), and z = 0, so\n"
        "counterclockwise is from +x to +y. The lesson one-pivot solves a task move by move.\n\n";
    for (Index i = 0; i < points.size(); ++i) {
        const Vec3& x = points.position[i];
        text += fmt::format("{:>3}  {:>6.3f} {:>6.3f}  {}\n", i, x.x, x.y, statusText(task, i));
    }
    text += "\nWrite the moves into a file, one a line, in this order:\n";
    for (const teach::MoveRow& row : teach::moveTable())
        text += fmt::format("  {:<6}  {}\n", row.name, row.help);
    text += fmt::format(
        "One `keep` or `remove` for each neighbor between first and last that is not DONE, by\n"
        "increasing angle from first; none for points that start or end move to. A point is\n"
        "written by its number, p, first and last by their names, too. For example\n"
        "  start 4\n  keep 7\n  remove 2\n  fan first 4 7 last\n  next last\n"
        "  spiraling-edge practice --seed {} --answer FILE\n",
        task.seed);
    return text;
}

Json taskJson(const PracticeTask& task) {
    const PointSet& points = *task.points;
    const auto list = points.neighbors[task.p];
    return {{"seed", task.seed},
            {"rules", "paper"},
            {"address", toString(task.address)},
            {"p", task.p},
            {"first", task.first},
            {"last", task.last},
            {"neighbors", std::vector<Index>(list.begin(), list.end())},
            {"ring", task.ring},
            {"stack", task.stack},
            {"done", task.done},
            {"points", points.position},
            {"normals", points.normal}};
}

Answer solutionAnswer(const PracticeTask& task) {
    const std::vector<PointName> names = teach::practiceNames(task);
    Answer answer{"", Json::array()};
    for (const teach::RunMove& each : task.solution) {
        const std::string address = toString(each.event.address);
        const std::string_view section = stageSection(each.event.address.stage);
        answer.text +=
            fmt::format("{:<24}  # {} ({})\n", teach::moveText(each.move, names), address, section);
        answer.json.push_back(
            {{"move", teach::moveText(each.move)}, {"address", address}, {"section", section}});
    }
    return answer;
}

Answer gradeAnswer(const PracticeGrade& grade, const std::vector<PlayMove>& moves,
                   const PracticeTask& task) {
    const std::size_t wrong = grade.rightMoves;
    Answer answer{fmt::format("right: all {} moves\n", moves.size()),
                  {{"right", grade.right}, {"right_moves", wrong}}};
    if (grade.right) return answer;
    const std::string given =
        wrong < moves.size() ? teach::moveText(moves[wrong], teach::practiceNames(task)) + ": wrong"
                             : "missing";
    answer.text = fmt::format("move {}, {}\n  {} ({}, {})\n", wrong + 1, given, grade.sentence,
                              grade.address, grade.section);
    answer.json.update({{"section", grade.section},
                        {"stage", grade.stage},
                        {"address", grade.address},
                        {"sentence", grade.sentence}});
    return answer;
}

ExitCode gradeAnswerFile(const PracticeArguments& arguments, const PracticeTask& task) {
    arguments.force.require({{"--answer", arguments.answer}}, {{"--result", arguments.result}});
    const std::string path = isStandardInput(arguments.answer) ? "/dev/stdin" : arguments.answer;
    const std::string bytes = require(readBytes(path, kTextLimit), ExitCode::Input);
    const std::vector<PlayMove> moves =
        require(teach::readMoves(bytes, nameOfInput(arguments.answer), task), ExitCode::Input);
    const PracticeGrade grade = teach::gradePractice(task, moves);
    if (!arguments.result.empty()) {
        writeOutput(arguments.result, teach::resultJson(teach::practiceResult(moves, grade, task)));
    }
    print(gradeAnswer(grade, moves, task), arguments.json);
    return grade.right ? ExitCode::Good : ExitCode::CheckFailed;
}

}  // namespace

ExitCode practiceVerb(CLI::App& app, const Arguments& words) {
    PracticeArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    const PracticeTask task = teach::practiceTask(arguments.seed);
    if (!arguments.answer.empty()) return gradeAnswerFile(arguments, task);
    const Answer answer =
        arguments.solution ? solutionAnswer(task) : Answer{taskText(task), taskJson(task)};
    printText(arguments.json ? answer.json.dump() + "\n" : answer.text);
    return ExitCode::Good;
}

}  // namespace se::cli
