// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of a part, drawn off screen: no display, no graphics card.
#pragma once

#include "ncsim/brep/shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/export/image.h"
#include "ncsim/export/overlay.h"
#include "ncsim/export/provenance.h"
#include "ncsim/export/render_options.h"

namespace ncsim::exporter {

/// Draws what `model` hands out facet by facet, each behind its masks in the stencil buffer
/// (Schüppel 2001, section 5.1): no boundary is computed. Uncut stock and the faces of each
/// tool have a colour of their own.
///
/// `overlay` is drawn over it, hidden by what stands before it.
///
/// Both functions: the same input gives the same bytes on every machine. Throws std::runtime_error
/// if the size or the number of samples is out of range.
Image render_model(const cda::WorkpieceModel& model, const Provenance& provenance,
                   const RenderOptions& options, const Overlay& overlay = {});

/// Draws `boundary`. Faces that `shading` knows to be round are lit as what they stand for, from
/// corner to corner, and have no lines between them. Without it, equal to the picture of the model
/// whose boundary it is, but for pixels on edges.
Image render_boundary(const cda::Boundary& boundary, const Provenance& provenance,
                      const RenderOptions& options, const Overlay& overlay = {},
                      const brep::Shading& shading = {});

}  // namespace ncsim::exporter
