// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the draft of a set-up, feature by feature, and notes what could be wrong with it where it
// knows what then has to be told.
#pragma once

#include "support/random.h"
#include "support/set_up_draft.h"

#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>

namespace ncsim::test::set_ups {

class Writer {
public:
    explicit Writer(std::uint64_t seed) : random_(seed) {}

    void run();
    const Draft& draft() const { return draft_; }
    const std::vector<Fault>& faults() const { return faults_; }
    Random& random() { return random_; }

private:
    enum class Kind { OpenSlot, Loop, Pocket, Helix, Arcs, Drilling, Incremental, Rotated, Side };
    struct Feature {
        Kind kind = Kind::OpenSlot;
        std::size_t tool = 0;
        Length width = 0, x0 = 0;  // of its strip of the block
        Length depth = 0;
        std::vector<Length> passes;  // depths
        Length room = 0;             // from the middle of the strip for the middle of the tool
    };

    template <typename T>
    T one_of(std::initializer_list<T> choices) {
        return choices.begin()[random_.next() % choices.size()];
    }
    bool happens(int percent) { return random_.between(1, 100) <= percent; }
    Length mm(double value) const;
    Length within(double low, double high) { return random_.between(mm(low), mm(high)); }
    // Nothing, the least there is, or so much.
    Length margin(double low, double high);
    Length little() { return one_of({Length{1}, Length{10}, Length{100}, Length{1000}}); }

    std::string number(Length value) const { return decimal(value, draft_.inches ? 4 : 3); }
    std::string word(Axis axis, Length value) const { return kLetters[axis] + number(value); }

    void fault(std::string name, std::string verdict, std::string tells,
               std::set<std::string> may_tell, std::function<std::size_t(Draft&)> put_in);

    // --- what is made of what

    void choose_features();
    Feature feature_for(std::size_t index);
    bool is_open(const Feature& f) const;

    void lay_out();

    // --- blocks

    std::size_t line(const std::string& text);
    std::size_t next_line() const { return draft_.lines.size() + 1; }

    void reach(Axis axis, Length value, std::size_t where);
    std::size_t go(const char* code, std::initializer_list<std::pair<Axis, Length>> to,
                   const std::string& more = {});
    // Feed moves name F when they like to; the first has to.
    std::string feed();
    std::size_t feed_to(std::initializer_list<std::pair<Axis, Length>> to);
    void note_feed(std::size_t where);
    Tool& tool() { return draft_.tools[tool_]; }

    // This move cuts, by construction: no other feature is there.
    void cuts(std::size_t where, Length depth, Length sideways);
    void cuts_if_rapid(std::size_t where);

    // --- from feature to feature

    void write();
    void change_tool();
    // To where a feature begins, above all.
    void traverse(Length x, Length y, bool above_stock);
    void traverse_faults(Length from, Length to, std::size_t where);
    void retract(bool closed);
    void cut(const Feature& f);
    Length middle(const Feature& f) const { return f.x0 + f.width / 2; }
    Length radius() { return tool().diameter / 2; }
    Length middle_y() const { return (draft_.stock_min[Y] + draft_.stock_max[Y]) / 2; }

    // A tool beside the block at this depth is above the jaws, or in them.
    void jaw_fault(std::size_t where, Length z);
    void open_slot(const Feature& f);
    // What does not cut at its centre, from above.
    void plunge_fault(std::size_t down);
    // The same pass again and again, each a step deeper.
    void loop(const Feature& f);
    void cuts_in_loop(std::size_t where, Length step, Length depth);
    Length lower_to_start();
    void pocket(const Feature& f);
    // The next pass around the pocket goes on sideways, into the clamp.
    void clamp_fault(const Feature& f);
    // Straight down by more than any ramp allows.
    void blind_fault(std::size_t where, Length by);
    // The chords of a turn lie a rounding beside those of the last: flutes have to be longer.
    void spare(const Feature& f);
    void helix(const Feature& f);
    void arc_note(std::size_t where, Length cx, Length cy, Length r);
    // A slot along three quarters of a circle.
    void arcs(const Feature& f);
    void drilling(const Feature& f);
    void incremental(const Feature& f);
    void rotated(const Feature& f);
    // With a neck that is thinner than the cutter: in from the side, and out again.
    void side_slot(const Feature& f);

    // --- tools and machine, once all is known

    void finish_tools();
    void tool_faults(std::size_t index, Length clamp);
    static std::size_t first_above(const std::vector<std::pair<std::size_t, Length>>& all,
                                   Length limit);
    void length_faults(std::size_t index);
    void set_machine();
    void travel_fault(Axis axis, Length end, int sign);
    void general_faults();
    Random random_;
    Draft draft_;
    std::vector<Fault> faults_;
    std::vector<Feature> features_;
    Length top_ = 0, high_ = 0, clear_ = 0;  // of the block; of all; where traverses are
    Length home_height_ = 0;
    Length clamp_min_ = 0, clamp_max_ = 0;
    std::optional<Length> jaw_top_;
    bool has_table_ = false;

    std::array<Length, 3> at_{};
    std::size_t tool_ = 0;
    bool approaching_ = false, has_feed_ = false;
    std::size_t header_ = 0, home_ = 0, offset_ = 0, first_feed_ = 0, clear_line_ = 0;
    std::optional<std::size_t> closed_;  // line of the retract out of a closed pocket
    std::set<std::size_t> cancelled_;    // tools before which stands G49
    std::array<std::vector<std::pair<std::size_t, Length>>, 3> reached_;  // line and place
    std::array<std::vector<Length>, 3> within_;                           // nothing goes beyond
    std::vector<std::string> subprograms_;
};

}  // namespace ncsim::test::set_ups
