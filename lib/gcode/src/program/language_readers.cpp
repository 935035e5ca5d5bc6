// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses the readers of a language.
#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/klartext.h"
#include "ncsim/gcode/language.h"
#include "ncsim/gcode/sinumerik.h"

namespace ncsim::gcode {

Language language_of(const SourceFile& program) {
    if (is_klartext(program)) return Language::Klartext;
    return is_sinumerik(program) ? Language::Sinumerik : Language::GCode;
}

std::string_view name_of(Language language) {
    switch (language) {
        case Language::GCode: break;
        case Language::Klartext: return "klartext";
        case Language::Sinumerik: return "sinumerik";
    }
    return "g-code";
}

std::unique_ptr<ProgramNotes> notes_of(const SourceFile& program) {
    switch (language_of(program)) {
        case Language::GCode: break;
        case Language::Klartext: return std::make_unique<KlartextNotes>(program);
        case Language::Sinumerik: return std::make_unique<SinumerikNotes>(program);
    }
    return nullptr;
}

std::optional<RoundBlank> round_blank_of(const SourceFile& program) {
    switch (language_of(program)) {
        case Language::GCode: break;
        case Language::Klartext: return klartext_cylinder(program);
        case Language::Sinumerik: return sinumerik_cylinder(program);
    }
    return std::nullopt;
}

std::unique_ptr<ProgramListing> listing_of(const SourceFile& program) {
    switch (language_of(program)) {
        case Language::GCode: break;
        case Language::Klartext: return std::make_unique<KlartextListing>(program);
        case Language::Sinumerik: return std::make_unique<SinumerikListing>(program);
    }
    return nullptr;
}

}  // namespace ncsim::gcode
