// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parsing of the command line: options, values and error messages.
#include "commands/options.h"

#include "ncsim/setup/job_file.h"

#include "commands/help_topics.h"
#include "commands/libraries.h"
#include "system/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace ncsim::app {
namespace {

Options options(const std::vector<std::string>& arguments) {
    auto parsed = parse_options(arguments);
    const auto* farewell = std::get_if<EarlyExit>(&parsed);
    EXPECT_FALSE(farewell) << farewell->text;
    const auto* run = std::get_if<Options>(&parsed);
    return run ? *run : Options{};
}

std::string refusal(const std::vector<std::string>& arguments) {
    auto parsed = parse_options(arguments);
    const auto* farewell = std::get_if<EarlyExit>(&parsed);
    if (!farewell) return "accepted";
    EXPECT_EQ(farewell->exit_code, kEnvironment);
    return farewell->text;
}

// Tiles are of one run if their words are equal.
TEST(Options, WordsOfAPartTellASwitchThatIsOff) {
    const auto words = [](const std::vector<std::string>& more) {
        std::vector<std::string> all{"run", "a.nc", "--stl", "a.stl"};
        all.insert(all.end(), more.begin(), more.end());
        return options(all).words;
    };
    EXPECT_NE(words({"--block-delete", "off"}), words({"--block-delete"}));
    EXPECT_EQ(words({"--block-delete", "on"}), words({"--block-delete"}));
    EXPECT_NE(words({"--block-delete", "off"}), words({}));
}

TEST(Options, ASetUpIsSelectedOnce) {
    EXPECT_NE(
        refusal({"run", "a.nc", "--job", "j.toml", "--setup", "2"}).find("and 'a.nc' another"),
        std::string::npos);
    EXPECT_NE(refusal({"diff", "a.nc", "b.nc", "--job", "j.toml", "--setup", "2"})
                  .find("expected the job alone"),
              std::string::npos);
    EXPECT_NE(refusal({"run", "a.nc", "--setup", "2"}).find("of a job file"), std::string::npos);
}

TEST(Options, RefusalsOfferOnlyWhatTheCommandAccepts) {
    const auto message = [](std::vector<std::string> words) {
        words.insert(words.end(), {"--model", "?"});
        return refusal(words);
    };
    EXPECT_EQ(message({"check", "a.nc"}), "ncsim: --model '?': expected cda\n");
    EXPECT_EQ(message({"diff", "a.nc", "b.nc"}), "ncsim: --model '?': expected cda\n");
    EXPECT_EQ(message({"measure", "a.nc"}), "ncsim: --model '?': expected cda or cda-flat\n");
    EXPECT_EQ(message({"run", "a.nc"}), "ncsim: --model '?': expected cda, cda-flat or dexel\n");
}

// Value that an option accepts, by its name or its kind of value in help.
std::string example_of(const cli::Option& option) {
    static const std::map<std::string, std::string> values{{"--dialect", "haas"},
                                                           {"--model", "cda"},
                                                           {"--units", "inch"},
                                                           {"--views", "iso"},
                                                           {"--rapid", "dog-leg"},
                                                           {"--renderer", "own"},
                                                           {"--frame", "part"},
                                                           {"--rays", "z"},
                                                           {"--report-units", "inch"},
                                                           {"--colour", "line"},
                                                           {"--job", "a.toml"},
                                                           {"--step-schema", "ap214"},
                                                           {"FILE", "a"},
                                                           {"DIR", "a"},
                                                           {"--step-surfaces", "faceted"},
                                                           {"N", "2"},
                                                           {"MM", "1"},
                                                           {"--background", "dark"},
                                                           {"--shade", "none"},
                                                           {"GB", "1"},
                                                           {"S", "1"},
                                                           {"X,Y,Z", "1,2,3"},
                                                           {"D1=R", "D1=1"},
                                                           {"WORDS", "G187"},
                                                           {"NAME=VALUE", "#500=1"},
                                                           {"STOCK", "1x2x3"},
                                                           {"TURNS", "X90"},
                                                           {"RULES", "plunge"},
                                                           {"THINGS", "holder"},
                                                           {"REASONS", "all"},
                                                           {"RULE=S", "plunge=note"},
                                                           {"VIEW", "top"},
                                                           {"WxH", "10x10"},
                                                           {"--assume-tool", "flat:D6"},
                                                           {"MARKS", "none"},
                                                           {"x=N", "x=1"},
                                                           {"TOOL", "T1=flat:D6"},
                                                           {"z=N", "z=1"},
                                                           {"I/N", "0/2"},
                                                           {"SETUP", "1"},
                                                           {"LINKS", "a"},
                                                           {"TOL", "0.1"}};
    const auto named = values.find("--" + option.long_names().front());
    const auto found = named != values.end() ? named : values.find(option.type_name());
    EXPECT_NE(found, values.end()) << option.name() << ": add a value to this table";
    return found == values.end() ? "" : found->second;
}

// Returns `shown` of the command line `words` of a command with the options of type Of.
template <class Of, class Shown>
auto shown_of(const std::vector<std::string>& words, const Shown& shown) {
    cli::App app("", "ncsim");
    Of options;
    cli::App* const command = app.add_subcommand("command", "");
    add_options(*command, options);
    app.parse(words);
    return shown(*command);
}

// Returns the options that `shown` does not depend on.
template <class Of, class Shown>
std::vector<std::string> options_without_effect_on(const Shown& shown) {
    cli::App app("", "");
    Of ignored;
    add_options(app, ignored);
    std::vector<std::string> without;
    for (const cli::Option* option : app.options()) {
        if (option->is_positional() || option->name() == "--help") continue;
        const std::string name = "--" + option->long_names().front();
        std::vector<std::string> words{"command", "a.nc"};
        if (name == "--finding") words.emplace_back("--png=a");
        if (name == "--block-volumes") words.emplace_back("--report=a");
        if (name == "--frame" || name == "--transparent") words.emplace_back("--show-machine");
        const auto before = shown_of<Of>(words, shown);
        words.push_back(option->is_flag() ? name : name + "=" + example_of(*option));
        if (shown_of<Of>(words, shown) == before) without.push_back(name);
    }
    std::ranges::sort(without);
    return without;
}

// A new option of check belongs to the key of cached verdicts, or to this list of options that
// cannot change a verdict.
TEST(Options, OfCheckAreInTheKeyOfTheCacheUnlessTheyCannotChangeAVerdict) {
    const std::vector<std::string> files{
        "--csv",     "--github",   "--html",           "--json",     "--junit",
        "--out",     "--sarif",    "--see-through",    "--shade",    "--png",
        "--finding", "--tile-out", "--write-baseline", "--exit-zero"};
    const std::vector<std::string> look_of_png{"--background", "--cut-view", "--marks",
                                               "--size",       "--view",     "--views"};
    const std::vector<std::string> division{"--cache", "--isolate", "--jobs", "--list",
                                            "--shard", "--threads", "--tile", "--watch"};
    const std::vector<std::string> limits{"--max-memory", "--max-time"};  // keep no verdict
    std::vector<std::string> all{"--no-project"};  // the key has the settings of the project
    for (const auto* some : {&files, &look_of_png, &division, &limits})
        all.insert(all.end(), some->begin(), some->end());
    std::ranges::sort(all);
    EXPECT_EQ(options_without_effect_on<CheckOptions>(settings_of), all);
}

// A new option of run belongs to the words of tiles, or to this list of options that cannot change
// what merge makes of the tiles.
TEST(Options, OfRunAreInTheWordsOfTilesUnlessTheyCannotChangeThePart) {
    std::vector<std::string> all{"--max-memory", "--max-time", "--quiet", "--threads",
                                 "--tile",       "--tile-out", "--watch"};
    // ncsim run refuses files to write with --tile.
    for (const OutputFile& file : output_files())
        all.emplace_back(file.option);
    all.emplace_back("--frames");
    std::ranges::sort(all);
    EXPECT_EQ(options_without_effect_on<Options>(words_of_tile), all);
}

TEST(Options, OfProjectsAndJobsAreOptionsOfCheck) {
    cli::App app("", "");
    CheckOptions ignored;
    add_options(app, ignored);
    for (const cli::Option* option : app.options()) {
        const std::string name = option->is_positional() ? "" : option->long_names().front();
        EXPECT_EQ(kind_of_check_option(name).has_value(), option->counts().project) << name;
    }
    for (const std::string_view name : setup::kJobOptions)
        EXPECT_TRUE(kind_of_check_option(std::string(name))) << name;
    EXPECT_FALSE(kind_of_check_option("quiet") || kind_of_check_option("json"));
    EXPECT_TRUE(kind_of_check_option("tool-table")->is_file);
    EXPECT_TRUE(kind_of_check_option("block-delete")->is_switch);
}

TEST(Options, ThatWriteJobFilesAreThoseOfCommandsThatWriteThem) {
    for (const char* command : {"check", "measure", "sheet", "explain"})
        EXPECT_NE(refusal({command, "a.nc", "--save-job", "a.toml"}).find("no option --save-job"),
                  std::string::npos)
            << command;
}

TEST(Options, OfMergeAreThoseOfRunForTiles) {
    const Command command = parse_options({"merge", "tiles", "--stl", "a.stl", "--view", "top"});
    const auto* merge = std::get_if<MergeOptions>(&command);
    ASSERT_TRUE(merge);
    EXPECT_EQ(merge->of_run, (std::vector<std::pair<std::string, std::string>>{{"stl", "a.stl"},
                                                                               {"view", "top"}}));
    EXPECT_EQ(refusal({"merge", "tiles", "--step", "a.step"}),
              "ncsim: there is no option --step; did you mean --stl?\nTry: ncsim merge --help\n");
}

TEST(Options, NumbersOutsideTheirRangeAreRefusedWithTheRange) {
    EXPECT_EQ(refusal({"run", "a.nc", "--threads", "0"}),
              "ncsim: --threads: expected 1 to 1024, not 0\nTry: ncsim run --help\n");
    EXPECT_EQ(refusal({"run", "a.nc", "--tolerance", "20"}),
              "ncsim: --tolerance: expected 0.0001 to 10 mm, not 20\nTry: ncsim run --help\n");
    EXPECT_EQ(refusal({"run", "a.nc", "--step-refine", "7"}),
              "ncsim: --step-refine: expected 0 to 6, not 7\nTry: ncsim run --help\n");
    EXPECT_EQ(refusal({"run", "a.nc", "--step-refine", "1.5"}).find("ncsim: "), 0U);
}

TEST(Options, OfAPlainRunAreTheDefaults) {
    const Options o = options({"run", "part.nc"});
    EXPECT_EQ(o.program, "part.nc");
    EXPECT_EQ(o.model, "cda");
    EXPECT_EQ(o.width, 1280U);
    EXPECT_FALSE(o.inches);
    EXPECT_TRUE(outputs_of(o).empty());
}

TEST(Options, TakeEverythingThatCanBeAskedFor) {
    const Options o = options({"run",
                               "part.nc",
                               "--png",
                               "a.png",
                               "--gltf=a.glb",
                               "--vrml",
                               "a.wrl",
                               "--stl",
                               "a.stl",
                               "--step",
                               "a.step",
                               "--report",
                               "a.json",
                               "--stats",
                               "a.csv",
                               "--xml",
                               "a.xml",
                               "--stock",
                               "10x20x30",
                               "--tool",
                               "T1=flat:D10",
                               "--tool",
                               "T2=ball:D6:L30",
                               "--assume-tool",
                               "flat:D3",
                               "--units",
                               "inch",
                               "--block-delete",
                               "--tolerance",
                               "0.01",
                               "--threads",
                               "4",
                               "--view",
                               "top",
                               "--size",
                               "640x480",
                               "--colour",
                               "depth",
                               "-q"});
    EXPECT_EQ(outputs_of(o).size(), 8U);
    EXPECT_EQ(o.model, "cda-flat") << "statistics and XML show its cells";
    EXPECT_EQ(o.stock->box.max, (Vec3{5, 10, 0}));
    EXPECT_EQ(o.tools.size(), 2U);
    EXPECT_EQ(o.assumed_tool->diameter, 3);
    EXPECT_TRUE(o.inches);
    EXPECT_TRUE(o.block_delete);
    EXPECT_EQ(o.tolerance, 0.01);
    EXPECT_EQ(o.threads, 4U);
    EXPECT_EQ(o.views, std::vector{exporter::View::Top});
    EXPECT_EQ(o.height, 480U);
    EXPECT_TRUE(o.quiet);
}

TEST(Options, SwitchesAreOnOrOff) {
    EXPECT_EQ(options({"run", "part.nc", "--block-delete=off"}).block_delete, false);
    EXPECT_EQ(options({"run", "part.nc", "--block-delete", "on"}).block_delete, true);
    const std::string text = refusal({"run", "part.nc", "--block-delete=x"});
    EXPECT_NE(text.find("--block-delete 'x': expected on or off"), std::string::npos) << text;
}

TEST(Options, MarksAreOnUnlessSomeAreNamed) {
    EXPECT_TRUE(options({"run", "part.nc", "--png", "a.png"}).marks.legend);
    const Options some = options({"run", "part.nc", "--png", "a.png", "--marks", "axes,scale"});
    EXPECT_TRUE(some.marks.axes && some.marks.scale);
    EXPECT_FALSE(some.marks.zero || some.marks.legend);
    EXPECT_FALSE(options({"run", "part.nc", "--png", "a.png", "--marks", "none"}).marks.any());
}

TEST(Options, NameViewsInTheOrderOfTheSheet) {
    const Options o = options({"run", "part.nc", "--png", "a.png", "--ply", "a.ply", "--3mf",
                               "a.3mf", "--views", "front,iso", "--background", "dark"});
    EXPECT_EQ(o.views, (std::vector{exporter::View::Front, exporter::View::Iso}));
    EXPECT_EQ(o.background, exporter::Background::Dark);
    EXPECT_EQ(outputs_of(o), (std::vector<std::string>{"a.png", "a.ply", "a.3mf"}));
}

TEST(Options, NameTheControlAndItsWords) {
    const Options o =
        options({"run", "part.nc", "--dialect", "haas", "--strict", "--allow", "G187,M198"});
    EXPECT_EQ(o.dialect, gcode::Dialect::Haas);
    EXPECT_TRUE(o.strict);
    EXPECT_EQ(o.allow, (std::vector<std::string>{"G187", "M198"}));
    EXPECT_EQ(options({"run", "part.nc"}).dialect, gcode::Dialect::Auto);
}

TEST(Options, RefuseWhatMakesNoSense) {
    const std::vector<std::vector<std::string>> table = {
        {},
        {"walk", "part.nc"},
        {"run"},
        {"run", "part.nc", "other.nc"},
        {"run", "part.nc", "--nonsense"},
        {"run", "part.nc", "--size", "0x10"},
        {"run", "part.nc", "--size", "10"},
        {"run", "part.nc", "--size", "99999x99999"},
        {"run", "part.nc", "--size", "10x10x10"},
        {"run", "part.nc", "--size", "-5x10"},
        {"run", "part.nc", "--tolerance", "0"},
        {"run", "part.nc", "--dialect", "klingon"},
        {"run", "part.nc", "--tolerance", "nan"},
        {"run", "part.nc", "--tolerance", "1e9"},
        {"run", "part.nc", "--threads", "0"},
        {"run", "part.nc", "--view", "sideways"},
        {"run", "part.nc", "--views", "iso,,top"},
        {"run", "part.nc", "--views", ""},
        {"run", "part.nc", "--view", "iso", "--views", "iso,top"},
        {"run", "part.nc", "--background", "pink"},
        {"run", "part.nc", "--simplify", "1e-9"},
        {"run", "part.nc", "--simplify", "nan"},
        {"run", "part.nc", "--step-max-faces", "0"},
        {"run", "part.nc", "--step-surfaces", "round"},
        {"run", "part.nc", "--at-line", "0"},
        {"run", "part.nc", "--every", "10"},
        {"run", "part.nc", "--gif", "a.gif", "--every", "0"},
        {"run", "part.nc", "--units", "furlong"},
        {"run", "part.nc", "--model", "voxel"},
        {"run", "part.nc", "--model", "cda", "--stats", "a.csv"},
        {"run", "part.nc", "--stock", "1x2"},
        {"run", "part.nc", "--stock", "1e12x1x1"},
        {"run", "part.nc", "--tool", "T1=flat"},
        {"run", "part.nc", "--tool", "T1=flat:D1", "--tool", "T1=flat:D2"},
    };
    for (const auto& arguments : table) {
        std::string all;
        for (const std::string& a : arguments)
            all.append(a).append(" ");
        SCOPED_TRACE(all);
        const std::string text = refusal(arguments);
        EXPECT_EQ(text.rfind("ncsim: ", 0), 0U) << text;
    }
}

TEST(Options, NameTheModelThatDoesNotVerifyAndThoseThatDo) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"check", "a.nc"}, {"diff", "a.nc", "b.nc"}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.end(), {"--model", "cda-flat"});
        const std::string text = refusal(arguments);
        EXPECT_NE(text.find("--model cda-flat"), std::string::npos) << text;
        EXPECT_NE(text.find("with cda"), std::string::npos) << text;
    }
    EXPECT_NE(refusal({"run", "a.nc", "--model", "voxel"}).find("expected cda, cda-flat or dexel"),
              std::string::npos);
}

