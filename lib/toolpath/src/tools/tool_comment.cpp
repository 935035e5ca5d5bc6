// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forms of comments with a tool or a stock, as CAM systems write them.
#include "tools/tool_comment.h"

#include "tools/tool_phrase.h"
#include "tools/tool_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ncsim::toolpath {

namespace {

using text::Quantity;
using text::Unit;

constexpr std::size_t kNone = std::string_view::npos;

std::size_t skip(std::string_view s, std::size_t at, std::string_view any_of) {
    while (at < s.size() && any_of.find(s[at]) != kNone)
        ++at;
    return at;
}

// Reads the number after a key: `D=10.`, `D = 2.0 mm`, `DIA. - .0625`, `DIA-0.5000`, `Dia. 0.250`.
std::optional<Quantity> value_after(std::string_view s, std::string_view key,
                                    std::string_view separators) {
    for (std::size_t at = text::find_word(s, key); at != kNone;
         at = text::find_word(s, key, at + 1)) {
        std::size_t number = skip(s, at + key.size(), separators);
        if (number == at + key.size()) continue;
        if (s[number - 1] == '.') --number;  // .0625, not the point of DIA.
        if (const auto q = text::quantity_at(s, number)) return q;
    }
    return std::nullopt;
}

// Reads a tool number at `at`: a whole number without decimal point or fraction. 0 if there is
// none.
int tool_number_at(std::string_view s, std::size_t at) {
    std::size_t end = at;
    int number = 0;
    while (end < s.size() && is_digit(s[end]) && number < 10000000) {
        number = 10 * number + (s[end++] - '0');
    }
    const bool whole =
        end > at && (end == s.size() || (s[end] != '.' && s[end] != '/' && !is_digit(s[end])));
    return whole ? number : 0;
}

// Returns the kind for a type name of Fusion 360; its slot mill is a disc on a neck.
std::optional<ToolKind> fusion_kind_named(std::string_view s) {
    if (s.find("SLOT MILL") != kNone) return ToolKind::SlotMill;
    if (s.find("DOVETAIL") != kNone) return ToolKind::DovetailMill;
    if (s.find("LOLLIPOP") != kNone) return ToolKind::LollipopMill;
    if (s.find("RADIUS MILL") != kNone) return ToolKind::CornerRoundingMill;
    if (s.find("FORM MILL") != kNone) return ToolKind::Other;
    return words::kind_named(s);
}

// Sets an angle. In Fusion's comments TAPER is per side for mills, the whole point angle for
// drills.
void take_taper(ToolSpec& spec, double degrees) {
    if (degrees <= 0 || degrees >= 180) return;
    if (!spec.kind && degrees >= 60) spec.kind = ToolKind::Drill;
    if (!spec.kind) spec.kind = ToolKind::TaperedEndMill;
    switch (*spec.kind) {
        case ToolKind::Drill: spec.angle = degrees; break;
        case ToolKind::ChamferMill:
        case ToolKind::Countersink:
        case ToolKind::VCutter: spec.angle = degrees < 60 ? 2 * degrees : degrees; break;
        case ToolKind::TaperedEndMill:
        case ToolKind::DovetailMill: spec.taper = std::min(degrees, 80.0); break;
        default: break;  // printed for tools without taper
    }
}

// True for "LEFT HAND TAP", "LH TAP", "L.H.", and the words of other languages.
bool names_left_hand(std::string_view s) {
    for (const char* const name :
         {"LH", "L.H", "LEFT HAND", "LEFT-HAND", "LEFTHAND", "LINKS", "GAUCHE"}) {
        if (text::find_word(s, name) != kNone) return true;
    }
    // These words have several endings.
    for (const char* const begin : {"LINKSGEWINDE", "IZQUIERD", "SINISTR"}) {
        if (s.find(begin) != kNone) return true;
    }
    return false;
}

// Reads (T1 D=10. CR=0. TAPER=118deg - ZMIN=-5. - flat end mill), also with a name instead of T1.
std::optional<ToolRemark> read_fusion(std::string_view s) {
    const std::size_t d = s.find(" D=");
    if (d == kNone) return std::nullopt;
    const auto diameter = text::quantity_at(s, d + 3);
    const std::size_t type = s.rfind(" - ");
    if (!diameter || type == kNone || type < d) return std::nullopt;
    const bool numbered = s[0] == 'T' && s.size() > 1 && is_digit(s[1]);
    if (!numbered && s[0] != '"') return std::nullopt;
    ToolRemark remark;
    remark.certain = true;
    remark.unit = diameter->unit;
    if (numbered) remark.spec.number = tool_number_at(s, 1);
    remark.spec.diameter = diameter->value;
    remark.spec.kind = fusion_kind_named(s.substr(type));
    if (const auto cr = value_after(s, "CR", "= ")) {
        if (cr->value > 0) remark.spec.corner_radius = cr->value;
    }
    if (const auto taper = value_after(s, "TAPER", "= ")) take_taper(remark.spec, taper->value);
    // A corner radius is more reliable than the name of a mill.
    if (remark.spec.kind == ToolKind::FlatEndMill && remark.spec.corner_radius) {
        remark.spec.kind.reset();
    }
    // Further keys of vendors: FL=1 flute length, SD=6 shank, BL=30 stick-out.
    for (const auto& [key, into] : {std::pair{"FL", &ToolSpec::length},
                                    {"SD", &ToolSpec::shank_diameter},
                                    {"BL", &ToolSpec::stick_out}}) {
        const auto value = value_after(s, key, "=");
        if (value && value->value > 0) remark.spec.*into = value->value;
    }
    return remark;
}

std::vector<double> numbers_after_comma(std::string_view s) {
    std::vector<double> values;
    const auto parts = text::split(s, ',');
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::string_view part = trimmed(parts[i]);
        const auto q = text::quantity_at(part, 0);
        if (!q) break;
        values.push_back(q->value);
    }
    return values;
}

