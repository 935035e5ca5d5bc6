// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the draft of a set-up, feature by feature. Records possible faults where the construction
// determines the expected finding.
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
        Length width = 0, x0 = 0;  // strip of the block for the feature
        Length depth = 0;
        std::vector<Length> passes;  // depths
        Length room = 0;             // from the middle line of the strip to the outermost tool
                                     // centre
    };

    template <typename T>
    T one_of(std::initializer_list<T> choices) {
        return choices.begin()[random_.next() % choices.size()];
    }
    bool happens(int percent) { return random_.between(1, 100) <= percent; }
    Length mm(double value) const;
    Length within(double low, double high) { return random_.between(mm(low), mm(high)); }
    // Returns 0, one step, or a length between `low` and `high` mm.
    Length margin(double low, double high);
    Length little() { return one_of({Length{1}, Length{10}, Length{100}, Length{1000}}); }

    std::string number(Length value) const { return decimal(value, draft_.inches ? 4 : 3); }
    std::string word(Axis axis, Length value) const { return kLetters[axis] + number(value); }

    void fault(std::string name, std::string verdict, std::string tells,
               std::set<std::string> may_tell, std::function<std::size_t(Draft&)> put_in);

    // --- choice of tools and features

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
    // Returns the word F, always for the first feed move and at random for later moves.
    std::string feed();
    std::size_t feed_to(std::initializer_list<std::pair<Axis, Length>> to);
    void note_feed(std::size_t where);
    Tool& tool() { return draft_.tools[tool_]; }

    // Records that the move in line `where` cuts by construction: no earlier feature has removed
    // the material.
    void cuts(std::size_t where, Length depth, Length sideways);
    void cuts_if_rapid(std::size_t where);

    // --- moves from feature to feature

    void write();
    void change_tool();
    // Moves to the start of a feature above all bodies.
    void traverse(Length x, Length y, bool above_stock);
    void traverse_faults(Length from, Length to, std::size_t where);
    void retract(bool closed);
    void cut(const Feature& f);
    Length middle(const Feature& f) const { return f.x0 + f.width / 2; }
    Length radius() { return tool().diameter / 2; }
    Length middle_y() const { return (draft_.stock_min[Y] + draft_.stock_max[Y]) / 2; }

    // Records a fault in which the jaws reach higher than the tool, which is next to the block at
    // height `z`.
    void jaw_fault(std::size_t where, Length z);
    void open_slot(const Feature& f);
    // Records a fault in which a tool that does not cut at the centre plunges.
    void plunge_fault(std::size_t down);
    // Writes a loop that repeats a pass, each time one step deeper.
    void loop(const Feature& f);
    void cuts_in_loop(std::size_t where, Length step, Length depth);
    Length lower_to_start();
    void pocket(const Feature& f);
    // Records a fault in which the next pass around the pocket continues sideways into the clamp.
    void clamp_fault(const Feature& f);
    // Records a fault in which a mill with a core that does not cut plunges by `by`, which is more
    // than any ramp permits.
    void blind_fault(std::size_t where, Length by);
    // Lengthens the required flutes, because chords of successive helix turns differ by rounding.
    void spare(const Feature& f);
    void helix(const Feature& f);
    void arc_note(std::size_t where, Length cx, Length cy, Length r);
    // Writes a slot along three quarters of a circle.
    void arcs(const Feature& f);
    void drilling(const Feature& f);
    void incremental(const Feature& f);
    void rotated(const Feature& f);
    // Writes a slot for a tool with a neck thinner than the cutter: the tool enters from the side
    // and leaves the same way.
    void side_slot(const Feature& f);

    // --- tools and machine, after all features are written

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
    Length top_ = 0, high_ = 0, clear_ = 0;  // heights: top of the block; highest body; traverses
    Length home_height_ = 0;
    Length clamp_min_ = 0, clamp_max_ = 0;
    std::optional<Length> jaw_top_;
    bool has_table_ = false;

    std::array<Length, 3> at_{};
    std::size_t tool_ = 0;
    bool approaching_ = false, has_feed_ = false;
    std::size_t header_ = 0, home_ = 0, offset_ = 0, first_feed_ = 0, clear_line_ = 0;
    std::optional<std::size_t> closed_;  // line of the retract out of a closed pocket
    std::set<std::size_t> cancelled_;    // tools whose change follows a G49
    std::array<std::vector<std::pair<std::size_t, Length>>, 3> reached_;  // line and coordinate
    std::array<std::vector<Length>, 3> within_;  // coordinates that the motions
                                                 // do not pass
    std::vector<std::string> subprograms_;
};

}  // namespace ncsim::test::set_ups
