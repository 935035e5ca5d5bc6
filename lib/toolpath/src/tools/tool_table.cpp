// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads tools and stock in the comments of a program in two steps. A pass over the blocks collects
// remarks in order, tool calls, and units; then every remark gets its tool and its unit.
#include "ncsim/toolpath/tool_table.h"

#include "ncsim/gcode/language.h"
#include "ncsim/gcode/parser.h"

#include "tools/comment_text.h"
#include "tools/tool_comment.h"
#include "tools/tool_messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace ncsim::toolpath {

namespace {

using gcode::Block;
using text::Unit;

struct PlacedRemark {
    ToolRemark remark;
    gcode::SourceSpan span;
    std::string text;
    int owner = 0;  // tool number; 0 while unknown
};

bool is_word(const gcode::Word& word, char letter, double number) {
    return word.letter == letter && word.literal && !word.comma && word.number == number;
}

// True for moves of a working tool. Moves to a reference position, upwards, or in machine
// coordinates, and offsets precede tool changes and do not count.
bool is_move(const Block& block) {
    static constexpr std::array kBeforeChange{4.0, 10.0, 28.0, 30.0, 52.0, 53.0, 92.0};
    const bool is_before_change =
        std::any_of(block.words.begin(), block.words.end(), [](const gcode::Word& w) {
            return w.letter == 'G' && w.literal &&
                   std::ranges::find(kBeforeChange, w.number) != kBeforeChange.end();
        });
    const auto has = [&block](char letter) {
        return std::ranges::any_of(block.words,
                                   [letter](const gcode::Word& w) { return w.letter == letter; });
    };
    const bool goes_up =
        has('Z') && !has('X') && !has('Y') &&
        std::ranges::any_of(block.words, [](const gcode::Word& w) { return is_word(w, 'G', 0); });
    if (is_before_change || goes_up) return false;
    return std::any_of(block.words.begin(), block.words.end(), [](const gcode::Word& w) {
        return w.letter == 'X' || w.letter == 'Y' || w.letter == 'Z';
    });
}

// True for a line that holds a comment alone, after its number.
bool is_comment_alone(const Block& block) {
    std::string_view text = block.text;
    const auto skip = [&text](std::string_view bytes) {
        text.remove_prefix(std::min(text.find_first_not_of(bytes), text.size()));
    };
    skip(" \t");
    if (text.starts_with('N') || text.starts_with('n')) text.remove_prefix(1);
    skip("0123456789 \t");
    // In languages other than G-code, the text has no comments.
    constexpr std::string_view kBegin = "(;*";
    return block.words.empty() &&
           (text.empty() || kBegin.find(text.front()) != std::string_view::npos);
}

void scale(ToolSpec& spec, double factor) {
    for (auto* length : {&spec.diameter, &spec.corner_radius, &spec.tip_diameter, &spec.length,
                         &spec.neck_diameter, &spec.neck_length, &spec.shank_diameter,
                         &spec.shank_length, &spec.stick_out}) {
        if (*length) **length *= factor;
    }
    for (ToolPiece& piece : spec.pieces) {
        for (ProfilePoint& p : piece.profile) {
            p.radius *= factor, p.height *= factor, p.fillet *= factor;
        }
    }
}

class NoteReader {
public:
    explicit NoteReader(bool default_inches)
        : inches_(default_inches), inches_first_(default_inches) {}

    void read(const Block& block) {
        if (!block.words.empty()) in_list_ = false;  // lists are on lines of their own
        in_title_ = block.control.word == gcode::ControlWord::ProgramNumber;
        for (const gcode::Comment& comment : block.comments) {
            if (const int tool = gcode::tool_called_in(comment); tool > 0) {
                call_tool(tool);
            } else if (!read(comment) && is_comment_alone(block)) {
                note_operation(comment);
            }
        }
        for (const gcode::Word& word : block.words) {
            if (is_word(word, 'G', 20) || is_word(word, 'G', 21)) set_units(word.number == 20);
            if (word.letter == 'T' && word.literal && word.number >= 1 && word.number < 1e8) {
                call_tool(static_cast<int>(word.number));
            }
        }
        if (is_move(block)) end_waiting();
    }