std::optional<double> positive(const std::vector<double>& v, std::size_t i) {
    return i < v.size() && v[i] > 0 ? std::optional(v[i]) : std::nullopt;
}

// Reads (TOOL/MILL,Dia,CornerR,Height,TaperAngle) and related forms.
std::optional<ToolRemark> read_cutviewer(std::string_view s) {
    if (s.substr(0, 5) != "TOOL/") return std::nullopt;
    ToolRemark remark;
    remark.certain = true;
    ToolSpec& spec = remark.spec;
    const std::string_view name = trimmed(s.substr(5, s.find(',') - 5));
    const std::vector<double> v = numbers_after_comma(s);
    spec.diameter = positive(v, 0);
    if (!spec.diameter) return std::nullopt;
    if (name == "MILL") {
        spec.corner_radius = positive(v, 1);
        spec.length = positive(v, 2);
        if (const auto taper = positive(v, 3)) {
            spec.taper = std::min(*taper, 80.0);
            spec.kind = ToolKind::TaperedEndMill;
        } else if (!spec.corner_radius) {
            spec.kind = ToolKind::FlatEndMill;
        }
    } else if (name == "DRILL" || name == "CHAMFER") {
        spec.kind = name == "DRILL" ? ToolKind::Drill : ToolKind::ChamferMill;
        spec.angle = positive(v, 1);
        spec.length = positive(v, 2);
    } else if (name == "CDRILL") {
        // Two drills on top of each other: D1, A1 and L of the pilot; D2, A2 and H of the whole.
        const auto a1 = positive(v, 1), l = positive(v, 2), d2 = positive(v, 3),
                   a2 = positive(v, 4), h = positive(v, 5);
        if (!a1 || !l || !d2 || !a2 || !h || *d2 < *spec.diameter) return std::nullopt;
        spec.pieces = drill(*spec.diameter, *a1, *l).pieces;
        ToolPiece body = v_cutter(*d2, *spec.diameter, *a2, *h - *l).pieces.front();
        const double base = spec.pieces.front().profile.back().height;
        for (ProfilePoint& p : body.profile)
            p.height += base;
        spec.pieces.push_back(std::move(body));
        spec.kind = ToolKind::VCutter;
    } else if (name == "CRMILL") {
        // Diameters of the tip and of all, radius, height of all, and how high it cuts.
        spec.kind = ToolKind::CornerRoundingMill;
        spec.tip_diameter = v.front();
        spec.diameter = positive(v, 1);
        spec.corner_radius = positive(v, 2);
        spec.length = positive(v, 4);
        if (!is_complete(spec)) return std::nullopt;
    } else {
        return std::nullopt;
    }
    return remark;
}

