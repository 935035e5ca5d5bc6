// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges, writes and reads the observations of tiles.
#include "ncsim/verify/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>

namespace ncsim::verify {

namespace {

enum Flag : std::uint32_t {
    kTouches = 1,
    kCertain = 2,
    kAssumed = 4,
    kHasPoint = 8,
    kHasBox = 16,
    kHasValue = 32,
    kHasValues = 64,
    kAllFlags = 127,
};

// Sort key of an observation. Observations of fixtures keep the order in which they were made.
auto place_of(const Observation& o) {
    const bool has_number = o.subject != Subject::Fixture;
    return std::tuple(o.motion, o.step, o.subject, has_number ? o.index : 0,
                      has_number ? o.other : 0);
}

// True if volumes add up; otherwise the largest value counts.
bool sums(Subject subject) {
    return subject == Subject::FeedCut || subject == Subject::RapidCut ||
           subject == Subject::Removed;
}

// True if observations of this subject are not merged, because a single tile makes each of the
// observations or each counts separately.
bool is_not_merged(Subject subject) {
    return subject == Subject::Fixture || subject == Subject::Link;
}

void add_to(Observation& all, const Observation& more) {
    // The point of a certain contact is preferred.
    const auto weight = [](const Observation& o) {
        return std::tuple(!o.point.has_value(), !o.certain, o.rank);
    };
    if (weight(more) < weight(all)) {
        all.point = more.point;
        all.rank = more.rank;
    }
    all.touches |= more.touches;
    all.certain |= more.certain;
    all.assumed |= more.assumed;
    all.box.add(more.box);
    if (more.value && all.value) {
        all.value =
            sums(all.subject) ? *all.value + *more.value : std::max(*all.value, *more.value);
    } else if (more.value) {
        all.value = more.value;
    }
    all.places.insert(all.places.end(), more.places.begin(), more.places.end());
}

void write(std::string& text, const Vec3& v) {
    fmt::format_to(std::back_inserter(text), " {} {} {}", v.x, v.y, v.z);
}

void write(std::string& text, const Box& box) {
    write(text, box.min);
    write(text, box.max);
}

class Line {
public:
    explicit Line(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    template <class Number>
    Number number() {
        Number value{};
        if (!is_first_ && (at_ == end_ || *at_++ != ' ')) refuse();
        is_first_ = false;
        const auto read = std::from_chars(at_, end_, value);
        if (read.ec != std::errc()) refuse();
        at_ = read.ptr;
        return value;
    }
    double length() {
        const auto value = number<double>();
        if (!std::isfinite(value)) refuse();
        return value;
    }
    Vec3 vec() {
        Vec3 v;
        for (int i = 0; i < 3; ++i)
            v[i] = length();
        return v;
    }
    Box box() {
        Box box;
        box.min = vec();
        box.max = vec();
        return box;
    }
    bool is_at_end() const { return at_ == end_; }
    [[noreturn]] static void refuse() {
        throw std::invalid_argument("what was seen cannot be read");
    }

private:
    const char* at_;
    const char* end_;
    bool is_first_ = true;
};

}  // namespace

Evidence together(std::vector<Evidence> tiles) {
    Evidence all;
    for (Evidence& tile : tiles) {
        all.insert(all.end(), std::make_move_iterator(tile.begin()),
                   std::make_move_iterator(tile.end()));
        Evidence().swap(tile);
    }
    std::ranges::stable_sort(all, {}, place_of);
    std::size_t kept = 0;
    for (Observation& o : all) {
        const bool is_same = kept > 0 && place_of(all[kept - 1]) == place_of(o);
        if (is_same && !is_not_merged(o.subject)) {
            add_to(all[kept - 1], o);
        } else if (Observation& place = all[kept++]; &place != &o) {
            place = std::move(o);
        }
    }
    all.resize(kept);
    return all;
}

std::string bytes_of(const Evidence& evidence) {
    std::string text;
    for (const Observation& o : evidence) {
        const std::uint32_t flags = (o.touches ? kTouches : 0U) | (o.certain ? kCertain : 0U) |
                                    (o.assumed ? kAssumed : 0U) | (o.point ? kHasPoint : 0U) |
                                    (o.box.is_empty() ? 0U : kHasBox) | (o.value ? kHasValue : 0U) |
                                    (o.values ? kHasValues : 0U);
        fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {}", o.motion, o.step,
                       static_cast<unsigned>(o.subject), o.index, o.other, o.rank, flags);
        if (o.point) write(text, *o.point);
        if (!o.box.is_empty()) write(text, o.box);
        if (o.value) fmt::format_to(std::back_inserter(text), " {}", *o.value);
        for (std::size_t i = 0; o.values && i < o.values->size(); ++i)
            fmt::format_to(std::back_inserter(text), " {}", (*o.values)[i]);
        for (const Box& place : o.places)
            write(text, place);
        text += '\n';
    }
    return text;
}

Evidence evidence_from(std::string_view bytes) {
    Evidence evidence;
    while (!bytes.empty()) {
        const std::size_t end = bytes.find('\n');
        if (end == std::string_view::npos) Line::refuse();
        Line line(bytes.substr(0, end));
        bytes.remove_prefix(end + 1);
        Observation& o = evidence.emplace_back();
        o.motion = line.number<std::uint64_t>();
        o.step = line.number<std::uint64_t>();
        const auto subject = line.number<unsigned>();
        if (subject > static_cast<unsigned>(Subject::Link)) Line::refuse();
        o.subject = static_cast<Subject>(subject);
        o.index = line.number<std::uint32_t>();
        o.other = line.number<std::uint32_t>();
        o.rank = line.number<std::uint32_t>();
        const auto flags = line.number<std::uint32_t>();
        if (flags > kAllFlags) Line::refuse();
        o.touches = (flags & kTouches) != 0;
        o.certain = (flags & kCertain) != 0;
        o.assumed = (flags & kAssumed) != 0;
        if ((flags & kHasPoint) != 0) o.point = line.vec();
        if ((flags & kHasBox) != 0) o.box = line.box();
        if ((flags & kHasBox) != 0 && o.box.is_empty()) Line::refuse();
        if ((flags & kHasValue) != 0) o.value = line.length();
        if ((flags & kHasValues) != 0) {
            for (double& value : o.values.emplace())
                value = line.length();
        }
        while (!line.is_at_end())
            o.places.push_back(line.box());
    }
    return evidence;
}

}  // namespace ncsim::verify
