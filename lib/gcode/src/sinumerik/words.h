// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words of a block with their values: axes, centres, tool, feed, G codes and keywords.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/state.h"

#include "sinumerik/formula.h"
#include "sinumerik/line_reader.h"
#include "text/code_scanner.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::sinumerik {

/// Meaning of a value: by the mode G90 or G91, or as the function before the value states.
enum class Way : std::uint8_t { Modal, Absolute, Increment, Shortest, Positive, Negative };

struct Coordinate {
    double value = 0.0;
    Way way = Way::Modal;
    SourceSpan span;
};

/// Groups of codes that exclude each other in a block.
enum class CodeGroup : std::uint8_t {
    Motion,
    OneShot,  ///< G4, G74, G75, G110 … G112, G25, G26.
    Plane,
    Side,
    System,    ///< G54 …, G500.
    Suppress,  ///< G53, G153, SUPA.
    Units,
    Distance,
    Feed,
    Corner,     ///< G450, G451.
    Transform,  ///< TRAORI, TRAFOOF.
    PathMode,
    None,  ///< No group.
};
constexpr std::size_t kCodeGroups = 13;

// Numbers that stand for codes without a number.
constexpr int kSupa = 10'001;
constexpr int kCip = 10'002;
constexpr int kCt = 10'003;
constexpr int kTraori = 10'004;
constexpr int kTrafoof = 10'005;

/// The words of a block.
struct Words {
    std::array<std::optional<Coordinate>, 9> axis;
    std::array<std::optional<Coordinate>, 3> centre, via;  ///< I J K; I1 J1 K1.
    std::array<std::optional<double>, 3> direction;        ///< A3 B3 C3.
    std::optional<double> radius, opening, polar_radius, turns;
    std::optional<Coordinate> polar_angle;
    std::optional<double> rounding, chamfer, chamfer_length;  ///< RND CHR CHF.
    std::optional<double> modal_rounding;                     ///< RNDM
    std::optional<double> corner_feed, modal_corner_feed;     ///< FRC FRCM.
    std::optional<double> line_angle, plane_angle;            ///< ANG RPL.
    std::optional<double> feed, speed, edge, tool;
    std::optional<std::string> tool_name;
    std::optional<bool> turns_by_vector;  ///< ORIWKS, ORIVECT: true; ORIMKS, ORIAXES: false.
    std::vector<int> m;
    std::array<std::optional<int>, kCodeGroups> code;
    SourceSpan corner_span;

    std::optional<int> of(CodeGroup group) const { return code[static_cast<std::size_t>(group)]; }
    bool has_m(int number) const;
    bool has_axes() const;
    bool has_plain_axes() const;
    bool is_empty() const;
};

/// Reads words into `Words`.
class WordReader {
public:
    WordReader(Expressions& expressions, DiagnosticLog& log)
        : expressions_(expressions), log_(log) {}

    /// Result of reading an item of a block.
    enum class Found : std::uint8_t { Yes, No, Error };
    /// Reads the word at `scan`: "X10", "CR=5", "I=AC(3)", "G1", "T="DRILL"".
    Found word(CodeScanner& scan, const Line& line, Words& words);
    /// Reads a word of a letter and a number: "X10", "G1", "Z-3.5". Requires: no '=' follows.
    Found plain_word(CodeScanner& scan, const Line& line, Words& words);
    /// Reads a keyword without value: "SUPA", "CIP", "FFWON".
    Found keyword(std::string_view name, SourceSpan span, Words& words);

private:
    Found g_code(double number, SourceSpan span, Words& words);
    bool set_code(CodeGroup group, int code, std::string_view name, SourceSpan span, Words& words);
    Found take(std::string_view name, double value, const Coordinate& coordinate, SourceSpan span,
               Words& words);
    std::optional<Coordinate> coordinate(CodeScanner& scan, const Line& line);
    Found fail(const MessageText& message, SourceSpan span,
               std::initializer_list<std::string_view> arguments = {});

    Expressions& expressions_;
    DiagnosticLog& log_;
};

/// True for the name of an address that is written with '=': "CR", "TURN", "I1".
bool is_long_address(std::string_view name);

}  // namespace ncsim::gcode::sinumerik
