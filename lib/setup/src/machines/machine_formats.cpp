// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice of the reader by the name of the file.
#include "ncsim/setup/machine_formats.h"

#include "machines/freecad_machine.h"
#include "machines/fusion_machine.h"
#include "machines/linuxcnc_machine.h"
#include "machines/toml_machine.h"
#include "machines/urdf_machine.h"

namespace ncsim::setup {

MachineFile read_machine(const std::string& path, InputSet& inputs) {
    if (path.ends_with(".ini")) return read_linuxcnc_machine(path, inputs);
    if (path.ends_with(".fcm")) return read_freecad_machine(path, inputs);
    if (path.ends_with(".machine")) return read_fusion_machine(path, inputs);
    if (path.ends_with(".urdf")) return read_urdf_machine(path, inputs);
    return read_toml_machine(path, inputs);
}

}  // namespace ncsim::setup
