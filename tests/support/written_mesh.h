// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mesh as a program reads it from a file: corners are the floats of the file, and corners with
// equal floats are merged.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::test {

struct WrittenMesh {
    std::vector<std::array<float, 3>> points;  ///< Distinct points in ascending order, mm.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 3>> normals;  ///< Normal of each triangle; STL only.
};

/// Reads a binary STL file.
/// Throws: std::runtime_error if `bytes` is not a binary STL file.
WrittenMesh read_stl(const std::string& bytes);

/// Reads a binary glTF file as ncsim writes it: all primitives of the single mesh, in the frame of
/// the node.
/// Throws: std::runtime_error if `bytes` is not a binary glTF file.
WrittenMesh read_glb(const std::string& bytes);

struct Soundness {
    std::size_t triangles = 0;
    std::size_t repeated = 0;  ///< Triangles with two equal corners.
    std::size_t flat = 0;      ///< Further triangles whose area is zero, exactly or in double
                               ///< precision.
    std::size_t unpaired = 0;  ///< Directed edges that do not occur exactly once in each direction.
    std::size_t pinched = 0;   ///< Corners whose triangles form more than one fan.
    double volume = 0.0;       ///< Enclosed, mm³.
    double area = 0.0;         ///< mm².
    double largest = 0.0;      ///< Largest absolute value of a coordinate.

    /// True if the mesh is a closed oriented 2-manifold without degenerate triangles.
    bool is_sound() const { return repeated + flat + unpaired + pinched == 0; }
};
Soundness soundness(const WrittenMesh& mesh);

/// Describes `found` for messages: "12 triangles, 1 flat, …".
std::string to_string(const Soundness& found);

}  // namespace ncsim::test