    ProgramNotes finish() {
        end_waiting();
        choose_operations();
        place_listed();
        for (PlacedRemark& placed : remarks_)
            keep(placed);
        if (block_) {
            const auto in_mm = [this](const Triple& t) {
                return factor(t.unit, inches_first_) * t.value;
            };
            const Vec3 size = in_mm(block_->first);
            const Vec3 min = Vec3{} - in_mm(block_->second);
            set_stock({min, min + size}, block_span_, block_text_);
        } else if (min_ && max_) {
            Box box;
            box.add(factor(min_->unit, inches_first_) * min_->value);
            box.add(factor(max_->unit, inches_first_) * max_->value);
            set_stock(box, block_span_, block_text_);
        } else if (size_ && !size_is_elsewhere_) {
            // Vectric's default zero, unless specified: the lower left corner, on top.
            const Vec3 size = factor(size_->unit, inches_first_) * size_->value;
            Vec3 min{(-1 - zero_xy_.x) / 2 * size.x, (-1 - zero_xy_.y) / 2 * size.y,
                     zero_at_bed_ ? 0.0 : -size.z};
            set_stock({min, min + size}, block_span_, block_text_);
            if (notes_.stock) notes_.stock->place_assumed = !zero_specified_;
        }
        if (start_) notes_.start = factor(start_->unit, inches_first_) * start_->value;
        return std::move(notes_);
    }

private:
    static double factor(Unit unit, bool inches) {
        const bool is_inch = unit == Unit::None ? inches : unit == Unit::Inch;
        return is_inch ? 25.4 : 1.0;
    }

    // Returns true if the comment is about the tools or the stock.
    bool read(const gcode::Comment& comment) {
        const bool after_heading = std::exchange(size_expected_, false);
        if (after_heading) {
            if (const auto size = read_size_remark(comment.text)) {
                StockRemark remark;
                remark.what = StockRemark::What::Size;
                remark.first = *size;
                take_stock(remark, comment);
                return true;
            }
        }
        const std::string heading = uppercase(trimmed(comment.text));
        if (heading == "REQUIRED TOOLS:") {
            in_list_ = true;
            return true;
        }
        // Nested parentheses are a single comment; the inner pair may be the remark.
        if (auto stock = read_stock_remark(comment.text)) {
            take_stock(*stock, comment);
        } else if (const auto keyed = read_keyed_remark(comment.text)) {
            take_keyed(*keyed, comment);
        } else if (auto tool = read_tool_remark(comment.text)) {
            PlacedRemark placed{std::move(*tool), comment.span, std::string(comment.text), 0};
            placed.owner = placed.remark.spec.number;
            // "O600 (TAP M8)" names the work of the program, not the first tool.
            if (placed.owner == 0 && in_title_) return false;
            if (placed.owner == 0 && in_list_) {
                listed_.push_back(std::move(placed));
                return true;
            }
            if (placed.owner == 0) waiting_.push_back(remarks_.size());
            remarks_.push_back(std::move(placed));
        } else {
            return false;
        }
        return true;
    }

    static constexpr int kMostOfOneName = 5;
    static constexpr std::size_t kMostNames = 200;

    void note_operation(const gcode::Comment& comment) {
        if (names_.size() > kMostNames) return;
        auto name = operation_name_of(comment.text);
        if (!name || ++names_[*name] > kMostOfOneName) return;
        notes_.operations.push_back({comment.span.line, std::move(*name)});
    }

    // Remarks that are repeated over and over are no names, and neither are very many.
    void choose_operations() {
        std::erase_if(notes_.operations, [this](const OperationName& operation) {
            return names_.size() > kMostNames || names_[operation.name] > kMostOfOneName;
        });
    }

    // Reads a PowerMill comment, with a key per comment. A repeated key starts the next tool.
    void take_keyed(const KeyedRemark& keyed, const gcode::Comment& comment) {
        using Key = KeyedRemark::Key;
        const unsigned bit = 1U << static_cast<unsigned>(keyed.key);
        if ((keys_seen_ & bit) != 0) end_keyed();
        if (keys_seen_ == 0) keyed_ = {ToolRemark{}, comment.span, std::string(comment.text), 0};
        keys_seen_ |= bit;
        ToolSpec& spec = keyed_.remark.spec;
        switch (keyed.key) {
            case Key::ToolNumber:
                if (keyed.value >= 1 && keyed.value < 1e8) {
                    spec.number = static_cast<int>(keyed.value);
                }
                break;
            case Key::Diameter:
                if (keyed.value > 0) spec.diameter = keyed.value;
                keyed_.remark.unit = keyed.unit;
                keyed_.text = std::string(comment.text);
                keyed_.span = comment.span;
                break;
            case Key::TipRadius:
                if (keyed.value > 0) spec.corner_radius = keyed.value;
                break;
            case Key::Taper:
                if (keyed.value > 0) spec.taper = std::min(keyed.value, 80.0);
                break;
            case Key::ToolType: spec.kind = keyed.kind; break;
            case Key::TorusRadius: torus_radius_ = keyed.value; break;
        }
    }

