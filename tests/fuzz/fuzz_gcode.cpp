// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads any bytes as a program. Lexer, parser and interpreter must end within their limits, and
// make no motion with a coordinate that is not a number. The first byte selects the rules.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ncsim::gcode;
    if (size == 0) return 0;
    const SourceFile file{"fuzz.nc",
                          std::string(reinterpret_cast<const char*>(data + 1), size - 1)};
    InterpreterOptions options;
    constexpr Dialect kDialects[] = {Dialect::Auto, Dialect::Rs274, Dialect::Fanuc,
                                     Dialect::Haas, Dialect::Grbl,  Dialect::Mach3};
    options.dialect = kDialects[data[0] % 6];
    options.strict = (data[0] & 0x40) != 0;
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
        if (const Position* end = end_of(motion); end && std::isnan(end->x.mm())) std::abort();
        if (++motions < 100) {
            text.clear();
            print(text, motion);
        }
    });
    for (const Diagnostic& d : result.diagnostics)
        text += render(d, file);
    return 0;
}
