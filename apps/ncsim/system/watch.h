// SPDX-License-Identifier: GPL-3.0-or-later
//
// Repeats a command when a file changes that it read.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Command to repeat.
struct WatchedCommand {
    /// Runs the command in a child process and returns the exit code.
    std::function<int()> run;
    std::vector<std::string> inputs;   ///< Files and folders of the command line.
    std::vector<std::string> outputs;  ///< Files that the command writes, which are not watched.
    bool is_quiet = false;             ///< No line for each run.
};

/// Runs `command` once, then again after each change of a file that the last run read or looked
/// for, or of the programs in a folder that the last run listed. A file is changed if its time,
/// size or inode differs; the next run begins when the files are unchanged for one look. A file
/// that changes during a run causes another run.
/// Returns: the exit code of the last run, after SIGINT. SIGTERM and SIGHUP end the process.
/// Requires: the process has no second thread.
/// Throws: std::runtime_error if no process can be created.
int watch(const WatchedCommand& command);

}  // namespace ncsim::app