// No value exceeds nan: with nan as tolerance, parts that differ by 600 mm³ would count as equal.
TEST(Options, RefuseWhatIsNoNumber) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"diff", "a.nc", "b.nc", "--tol"},
          {"check", "a.nc", "--design", "a.stl", "--design-tol"},
          {"run", "a.nc", "--max-time"},
          {"run", "a.nc", "--max-memory"},
          {"run", "a.nc", "--tolerance"},
          {"run", "a.nc", "--model", "dexel", "--resolution"}}) {
        for (const char* number : {"nan", "-nan", "inf", "-1", "1e999", "x", ""}) {
            std::vector<std::string> arguments = words;
            arguments.emplace_back(number);
            EXPECT_NE(refusal(arguments).find(words.back()), std::string::npos)
                << words.back() << " " << number;
        }
    }
}

// Results of rays are never exact: the error message for options that need an exact model names the
// exact models.
TEST(Options, RefuseRaysWhereOnlyAnExactModelWillDo) {
    for (const std::vector<std::string>& asked : {std::vector<std::string>{"--step", "a.step"},
                                                  {"--section", "z=-1", "--dxf", "a.dxf"},
                                                  {"--save-stock", "a.ncstock"},
                                                  {"--report", "a.json", "--block-volumes"}}) {
        std::vector<std::string> arguments{"run", "a.nc", "--model", "dexel"};
        arguments.insert(arguments.end(), asked.begin(), asked.end());
        const std::string text = refusal(arguments);
        EXPECT_NE(text.find(asked.back() == "--block-volumes" ? asked.back() : asked.front()),
                  std::string::npos)
            << text;
        EXPECT_NE(text.find("use cda or cda-flat"), std::string::npos) << text;
    }
    EXPECT_NE(refusal({"run", "a.nc", "--resolution", "0.1"}).find("--model dexel"),
              std::string::npos);
    EXPECT_FALSE(refusal({"run", "a.nc", "--model", "dexel", "--resolution", "0"}).empty());
    EXPECT_NE(refusal({"check", "a.nc", "--model", "dexel"}).find("with cda"), std::string::npos);
    EXPECT_NE(refusal({"measure", "a.nc", "--model", "dexel"}).find("use cda"), std::string::npos);
}

