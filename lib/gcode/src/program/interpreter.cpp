// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses the dialect of a program, refuses unreadable programs, and runs the program.
#include "ncsim/gcode/interpreter.h"

#include "ncsim/gcode/executed_text.h"

#include "control/control_rules.h"
#include "klartext/klartext_runner.h"
#include "program/runner.h"
#include "sinumerik/sinumerik_runner.h"
#include "text/message.h"

#include <optional>
#include <string_view>

namespace ncsim::gcode {
namespace {

std::string reasons(const std::vector<Evidence>& evidence) {
    std::string out;
    for (const Evidence& e : evidence) {
        if (!out.empty()) out += ", ";
        out += e.text;
        if (e.line > 0) out.append(" (line ").append(std::to_string(e.line)).append(")");
    }
    return out;
}

SourceSpan place(const std::vector<Evidence>& evidence) {
    return {evidence.empty() ? 0 : evidence.front().line, 1, 0};
}

/// Returns the remedy for a program of the kind `kind`, which is not executed.
std::string_view remedy(Kind kind) {
    switch (kind) {
        case Kind::Heidenhain:
        case Kind::HeidenhainIso:
        case Kind::Siemens:
        case Kind::Okuma:
        case Kind::Isg:
            return "post it for a control with G-code, such as LinuxCNC's or Fanuc's, or, if it is "
                   "that already, name the control (--dialect)";
        default: return "only milling is simulated; if it mills, name its control (--dialect)";
    }
}

/// True if the program must not be run: it would be misread completely. A kind specified by the
/// user, and programs that move a tool like a milling program, run with a warning.
bool refuse(const DialectFindings& findings, bool strict, DiagnosticLog& log) {
    const SourceSpan span = place(findings.kind_evidence);
    const std::string why = reasons(findings.kind_evidence);
    const auto warn = [&] {
        log.add(Message::ForeignKind, span, {name_of(findings.kind), why});
        return false;
    };
    switch (findings.kind) {
        case Kind::Milling: return false;
        case Kind::NotAProgram: log.add(Message::NoProgram, span, {why}); return true;
        case Kind::Laser:
        case Kind::Plasma: return warn();
        case Kind::Printer:
        case Kind::Lathe:
            if (strict) return warn();
            break;
        default: break;
    }
    if (findings.stated) return warn();
    log.add(Message::ForeignProgram, span, {name_of(findings.kind), why, remedy(findings.kind)});
    return true;
}

/// Interprets a program in a language other than G-code: Klartext or SINUMERIK.
void interpret_language(Dialect dialect, const SourceFile& program,
                        const InterpreterOptions& options, const MotionSink& sink,
                        DiagnosticLog& log, Interpretation& result) {
    InterpreterOptions own = options;
    // M128, M129 and M126 are codes of Klartext; TRAORI and TRAFOOF use the same numbers.
    own.tip_control.m_codes[128] = Coordinates::Tip;
    own.tip_control.m_codes[129] = Coordinates::Axes;
    own.rotary_ways = {};
    const Rules rules = Rules::of(dialect, false);
    ArcCentres centres;
    centres.is_settled = true;
    if (dialect == Dialect::Heidenhain) {
        klartext::Runner(program, own, rules, centres, sink, log, result).run();
    } else {
        sinumerik::Runner(program, own, options.rotary_ways, rules, centres, sink, log, result)
            .run();
    }
}

/// Returns the language of the program: Heidenhain or Sinumerik; Auto for G-code.
Dialect language_of(const DialectFindings& findings, bool strict) {
    if (findings.stated) {
        const bool is_language =
            findings.dialect == Dialect::Heidenhain || findings.dialect == Dialect::Sinumerik;
        return is_language ? findings.dialect : Dialect::Auto;
    }
    if (strict) return Dialect::Auto;
    return findings.kind == Kind::Heidenhain ? Dialect::Heidenhain
           : findings.kind == Kind::Siemens  ? Dialect::Sinumerik
                                             : Dialect::Auto;
}

/// Interprets the whole program without output.
/// Returns: true if more arcs fit absolute than incremental centres.
bool has_absolute_centres(const SourceFile& program, InterpreterOptions options,
                          const Rules& rules) {
    options.observe_state = nullptr;
    Interpretation result;
    result.files.push_back(program.name);
    DiagnosticLog log;
    ArcCentres counted;
    counted.counts_only = true;
    Runner(
        program, options, rules, counted, [](const Motion&) {}, log, result)
        .run();
    return counted.absolute > counted.incremental;
}

/// Executes `program`, a text without deleted blocks.
Interpretation execute(const SourceFile& program, const InterpreterOptions& given,
                       const MotionSink& sink) {
    Interpretation result;
    DiagnosticLog log;
    result.files.push_back(program.name);
    result.dialect = given.of_file ? *given.of_file : detect_dialect(program);
    if (given.dialect != Dialect::Auto) {
        result.dialect.dialect = given.dialect;
        result.dialect.stated = true;
    }
    if (given.strict) result.dialect.dialect = Dialect::Rs274;
    if (const Dialect language = language_of(result.dialect, given.strict);
        language != Dialect::Auto) {
        result.dialect.dialect = language;
        result.dialect.kind = Kind::Milling;
        if (!result.dialect.stated) {
            result.dialect.evidence = result.dialect.kind_evidence;
            log.add(Message::DialectConcluded, place(result.dialect.evidence),
                    {name_of(language), reasons(result.dialect.evidence)});
        }
        interpret_language(language, program, given, sink, log, result);
        result.diagnostics = log.take();
        return result;
    }
    if (result.dialect.dialect == Dialect::SinumerikIso) result.dialect.kind = Kind::Milling;
    if (refuse(result.dialect, given.strict, log)) {
        result.refused = true;
        result.diagnostics = log.take();
        return result;
    }
    const std::vector<Evidence>& evidence = result.dialect.evidence;
    if (!given.strict && !result.dialect.stated && !evidence.empty()) {
        log.add(Message::DialectConcluded, place(evidence),
                {name_of(result.dialect.dialect), reasons(evidence)});
    }
    // The ISO mode of SINUMERIK is the language of Fanuc; G291 selects it.
    const bool is_iso = result.dialect.dialect == Dialect::SinumerikIso;
    InterpreterOptions of_mode;
    if (is_iso) {
        of_mode = given;
        of_mode.allow.emplace_back("G291");
    }
    const InterpreterOptions& options = is_iso ? of_mode : given;
    Rules rules = Rules::of(is_iso ? Dialect::Fanuc : result.dialect.dialect, options.strict);
    rules.c_may_be_corner = result.dialect.c_may_be_corner;
    rules.linuxcnc_planes =
        rules.dialect == Dialect::Rs274 && (result.dialect.stated || !evidence.empty());
    rules.only_grbl = rules.dialect == Dialect::Grbl && result.dialect.stated;
    ArcCentres centres;
    centres.are_absolute = [&] { return has_absolute_centres(program, options, rules); };
    Runner runner(program, options, rules, centres, sink, log, result);
    runner.run();
    result.diagnostics = log.take();
    return result;
}

}  // namespace

Interpretation interpret(const SourceFile& program, const InterpreterOptions& options,
                         const MotionSink& sink) {
    if (!options.block_delete) return execute(program, options, sink);
    const ExecutedText text(program, options);
    InterpreterOptions own = options;
    if (options.read_file) {
        own.read_file = [&](std::string_view name) {
            std::optional<SourceFile> file = options.read_file(name);
            if (file) remove_deleted_blocks(*file, text.language(), options.strict);
            return file;
        };
    }
    return execute(text.file(), own, sink);
}

}  // namespace ncsim::gcode
