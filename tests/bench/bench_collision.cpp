// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The torch against a part of a million triangles: the grids of CellCollision against FCL's boolean
// query of two meshes (OBBRSS), the same poses of the torch in one run, one thread. The meshes lie
// inside the solids that they stand for, so that whatever FCL finds must be found; a run that
// misses one fails.

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/collision/cell_collision.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

namespace {

using wcam::collision::CellCollision;
using wcam::collision::ToolState;
using wcam::geometry::Pose;
using wcam::geometry::TriangleMesh;
using wcam::geometry::Vec3;

constexpr int kLayers = 125;
constexpr int kPoints = 500;  // per layer: 62 500 rods of 16 triangles
constexpr int kSides = 8;
constexpr std::size_t kStates = 100000;
constexpr int kRepetitions = 5;
constexpr double kGoal = 100.0;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A quarter of a torus of pipe radius 40 and bend radius 125 in 125 layers.
wcam::toolpath::Toolpath quarterTorus() {
  wcam::toolpath::Toolpath path;
  for (int l = 1; l <= kLayers; ++l) {
    const double angle = 0.5 * wcam::kPi * l / kLayers;
    const Vec3 across(std::cos(angle), 0, -std::sin(angle));
    const Vec3 along(std::sin(angle), 0, std::cos(angle));
    const Vec3 centre(125 * (1 - std::cos(angle)), 0, 125 * std::sin(angle));
    wcam::toolpath::Bead bead;
    for (int i = 0; i <= kPoints; ++i) {
      const double a = 2 * wcam::kPi * i / kPoints;
      wcam::toolpath::PathPoint point;
      const Vec3 out = std::cos(a) * across + std::sin(a) * Vec3::UnitY();
      point.p = centre + 40 * out;
      point.b = point.axis = point.up = along;
      point.t = along.cross(out);
      point.height = 1.6;
      point.width = 5.0;
      bead.points.push_back(point);
    }
    wcam::toolpath::Layer layer;
    layer.beads.push_back(std::move(bead));
    path.layers.push_back(std::move(layer));
  }
  return path;
}

/// Prism inside a rod, open at its ends.
void addPrism(const Vec3& a, const Vec3& b, double radius, int sides, TriangleMesh& mesh) {
  const Vec3 along = (b - a).normalized();
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.cross(u);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * wcam::kPi * k / sides;
    const Vec3 out = radius * (std::cos(angle) * u + std::sin(angle) * v);
    mesh.vertices.push_back(a + out);
    mesh.vertices.push_back(b + out);
  }
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t i = first + 2 * k;
    const std::uint32_t j = first + 2 * ((k + 1) % n);
    mesh.triangles.push_back({i, j, j + 1});
    mesh.triangles.push_back({i, j + 1, i + 1});
  }
}

void addDisc(const Vec3& centre, const Vec3& along, double radius, int sides, TriangleMesh& mesh) {
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.cross(u);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(centre);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * wcam::kPi * k / sides;
    mesh.vertices.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t k = 0; k < n; ++k) {
    mesh.triangles.push_back({first, first + 1 + k, first + 1 + (k + 1) % n});
  }
}

/// The torch's shapes as a fine mesh inside them, in the frame of the TCP.
TriangleMesh torchMesh(const wcam::cell::Cell& cell) {
  constexpr int kTorchSides = 64;
  constexpr int kRings = 8;
  TriangleMesh mesh;
  for (const wcam::cell::Shape& shape : cell.shapes.torch) {
    if (shape.frame != "tcp" && shape.frame != "flange") {
      continue;
    }
    const Pose pose = (shape.frame == "tcp" ? Pose::Identity() : cell.T_flange_tcp.inverse()) *
                      shape.T_frame_shape;
    const Vec3 half(0, 0, 0.5 * shape.length);
    for (int k = 0; k < kRings; ++k) {
      const Vec3 from = -half + 2.0 * half * k / kRings;
      const Vec3 to = -half + 2.0 * half * (k + 1) / kRings;
      addPrism(pose * from, pose * to, shape.radius, kTorchSides, mesh);
    }
    for (const double side : {-1.0, 1.0}) {
      addDisc(pose * Vec3(side * half), pose.linear().col(2), shape.radius, kTorchSides, mesh);
    }
  }
  return mesh;
}

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::unique_ptr<Model> modelOf(const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  auto model = std::make_unique<Model>();
  model->beginModel();
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

/// Tool poses near the surface, as planning meets them and beyond.
std::vector<ToolState> randomTools(const std::vector<wcam::collision::DepositRod>& rods) {
  std::mt19937_64 random(20261127);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  std::vector<ToolState> tools;
  while (tools.size() < kStates) {
    ToolState tool;
    const Vec3& near = rods[random() % rods.size()].a;
    tool.T_part_tcp.translation() =
        near + Vec3(uniform(-25, 25), uniform(-25, 25), uniform(-25, 25));
    const Vec3 axis(uniform(-1, 1), uniform(-1, 1), uniform(-0.3, 1));
    if (axis.norm() < 0.1) {
      continue;
    }
    tool.T_part_tcp.linear() =
        wcam::cell::frameWithZ(axis.normalized(), uniform(-wcam::kPi, wcam::kPi));
    tool.deposited = 1U << 30U;  // all of it, as the mesh
    tools.push_back(tool);
  }
  return tools;
}

}  // namespace