// For example "$MACHINE" if the variable is not set.
TEST(Options, RefuseEmptyNamesOfFiles) {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"check", "a.nc", "--machine", ""},
                                               {"check", "a.nc", "--holders", ""},
                                               {"check", "a.nc", "--cache", ""},
                                               {"check", "a.nc", "--json", ""},
                                               {"check", ""},
                                               {"run", "a.nc", "--machine", ""},
                                               {"run", "a.nc", "--job", ""},
                                               {"run", "a.nc", "--png", ""},
                                               {"merge", ""}}) {
        const Command command = parse_options(words);
        const auto* farewell = std::get_if<EarlyExit>(&command);
        ASSERT_TRUE(farewell) << words.back();
        EXPECT_EQ(farewell->exit_code, kEnvironment);
        EXPECT_NE(farewell->text.find("the name is empty"), std::string::npos) << farewell->text;
    }
    const Command command = parse_options({"check", "a.nc", "--machine="});
    EXPECT_TRUE(std::holds_alternative<EarlyExit>(command));
}

TEST(Options, AreGuessedWhereSomebodyMistypes) {
    const auto said = [](std::vector<std::string> words) {
        const Command command = parse_options(words);
        const auto* farewell = std::get_if<EarlyExit>(&command);
        return farewell ? farewell->text : "accepted";
    };
    EXPECT_EQ(said({"rnu", "a.nc"}),
              "ncsim: there is no command 'rnu'; did you mean run? (run, parse, tools, check, "
              "merge, diff, machine, measure, init, sheet, explain, rules)\nTry: ncsim --help\n");
    EXPECT_EQ(said({"run", "a.nc", "--pgn", "a.png"}),
              "ncsim: there is no option --pgn; did you mean --png?\nTry: ncsim run --help\n");
    EXPECT_EQ(said({"check", "a.nc", "--machin=m.toml"}),
              "ncsim: there is no option --machin; did you mean --machine?\nTry: ncsim check "
              "--help\n");
    EXPECT_EQ(said({"run", "a.nc", "--frobnicate"}),
              "ncsim: there is no option --frobnicate\nTry: ncsim run --help\n");
    EXPECT_EQ(said({"rnu", "--help"}), said({"rnu", "a.nc"}));
    EXPECT_EQ(said({"version"}), said({"--version"}));
    EXPECT_EQ(said({"-V"}), said({"--version"}));
    EXPECT_EQ(said({"help"}), said({"--help"}));
    EXPECT_EQ(said({"help", "check"}), said({"check", "--help"}));
}

