// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of `ncsim merge`.
#include "options/merge_options.h"

#include "options/run_options.h"

namespace ncsim::app {

namespace {

constexpr OptionRow<MergeOptions> kSources[] = {{"sources", "DIRS", kWork,
                                                 "Folders or files with results",
                                                 store<&MergeOptions::sources>, kRequired}};

// Adds the options of ncsim run that merge applies to tiles.
void add_options_of_run(cli::App& merge, MergeOptions& o) {
    cli::App run("", "");
    Options ignored;
    add_options(run, ignored);
    for (const cli::Option* option : run.options()) {
        if (!option->counts().merge) continue;
        const std::string name = option->long_names().front();
        const char* const more = name == "gltf" ? "; DIR/: a mesh per tile" : "";
        const auto take = [&o, name](const std::string& value) {
            o.of_run.emplace_back(name, value);
        };
        merge.add_option_function<std::string>("--" + name, take, option->text() + more)
            ->describe(option->type_name().c_str(), "Outputs of tiles", kWork, {});
    }
}

}  // namespace

void add_options(cli::App& merge, MergeOptions& o) {
    add_rows(merge, "", kSources, o);
    add_rows(merge, "Outputs", report_options(), static_cast<ReportOptions&>(o));
    add_options_of_run(merge, o);
}

}  // namespace ncsim::app