// Reads (@FC|TOOL|number=3|type=Chamfer|diameter=3.175|…) and ;@MKR|TOOL|…
std::optional<ToolRemark> read_piped(std::string_view s) {
    if (s.empty() || s[0] != '@' || s.find("|TOOL|") == kNone) return std::nullopt;
    ToolRemark remark;
    remark.certain = true;
    ToolSpec& spec = remark.spec;
    for (const std::string_view part : text::split(s, '|')) {
        const std::size_t equals = part.find('=');
        if (equals == kNone) continue;
        const std::string_view key = part.substr(0, equals);
        const std::string_view value = part.substr(equals + 1);
        const auto q = text::quantity_at(value, 0);
        if (key == "NUMBER") spec.number = tool_number_at(value, 0);
        if (key == "TYPE") spec.kind = words::kind_named(value);
        if (!q || q->value <= 0) continue;
        if (key == "DIAMETER") spec.diameter = q->value;
        if (key == "TIPDIAMETER") spec.tip_diameter = q->value;
        if (key == "FLUTELENGTH") spec.length = q->value;
        if (key == "SHANKDIAMETER" || key == "HANDLEDIAMETER") spec.shank_diameter = q->value;
        if (key == "STICKLENGTH") spec.stick_out = q->value;
        if (key == "CORNERRADIUS") spec.corner_radius = q->value;
        if (key == "CUTTINGEDGEANGLE") spec.angle = q->value;
    }
    if (!spec.diameter) return std::nullopt;
    return remark;
}

// Reads "tool#=1 flute=6 len=20 unit=metric" of Kiri:Moto.
std::optional<ToolRemark> read_kiri(std::string_view s) {
    if (s.substr(0, 6) != "TOOL#=") return std::nullopt;
    ToolRemark remark;
    remark.certain = true;
    remark.spec.number = tool_number_at(s, 6);
    const auto diameter = value_after(s, "FLUTE", "=");
    if (!diameter || diameter->value <= 0) return std::nullopt;
    remark.spec.diameter = diameter->value;
    if (const auto length = value_after(s, "LEN", "=")) {
        if (length->value > 0) remark.spec.length = length->value;
    }
    if (s.find("UNIT=METRIC") != kNone) remark.unit = Unit::Millimetre;
    if (s.find("UNIT=IMPERIAL") != kNone) remark.unit = Unit::Inch;
    return remark;
}

// Reads ( T01 | 0.610mm 0.0240in | 0.0000in | 0.0000in | 0 ), a row of pcb-gcode's drill table.
std::optional<ToolRemark> read_drill_table(std::string_view s) {
    if (s[0] != 'T' || s.size() < 2 || !is_digit(s[1])) return std::nullopt;
    const auto cells = text::split(s, '|');
    if (cells.size() < 3) return std::nullopt;
    ToolRemark remark;
    remark.certain = true;
    remark.spec.number = tool_number_at(trimmed(cells[0]), 1);
    const auto size = text::quantity_at(trimmed(cells[1]), 0);
    if (remark.spec.number == 0 || !size || size->value <= 0.0) return std::nullopt;
    if (size->unit != Unit::Millimetre && size->unit != Unit::Inch) return std::nullopt;
    remark.spec.kind = ToolKind::Drill;
    remark.spec.diameter = size->value;
    remark.unit = size->unit;
    return remark;
}

