// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/setup/machine_formats.h"

#include "linuxcnc_machine.h"

namespace ncsim::setup {

MachineFile read_machine(const std::string& path, InputSet& inputs) {
    return path.ends_with(".ini") ? read_linuxcnc_machine(path, inputs)
                                  : read_machine_file(path, inputs);
}

}  // namespace ncsim::setup
