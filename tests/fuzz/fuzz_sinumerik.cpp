// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads any bytes as a SINUMERIK program. Reader, expressions, jumps, loops, calls and cycles must
// end within their limits, and make no motion with a coordinate that is not a number.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"
#include "ncsim/gcode/sinumerik.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ncsim::gcode;
    if (size == 0) return 0;
    const SourceFile file{"fuzz.mpf",
                          std::string(reinterpret_cast<const char*>(data + 1), size - 1)};
    InterpreterOptions options;
    options.dialect = Dialect::Sinumerik;
    options.block_delete = (data[0] & 0x80) != 0;
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = false, .diameter = Length::from_mm(1.0)}};
    options.limits = {.repeated_blocks = 3000, .call_depth = 20};
    options.read_file = [&](std::string_view name) -> std::optional<SourceFile> {
        if (name.size() > 1) return std::nullopt;
        return file;
    };
    std::string text;
    std::uint64_t motions = 0;
    const Interpretation result = interpret(file, options, [&](const Motion& motion) {
        const Position* end = end_of(motion);
        if (end && (std::isnan(end->x.mm()) || std::isnan(end->y.mm()) || std::isnan(end->z.mm())))
            std::abort();
        if (++motions < 100) {
            text.clear();
            print(text, motion);
        }
    });
    for (const Diagnostic& d : result.diagnostics)
        text += render(d, file);
    SinumerikNotes notes(file);
    Block block;
    while (notes.next(block))
        text += std::to_string(block.words.size() + block.comments.size());
    SinumerikListing listing(file);
    DiagnosticLog log;
    ListedBlock line;
    while (listing.next(line, log))
        text += line.text;
    (void)sinumerik_cylinder(file);
    return 0;
}
