// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of a part, drawn off screen: no display and no graphics card are needed.
#pragma once

#include "ncsim/brep/part_shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/cell_model.h"
#include "ncsim/export/image.h"
#include "ncsim/export/overlay.h"
#include "ncsim/export/render_options.h"
#include "ncsim/mesh/provenance.h"

namespace ncsim::exporter {

/// Draws `model` facet by facet, each facet behind its masks in the stencil buffer; no boundary is
/// computed. Uncut stock and the faces of each tool have a colour of their own. `overlay` is drawn
/// on top, hidden by the bodies in front.
///
/// Guarantees: the same input gives the same bytes on every machine.
/// Throws: std::runtime_error if the size or the number of samples is out of range.
/// Source: Schüppel 2001, section 5.1.
Image render_model(const cda::FacetModel& model, const mesh::Provenance& provenance,
                   const RenderOptions& options, const Overlay& overlay = {});

/// Draws `boundary`, cut open if the options have a plane. Faces that `shading` knows to be round
/// are lit with the normals of their surface, from corner to corner, and have no lines between
/// them. Without `shading`, the picture equals that of the model with this boundary, except for
/// pixels on edges. Guarantees and exceptions are those of render_model().
Image render_boundary(const cda::Boundary& boundary, const mesh::Provenance& provenance,
                      const RenderOptions& options, const Overlay& overlay = {},
                      const brep::Shading& shading = {});

}  // namespace ncsim::exporter