int main() {
  const wcam::ThreadLimit oneThread(1);
  const wcam::cell::Cell cell =
      wcam::cell::loadCell(std::string(WCAM_RESOURCES) + "/cells/fanuc_arcmate120ic.json");
  const wcam::toolpath::Toolpath path = quarterTorus();
  wcam::collision::CollisionSettings settings;
  settings.safetyDistance = 0.0;
  double start = seconds();
  const CellCollision exact(cell, path, nullptr, settings);
  const double build = seconds() - start;
  settings.refine = false;
  const CellCollision grids(cell, path, nullptr, settings);
  TriangleMesh part;
  for (const auto& rod : exact.deposit()) {
    addPrism(rod.a, rod.b, rod.radius, kSides, part);
  }
  const TriangleMesh torch = torchMesh(cell);
  start = seconds();
  const auto partModel = modelOf(part);
  const double fclBuild = seconds() - start;
  const auto torchModel = modelOf(torch);
  const std::vector<ToolState> tools = randomTools(exact.deposit());

  std::vector<float> bound(tools.size());
  std::vector<float> refined(tools.size());
  double fast = 1e300;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    start = seconds();
    grids.evaluateTorch(tools, bound);
    fast = std::min(fast, seconds() - start);
  }
  start = seconds();
  exact.evaluateTorch(tools, refined);
  const double withExact = seconds() - start;

  std::vector<char> hit(tools.size());
  start = seconds();
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    hit[i] = fcl::collide(torchModel.get(), tools[i].T_part_tcp, partModel.get(), Pose::Identity(),
                          request, result) > 0
                 ? 1
                 : 0;
  }
  const double reference = seconds() - start;

  std::size_t colliding = 0;
  std::size_t missed = 0;
  std::size_t missedExact = 0;
  std::size_t alarms = 0;
  std::size_t free = 0;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    colliding += hit[i] != 0 ? 1 : 0;
    missed += hit[i] != 0 && bound[i] >= 0.0F ? 1 : 0;
    missedExact += hit[i] != 0 && refined[i] >= 0.0F ? 1 : 0;
    free += refined[i] >= 0.0F ? 1 : 0;
    alarms += refined[i] >= 0.0F && bound[i] < 0.0F ? 1 : 0;
  }
  const auto count = static_cast<double>(tools.size());
  std::printf("part %zu triangles in %zu rods, torch %zu triangles, %zu states, %zu colliding\n",
              part.triangles.size(), exact.deposit().size(), torch.triangles.size(), tools.size(),
              colliding);
  std::printf("build: grids and hierarchy %.3f s, FCL %.3f s\n", build, fclBuild);
  std::printf("grids            %9.1f ns/state\n", fast / count * 1e9);
  std::printf("grids and exact  %9.1f ns/state\n", withExact / count * 1e9);
  std::printf("FCL boolean      %9.1f ns/state\n", reference / count * 1e9);
  std::printf(
      "missed by the grids %zu, by the exact stage %zu; free %zu, of these not freed by the "
      "grids %zu (%.2f %% of all)\n",
      missed, missedExact, free, alarms, 100.0 * static_cast<double>(alarms) / count);
  std::printf("ratio %.1f (goal %.0f), with the exact stage %.1f\n", reference / fast, kGoal,
              reference / withExact);
  if (missed > 0 || missedExact > 0) {
    std::printf("a collision was missed: the run is invalid\n");
    return 1;
  }
  return 0;
}