TEST(Options, HelpExplainsCommandsAndTopics) {
    const auto answer = [](const std::vector<std::string>& words) {
        return std::get<EarlyExit>(parse_options(words));
    };
    const std::string all = answer({"help"}).text;
    for (const std::string& name : topic_names()) {
        SCOPED_TRACE(name);
        const EarlyExit page = answer({"help", name});
        EXPECT_EQ(page.exit_code, kClean);
        EXPECT_TRUE(page.text.starts_with(name + ": ")) << page.text;
        const std::string heading = page.text.substr(0, page.text.find('\n'));
        const std::string summary = heading.substr(name.size() + 2);
        EXPECT_NE(all.find("  " + name + std::string(12 - name.size(), ' ') + summary + "\n"),
                  std::string::npos);
        EXPECT_FALSE(page.text.find("\n\n\n") != std::string::npos || page.text.ends_with("\n\n"));
        std::istringstream lines(page.text);
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 100U) << line;
        // A command with the name of a topic would hide its own help.
        EXPECT_EQ(answer({name}).exit_code, kEnvironment);
    }
    EXPECT_NE(answer({"help", "tool"}).text.find("reamer, boring-bar"), std::string::npos);
    EXPECT_NE(answer({"help", "exit-codes"}).text.find("4  not proven"), std::string::npos);
    EXPECT_EQ(answer({"help", "verdict"}).exit_code, kEnvironment);
    EXPECT_EQ(answer({"help", "verdict"}).text,
              "ncsim: there is no help topic 'verdict'; did you mean verdicts?\nTry: ncsim help\n");
    EXPECT_EQ(answer({"help", "--help"}).text, all);
}