// Reads X, Y and Z with numbers: "X= 76.000, Y= 5.500, Z= 1.000", "X:100 Y:50 Z:10".
std::optional<Triple> named_triple(std::string_view s) {
    Triple t;
    for (int axis = 0; axis < 3; ++axis) {
        const char name = static_cast<char>('X' + axis);
        auto q = value_after(s, {&name, 1}, "=: ");
        const std::size_t glued = text::find_word(s, {&name, 1});  // X76.2
        if (!q && glued != kNone && glued + 1 < s.size()) q = text::quantity_at(s, glued + 1);
        if (!q || std::abs(q->value) > 1e6) return std::nullopt;
        t.value[axis] = q->value;
        if (q->unit != Unit::None) t.unit = q->unit;
    }
    return t;
}

std::optional<Triple> named_size(std::string_view s) {
    const auto t = named_triple(s);
    if (!t) return std::nullopt;
    const bool is_size = t->value.x > 0 && t->value.y > 0 && t->value.z > 0;
    return is_size ? t : std::nullopt;
}

// Returns the position after the name of a block in front of its size: "STOCK 100x50x10", "; Stock
// Size: 3(X) * 3(Y) * 3(Z) mm".
std::optional<std::size_t> find_after_block_name(std::string_view s) {
    static constexpr std::string_view kNames[] = {"RAW STOCK",    "STOCK",     "BLANK",
                                                  "BLOCK",        "WORKPIECE", "MATERIAL",
                                                  "RAW MATERIAL", "ROHTEIL",   "BRUT"};
    for (const std::string_view name : kNames) {
        if (s.substr(0, name.size()) != name) continue;
        std::size_t at = name.size();
        const auto skip = [&](std::string_view what) {
            at = std::min(s.find_first_not_of(what, at), s.size());
        };
        if (at < s.size() && text::is_letter(s[at])) continue;
        skip(" ");
        for (const std::string_view word : {"SIZE", "DIMENSIONS", "IS"}) {
            if (s.substr(at, word.size()) == word) at += word.size();
        }
        skip(" :=");
        return at;
    }
    return std::nullopt;
}

// Reads three lengths without further numbers: "100x50x10", "4in x 2in x 1/2in", "3(X) * 3(Y) *
// 3(Z) mm".
std::optional<Triple> product_at(std::string_view s, std::size_t at) {
    Triple t;
    const auto skip_blanks = [&] { at = std::min(s.find_first_not_of(' ', at), s.size()); };
    for (int axis = 0; axis < 3; ++axis) {
        skip_blanks();
        if (axis > 0) {
            if (at == s.size() || (s[at] != 'X' && s[at] != '*')) return std::nullopt;
            ++at;
            skip_blanks();
        }
        auto q = text::quantity_at(s, at);
        if (!q || !(q->value > 0) || q->value > 1e6) return std::nullopt;
        // "4INX2INX1IN": the unit is adjacent to the X.
        for (const auto& [name, unit] : {std::pair{"MMX", Unit::Millimetre}, {"INX", Unit::Inch}}) {
            if (q->unit == Unit::None && s.substr(std::min(q->end, s.size()), 3) == name)
                q->unit = unit, q->end += 2;
        }
        if (q->unit == Unit::None && q->is_fraction) q->unit = Unit::Inch;
        if (q->unit == Unit::Degree) return std::nullopt;
        if (t.unit != Unit::None && q->unit != Unit::None && q->unit != t.unit) return std::nullopt;
        t.value[axis] = q->value;
        if (q->unit != Unit::None) t.unit = q->unit;
        at = q->end;
        const char label[] = {'(', static_cast<char>('X' + axis), ')', '\0'};
        if (s.substr(at, 3) == label) at += 3;
    }
    skip_blanks();
    if (s.substr(at, 2) == "MM") t.unit = Unit::Millimetre;
    if (s.substr(at, 2) == "IN") t.unit = Unit::Inch;
    if (s.find_first_of("0123456789", at) != kNone) return std::nullopt;
    return t;
}

