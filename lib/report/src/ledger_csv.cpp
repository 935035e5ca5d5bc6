// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ledger as CSV.
#include "ncsim/report/ledger_csv.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"

#include "ledger_operations.h"
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

std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string csv_path(const std::string& path) {
    return csv_text(printable_path(path));
}

}  // namespace

std::string ledger_csv_share(const Checked& checked, LengthUnit unit) {
    const double length = in_unit(1.0, unit), volume = length * length * length;
    const auto scaled = [](std::optional<double> value, double factor) {
        if (value) *value *= factor;
        return number(value);
    };
    std::string out;
    const std::string program = csv_path(relative_path(checked.path));
    for (const verify::LedgerRow& row : checked.verdict.ledger.rows) {
        out += fmt::format("{},{},{},{},{},{},{},{},{},{},{}", program,
                           csv_path(file_of(checked, {row.file, {}})), row.line, row.first_motion,
                           row.last_motion, row.tool, name_of(row.kind),
                           scaled(row.length_mm, length), scaled(row.removed_mm3, volume),
                           number(row.seconds), scaled(row.removal_rate(), volume));
        for (const Vec3& corner : {row.contact.min, row.contact.max}) {
            for (int axis = 0; axis < 3; ++axis) {
                out += ',';
                if (!row.contact.is_empty()) out += scaled(corner[axis], length);
            }
        }
        const simulation::CheckedOperation* const operation =
            operation_of(checked, row.first_motion);
        out += ',';
        if (operation) out += csv_text(one_line(operation->name));
        out += '\n';
    }
    return out;
}

void write_ledger_csv(std::ostream& out, const Entries& all, LengthUnit unit) {
    const std::string_view name = name_of(unit);
    out << fmt::format(
        "program,file,line,first_motion,last_motion,tool,kind,length_{0},removed_{0}3,seconds,"
        "{0}3_per_minute,contact_min_x,contact_min_y,contact_min_z,contact_max_x,contact_max_y,"
        "contact_max_z,operation\n",
        name);
    all([&](const Entry& entry) { out << entry.csv; });
}

}  // namespace ncsim::report