TEST(Options, VersionNamesLibrariesAndLicences) {
    const auto answer = [](const std::vector<std::string>& words) {
        return std::get<EarlyExit>(parse_options(words));
    };
    const std::string text = answer({"--version", "--verbose"}).text;
    EXPECT_TRUE(text.starts_with(answer({"--version"}).text));
    EXPECT_NE(text.find("GPL-3.0-or-later"), std::string::npos);
    EXPECT_EQ(answer({"version", "--verbose"}).text, text);
    EXPECT_EQ(answer({"--verbose", "--version"}).text, text);
    EXPECT_GE(libraries().size(), 16U);
    for (const Library& library : libraries()) {
        SCOPED_TRACE(library.name);
        EXPECT_NE(text.find("  " + library.name + " "), std::string::npos);
        EXPECT_FALSE(library.licence.empty() || library.use.empty());
        EXPECT_EQ(library.version.find_first_not_of("0123456789."), std::string::npos)
            << library.version;
        EXPECT_NE(library.version.find('.'), std::string::npos) << library.version;
    }
    EXPECT_EQ(refusal({"--verbose", "rules"}),
              "ncsim: --verbose stands with --version, or behind a command\n");
}

TEST(Options, HelpOfFilesExplainsQuiet) {
    const Command answer = parse_options({"help", "files"});
    EXPECT_NE(std::get<EarlyExit>(answer).text.find("-q prints errors"), std::string::npos);
    for (const char* command : {"run", "check", "merge", "diff", "measure", "init", "tools"}) {
        const Command help = parse_options({command, "--help"});
        EXPECT_NE(std::get<EarlyExit>(help).text.find("-q,--quiet"), std::string::npos) << command;
    }
}

