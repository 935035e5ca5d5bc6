// SPDX-License-Identifier: GPL-3.0-or-later
//
// A 3MF file is a ZIP archive of three XML files: the content types, the name of the model file,
// and the model.
#include "ncsim/export/threemf.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/triangulate.h"

#include "formats/file_text.h"
#include "formats/zip.h"
#include "render/palette.h"

#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ncsim::exporter {

namespace {

constexpr std::string_view kTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";

constexpr std::string_view kRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="model" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

constexpr std::string_view kModelStart =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
)";

void append_attribute(std::string& text, std::string_view name, double value) {
    text += ' ';
    text += name;
    text += "=\"";
    append_number(text, value);
    text += '"';
}

void append_attribute(std::string& text, std::string_view name, std::size_t value) {
    text += ' ';
    text += name;
    text += "=\"";
    text += std::to_string(value);
    text += '"';
}

void append_materials(std::string& text, const Palette& palette) {
    text += "<basematerials id=\"1\">\n";
    for (const FaceSource& maker : palette.face_sources()) {
        text += "<base name=\"" + maker.name() + "\" displaycolor=\"#";
        const Rgba8 colour = palette.colour(maker);
        for (const std::uint8_t channel : {colour.r, colour.g, colour.b, colour.a}) {
            text += "0123456789ABCDEF"[channel >> 4];
            text += "0123456789ABCDEF"[channel & 0xF];
        }
        text += "\"/>\n";
    }
    text += "</basematerials>\n";
}

void append_object(std::string& text, const cda::Boundary& boundary, const TriangleMesh& mesh,
                   const mesh::Provenance& provenance, const Palette& palette) {
    text +=
        "<object id=\"2\" type=\"model\" name=\"part\" pid=\"1\" "
        "pindex=\"0\">\n<mesh>\n<vertices>\n";
    for (const Vec3& p : mesh.vertices) {
        text += "<vertex";
        append_attribute(text, "x", p.x);
        append_attribute(text, "y", p.y);
        append_attribute(text, "z", p.z);
        text += "/>\n";
    }
    text += "</vertices>\n<triangles>\n";
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const cda::Origin origin = boundary.faces[mesh.face[t]].origin;
        text += "<triangle";
        append_attribute(text, "v1", std::size_t{mesh.triangles[t][0]});
        append_attribute(text, "v2", std::size_t{mesh.triangles[t][1]});
        append_attribute(text, "v3", std::size_t{mesh.triangles[t][2]});
        text += " pid=\"1\"";
        append_attribute(text, "p1", palette.rank(provenance.of(origin)));
        text += "/>\n";
    }
    text += "</triangles>\n</mesh>\n</object>\n";
}

}  // namespace

void write_3mf(std::ostream& out, const cda::Boundary& boundary,
               const mesh::Provenance& provenance) {
    write_3mf(out, boundary, cda::triangulate(boundary), provenance);
}

void write_3mf(std::ostream& out, const cda::Boundary& boundary, const TriangleMesh& mesh,
               const mesh::Provenance& provenance) {
    const Palette palette(provenance);
    std::string model(kModelStart);
    model += "<metadata name=\"Title\">" + xml_text(provenance.program) + "</metadata>\n";
    model += "<metadata name=\"Application\">ncsim</metadata>\n<resources>\n";
    append_materials(model, palette);
    if (!boundary.faces.empty()) append_object(model, boundary, mesh, provenance, palette);
    model += "</resources>\n<build>\n";
    if (!boundary.faces.empty()) model += "<item objectid=\"2\"/>\n";
    model += "</build>\n</model>\n";

    ZipWriter archive(out);
    archive.add("[Content_Types].xml", kTypes);
    archive.add("_rels/.rels", kRelations);
    archive.add("3D/3dmodel.model", model);
    archive.finish();
    if (!out) throw std::runtime_error("cannot write 3MF: the stream failed");
}

}  // namespace ncsim::exporter
