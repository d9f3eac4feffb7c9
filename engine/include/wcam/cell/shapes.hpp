// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/value.hpp"
#include "wcam/geometry/mesh.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wcam::cell {

enum class ShapeKind {
  Sphere,    ///< radius
  Capsule,   ///< radius around a segment of `length` along z, centred
  Cylinder,  ///< radius and length along z, centred, flat ends
  Box,       ///< full sizes, centred
  Mesh       ///< closed triangles
};

/// A solid that is fixed to a frame of the cell, mm.
struct Shape {
  std::string name;
  ShapeKind kind = ShapeKind::Sphere;
  /// "world", "base", the name of a joint (the frame that turns with it), "flange", "tcp", "table".
  std::string frame;
  geometry::Pose T_frame_shape = geometry::Pose::Identity();
  double radius = 0.0;
  double length = 0.0;
  geometry::Vec3 size = geometry::Vec3::Zero();
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  /// Frames and names of shapes that this one is never compared with.
  std::vector<std::string> ignore;
};

/// What can collide in a cell, from the keys `torch.neck`, `torch.collision`, `robot.collision`,
/// `positioner.collision` (or `part_holder.collision`) and `obstacles` of its file.
struct CellShapes {
  std::vector<Shape> torch;
  std::vector<Shape> robot;
  std::vector<Shape> positioner;
  std::vector<Shape> obstacles;

  [[nodiscard]] bool empty() const {
    return torch.empty() && robot.empty() && positioner.empty() && obstacles.empty();
  }
};

/// How the reader of shapes asks the reader of the cell file: problems are collected there.
struct ShapeReading {
  std::function<void(const std::string& path, const Text& message)> problem;
  /// The pose under a key of an object; the identity when it is missing.
  std::function<geometry::Pose(
      const Value& parent, const std::string& parentPath, const std::string& key)>
      pose;
  std::vector<std::string> frames;  ///< all frames that the cell has
  std::filesystem::path folder;     ///< that paths of meshes are relative to
};

/// Reads all shapes of a cell file. Problems (sizes that are not positive, unknown frames and keys,
/// meshes that cannot be read) go to `reading.problem` with their path.
CellShapes readShapes(const Value& file, const ShapeReading& reading, const JobContext& context);

/// The mesh files that the shapes of a cell file name, in order, resolved against its folder.
std::vector<std::filesystem::path> shapeFiles(const Value& file,
                                              const std::filesystem::path& folder);

}  // namespace wcam::cell