TEST(Options, RefusesAnOutputWithTheEndingOfAnotherFormat) {
    const auto refused = [](const std::string& option, const std::string& path) {
        const Command command = parse_options({"run", "a.nc", option, path});
        const auto* exit = std::get_if<EarlyExit>(&command);
        return exit ? exit->text : "";
    };
    EXPECT_EQ(refused("--png", "out/a.jpg"),
              "ncsim: --png 'out/a.jpg': the ending is that of another format; 'out/a.png'\n");
    EXPECT_NE(refused("--gltf", "a.gltf"), "");
    EXPECT_NE(refused("--html", "a.png"), "");
    EXPECT_NE(refused("--stl", "a.PLY"), "");
    EXPECT_NE(refused("--svg", "a.dxf"), "");
    EXPECT_NE(refused("--gif", "a.apng"), "");
    for (const char* path : {"a.png", "a.PNG", "-", "a", "a.out", "a.jpg.tmp", "/dev/full"})
        EXPECT_EQ(refused("--png", path), "") << path;
    EXPECT_EQ(refused("--step", "a.stp"), "");
    EXPECT_EQ(refused("--vrml", "a.vrml"), "");
}

TEST(Options, HelpNamesTheExitCodesAndEndsWithAnExample) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                      {"run", "--help"},
                                                      {"parse", "--help"},
                                                      {"tools", "--help"}}) {
        auto parsed = parse_options(arguments);
        const auto& farewell = std::get<EarlyExit>(parsed);
        EXPECT_EQ(farewell.exit_code, kClean);
        EXPECT_NE(farewell.text.find("Exit codes: 0 clean; 1"), std::string::npos);
        EXPECT_NE(farewell.text.find("Example: ncsim "), std::string::npos);
    }
}