// Reads "DX 3.50IN DY 2.50IN DZ 0.75IN" anywhere in `s`.
std::optional<Triple> named_lengths(std::string_view s) {
    Triple t;
    for (int axis = 0; axis < 3; ++axis) {
        const char name[] = {'D', static_cast<char>('X' + axis), '\0'};
        const std::size_t at = text::find_word(s, name);
        if (at == kNone) return std::nullopt;
        const auto q = text::quantity_at(s, skip(s, at + 2, " =:"));
        if (!q || q->value <= 0.0 || q->value > 1e6 || q->unit == Unit::Degree) return std::nullopt;
        const Unit unit = q->is_fraction && q->unit == Unit::None ? Unit::Inch : q->unit;
        if (axis > 0 && unit != t.unit) return std::nullopt;
        t.value[axis] = q->value;
        t.unit = unit;
    }
    return t;
}

// Reads the position of the zero on the stock: "WCS G54 FRONT-LEFT-TOP", "ZERO: CENTER, TOP OF
// STOCK". -1 is left, front (lower) and bottom, 0 the middle, 1 right, back (upper) and top. Empty
// if `s` contains an unknown word, or does not name the height and both positions in the plane.
std::optional<Triple> zero_named(std::string_view s) {
    static constexpr std::string_view kHeads[] = {"WCS", "ZERO", "ORIGIN", "DATUM", "XYZ", "WORK"};
    static constexpr std::string_view kFillers[] = {
        "ZERO",  "ORIGIN", "DATUM", "WORK",  "OFFSET", "CORNER", "OF",    "THE",   "AT", "IS",
        "STOCK", "ON",     "AND",   "BLOCK", "XYZ",    "PART",   "LOWER", "UPPER", "XY"};
    Triple t;
    bool has_x = false, has_y = false, is_middle = false, has_height = false, is_first = true;
    for (std::size_t at = 0; at < s.size();) {
        if (!text::is_letter(s[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < s.size() && (text::is_letter(s[end]) || is_digit(s[end])))
            ++end;
        const std::string_view word = s.substr(at, end - at);
        at = end;
        const auto is_one_of = [word](const auto& words) {
            return std::ranges::find(words, word) != std::end(words);
        };
        if (std::exchange(is_first, false)) {
            if (!is_one_of(kHeads)) return std::nullopt;
        } else if (word == "LEFT" || word == "RIGHT") {
            t.value.x = word == "LEFT" ? -1.0 : 1.0;
            has_x = true;
        } else if (word == "FRONT" || word == "LOWER") {
            t.value.y = -1.0;
            has_y = true;
        } else if (word == "BACK" || word == "REAR" || word == "UPPER") {
            t.value.y = 1.0;
            has_y = true;
        } else if (word == "CENTER" || word == "CENTRE" || word == "MIDDLE") {
            is_middle = true;
        } else if (word == "TOP" || word == "BOTTOM") {
            t.value.z = word == "TOP" ? 1.0 : -1.0;
            has_height = true;
        } else if (word.size() > 1 && word[0] == 'G' && is_digit(word[1])) {
            if (word.substr(0, 2) != "G5") return std::nullopt;  // G54 … G59
        } else if (!is_one_of(kFillers)) {
            return std::nullopt;
        }
    }
    // "TOP LEFT" may be a corner of a drawing: the third position is missing.
    const bool has_plane = (has_x && has_y) || is_middle;
    return has_plane && has_height ? std::optional(t) : std::nullopt;
}

// Reads Vectric's words for the position of the zero: "Bottom Left Corner", "Center".
Triple corner_named(std::string_view s) {
    const auto has = [s](std::string_view word) { return s.find(word) != kNone; };
    Triple t;
    t.value.x = has("LEFT") ? -1.0 : has("RIGHT") ? 1.0 : 0.0;
    t.value.y = has("BOTTOM") ? -1.0 : has("TOP") ? 1.0 : 0.0;
    return t;
}

// Reads three numbers, with or without units: "0.00mm, 0.00mm, -1.00mm".
std::optional<Triple> triple_at(std::string_view s) {
    const auto parts = text::split(s, ',');
    if (parts.size() < 3) return std::nullopt;
    Triple t;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view part = trimmed(parts[static_cast<std::size_t>(axis)]);
        const auto q = text::quantity_at(part, 0);
        if (!q || std::abs(q->value) > 1e6) return std::nullopt;
        t.value[axis] = q->value;
        if (q->unit != Unit::None) t.unit = q->unit;
    }
    return t;
}

}  // namespace

