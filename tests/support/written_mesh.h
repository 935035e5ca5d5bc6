// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh as somebody finds it who has nothing but the file: corners are the floats that stand
// there, and those with the same floats are one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::test {

struct WrittenMesh {
    std::vector<std::array<float, 3>> points;  ///< Ascending, each once. mm.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 3>> normals;  ///< Of each triangle; only STL has them.
};

/// Binary STL. Throws std::runtime_error if it is none.
WrittenMesh read_stl(const std::string& bytes);

/// Binary glTF as ncsim writes it: all primitives of the one mesh, in the frame of its node.
/// Throws std::runtime_error if it is none.
WrittenMesh read_glb(const std::string& bytes);

struct Soundness {
    std::size_t triangles = 0;
    std::size_t repeated = 0;  ///< Triangles in which a corner stands twice.
    std::size_t flat = 0;      ///< Others whose area is zero, exactly or as doubles compute it.
    std::size_t unpaired = 0;  ///< Directed edges that do not stand once, and once in reverse.
    std::size_t pinched = 0;   ///< Corners whose triangles are more than one fan around it.
    double volume = 0.0;       ///< Enclosed, mm³.
    double area = 0.0;         ///< mm².
    double largest = 0.0;      ///< The largest coordinate, without its sign.

    /// A closed oriented 2-manifold without degenerate triangles.
    bool is_sound() const { return repeated + flat + unpaired + pinched == 0; }
};
Soundness soundness(const WrittenMesh& mesh);

/// In words, for messages: "12 triangles, 1 flat, …".
std::string to_string(const Soundness& found);

}  // namespace ncsim::test
