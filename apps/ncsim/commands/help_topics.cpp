// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of `ncsim help TOPIC`.
#include "commands/help_topics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ncsim::app {

const std::string_view kToolNotation = R"(
Tools:  T1=flat:D10:L22:S12x30:H28x15,40x25  kinds flat, ball, bull, face, v, spot, engraver,
        chamfer, countersink, drill, taper, slot, dovetail, lollipop, corner (rounding), tap,
        reamer, boring-bar, thread (a thread mill); values
        D diameter, L length of the flutes, R corner radius, K pitch of a thread,
        A angle, P tip diameter; above the flutes N neck and S shank (diameter, or diameter x
        length), E from the tip to the holder, H holder from below (diameter x height, or
        lower-upper x height); mm, or inches: D1/4in
)";

const std::string_view kStockNotation =
    R"(Stock:  x0,y0,z0:x1,y1,z1 or LxWxH (top at Z0, centred) or LxWxH@x,y,z (smallest corner); bars
        DdxH (top at Z0) or DdxH@x,y,z (lower end), along X or Y: DXdxL, DYdxL;
        mm, or inches: 4x2x1/2in
)";

const std::string_view kFileNotes = R"(
Files:  - is the standard input or the standard output; text then goes to the standard error.
Color:  --color auto, always, never with any command. auto: on a terminal, without NO_COLOR.
)";

const std::string_view kExitCodes = R"(
Exit codes: 0 clean; 1 faults in the NC program; 2 wrong usage, unreadable input or failed output;
3 internal error; 4 not proven: no fault was found, but information is missing (check).

)";

namespace {

struct Topic {
    std::string_view name, summary;
    std::string_view notation;  ///< Before the text; may be empty.
    std::string_view text;
};

constexpr std::string_view kVerdicts = R"(
ncsim check gives each program one verdict:

  clean       exit code 0: every move was simulated with specified tools, stock and positions, and
              no rule is violated
  accepted    exit code 0: clean except for findings and doubts that the user accepted
  not proven  exit code 4: no violation was found, but an assumption could hide a violation, or a
              move was not simulated
  failed      exit code 1: at least one error, whatever the assumptions are

For many programs the worst verdict counts: clean, accepted, not proven, failed.

A rule finds a violation. A doubt is a reason why the verdict is not proven. The text has the
option or comment that removes each doubt, in the line "fix".

  ncsim rules                   all rules and reasons for doubt
  ncsim rules rapid-in-material one rule: meaning, remedy, a program that fails, one that passes
  --accept stock-guess          a doubt that does not count
  --require holder,travels      values that must be specified
  --baseline known.json         known findings, which do not fail
  (ncsim: ignore air-cut)       comment in a block: the rule is off for this block
)";

constexpr std::string_view kTool = R"(
Sources of tools, the first one counts: --tool, job file (--job), tool tables (--tool-table),
comments of the CAM system in the program.

  ncsim tools part.nc                        tools of a program: shape, source, use
  ncsim run part.nc --tool T1=flat:D10:L22   flat end mill, 10 mm, flutes 22 mm
  ncsim run part.nc --tool-table tool.tbl    table of LinuxCNC; also CSV, Fusion, FreeCAD, HSMWorks
  ncsim run part.nc --assume-tool flat:D6    a tool for all tools without description; a doubt
  ncsim tools part.nc --save-job job.toml    the tools as a job file

A tool without a flute length has an assumed one, which may become a doubt (flutes-guess).
)";

constexpr std::string_view kStock = R"(
Sources of stock, the first one counts: --stock, job file (--job), comments of the program.
Without a source, a block is derived from the moves: a doubt (stock-guess).

  --stock 120x80x25          block: X -60 to 60, Y -40 to 40, Z -25 to 0
  --stock D60x40             bar along Z: Z -40 to 0
  --stock casting.stl        closed mesh: .stl, .obj, .glb, .wrl; .step
  --stock first.ncstock      part of another run (--save-stock first.ncstock)
  --stock-turn X180          turns stock of a file, --stock-move 0,0,-25 then moves the stock
)";

