// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses faults and writes a draft as program, machine file and options.
#include "support/set_ups.h"

#include "support/set_up_writer.h"

#include <stdexcept>
#include <utility>

namespace ncsim::test {

using namespace set_ups;

namespace {

Judged written(const Draft& d) {
    const auto mm = [&](Length value) { return decimal(value * (d.inches ? 254 : 100), 5) + "0"; };
    const auto point = [&](const std::array<Length, 3>& p) {
        return mm(p[X]) + ", " + mm(p[Y]) + ", " + mm(p[Z]);
    };
    Judged j;
    for (const std::string& line : d.lines)
        j.text += line + '\n';
    std::string machine = "name = \"mill\"\n";
    if (d.below_stock > 0) machine += "below_stock = " + mm(d.below_stock) + "\n";
    machine += d.fixtures.empty() ? "fixture = []\n" : "";
    machine += "[travel]\n";
    for (const Axis axis : {X, Y, Z}) {
        machine += static_cast<char>(kLetters[axis] + ('x' - 'X'));
        machine += " = [" + mm(d.travel_min[axis] + d.zero[axis]) + ", " +
                   mm(d.travel_max[axis] + d.zero[axis]) + "]\n";
    }
    machine += "[position]\nhome = [0, 0, 0]\n";
    if (d.start_specified) {
        machine += "start = [" + mm(d.start[X] + d.zero[X]) + ", " + mm(d.start[Y] + d.zero[Y]) +
                   ", " + mm(d.start[Z] + d.zero[Z]) + "]\n";
    }
    machine += "[offsets]\nG54 = [" + point(d.zero) + "]\n";
    for (const Fixture& f : d.fixtures) {
        machine += "[[fixture]]\nname = \"" + std::string(f.name) + "\"\nbox = [[" + point(f.min) +
                   "], [" + point(f.max) + "]]\n";
    }
    for (std::size_t i = 0; i < d.tools.size(); ++i) {
        const Tool& t = d.tools[i];
        if (t.blind > 0) {
            machine += "[[tool]]\nnumber = " + std::to_string(i + 1) +
                       "\nblind_diameter = " + mm(t.blind) + "\n";
        }
        if (!t.specified) continue;
        std::string text = "T" + std::to_string(i + 1) + "=" + t.kind + ":D" + mm(t.diameter) +
                           ":L" + mm(t.flutes);
        if (t.corner > 0) text += ":R" + mm(t.corner);
        if (t.kind == "v") text += ":A90";
        if (t.kind == "drill") text += ":A118";
        if (t.neck > 0) text += ":N" + mm(t.neck) + "x" + mm(t.neck_length);
        if (t.shank > 0) text += ":S" + mm(t.shank);
        if (t.holder > 0) text += ":E" + mm(t.stick_out) + ":H" + mm(t.holder) + "x40";
        j.options.insert(j.options.end(), {"--tool", text});
    }
    j.options.insert(
        j.options.end(),
        {"--stock", mm(d.stock_min[X]) + "," + mm(d.stock_min[Y]) + "," + mm(d.stock_min[Z]) + ":" +
                        mm(d.stock_max[X]) + "," + mm(d.stock_max[Y]) + "," + mm(d.stock_max[Z])});
    j.machine = machine;
    return j;
}

}  // namespace

Judged right_set_up(std::uint64_t seed) {
    Writer writer(seed);
    writer.run();
    return written(writer.draft());
}

std::set<std::string> faults_of(std::uint64_t seed) {
    Writer writer(seed);
    writer.run();
    std::set<std::string> names;
    for (const Fault& fault : writer.faults())
        names.insert(fault.name);
    return names;
}

Judged wrong_set_up(std::uint64_t seed, const std::string& name) {
    Writer writer(seed);
    writer.run();
    std::set<std::string> names;
    for (const Fault& fault : writer.faults())
        names.insert(fault.name);
    std::string wanted = name;
    if (!names.contains(name))
        wanted = *std::next(names.begin(), writer.random().between(0, std::ssize(names) - 1));
    std::vector<const Fault*> those;
    for (const Fault& fault : writer.faults()) {
        if (fault.name == wanted) those.push_back(&fault);
    }
    const Fault& fault = *those[writer.random().next() % those.size()];
    Draft draft = writer.draft();
    const std::size_t line = fault.put_in(draft);
    Judged judged = written(draft);
    judged.fault = fault.name;
    judged.verdict = fault.verdict;
    judged.tells = fault.tells;
    judged.line = line;
    judged.may_tell = fault.may_tell;
    return judged;
}

}  // namespace ncsim::test
