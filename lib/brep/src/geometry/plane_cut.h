// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves in which a plane cuts a surface, and places on these curves.
#pragma once

#include "ncsim/brep/surface_forms.h"

#include <optional>
#include <vector>

namespace ncsim::brep {

/// Cutting plane. `normal` is unit and points to the viewer.
struct CutPlane {
    Vec3 normal;
    double offset = 0.0;
    double height(Vec3 p) const { return dot(normal, p) - offset; }
};

/// Branch of a cut: the circle or ellipse centre + cos t · x + sin t · y, or the line centre + t ·
/// x if y is zero.
struct CutBranch {
    Vec3 centre, x, y;
};

/// Cut of a form by a plane, with at most two branches. A place on a branch is a number that grows
/// in one direction: mm on lines, degrees on all other curves.
class PlaneCut {
public:
    PlaneCut(const Form& form, const CutPlane& plane);

    /// False if the curves are not known in closed form.
    bool is_known() const { return kind_ != Kind::Unknown; }
    std::size_t branches() const { return count_; }
    bool is_straight() const { return kind_ == Kind::Straight; }
    /// True if the branches are closed curves, on the whole form.
    bool is_closed() const { return kind_ == Kind::Round || kind_ == Kind::Spiric; }
    /// Returns the branch that contains `p`, a point of the cut.
    std::size_t branch_of(Vec3 p) const;
    double place_of(Vec3 p) const;
    /// Returns the point at `place`; the apex if the plane goes through the apex of a cone, because
    /// all points of a ruling have the same place.
    Vec3 at(std::size_t branch, double place) const;
    /// True if the place grows from `p` in direction `d`.
    bool grows(Vec3 p, Vec3 d) const;

    /// Returns the branch if it is a line, a circle or an ellipse.
    std::optional<CutBranch> exact(std::size_t branch) const;
    /// Returns the apex if the plane cuts a cone in its apex: the cut is two rulings that end
    /// there.
    std::optional<Vec3> apex() const;

private:
    // Conic: open curve of a cone, by the angle about the cone's axis. Spiric: curve of a torus in
    // a plane parallel to the torus's axis.
    enum class Kind { Unknown, Nothing, Straight, Round, Conic, Spiric };

    void cut(const Plane& f);
    void cut(const Cylinder& f);
    void cut(const Cone& f);
    void cut(const Sphere& f);
    void cut(const Torus& f);
    void cut(const Extrusion& f);
    void cut(const Dome& f);
    void cut(const Coil& f);
    static void cut(const Spiral&) {}  // Stays Unknown.
    void cut(const Envelope&) {}
    void cut(const Helicoid&) {}
    void cut(const Characteristic&) {}
    void cut(const Trail&) {}
    void add(const CutBranch& branch);

    CutPlane plane_;
    Kind kind_ = Kind::Unknown;
    std::size_t count_ = 0;
    std::vector<CutBranch> branches_;  // Lines and rounds; circles of a spiric through the axis.
    Vec3 origin_, axis_, x_, y_;       // Frame of conics and spirics.
    double slope_ = 0.0, major_ = 0.0, minor_ = 0.0, offset_ = 0.0;
    bool through_apex_ = false;
};

}  // namespace ncsim::brep
