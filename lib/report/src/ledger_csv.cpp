// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ledger as CSV.
#include "ncsim/report/ledger_csv.h"

#include "ncsim/report/file_names.h"
#include "ncsim/report/plain_text.h"

#include "shares.h"

#include <fmt/format.h>

#include <optional>
#include <ostream>

namespace ncsim::report {

namespace {

// Returns nine digits, which hide the rounding errors of binary fractions; empty for an unknown
// value.
std::string number(std::optional<double> value) {
    return value ? fmt::format("{:.9g}", *value) : std::string();
}

std::string csv_path(const std::string& path) {
    const std::string text = printable_path(path);
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

}  // namespace

std::string ledger_csv_share(const Checked& checked) {
    std::string out;
    const std::string program = csv_path(relative_path(checked.path));
    for (const verify::LedgerRow& row : checked.verdict.ledger.rows) {
        out +=
            fmt::format("{},{},{},{},{},{},{},{},{},{},{}", program,
                        csv_path(file_of(checked, {row.file, {}})), row.line, row.first_motion,
                        row.last_motion, row.tool, name_of(row.kind), number(row.length_mm),
                        number(row.removed_mm3), number(row.seconds), number(row.removal_rate()));
        for (const cda::Vec3& corner : {row.contact.min, row.contact.max}) {
            for (int axis = 0; axis < 3; ++axis) {
                out += ',';
                if (!row.contact.is_empty()) out += number(corner[axis]);
            }
        }
        out += '\n';
    }
    return out;
}

void write_ledger_csv(std::ostream& out, const Entries& all) {
    out << "program,file,line,first_motion,last_motion,tool,kind,length_mm,removed_mm3,seconds,"
           "mm3_per_minute,contact_min_x,contact_min_y,contact_min_z,contact_max_x,contact_max_y,"
           "contact_max_z\n";
    all([&](const Entry& entry) { out << entry.csv; });
}

}  // namespace ncsim::report
