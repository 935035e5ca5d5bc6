// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads free-form tool descriptions in two steps. A pass over the words collects the values; then
// the whole is judged: it is a description if a single number can be the size, and if the rest
// consists of typical words of tool descriptions.
#include "tools/tool_phrase.h"

#include "tools/tool_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ncsim::toolpath {

namespace {

using text::Quantity;
using text::Unit;
using words::Role;
using words::Token;

bool is_whole(const Quantity& q) {
    return q.value == std::floor(q.value) && !q.is_fraction && q.unit == Unit::None;
}

bool is_length(const Quantity& q) {
    return q.unit != Unit::Degree;
}

// Converts a length to `unit`; a length without unit keeps its value. 0 if `unit` is None and the
// length has a unit.
double convert_to_unit(const Quantity& q, Unit unit) {
    if (q.unit == unit || q.unit == Unit::None) return q.value;
    if (unit == Unit::Millimetre) return 25.4 * q.value;
    return unit == Unit::Inch ? q.value / 25.4 : 0.0;
}

class Phrase {
public:
    explicit Phrase(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

    std::optional<ToolRemark> read() {
        for (at_ = 0; at_ < tokens_.size() && !ended_; ++at_) {
            const Token& token = tokens_[at_];
            if (token.is_number()) {
                take_number();
            } else if (token.is_word()) {
                take_word();
            } else {
                take_mark();
            }
        }
        if (!choose_size() || !is_description()) return std::nullopt;
        return remark();
    }

private:
    // A number that may be the size of the tool.
    struct Size {
        enum class How { Plain, Gauge, Thread } how = How::Plain;
        Quantity quantity;
        std::size_t at = 0;
        int segment = 0;
        bool is_explicit() const {
            return how != How::Plain || quantity.unit != Unit::None || quantity.is_fraction;
        }
        bool is_whole_number() const { return how == How::Plain && is_whole(quantity); }
    };

    const Token* token(std::size_t i) const { return i < tokens_.size() ? &tokens_[i] : nullptr; }
    bool mark_at(std::size_t i, char mark) const {
        return i < tokens_.size() && tokens_[i].is(mark);
    }
    bool number_at(std::size_t i) const { return i < tokens_.size() && tokens_[i].is_number(); }

    // Counts segments: parts of a comment with different subjects, as in T1 | 1/4 ENDMILL | H1.
    void take_mark() {
        const Token& t = tokens_[at_];
        const bool between = !t.joined_left && !t.joined_right;
        if (t.is('|') || t.is(';') || t.is(',') || (between && (t.is('-') || t.is('/'))))
            ++segment_;
        if (t.is('#') && number_at(at_ + 1) && is_whole(tokens_[at_ + 1].quantity)) {
            take_gauge(at_ + 1);
        } else if (t.is('<') || t.is('[')) {
            ++expressions_;  // expressions of a program; they contain sizes, too
        }
    }

    // Returns the index of the number after a key: D=10, DIA. - .25, (Bit diameter: 1/8"). 0 if
    // there is none.
    std::size_t value_of_key(std::size_t key) const {
        std::size_t i = key + 1;
        bool separated = false;
        while (i < tokens_.size() && !tokens_[i].is_number()) {
            const Token& t = tokens_[i];
            if (!(t.is('=') || t.is(':') || t.is('.') || t.is('-') || t.is('{') || t.is('(') ||
                  t.is('#') || t.is('~'))) {
                return 0;
            }
            separated = separated || t.is('=') || t.is(':');
            ++i;
        }
        if (i >= tokens_.size()) return 0;
        // A single letter is a key only if the number cannot belong to another key.
        const bool glued = i == key + 1 && tokens_[i].joined_left;
        if (tokens_[key].text.size() == 1 && !glued && !separated) return 0;
        // `1/4 DIA 2 FLUTE`
        if (!glued && !separated && counts_flutes(i)) return 0;
        return i;
    }

    bool counts_flutes(std::size_t number) const {
        std::size_t i = number + 1;
        if (mark_at(i, '-')) ++i;
        const Token* next = token(i);
        if (!next || !next->is_word(Role::Flutes) || !is_whole(tokens_[number].quantity))
            return false;
        return next->text.size() > 1 || tokens_[number].joined_right;
    }

    void take_key(Role role, const Quantity& q, bool weak) {
        if (q.unit == Unit::Degree && role != Role::Angle) {
            if (role == Role::Tip) take_angle(q.value);
            return;
        }
        switch (role) {
            case Role::Diameter:
                if (!(weak ? weak_diameter_ : diameter_)) {
                    (weak ? weak_diameter_ : diameter_) = q;
                    key_segment_ = segment_;
                }
                break;
            case Role::ToolRadius:
                if (!diameter_) {
                    diameter_ = q;
                    diameter_->value *= 2;
                    key_segment_ = segment_;
                }
                break;
            case Role::CornerRadius: corner_ = q; break;
            case Role::Tip: tip_ = q; break;
            case Role::Angle: take_angle(q.value); break;
            case Role::FluteLength: flute_length_ = q; break;
            case Role::Shank: shank_ = q; break;
            case Role::StickOut: stick_out_ = q; break;
            case Role::Flutes: has_flutes_ = true; break;
            default: break;
        }
    }

    void take_angle(double degrees) {
        if (degrees >= 450 && degrees <= 1800) degrees /= 10;  // 90° whose degree sign became 0
        if (degrees > 0 && degrees < 180) angle_ = degrees;
    }

    void take_word() {
        const Token& word = tokens_[at_];
        const Token* next = token(at_ + 1);
        const bool drill_follows =
            next && next->is_word(Role::Noun) && next->kind == ToolKind::Drill;
        if (word.text.size() == 1 && drill_follows && !word.joined_left && word.text != "A") {
            return take_letter(word.text.front());  // F DRILL
        }
        const bool is_first = words_seen_++ == 0;
        is_chamfer_ = is_chamfer_ || word.text.starts_with("CHAMFER") ||
                      word.text.starts_with("FASENFR") || word.text.starts_with("FASFR");
        // #1 DRILL - 6MM SLIDE REAMER DRILL: the second part is the purpose of the first.
        const bool is_aside = has_noun_ && word.role == Role::Noun && segment_ != noun_segment_;
        if (word.rank > rank_ && !is_aside) kind_ = word.kind, rank_ = word.rank;
        switch (word.role) {
            case Role::Noun:
                if (!has_noun_) noun_at_ = at_, noun_segment_ = segment_;
                has_noun_ = true;
                is_mill_ = word.rank != 2 && word.rank != 3;
                if (word.rank == 3) is_thread_ = true;
                if (word.text == "CENTER DRILL" || word.text == "CENTRE DRILL")
                    is_centre_drill_ = true;
                has_reamer_ = has_reamer_ || word.text.find("REAMER") != std::string::npos;
                break;
            case Role::Shape:
                has_shape_ = true;
                if (noun_at_ == kNowhere) noun_at_ = at_, noun_segment_ = segment_;
                break;
            case Role::Attribute: break;
            case Role::Tool: take_tool(is_first); break;
            case Role::Gauge: take_gauge_word(); break;
            case Role::Purpose:
                if (!is_first) ended_ = true;
                break;
            case Role::Prose: prose_.push_back({at_, segment_}); break;
            case Role::Unknown:
                if (word.text == "X" || word.text == "BY") break;
                if (!word.joined_left || at_ == 0 || !tokens_[at_ - 1].is_number()) ++unknown_;
                break;
            default: take_key_word(); break;
        }
    }

    void take_key_word() {
        const Token& word = tokens_[at_];
        const std::size_t value = value_of_key(at_);
        if (value == 0) {
            if (word.role == Role::Diameter && word.text.size() > 1) dangling_ = true;
            if (word.text.size() == 1 && word.role != Role::Flutes) ++letters_;
            return;
        }
        const Quantity& q = tokens_[value].quantity;
        if (word.role == Role::Flutes && !is_whole(q)) return;
        const bool is_register = word.role == Role::Other;
        if (is_register) {
            if (word.text == "H") register_ = q.value;
            if (word.text == "M" && tokens_[value].joined_left && !word.joined_left) {
                add({Size::How::Thread, millimetres(q), value, segment_});
                skip_pitch(value);
                return;
            }
        } else {
            const bool weak = word.text.size() == 1 && value == at_ + 1;  // D10 may be a register
            take_key(word.role, q, weak);
        }
        at_ = value;
    }

    static Quantity millimetres(Quantity q) {
        q.unit = Unit::Millimetre;
        return q;
    }

    // Skips a pitch, as in M8 X 1.25, M12X1.75, and keeps it.
    void skip_pitch(std::size_t value) {
        at_ = value;
        const Token* x = token(value + 1);
        if (x && (x->text == "X" || x->is('*') || x->is('-')) && number_at(value + 2)) {
            at_ = value + 2;
            pitch_mm_ = tokens_[at_].quantity.value;
        } else if (!pitch_mm_) {
            pitch_mm_ = words::coarse_pitch(tokens_[value].quantity.value);
        }
    }

    void take_tool(bool is_first) {
        const Token& word = tokens_[at_];
        says_tool_ = says_tool_ || word.text.size() > 1;
        if (is_first) tool_first_ = true;
        std::size_t i = at_ + 1;
        bool hash = false;
        while (i < tokens_.size() && !tokens_[i].is_number()) {
            const Token& t = tokens_[i];
            const bool no = t.is_word(Role::Gauge) && t.text != "LETTER" && t.text != "LTR";
            if (!(t.is('.') || t.is('#') || t.is('-') || t.is(':') || t.is('=') || no)) return;
            hash = hash || t.is('#');
            ++i;
        }
        if (i >= tokens_.size() || !is_whole(tokens_[i].quantity)) return;
        const bool glued = i == at_ + 1 && tokens_[i].joined_left;
        if (word.text == "T" && !glued && !hash) return;
        if (word.text == "T" && word.joined_left) return;
        if (counts_flutes(i)) return;
        const Quantity& q = tokens_[i].quantity;
        if (tokens_[i].text.find('.') != std::string::npos) return;
        if (tokens_[i].joined_right && token(i + 1) && token(i + 1)->is_word()) return;  // T15A
        if (q.value < 1 || q.value >= 1e8) return;
        if (number_ == 0) {
            number_ = static_cast<int>(q.value);
            numbered_first_ = is_first;
        }
        at_ = i;
    }

    // Reads NO. 7, LETTER F.
    void take_gauge_word() {
        std::size_t i = at_ + 1;
        while (mark_at(i, '.') || mark_at(i, '#') || mark_at(i, '-'))
            ++i;
        if (number_at(i) && is_whole(tokens_[i].quantity)) return take_gauge(i);
        const Token* next = token(i);
        if (next && next->is_word() && next->text.size() == 1) {
            at_ = i;
            take_letter(next->text.front());
        }
    }

    void take_letter(char letter) {
        ++words_seen_;
        Quantity q;
        q.value = words::letter_drill(letter);
        q.unit = Unit::Inch;
        add({Size::How::Gauge, q, at_, segment_});
    }

    void take_gauge(std::size_t number) {
        Quantity q = tokens_[number].quantity;
        at_ = number;
        gauge_ = static_cast<int>(std::min(q.value, 1000.0));
        q.unit = Unit::Inch;
        q.value = 0.0;  // follows from the kind, later
        add({Size::How::Gauge, q, number, segment_});
        skip_thread(number);
    }

    // Skips the turns per inch of #10-32, 1/4-20, 1/4"-20, and keeps the pitch.
    bool skip_thread(std::size_t number) {
        if (!mark_at(number + 1, '-') || !tokens_[number + 1].joined_left ||
            !tokens_[number + 1].joined_right || !number_at(number + 2) ||
            !is_whole(tokens_[number + 2].quantity) || counts_flutes(number + 2)) {
            return false;
        }
        at_ = number + 2;
        if (const double turns = tokens_[at_].quantity.value; turns > 0.0) pitch_mm_ = 25.4 / turns;
        return true;
    }

    void take_number() {
        const Token& t = tokens_[at_];
        const Quantity& q = t.quantity;
        const Token* next = token(at_ + 1);
        if (next && at_ == 0 && next->is('=') && is_whole(q) && q.value >= 1 && q.value < 1e8) {
            number_ = static_cast<int>(q.value);
            numbered_first_ = true;
            return;
        }
        if (q.unit == Unit::Degree) return take_angle(q.value);
        if (counts_flutes(at_)) {
            has_flutes_ = true;
            at_ += mark_at(at_ + 1, '-') ? 2 : 1;
            return;
        }
        const Token* before = at_ > 0 ? &tokens_[at_ - 1] : nullptr;
        const bool follows_x = before && (before->text == "X" || before->is('*')) && at_ > 1 &&
                               tokens_[at_ - 2].is_number();
        if (follows_x) return take_second(q);
        if (before && before->is_word() && t.joined_left) return;  // DRILL2, H21
        if (take_value_before_key()) return;
        if (next && next->is_word() && t.joined_right && !q.is_fraction && q.unit == Unit::None &&
            next->text != "X" && (next->role != Role::Diameter || next->text.size() == 1)) {
            return;  // 27BIT, 163A
        }
        const bool fraction_or_whole = q.is_fraction || is_whole(q);
        const std::size_t number = at_;
        if (fraction_or_whole && (q.unit == Unit::None || q.unit == Unit::Inch) &&
            skip_thread(number)) {
            Quantity screw = q;
            if (!q.is_fraction)
                screw.value = words::number_screw(static_cast<int>(std::min(q.value, 1000.0)));
            screw.unit = Unit::Inch;
            add({Size::How::Thread, screw, number, segment_});
            return;
        }
        add({Size::How::Plain, q, at_, segment_});
    }

    // Reads .250 DIA, 1. RAD, 0.5R, 22 LOC, 2500 RPM.
    bool take_value_before_key() {
        std::size_t i = at_ + 1;
        const Token* key = token(i);
        if (!key || !key->is_word() || key->role < Role::Diameter || key->role > Role::Other ||
            key->role == Role::Gauge || key->role == Role::Flutes) {
            return false;
        }
        const bool one_letter = key->text.size() == 1;  // 3D is not a diameter
        if (one_letter && !(tokens_[at_].joined_right && key->role == Role::CornerRadius))
            return false;
        const std::size_t value = value_of_key(i);
        // A key has a single number. The number after the key takes precedence, except for degrees,
        // which follow their number, and in a row such as 22 LOC 10 SHANK 40 STICKOUT.
        if (value != 0 && !is_degree(*key) && !ends_with_key(value)) return false;
        take_key(key->role, tokens_[at_].quantity, false);
        if (key->role == Role::Diameter && key->text.size() > 1) dangling_ = false;
        at_ = i;
        return true;
    }

    // True behind the size of a tool if keys follow numbers up to the last key: no number is left
    // for that key. `value`: the number after the first key.
    bool ends_with_key(std::size_t value) const {
        if (sizes_.empty() && !diameter_) return false;
        while (value != 0) {
            const Token* key = token(value + 1);
            if (!number_at(value) || !key || !key->is_word() || key->text.size() == 1 ||
                key->role < Role::Diameter || key->role > Role::Other || key->role == Role::Gauge ||
                key->role == Role::Flutes) {
                return false;
            }
            value = value_of_key(value + 1);
        }
        return true;
    }

    static bool is_degree(const Token& key) {
        return key.role == Role::Angle &&
               (key.text.substr(0, 3) == "DEG" || key.text.substr(0, 4) == "GRAD");
    }

    // Reads the second number of 2*8mm, 1/8 X 90, 14 X 1.25. It is not a diameter, but its unit
    // holds for the first.
    void take_second(const Quantity& q) {
        ++dimensions_;
        if (sizes_.empty() || sizes_.back().at + 2 != at_) return;
        Size& first = sizes_.back();
        if (q.unit == Unit::Degree) return take_angle(q.value);
        if (is_conical(kind_) || (token(at_ + 1) && is_conical(token(at_ + 1)->kind))) {
            if (is_whole(q) && q.value >= 20) return take_angle(q.value);
        }
        if (first.quantity.unit == Unit::None && !first.quantity.is_fraction) {
            first.quantity.unit = q.unit;
        }
    }

    void add(const Size& size) { sizes_.push_back(size); }

    // Returns the size of gauge #7, in inches, for drills, centre drills and taps.
    double gauge_size() const {
        if (is_centre_drill_) return words::centre_drill(gauge_);
        if (is_thread_ && !has_reamer_) return words::number_screw(gauge_);
        if (kind_ == ToolKind::Drill || has_reamer_) return words::number_drill(gauge_);
        return 0.0;
    }

    bool choose_size() {
        for (Size& size : sizes_) {
            if (size.how == Size::How::Gauge && size.quantity.value == 0.0) {
                size.quantity.value = gauge_size();
            }
        }
        std::erase_if(sizes_, [this](const Size& size) {
            // M6 TAP DRILL: the size is unknown.
            if (size.how == Size::How::Thread) return !is_thread_;
            return size.quantity.value <= 0.0;
        });
        const auto first_where = [this](auto&& matches) {
            const auto found = std::find_if(sizes_.begin(), sizes_.end(), matches);
            return found == sizes_.end() ? nullptr : &*found;
        };
        const auto before = [this](const Size& s) {
            return s.at < noun_at_ && noun_at_ != kNowhere;
        };
        named_ = first_where([&](const Size& s) { return before(s) && s.is_explicit(); });
        if (!named_) {
            named_ =
                first_where([&](const Size& s) { return before(s) && s.segment == noun_segment_; });
        }
        if (!named_) named_ = first_where([&](const Size& s) { return s.is_explicit(); });
        if (!named_ && !sizes_.empty()) named_ = &sizes_.front();
        if (weak_diameter_ && weak_diameter_->value == register_) weak_diameter_.reset();
        if (diameter_) {
            size_ = diameter_;
        } else if (named_ && (named_->is_explicit() || !weak_diameter_)) {
            size_ = named_->quantity;
        } else if (weak_diameter_) {
            size_ = weak_diameter_;
            is_weak_ = true;
        } else if (corner_ && kind_ == ToolKind::BallEndMill) {
            size_ = corner_;
            size_->value *= 2;
        } else if (tip_ && is_conical(kind_)) {
            size_ = tip_;
            is_tip_ = true;
        }
        return size_ && is_length(*size_) && size_->value > 0.0;
    }

    int prose_in(int segment) const {
        return static_cast<int>(std::count_if(prose_.begin(), prose_.end(),
                                              [=](const auto& p) { return p.second == segment; }));
    }

    // True if a mill is followed by its use: 6MM ENDMILL ROUGH POCKET.
    bool names_tool_then_use() const {
        return named_ && has_noun_ && is_mill_ && named_->is_explicit() && named_->at < noun_at_ &&
               prose_.size() <= 2 && prose_.front().first > noun_at_ &&
               (number_ > 0 || named_->at <= 1);
    }

    bool is_description() const {
        if (expressions_ > 0 && !has_noun_) return false;
        if (dimensions_ > 1) return false;  // a block
        if (!is_plausible()) return false;
        if (kind_ == ToolKind::CornerRoundingMill && !corner_) return false;
        const bool anchored = number_ > 0 && numbered_first_;
        if (!prose_.empty() && !names_tool_then_use()) {
            // Operations may stand next to a numbered tool, in segments of their own.
            const int where = diameter_ ? key_segment_ : named_ ? named_->segment : noun_segment_;
            if (number_ == 0 || prose_in(where) > 0) return false;
            if (has_noun_ && prose_in(noun_segment_) > 0) return false;
        }
        if (number_ == 0 && plain_sizes() > 1) return false;  // a table
        const int names = anchored ? 4 : number_ > 0 || tool_first_ ? 2 : has_noun_ ? 1 : 0;
        if (unknown_ > names) return false;
        if (dangling_ && !diameter_ && (!named_ || named_->how == Size::How::Gauge || !has_noun_)) {
            return false;
        }
        if (diameter_) {
            const bool alone = unknown_ == 0 && letters_ == 0;
            return number_ > 0 || has_noun_ || has_shape_ || tool_first_ || says_tool_ || alone;
        }
        if (is_weak_) {
            const bool cutter = has_noun_ || has_shape_ || number_ > 0 || tool_first_;
            return cutter ||
                   (corner_ && unknown_ == 0 && 2 * corner_->value <= weak_diameter_->value);
        }
        if (!named_) return has_noun_ || has_shape_;  // R3 BALL, ENGRAVE 20 DEG TIP 0.1
        if (has_noun_) return names_size();
        if (has_shape_) return shapes_size();
        if (has_flutes_) return !named_->is_whole_number() || number_ > 0;
        if (angle_) return named_->is_explicit() && unknown_ == 0;
        // T3 6MM; T9 : 16.0
        if ((anchored || tool_first_) && unknown_ == 0 && sizes_.size() == 1) {
            if (named_->is_explicit()) return true;
            const std::size_t before = named_->at == 0 ? kNowhere : named_->at - 1;
            return number_ > 0 && (mark_at(before, ':') || mark_at(before, '='));
        }
        return false;
    }

    // True if the number is the size. A number without unit next to the name of a tool may count
    // holes, passes or operations.
    bool names_size() const {
        if (named_->is_explicit()) return true;
        if (named_->segment != noun_segment_) return false;
        const bool before = named_->at < noun_at_;
        if (number_ > 0) return before || !named_->is_whole_number() || is_mill_;
        if (unknown_ > 0) return false;
        if (!named_->is_whole_number()) return true;
        return before && is_mill_ && rank_ > 0 && named_->quantity.value >= 2;
    }

    // True for BALL 6MM, but not for CHAMFER 1MM.
    bool shapes_size() const {
        if (is_conical(kind_) && !angle_ && !tip_ && number_ == 0) return false;
        if (number_ > 0) return true;
        const double mm = convert_to_unit(named_->quantity, Unit::Millimetre);
        return named_->is_explicit() && unknown_ == 0 && mm <= 60.0;
    }

    std::size_t plain_sizes() const {
        return static_cast<std::size_t>(std::count_if(
            sizes_.begin(), sizes_.end(), [](const Size& s) { return !s.is_explicit(); }));
    }

    bool is_plausible() const {
        const bool inch = unit_of(*size_) == Unit::Inch;
        return size_->value * (inch ? 25.4 : 1.0) >= 0.001 && size_->value <= (inch ? 13.0 : 320.0);
    }

    static Unit unit_of(const Quantity& q) {
        return q.is_fraction && q.unit == Unit::None ? Unit::Inch : q.unit;
    }

    ToolRemark remark() const {
        ToolRemark result;
        ToolSpec& spec = result.spec;
        spec.number = number_;
        spec.kind = kind_;
        spec.diameter = size_->value;
        result.unit = unit_of(*size_);
        result.certain = diameter_.has_value();
        const auto length = [&result](const std::optional<Quantity>& q) -> std::optional<double> {
            if (!q) return std::nullopt;
            const double value =
                convert_to_unit(*q, result.unit == Unit::None ? unit_of(*q) : result.unit);
            const bool same = result.unit != Unit::None || unit_of(*q) == Unit::None;
            return same && value > 0 ? std::optional(value) : std::nullopt;
        };
        if (!kind_ && angle_) spec.kind = ToolKind::VCutter;
        if (is_conical(spec.kind)) {
            spec.angle = angle_;
            if (is_chamfer_ && angle_ == 45.0) spec.angle = 90.0;  // 45 degrees is per side
            spec.tip_diameter = length(tip_);
        }
        if (spec.kind == ToolKind::DovetailMill && angle_ && *angle_ < 90.0)
            spec.taper = dovetail_taper(*angle_);
        if (spec.kind == ToolKind::Drill) spec.angle = angle_;
        if (spec.kind == ToolKind::TaperedEndMill && angle_) spec.taper = std::min(*angle_, 80.0);
        if (const auto corner = length(corner_); corner && *corner <= 0.505 * *spec.diameter) {
            const bool is_round = spec.kind != ToolKind::Drill && !is_conical(spec.kind);
            if (is_round) spec.corner_radius = corner;
            // The radius is more reliable than the name.
            if (is_round && spec.kind == ToolKind::FlatEndMill) spec.kind.reset();
        }
        if (spec.kind == ToolKind::Tap && pitch_mm_.value_or(0.0) > 0.0) spec.pitch = pitch_mm_;
        spec.length = length(flute_length_);
        spec.shank_diameter = length(shank_);
        spec.stick_out = length(stick_out_);
        // The size is the small end of an engraving cone if the large end is unspecified.
        const double mm = *spec.diameter * (result.unit == Unit::Inch ? 25.4 : 1.0);
        const bool is_small = angle_ && result.unit != Unit::None && mm <= 1.0;
        if (is_conical(spec.kind) && !diameter_ && (is_tip_ || (!tip_ && is_small))) {
            spec.tip_diameter = std::exchange(spec.diameter, std::nullopt);
        }
        return result;
    }

    static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    bool ended_ = false;
    int segment_ = 0;
    // Collected values.
    int number_ = 0;
    bool numbered_first_ = false, tool_first_ = false, says_tool_ = false;
    std::optional<ToolKind> kind_;
    int rank_ = 0;
    bool has_noun_ = false, has_shape_ = false, has_flutes_ = false;
    bool is_mill_ = false, is_thread_ = false, is_centre_drill_ = false, has_reamer_ = false;
    std::size_t noun_at_ = kNowhere;
    int noun_segment_ = 0, key_segment_ = 0;
    std::vector<Size> sizes_;
    int gauge_ = 0;
    std::optional<Quantity> diameter_, weak_diameter_, corner_, tip_, flute_length_, shank_,
        stick_out_;
    std::optional<double> angle_;
    std::optional<double> pitch_mm_;  // of a thread
    bool is_chamfer_ = false;
    double register_ = 0.0;
    // Evidence against a description of a tool.
    int words_seen_ = 0, unknown_ = 0, letters_ = 0, expressions_ = 0, dimensions_ = 0;
    bool dangling_ = false, is_weak_ = false, is_tip_ = false;
    std::vector<std::pair<std::size_t, int>> prose_;  // token indices and segments
    const Size* named_ = nullptr;
    std::optional<Quantity> size_;
};

}  // namespace

std::optional<ToolRemark> read_tool_phrase(std::string_view comment) {
    if (comment.size() > words::kLongest) return std::nullopt;
    std::string plain = words::plain_upper(trimmed(comment));
    std::string_view s = plain;
    const bool digits = s.find_first_of("0123456789") != std::string_view::npos;
    if (!digits && s.find("DRILL") == std::string_view::npos) return std::nullopt;
    for (const std::string_view log : {"DEBUG", "PRINT", "LOG,", "AXIS,", "PROBE"}) {
        if (s.substr(0, log.size()) == log) return std::nullopt;
    }
    if (s.substr(0, 4) == "MSG," || s.substr(0, 4) == "MSG:") s = trimmed(s.substr(4));
    if (s.empty() || s.front() == '=') return std::nullopt;
    return Phrase(words::tokens_of(s)).read();
}

}  // namespace ncsim::toolpath
