// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes entities of STEP files.
#include "formats/step_file.h"

#include "formats/file_text.h"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace ncsim::exporter {

namespace {

std::string real(double number) {
    std::string text;
    append_number(text, number);
    const std::size_t exponent = text.find('e');
    if (exponent != std::string::npos) text[exponent] = 'E';
    if (text.find('.') == std::string::npos) {
        text.insert(std::min(exponent, text.size()), 1, '.');
    }
    return text;
}

void append_hex(std::string& text, std::uint32_t number, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
        text += "0123456789ABCDEF"[(number >> shift) & 0xF];
    }
}

}  // namespace

StepValue::StepValue(Entity entity) : text("#" + std::to_string(entity.number)) {}

StepValue::StepValue(double number) : text(real(number)) {}

StepValue::StepValue(Vec3 v) : text("(" + real(v.x) + "," + real(v.y) + "," + real(v.z) + ")") {}

StepValue::StepValue(const std::vector<Entity>& entities) : text("(") {
    for (const Entity entity : entities) {
        if (text.size() > 1) text += ',';
        text += StepValue(entity).text;
    }
    text += ')';
}

// Source: ISO 10303-21, 6.4.3.
std::string step_string(std::string_view words) {
    const std::string utf8 = printable_utf8(words);
    std::string text = "'";
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<std::uint8_t>(utf8[i]);
        if (lead < 0x80) {
            text += utf8[i];
            if (utf8[i] == '\'' || utf8[i] == '\\') text += utf8[i];
            ++i;
            continue;
        }
        const int length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        std::uint32_t number = lead & (0xFFU >> (length + 1));
        for (int j = 1; j < length; ++j) {
            number = number << 6 | (static_cast<std::uint8_t>(utf8[++i]) & 0x3FU);
        }
        ++i;
        text += length == 4 ? "\\X4\\" : "\\X2\\";
        append_hex(text, number, length == 4 ? 8 : 4);
        text += "\\X0\\";
    }
    return text + "'";
}

Entity StepFile::add(std::string_view form, std::initializer_list<StepValue> values) {
    ++last_.number;
    text_.append(StepValue(last_).text).append("=");
    for (const StepValue& value : values) {
        const std::size_t place = form.find("{}");
        text_.append(form.substr(0, place)).append(value.text);
        form.remove_prefix(place + 2);
    }
    text_.append(form).append(";\n");
    if (text_.size() >= kFlushSize) flush();
    return last_;
}

void StepFile::flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
}

void StepFile::finish() {
    flush();
    if (!out_) throw std::runtime_error("cannot write STEP: the stream failed");
}

}  // namespace ncsim::exporter
