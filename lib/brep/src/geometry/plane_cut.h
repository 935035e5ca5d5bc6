// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves in which a plane cuts a surface, and where on them points are.
#pragma once

#include "ncsim/brep/surface.h"

#include <optional>
#include <vector>

namespace ncsim::brep {

/// `normal` is unit; it points to who looks at the cut.
struct CutPlane {
    Vec3 normal;
    double offset = 0.0;
    double height(Vec3 p) const { return cda::dot(normal, p) - offset; }
};

/// A circle, an ellipse, or a line: of the form centre + cos t · x + sin t · y, or centre + t · x
/// where y is zero.
struct CutBranch {
    Vec3 centre, x, y;
};

/// What a plane and a form have in common: one branch, or two. Places on them are told by a number
/// that grows one way along the branch, degrees where it is closed.
class PlaneCut {
public:
    PlaneCut(const Form& form, const CutPlane& plane);

    /// Else the curves are not known here.
    bool is_known() const { return kind_ != Kind::Unknown; }
    std::size_t branches() const { return count_; }
    bool is_straight() const { return kind_ == Kind::Straight; }
    /// All of it is there, however far the face goes.
    bool is_closed() const { return kind_ == Kind::Round || kind_ == Kind::Spiric; }
    /// Which one has `p`, a point of the cut.
    std::size_t branch_of(Vec3 p) const;
    double place_of(Vec3 p) const;
    Vec3 at(std::size_t branch, double place) const;
    /// Does the place grow where one goes from `p` in direction `d`?
    bool grows(Vec3 p, Vec3 d) const;

    /// Of a line, a circle or an ellipse.
    std::optional<CutBranch> exact(std::size_t branch) const;
    /// Where a cone is cut in its apex: the cut is two lines that end there.
    std::optional<Vec3> apex() const;

private:
    // Conic: of a cone, not closed, by the angle about its axis. Spiric: of a ring, by a plane
    // along its axis.
    enum class Kind { Unknown, Nothing, Straight, Round, Conic, Spiric };

    void cut(const Plane& f);
    void cut(const Cylinder& f);
    void cut(const Cone& f);
    void cut(const Sphere& f);
    void cut(const Torus& f);
    void cut(const Extrusion& f);
    void cut(const Dome& f);
    void cut(const Coil& f);
    static void cut(const Spiral&) {}  // nothing is known of it
    void cut(const Envelope&) {}
    void cut(const Helicoid&) {}
    void cut(const Characteristic&) {}
    void cut(const Trail&) {}
    void add(const CutBranch& branch);

    CutPlane plane_;
    Kind kind_ = Kind::Unknown;
    std::size_t count_ = 0;
    std::vector<CutBranch> branches_;  // of lines and rounds; of a spiric its circles, if it has
    Vec3 origin_, axis_, x_, y_;       // of conics and spirics
    double slope_ = 0.0, major_ = 0.0, minor_ = 0.0, offset_ = 0.0;
    bool through_apex_ = false;
};

}  // namespace ncsim::brep
