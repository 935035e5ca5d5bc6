// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table of the parameters that each cycle applies.
#include "klartext/cycle_parameters.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace ncsim::gcode::klartext {
namespace {

/// Parameters of a cycle: numbers separated by blanks. Other parameters are left out.
struct CycleParameters {
    int cycle;
    std::string_view applied;
    /// Parameters without effect on the part: direction of a step aside, angle of the spindle,
    /// coolant, dwell, feed out of a finished place.
    std::string_view harmless = {};
    /// Parameters that do not act with the value 0.
    std::string_view off_at_zero = {};
};

constexpr std::string_view kArea = "200 201 202 203 204 206 207 215 338 351 368 369 385";

constexpr auto kCycles = std::to_array<CycleParameters>({
    {20, "1 2 3 4 5 6 7 8 9"},
    // Q19: slope of the way down; Q208: feed up; Q401, Q404: feed and places behind a coarse tool.
    {22, "10 11 12", "19 208 401 404", "18"},
    {23, "11 12", "10 208"},
    // Q438: number of the roughing tool.
    {24, "9 10 11 12 14", "438"},
    // Q446 to Q448: limits of what a coarse tool leaves.
    {25, "1 3 5 7 10 11 12 15 18", "446 447 448"},
    {200, "200 201 202 203 204 206 210 211", "", "395"},
    {201, "200 201 203 204 206 208 211"},
    {202, "200 201 203 204 206 208 211 214", "336 357"},
    {203, "200 201 202 203 204 205 206 208 210 211 212 213 256", "", "395"},
    {204, "200 203 204 249 250 251 252 253 254 255", "214 336"},
    {205, "200 201 202 203 204 205 206 208 211 212 253 256 257 258 259 379", "", "395"},
    {206, "200 201 203 204 206 211"},
    {207, "200 201 203 204 239"},
    {208, "200 201 203 204 206 334 335 351", "342", "370"},
    // Q403: speed of the way out.
    {209, "200 201 203 204 239 256 257", "336 403"},
    {220, "200 203 204 216 217 241 244 245 246 247 301 365"},
    {221, "200 203 204 224 225 226 237 238 242 243 301"},
    {240, "200 201 203 204 206 211 343", "253 344", "342"},
    // Q401: feed behind the depth Q435.
    {241, "200 201 202 203 204 205 206 208 211 212 253 379 426 427 428", "401 429 430", "435"},
    {247, "339"},
    {251, "218 219 220 224 366 367 370", "", "439"},
    {252, "223 366 370", "367", "439"},
    {253, "218 219 366 367 374", "", "439"},
    {254, "216 217 219 248 366 367 375 376 377 378", "", "439"},
    {256, "218 219 220 224 367 370 424 425 437"},
    // Q376: place at which the tool goes to the stud.
    {257, "222 223 370", "376"},
    {258, "220 222 224 370 571 572 573"},
    {262, "200 201 203 204 207 239 253 335 351 355", "", "512"},
    // Q357: see the doubt about the way out of the countersink.
    {263, "200 201 203 204 207 239 253 254 335 351 356 358 359", "357", "512"},
    {264, "200 201 202 203 204 206 207 239 253 256 257 258 335 351 356 358 359", "", "512"},
    {265, "200 201 203 204 207 239 253 254 335 358 359 360"},
    {267, "200 201 203 204 207 239 253 254 335 351 355 358 359", "", "512"},
});

bool contains(std::string_view numbers, std::uint32_t q) {
    const std::string number = std::to_string(q);
    for (std::size_t at = numbers.find(number); at != std::string_view::npos;
         at = numbers.find(number, at + 1)) {
        const std::size_t end = at + number.size();
        const bool begins = at == 0 || numbers[at - 1] == ' ';
        if (begins && (end == numbers.size() || numbers[end] == ' ')) return true;
    }
    return false;
}

}  // namespace

bool leaves_out(int cycle, std::uint32_t q, double value) {
    const auto* const row = std::ranges::find(kCycles, cycle, &CycleParameters::cycle);
    if (row == kCycles.end()) return false;
    const bool is_area = cycle >= 251 && cycle <= 258;
    const bool is_applied = contains(row->applied, q) || (is_area && contains(kArea, q));
    if (is_applied || contains(row->harmless, q)) return false;
    return value != 0.0 || !contains(row->off_at_zero, q);
}

}  // namespace ncsim::gcode::klartext