TEST(Options, HelpHasALinePerOptionThatFitsATerminal) {
    for (const char* name : {"run", "check", "parse", "tools", "diff", "measure", "merge"}) {
        SCOPED_TRACE(name);
        auto parsed = parse_options({name, "--help"});
        std::istringstream text(std::get<EarlyExit>(parsed).text);
        std::size_t lines = 0;
        std::size_t options = 0;
        bool had_wrapped_names = false;
        for (std::string line; std::getline(text, line); ++lines) {
            EXPECT_LE(line.size(), 101U) << line;  // the ellipsis has three bytes
            // Long names have a line of their own, which the description follows.
            const bool names_option = line.starts_with("  -");
            EXPECT_FALSE(had_wrapped_names && names_option) << line;
            had_wrapped_names = names_option && line.find("   ", 4) == std::string::npos;
            options += names_option ? 1 : 0;
        }
        EXPECT_GE(options, 6U);
        EXPECT_LE(lines, options + 50);
    }
    // The models that a command refuses are not offered.
    auto check = parse_options({"check", "--help"});
    EXPECT_EQ(std::get<EarlyExit>(check).text.find("dexel"), std::string::npos);
}

TEST(ProgressBar, TellsShareAndTimeLeft) {
    EXPECT_EQ(progress_bar(0, 10, 0.0), "[>                                       ]   0 %");
    EXPECT_EQ(progress_bar(5, 10, 0.5), "[====================>                   ]  50 %");
    EXPECT_EQ(progress_bar(5, 10, 61.0),
              "[====================>                   ]  50 %  ETA 1:01");
    EXPECT_EQ(progress_bar(12, 10, 0.0), "[========================================] 100 %");
    EXPECT_EQ(progress_bar(0, 0, 0.0), "[========================================] 100 %");
}

}  // namespace
}  // namespace ncsim::app