    void end_keyed() {
        if (keys_seen_ == 0) return;
        keys_seen_ = 0;
        const double torus = std::exchange(torus_radius_, 0.0);
        if (keyed_.remark.spec.kind == ToolKind::BullNoseEndMill && torus > 0) {
            keyed_.remark.spec.corner_radius = torus;
        }
        if (!keyed_.remark.spec.diameter) return;
        keyed_.remark.certain = true;
        keyed_.remark.spec.description = keyed_.text;
        if (keyed_.remark.spec.kind == ToolKind::FlatEndMill && keyed_.remark.spec.corner_radius) {
            keyed_.remark.spec.kind.reset();  // the radius is more reliable than the name
        }
        keyed_.owner = keyed_.remark.spec.number;
        if (keyed_.owner == 0) waiting_.push_back(remarks_.size());
        remarks_.push_back(std::move(keyed_));
    }

    // Assigns the tools of a list without numbers to the calls, in order. A comment at a call takes
    // precedence.
    void place_listed() {
        for (std::size_t i = 0; i < listed_.size(); ++i) {
            if (i >= calls_.size() && (i > 0 || !calls_.empty())) break;
            listed_[i].owner = calls_.empty() ? 0 : calls_[i];
            remarks_.push_back(std::move(listed_[i]));
        }
    }

    void take_stock(const StockRemark& remark, const gcode::Comment& comment) {
        using What = StockRemark::What;
        const bool whole = remark.what == What::Block;
        if (remark.what == What::Start && !start_) start_ = remark.first;
        if (remark.what == What::Min && !min_) min_ = remark.first;
        if (remark.what == What::Max && !max_) max_ = remark.first;
        if (whole && !block_) block_ = remark;
        switch (remark.what) {
            case What::Heading: size_expected_ = true; return;
            case What::ZeroAtTop: zero_at_bed_ = false, zero_specified_ = true; return;
            case What::ZeroAtBed: zero_at_bed_ = true, zero_specified_ = true; return;
            case What::Zero:
                zero_xy_ = remark.first.value;
                zero_at_bed_ = remark.first.value.z < 0.0;
                zero_specified_ = true;
                return;
            case What::ZeroXY: zero_xy_ = remark.first.value, zero_specified_ = true; return;
            case What::Elsewhere: size_is_elsewhere_ = true; return;
            case What::Size:
                if (!size_) size_ = remark.first;
                break;
            default: break;
        }
        if (remark.what != What::Start && (block_text_.empty() || (whole && !whole_seen_))) {
            block_text_ = std::string(comment.text);
            block_span_ = comment.span;
        }
        whole_seen_ = whole_seen_ || whole;
    }

    void set_units(bool inches) {
        inches_ = inches;
        if (!units_seen_) inches_first_ = inches;
        units_seen_ = true;
    }

    // Assigns waiting remarks without a number to the tool of this call.
    void call_tool(int number) {
        end_keyed();
        last_tool_ = number;
        if (std::find(calls_.begin(), calls_.end(), number) == calls_.end()) {
            calls_.push_back(number);
        }
        if (units_seen_) tool_inches_.try_emplace(number, inches_);
        for (const std::size_t i : waiting_)
            remarks_[i].owner = number;
        waiting_.clear();
    }

    // Assigns waiting remarks to the tool in the spindle, because a move came before a call.
    void end_waiting() {
        end_keyed();
        for (const std::size_t i : waiting_)
            remarks_[i].owner = last_tool_;
        waiting_.clear();
    }