std::optional<ToolRemark> read_tool_remark(std::string_view comment) {
    const std::string upper = uppercase(trimmed(comment));
    if (upper.size() < 3) return std::nullopt;
    for (const auto& form :
         {read_fusion, read_cutviewer, read_piped, read_kiri, read_drill_table, read_tool_phrase}) {
        if (auto remark = form(upper)) {
            // FreeCAD writes this comment in mm, whatever the unit of the program.
            if (upper.starts_with("COMPENSATED TOOL PATH")) remark->unit = Unit::Millimetre;
            if (remark->spec.kind == ToolKind::Tap) remark->spec.left_hand = names_left_hand(upper);
            remark->spec.description = std::string(trimmed(comment));
            return remark;
        }
    }
    return std::nullopt;
}

std::optional<StockRemark> read_stock_remark(std::string_view comment) {
    const std::string upper = uppercase(trimmed(comment));
    const std::string_view s = upper;
    StockRemark remark;
    const auto starts = [s](std::string_view key) { return s.substr(0, key.size()) == key; };
    if (starts("STOCK/BLOCK,")) {
        const auto size = triple_at(s.substr(12));
        if (!size || size->value.x <= 0 || size->value.y <= 0 || size->value.z <= 0) {
            return std::nullopt;
        }
        remark.first = *size;
        std::size_t comma = 11;
        for (int i = 0; i < 3 && comma != kNone; ++i)
            comma = s.find(',', comma + 1);
        if (comma != kNone) {
            if (const auto zero = triple_at(s.substr(comma + 1))) remark.second = *zero;
        }
        return remark;
    }
    using What = StockRemark::What;
    const std::size_t equals = s.find('=');
    if (s == "MATERIAL SIZE" || s == "MATERIAL SIZE:") {
        remark.what = What::Heading;
        return remark;
    }
    if (starts("STOCK X:") || starts("STOCK X=") || starts("MATERIAL SIZE: X")) {
        const auto size = named_size(s);
        if (!size) return std::nullopt;
        remark.what = What::Size;
        remark.first = *size;
        return remark;
    }
    if (const auto zero = zero_named(s)) {
        remark.what = What::Zero;
        remark.first = *zero;
        return remark;
    }
    if (const auto behind = find_after_block_name(s)) {
        auto size = product_at(s, *behind);
        if (!size) size = named_lengths(s);
        if (size) {
            remark.what = What::Size;
            remark.first = *size;
            return remark;
        }
    }
    if (starts("MATERIAL ORIGIN:")) {
        const auto origin = named_triple(s.substr(16));
        const bool at_corner = origin && origin->value == Vec3{};
        remark.what = at_corner ? What::ZeroXY : What::Elsewhere;
        remark.first.value = {-1, -1, 0};
        return remark;
    }
    if (starts("$SETPARTSIZE(")) {  // CNCSimulator
        const auto size = triple_at(s.substr(13, s.find(')') - 13));
        if (!size || size->value.x <= 0 || size->value.y <= 0 || size->value.z <= 0) {
            return std::nullopt;
        }
        remark.what = What::Size;
        remark.first = *size;
        return remark;
    }
    // Heidenhain's words, which simulators use in comments: BLK FORM 0.1 Z X+0 Y+0 Z-20.
    for (const auto& [key, what] :
         {std::pair{"BLK FORM 0.1", What::Min}, {"BLK FORM 0.2", What::Max}}) {
        if (!starts(key)) continue;
        std::string_view corner = trimmed(s.substr(12));
        if (corner.substr(0, 2) == "Z ") corner.remove_prefix(2);  // axis of the tool
        const auto at = named_triple(corner);
        if (!at) return std::nullopt;
        remark.what = what;
        remark.first = *at;
        return remark;
    }
    if (starts("X MIN =") || starts("X MAX =")) {  // Vectric: the corners of the material
        const std::string_view end = s.substr(1, 5);
        Triple corner;
        for (int axis = 0; axis < 3; ++axis) {
            const std::string key = std::string(1, static_cast<char>('X' + axis)).append(end);
            const auto q = value_after(s, key, "= ");
            if (!q || std::abs(q->value) > 1e6) return std::nullopt;
            corner.value[axis] = q->value;
            if (q->unit != Unit::None) corner.unit = q->unit;
        }
        remark.what = end == " MIN " ? What::Min : What::Max;
        remark.first = corner;
        return remark;
    }
    if (starts("Z ORIGIN FOR MATERIAL") && equals != kNone) {
        const bool bed = s.find("TABLE", equals) != kNone || s.find("BED", equals) != kNone;
        remark.what = bed ? What::ZeroAtBed : What::ZeroAtTop;
        return remark;
    }
    if (starts("XY ORIGIN FOR MATERIAL") && equals != kNone) {
        remark.what = What::ZeroXY;
        remark.first = corner_named(s.substr(equals));
        return remark;
    }
    for (const auto& [key, what] :
         {std::pair{"STOCKMIN:", What::Min}, {"STOCKMAX:", What::Max}, {"FROM/", What::Start}}) {
        if (!starts(key)) continue;
        const auto corner = triple_at(s.substr(std::string_view(key).size()));
        if (!corner) return std::nullopt;
        remark.what = what;
        remark.first = *corner;
        return remark;
    }
    return std::nullopt;
}

