// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// What the 3D view draws, as plain values: neither VTK, Qt nor the engine. Lengths in mm. Readable
/// as C++17, since VTK's headers need that.
namespace wcam::viewport {

/// Row-major 4 × 4 matrix of a rigid pose.
using Matrix = std::array<double, 16>;

inline constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

using Point = std::array<double, 3>;
using Colour = std::array<std::uint8_t, 3>;

/// Triangles with the faces they belong to, and the edges to draw on them.
struct MeshData {
  std::vector<float> positions;          ///< x, y, z per vertex
  std::vector<std::uint32_t> triangles;  ///< three vertices each
  std::vector<std::int32_t> faces;       ///< per triangle; empty: a mesh without faces
  std::vector<float> edgePositions;      ///< x, y, z per point of the edges
  std::vector<std::uint32_t> edgeBegin;  ///< first point of each edge, and the end of the last
  std::vector<std::int32_t> edgeIds;     ///< per edge

  [[nodiscard]] bool empty() const { return triangles.empty(); }
};

/// The moves of an operation in order, structure of arrays. A bead is deposited by the moves that
/// are marked in `deposits`; its section hangs below the point: `width` wide along `side`, `height`
/// high against `build`.
struct PathData {
  std::vector<float> positions;  ///< x, y, z per move
  std::vector<float> build;      ///< unit build direction
  std::vector<float> side;       ///< unit direction across the bead
  std::vector<float> heights;
  std::vector<float> widths;
  std::vector<std::uint8_t> deposits;  ///< 1: the move that ends here lays a bead
  std::vector<std::uint32_t> layers;   ///< per move, never decreasing inside a deposition order

  [[nodiscard]] std::size_t size() const { return deposits.size(); }
};

/// A simple solid that stands for a link of the robot, the torch or the table.
struct Solid {
  enum class Kind { Capsule, Cylinder, Cone, Box };
  Kind kind = Kind::Capsule;
  Point from{};  ///< axis; of a box: its lowest corner
  Point to{};    ///< … and its highest corner
  double radius = 0.0;
  Colour colour{};
};

/// A rigid body of the cell; moved by poses.
struct Body {
  std::string name;
  std::vector<Solid> solids;
  std::vector<MeshData> meshes;
  Colour meshColour{};
};

/// What lies under the mouse.
struct Pick {
  enum class Kind { None, Face, Edge, Move };
  Kind kind = Kind::None;
  int part = -1;   ///< index of the part of a face or edge
  int index = -1;  ///< face, edge or move
  Point position{};
};

enum class StandardView { Isometric, Front, Back, Left, Right, Top, Bottom };

}  // namespace wcam::viewport
