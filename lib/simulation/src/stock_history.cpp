// SPDX-License-Identifier: GPL-3.0-or-later
//
// A record has the form LINE TOOL ERROR closed|open PROGRAM: the line of the program (0: the
// stock), the tool, the largest deviation of facets (mm), and `open` if faces of the motion may lie
// on surfaces that are not listed.
#include "ncsim/simulation/stock_history.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/brep/candidate_filter.h"
#include "ncsim/brep/surface_text.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/workpiece.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace ncsim::simulation {

namespace {

constexpr std::string_view kClosed = "closed", kOpen = "open";
// Largest deviation of facets that a run can have, mm: that of --tool-tolerance and of arcs.
constexpr double kMostError = 100.0;
// Facets of a valid file lie on their surfaces within the error; the last digits may differ after
// the stock was turned.
constexpr double kReadTimes = 1.01;

template <class Number>
bool read_number(std::string_view& text, Number& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end == text.data() + text.size() || *end != ' ') return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    return true;
}

bool read_word(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word) || !text.substr(word.size()).starts_with(' ')) return false;
    text.remove_prefix(word.size() + 1);
    return true;
}

[[noreturn]] void refuse(const toolpath::Stock& stock, std::size_t line, const char* why) {
    throw std::runtime_error(fmt::format("{}:{}: {}", stock.from->path, line, why));
}

class HistoryReader {
public:
    explicit HistoryReader(const toolpath::Stock& stock)
        : stock_(stock), motion_(motion_of(stock)) {}

    StockHistory read() {
        for (const cda::ShapeSource& source : stock_.shape->sources)
            add(source);
        return std::move(history_);
    }

private:
    static brep::RigidMotion motion_of(const toolpath::Stock& stock) {
        brep::RigidMotion motion;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k)
                motion.rows[static_cast<std::size_t>(i)][k] =
                    stock.placement.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
        }
        motion.shift = stock.shape->lattice.to_mm(stock.placement.shift);
        return motion;
    }

    void add(const cda::ShapeSource& source) {
        std::string_view text = source.text;
        mesh::Provenance::Entry entry;
        brep::SweptSurfaces surfaces;
        const bool is_read = read_number(text, entry.nc_line) && read_number(text, entry.tool) &&
                             read_number(text, surfaces.error_mm) && surfaces.error_mm >= 0.0 &&
                             surfaces.error_mm <= kMostError;
        if (!is_read) refuse(stock_, source.line, kForm);
        surfaces.may_leave_other_surfaces = read_word(text, kOpen);
        if (!surfaces.may_leave_other_surfaces && !read_word(text, kClosed))
            refuse(stock_, source.line, kForm);
        // The stock of the first run belongs to no program.
        if (entry.nc_line != 0 || entry.tool != 0) {
            entry.earlier_program = number_of(text);
            entry.earlier_line = std::exchange(entry.nc_line, 0);
        }
        for (std::size_t i = 0; i < source.surfaces.size(); ++i) {
            const auto candidate = brep::candidate_of(source.surfaces[i]);
            if (!candidate)
                refuse(stock_, source.line + i + 1, "expected a surface that ncsim writes");
            surfaces.candidates.push_back(brep::moved(*candidate, motion_));
        }
        history_.entries.push_back(entry);
        history_.surfaces.push_back(std::move(surfaces));
    }

    std::uint32_t number_of(std::string_view program) {
        auto& programs = history_.programs;
        const auto found = std::ranges::find(programs, program);
        const auto number = static_cast<std::uint32_t>(found - programs.begin()) + 1;
        if (found == programs.end()) programs.emplace_back(program);
        return number;
    }

    static constexpr const char* kForm = "expected a source: LINE TOOL ERROR closed PROGRAM";
    const toolpath::Stock& stock_;
    brep::RigidMotion motion_;
    StockHistory history_;
};

}  // namespace

std::shared_ptr<const StockHistory> read_stock_history(const toolpath::Stock& stock) {
    if (!stock.shape || stock.shape->sources.empty()) return nullptr;
    StockHistory history = HistoryReader(stock).read();
    const cda::Boundary boundary =
        cda::create(cda::TreeCda(cda::TreeParameters{}), *stock.shape)->boundary();
    const brep::CandidateFilter filter(boundary);
    for (std::uint32_t i = 0; i < history.surfaces.size(); ++i) {
        const std::vector<bool> fits =
            filter.fitting(cda::Origin{i}, history.surfaces[i], kReadTimes);
        const auto first = std::ranges::find(fits, false);
        if (first == fits.end()) continue;
        refuse(stock,
               stock.shape->sources[i].line + static_cast<std::size_t>(first - fits.begin()) + 1,
               "the surface lies on no face of its source");
    }
    return std::make_shared<const StockHistory>(std::move(history));
}

cda::ShapeSource record_of(const mesh::Provenance& provenance, const mesh::Provenance::Entry& entry,
                           const brep::SweptSurfaces& source) {
    const bool is_earlier = entry.earlier_program != 0;
    cda::ShapeSource record;
    record.text =
        fmt::format("{} {} {} {} {}", is_earlier ? entry.earlier_line : entry.nc_line, entry.tool,
                    source.error_mm, source.may_leave_other_surfaces ? kOpen : kClosed,
                    one_line(is_earlier ? provenance.earlier_programs[entry.earlier_program - 1]
                                        : provenance.program));
    for (const brep::CandidateSurface& candidate : source.candidates)
        record.surfaces.push_back(brep::text_of(candidate));
    return record;
}

}  // namespace ncsim::simulation