    // Keeps a remark. Owner 0: the program calls no tool, and the remark describes the tool in the
    // spindle.
    void keep(PlacedRemark& placed) {
        ToolSpec spec = placed.remark.spec;
        spec.number = placed.owner;
        const auto called = tool_inches_.find(placed.owner);
        const bool inches = called != tool_inches_.end() ? called->second : inches_first_;
        scale(spec, factor(placed.remark.unit, inches));
        if (!is_complete(spec)) return;
        const auto known =
            std::find_if(notes_.tools.begin(), notes_.tools.end(),
                         [&](const ToolEntry& e) { return e.spec.number == spec.number; });
        if (known == notes_.tools.end()) {
            notes_.tools.push_back(
                {std::move(spec), ValueSource::Comment, placed.span, placed.text});
            certain_.push_back(placed.remark.certain);
            return;
        }
        const auto index = static_cast<std::size_t>(known - notes_.tools.begin());
        // A stated diameter takes precedence over a diameter in a name.
        if (placed.remark.certain && !certain_[index]) {
            *known = {std::move(spec), ValueSource::Comment, placed.span, placed.text};
            certain_[index] = true;
        } else if (placed.remark.certain && known->spec.diameter && spec.diameter &&
                   std::abs(*known->spec.diameter - *spec.diameter) > 1e-3) {
            notes_.diagnostics.push_back(gcode::diagnostic_of(
                Message::CommentsDisagree, placed.span,
                {std::to_string(spec.number), text::number(*spec.diameter),
                 std::to_string(known->span.line), text::number(*known->spec.diameter)}));
        }
    }

    void set_stock(const Box& box, gcode::SourceSpan span, const std::string& text) {
        const Vec3 size = box.size();
        if (!text::is_sane_length(size.x) || !text::is_sane_length(size.y) ||
            !text::is_sane_length(size.z)) {
            notes_.diagnostics.push_back(gcode::diagnostic_of(Message::StockSize, span));
            return;
        }
        notes_.stock = StockEntry{{box}, ValueSource::Comment, span, text};
    }

    ProgramNotes notes_;
    std::vector<bool> certain_;                      // parallel to notes_.tools
    std::map<std::string, int, std::less<>> names_;  // of operations: how often each stands there
    std::vector<PlacedRemark> remarks_;
    std::vector<std::size_t> waiting_;  // remarks without an owner yet
    std::map<int, bool> tool_inches_;   // units at the first call
    std::optional<StockRemark> block_;
    std::optional<Triple> min_, max_, start_;
    std::optional<Triple> size_;  // without a position: Vectric, Kiri:Moto
    Vec3 zero_xy_{-1, -1, 0};
    bool zero_at_bed_ = false;
    bool zero_specified_ = false;
    bool size_is_elsewhere_ = false;
    bool size_expected_ = false;  // after "Material Size"
    bool in_title_ = false;       // The comment is in the line of an O number.
    bool in_list_ = false;        // after "Required tools:"
    std::vector<PlacedRemark> listed_;
    std::vector<int> calls_;  // tool numbers in the order of their first call
    PlacedRemark keyed_;
    double torus_radius_ = 0.0;
    unsigned keys_seen_ = 0;  // a bit per KeyedRemark::Key
    gcode::SourceSpan block_span_;
    std::string block_text_;
    bool whole_seen_ = false;
    bool inches_ = false;
    bool inches_first_ = false;
    bool units_seen_ = false;
    int last_tool_ = 0;
};

/// Returns the round bar that the program describes.
std::optional<StockEntry> cylinder_of(const gcode::SourceFile& program) {
    const std::optional<gcode::RoundBlank> found = gcode::round_blank_of(program);
    if (!found || !text::is_sane_length(found->radius.mm()) ||
        !text::is_sane_length(found->length.mm()))
        return std::nullopt;
    StockEntry entry;
    const double radius = found->radius.mm();
    Vec3 min{-radius, -radius, -radius};
    Vec3 max{radius, radius, radius};
    min[found->axis] = found->top.mm() - found->length.mm();
    max[found->axis] = found->top.mm();
    entry.box = {min, max};
    entry.is_round = true;
    entry.axis = found->axis;
    entry.specified_by = ValueSource::Comment;
    entry.span = found->span;
    entry.text = found->text;
    return entry;
}

}  // namespace

ProgramNotes read_notes(const gcode::SourceFile& program, bool default_inches) {
    NoteReader notes(default_inches);
    Block block;
    if (const auto reader = gcode::notes_of(program)) {
        while (reader->next(block))
            notes.read(block);
        ProgramNotes found = notes.finish();
        if (!found.stock) found.stock = cylinder_of(program);
        return found;
    }
    gcode::BlockReader reader(program);
    while (reader.next(block))
        notes.read(block);
    return notes.finish();
}

const ToolEntry* find_tool(const std::vector<ToolEntry>& tools, int number) {
    const auto found = std::find_if(tools.begin(), tools.end(), [number](const ToolEntry& e) {
        return e.spec.number == number;
    });
    return found == tools.end() ? nullptr : &*found;
}

}  // namespace ncsim::toolpath
