// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "placing.hpp"

#include <cmath>

namespace wcam::gui {

namespace {

// Millimetres and degrees that people read; finer than any placement in a cell.
constexpr double kStep = 1e-6;

void tidy(std::array<double, 3>& v) {
  for (double& x : v) {
    x = std::round(x / kStep) * kStep;
    x = x == 0.0 ? 0.0 : x;
  }
}

}  // namespace

project::Placement placedOn(const geometry::PartSurface& surface,
                            const geometry::Pose& T_part_file,
                            const geometry::Pose& T_part_substrate,
                            int face) {
  const geometry::Pose T_substrate_part = T_part_substrate.inverse();
  geometry::Pose turn = geometry::Pose::Identity();
  if (face >= 0) {
    geometry::Vec3 normal = geometry::Vec3::Zero();
    for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
      if (t < surface.binding.face.size() && surface.binding.face[t] == face) {
        const auto& c = surface.mesh.triangles[t];
        const geometry::Vec3& a = surface.mesh.vertices[c[0]];
        normal += (surface.mesh.vertices[c[1]] - a).cross(surface.mesh.vertices[c[2]] - a);
      }
    }
    if (normal.norm() > 0.0) {
      const geometry::Vec3 wanted = -geometry::Vec3::UnitZ();
      turn.linear() = Eigen::Quaterniond::FromTwoVectors(
                          T_substrate_part.linear() * normal.normalized(), wanted)
                          .toRotationMatrix();
    }
  }
  geometry::Box box;
  for (const geometry::Vec3& p : surface.mesh.vertices) {
    box.add(turn * (T_substrate_part * p));
  }
  geometry::Pose move = geometry::Pose::Identity();
  if (!box.empty()) {
    move.translation() = geometry::Vec3(-0.5 * (box.min.x() + box.max.x()),
                                        -0.5 * (box.min.y() + box.max.y()), -box.min.z());
  }
  project::Placement placement =
      project::toPlacement(T_part_substrate * move * turn * T_substrate_part * T_part_file);
  tidy(placement.positionMm);
  tidy(placement.rotationDeg);
  return placement;
}

}  // namespace wcam::gui