constexpr std::string_view kJobs = R"(
A job file (.toml) has a program with tools, stock, machine and fixtures, or several set-ups of one
part. Each command reads the file in place of a program.

  ncsim init top.nc back.nc        writes a first job.toml, with all assumptions and what to measure
  ncsim check job.toml             all set-ups; the exit code is that of the worst verdict
  ncsim check job.toml --setup 2   one set-up, by number or name
  ncsim run part.nc --save-job job.toml

  version = 2
  program = "part.nc"
  stock = "80x50x25@-40,-25,-25"
  [[tool]]
  number = 1
  kind = "flat"
  diameter = 8
  length = 20

Paths are relative to the job file. docs/jobs.md lists all keys.
)";

constexpr std::string_view kConfig = R"(
The file ncsim.toml in a folder has the common options of all programs below:

  version = 1
  machine = "machines/mill.toml"       an option of ncsim check, without dashes
  require = ["holder", "travels"]      lists
  warnings-as-errors = true            flags
  [[program]]                          other options for some programs
  files = ["turning/**"]
  machine = "machines/trt.toml"

  ncsim check             without arguments: checks the folder if it has an ncsim.toml
  ncsim init --repo       writes a first ncsim.toml
  --verbose               prints each setting with file and line
  --no-project            ignores ncsim.toml

The nearest ncsim.toml counts, in the folder of the program or above, up to the folder with .git.
The command line comes first, then the job file, then ncsim.toml, then comments of the program.
)";

constexpr std::string_view kExits = R"(
  0  clean, or accepted; for other commands than check: the work is done, without errors
  1  the NC program has faults (check: failed); diff: the parts differ
  2  wrong usage, a file cannot be read, or an output cannot be written;
     diff: a program cannot be cut
  3  a bug in ncsim
  4  not proven: no fault was found, but information is missing (check)

Codes 2 and 3 have priority over verdicts. After a signal, the code is 128 + its number, as for all
programs: 130 after Ctrl+C. --watch ends with Ctrl+C, and the code is that of the last run.
--exit-zero: check ends with 0 despite findings and doubts.
)";

constexpr std::string_view kFiles = R"(
  ncsim run part.nc --stl - | viewer     a mesh to another program
  generate | ncsim check -               a program from the standard input

-q prints errors, warnings, findings and doubts only, and results that go to no file.

An output appears whole or not at all. ncsim refuses an output that is also an input, or whose name
has the ending of another format. A program or mesh has at most 1 GB, a set-up file 64 MB.
)";

constexpr std::string_view kWatch = R"(
ncsim run and ncsim check with --watch run again when a file changes that the last run read: the
program, subprograms, job, ncsim.toml, tool tables, machine, stock, design. So does a file that
appears where the last run searched: a subprogram, or a nearer ncsim.toml.

  ncsim check part.nc --watch
  ncsim run part.nc --png part.png --watch

Each run prints a line with its number, the changed file and the exit code. A folder is watched for
new and removed programs. Ctrl+C ends the command; the exit code is that of the last run.
The standard input, shards and tiles cannot be watched.
)";

const std::array kTopics = {
    Topic{"verdicts", "Clean, accepted, not proven, failed; rules and doubts", {}, kVerdicts},
    Topic{"tool", "Notation and sources of tools", kToolNotation, kTool},
    Topic{"stock", "Notation and sources of stock", kStockNotation, kStock},
    Topic{"jobs", "Job files: a program or several set-ups with all values", {}, kJobs},
    Topic{"config", "ncsim.toml: common options of a folder", {}, kConfig},
    Topic{"exit-codes", "Exit codes of all commands", {}, kExits},
    Topic{"files", "Standard input and output, safety of outputs", kFileNotes, kFiles},
    Topic{"watch", "Run again when a file changes", {}, kWatch},
};

}  // namespace

std::vector<std::string> topic_names() {
    std::vector<std::string> names;
    names.reserve(kTopics.size());
    for (const Topic& topic : kTopics)
        names.emplace_back(topic.name);
    return names;
}

std::string topic_text(std::string_view name) {
    const auto* const found = std::ranges::find(kTopics, name, &Topic::name);
    if (found == kTopics.end()) return {};
    std::string text = fmt::format("{}: {}\n", found->name, found->summary);
    if (!found->notation.empty() && !found->notation.starts_with("\n")) text += '\n';
    return text.append(found->notation).append(found->text);
}

std::string topic_list() {
    std::string text;
    for (const Topic& topic : kTopics)
        text += fmt::format("  {:<11} {}\n", topic.name, topic.summary);
    return text;
}

}  // namespace ncsim::app