std::optional<Triple> read_size_remark(std::string_view comment) {
    const std::string upper = uppercase(trimmed(comment));
    return upper.empty() || upper.front() != 'X' ? std::nullopt : named_size(upper);
}

std::optional<KeyedRemark> read_keyed_remark(std::string_view comment) {
    using Key = KeyedRemark::Key;
    static constexpr std::pair<std::string_view, Key> kKeys[] = {
        {"TOOL NUMBER", Key::ToolNumber},   {"TOOL NO", Key::ToolNumber},
        {"DIAMETER", Key::Diameter},        {"TOOL DIAMETER", Key::Diameter},
        {"TIP RADIUS", Key::TipRadius},     {"TOOL TIP RADIUS", Key::TipRadius},
        {"CORNER RADIUS", Key::TipRadius},  {"TAPER ANGLE", Key::Taper},
        {"TOOL TYPE", Key::ToolType},       {"SHAPE", Key::ToolType},
        {"TORUS_RADIUS", Key::TorusRadius}, {"TOOL_RADIUS", Key::Diameter}};
    const std::string upper = uppercase(trimmed(comment));
    const std::string_view s = upper;
    const std::size_t colon = s.find_first_of(":=");
    if (colon == kNone) return std::nullopt;
    const std::string_view key = trimmed(s.substr(0, colon));
    const bool is_radius = key == "TOOL_RADIUS";
    const bool of_pycam = is_radius || key == "SHAPE" || key == "TORUS_RADIUS";
    if (of_pycam != (s[colon] == '=')) return std::nullopt;
    const auto* found = std::find_if(std::begin(kKeys), std::end(kKeys),
                                     [key](const auto& k) { return k.first == key; });
    if (found == std::end(kKeys)) return std::nullopt;
    const std::string_view rest = trimmed(s.substr(colon + 1));
    KeyedRemark remark{found->second, 0.0, Unit::None, std::nullopt};
    if (remark.key == Key::ToolType) {
        remark.kind = words::kind_named(rest);
        return remark;
    }
    const auto q = rest.empty() ? std::nullopt : text::quantity_at(rest, 0);
    if (!q || q->end != rest.size() || q->value < 0) return std::nullopt;
    remark.value = is_radius ? 2 * q->value : q->value;
    remark.unit = q->is_fraction && q->unit == Unit::None ? Unit::Inch : q->unit;
    return remark;
}

}  // namespace ncsim::toolpath
