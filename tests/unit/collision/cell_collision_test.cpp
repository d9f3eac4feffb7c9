// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/collision/cell_collision.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/cell/kinematics.hpp"

#include "scenes.hpp"
#include <gtest/gtest.h>

#include <stop_token>

namespace wcam::collision::test {
namespace {

/// The torch alone: a nozzle of given stand-off, radius and length about the tool axis.
cell::Cell nozzleCell(double standOff, double radius, double length) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.shapes = {};
  cell::Shape nozzle;
  nozzle.name = "nozzle";
  nozzle.kind = cell::ShapeKind::Cylinder;
  nozzle.frame = "tcp";
  nozzle.radius = radius;
  nozzle.length = length;
  nozzle.T_frame_shape.translation() = Vec3(0, 0, standOff + 0.5 * length);
  cell.shapes.torch.push_back(nozzle);
  return cell;
}

CollisionSettings noSafety() {
  CollisionSettings settings;
  settings.safetyDistance = 0.0;
  return settings;
}

Pose toolAt(const Vec3& p, const Vec3& axis) {
  Pose pose = Pose::Identity();
  pose.linear() = cell::frameWithZ(axis.normalized(), 0.3);
  pose.translation() = p;
  return pose;
}

float torchAlone(const CellCollision& collision, const Pose& tool, std::size_t deposited) {
  const ToolState state{tool, deposited};
  float result = 0.0F;
  collision.evaluateTorch(std::span(&state, 1), std::span(&result, 1));
  return result;
}

TEST(CellCollision, rodsLieUnderThePathAndCountInOrder) {
  toolpath::Toolpath path = straightWall(2, 10.0, 5.0);
  path.layers[0].beads[0].points[2].arc = false;
  const std::vector<DepositRod> rods = depositRods(path);
  ASSERT_EQ(rods.size(), 3U);
  EXPECT_EQ(rods[0].order, 2U);
  EXPECT_EQ(rods[1].order, 5U);
  EXPECT_EQ(rods[2].order, 6U);
  EXPECT_EQ(rods[0].radius, 3.0);
  EXPECT_EQ(rods[0].a, Vec3(0, 0, -1));  // the top of the bead is the path
  EXPECT_EQ(rods[0].b, Vec3(5, 0, -1));
}

TEST(CellCollision, onlyWhatIsDepositedCounts) {
  const cell::Cell cell = nozzleCell(0.0, 10.0, 60.0);
  const toolpath::Toolpath path = straightWall(30, 60.0, 2.0);
  const std::size_t perLayer = path.layers[0].beads[0].points.size();
  const CellCollision collision(cell, path, nullptr, noSafety());
  // Beside the wall at half its height, leaning over it.
  const Pose tool = toolAt(Vec3(30, 0, 20), Vec3(0, 0, 1));
  EXPECT_GT(torchAlone(collision, tool, 0), 10.0F);
  for (std::size_t layer = 0; layer < 30; ++layer) {
    const float clearance = torchAlone(collision, tool, (layer + 1) * perLayer);
    // Layers up to the tool's end are below it or touch it; the next ones stand inside.
    if (2.0 * static_cast<double>(layer + 1) <= 20.0) {
      EXPECT_GE(clearance, 0.0F) << layer;
    } else {
      EXPECT_LT(clearance, -1.9F) << layer;
    }
  }
}

/// The contact zone: the safety distance is not asked of the bead under the nozzle, touching it is.
TEST(CellCollision, contactZoneIsNoNearCollision) {
  const toolpath::Toolpath path = straightWall(10, 60.0, 2.0);
  const std::size_t all = path.pointCount();
  for (const double standOff : {0.0, 2.0, 14.0}) {
    const cell::Cell cell = nozzleCell(standOff, 10.0, 60.0);
    CollisionSettings settings;
    settings.safetyDistance = 6.0;
    const CellCollision collision(cell, path, nullptr, settings);
    EXPECT_GE(torchAlone(collision, toolAt(Vec3(30, 0, 20), Vec3::UnitZ()), all), 0.0F);
    // A TCP inside the wall: the material above it is a collision, or nearer than it may be.
    EXPECT_LT(torchAlone(collision, toolAt(Vec3(30, 0, 19 - standOff), Vec3::UnitZ()), all), 0.0F);
    // A nozzle that leans flat beside the wall.
    EXPECT_LT(torchAlone(collision, toolAt(Vec3(30, 12, 12), Vec3(0, -0.4, 1)), all), 0.0F);
  }
}

TEST(CellCollision, depthAndPlaceOfAContact) {
  const cell::Cell cell = nozzleCell(0.0, 10.0, 60.0);
  const toolpath::Toolpath path = straightWall(10, 60.0, 2.0);
  const CellCollision collision(cell, path, nullptr, noSafety());
  // The wall's top (z = 20) stands 4 mm into the nozzle's end.
  const auto contacts =
      collision.torchContacts({toolAt(Vec3(30, 0, 16), Vec3::UnitZ()), path.pointCount()}, 0.0);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].first, "torch nozzle");
  EXPECT_EQ(contacts[0].second, "part");
  EXPECT_NEAR(contacts[0].distance, -4.0, 1e-6);
  ASSERT_GE(contacts[0].rod, 0);
  EXPECT_EQ(collision.deposit()[static_cast<std::size_t>(contacts[0].rod)].a.z(), 17.0);
}

TEST(CellCollision, substrateAndItsMesh) {
  const cell::Cell cell = nozzleCell(0.0, 10.0, 60.0);
  const toolpath::Toolpath nothing;
  const toolpath::Substrate plate(Pose::Identity(), Vec3(100, 100, 10));
  auto body = std::make_shared<geometry::PartSurface>();
  for (int i = 0; i < 8; ++i) {
    body->mesh.vertices.emplace_back((i & 1) != 0 ? 50 : -50, (i & 2) != 0 ? 50 : -50,
                                     (i & 4) != 0 ? 0 : -10);
  }
  body->mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                          {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const toolpath::Substrate box(Pose::Identity(), body);
  const CellCollision withPlate(cell, nothing, &plate, noSafety());
  const CellCollision withMesh(cell, nothing, &box, noSafety());
  for (const double height : {-5.0, -0.5, 0.5, 5.0, 20.0}) {
    const Pose tool = toolAt(Vec3(10, 0, height), Vec3::UnitZ());
    const float a = torchAlone(withPlate, tool, 0);
    const float b = torchAlone(withMesh, tool, 0);
    EXPECT_EQ(a < 0.0F, height < 0.0) << height;
    EXPECT_EQ(b < 0.0F, height < 0.0) << height;
  }
  // A nozzle wholly inside of a closed mesh touches none of its triangles.
  const CellCollision deep(nozzleCell(1.0, 1.0, 3.0), nothing, &box, noSafety());
  EXPECT_LT(torchAlone(deep, toolAt(Vec3(0, 0, -7), Vec3::UnitZ()), 0), 0.0F);
}

/// The shipped cells as the files describe them: free at rest, and the pairs that overlap by
/// construction are not compared.
TEST(CellCollision, shippedCellsAreFreeAtRest) {
  for (const char* name :
       {"fanuc_arcmate120ic", "fanuc_arcmate120ic_part_carried", "yaskawa_ma1440_mt250",
        "yaskawa_ma1440_part_carried", "kuka_kr16", "kuka_kr16_positioner",
        "kuka_kr16_part_carried", "kuka_kr360_platter", "kuka_kr360_part_carried"}) {
    const cell::Cell cell = shippedCell(name);
    const toolpath::Substrate plate(Pose::Identity(), Vec3(100, 100, 10));
    const CellCollision collision(cell, toolpath::Toolpath(), &plate, CollisionSettings());
    ASSERT_TRUE(collision.anything());
    CellState state;
    state.joints = cell::JointVector::Zero(cell.jointCount());
    if (std::string(name).starts_with("kuka")) {
      // Upper arm vertical, forearm level, away from a fixed torch.
      state.joints(0) = degToRad(cell.partCarried() ? 90.0 : 0.0);
      state.joints(1) = degToRad(-90.0);
      state.joints(2) = degToRad(90.0);
    }
    for (const Contact& contact : collision.contacts(state, 5.0)) {
      ADD_FAILURE() << name << ": " << contact.first << " and " << contact.second << " "
                    << contact.distance;
    }
  }
}

TEST(CellCollision, robotRunsIntoFloorTableAndItself) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  const CellCollision collision(cell, toolpath::Toolpath(), nullptr, CollisionSettings());
  const auto has = [&](std::initializer_list<double> degrees, const std::string& a,
                       const std::string& b) {
    CellState state;
    state.joints.resize(8);
    Eigen::Index i = 0;
    for (const double value : degrees) {
      state.joints(i++) = degToRad(value);
    }
    for (const Contact& contact : collision.contacts(state, 0.0)) {
      if (contact.first == a && contact.second == b) {
        float clearance = 0.0F;
        collision.evaluate(std::span(&state, 1), std::span(&clearance, 1));
        return clearance < 0.0F;
      }
    }
    return false;
  };
  EXPECT_TRUE(has({0, 110, -60, 0, 0, 0, 0, 0}, "robot forearm", "obstacle floor"));
  EXPECT_TRUE(has({41.7, 60, -70, 0, 0, 0, 0, 0}, "robot forearm", "positioner table"));
  EXPECT_TRUE(has({0, 0, 0, 0, 130, 0, 0, 0}, "torch torch body", "robot forearm"));
}

TEST(CellCollision, cellWithoutShapesIsFree) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.shapes = {};
  const toolpath::Substrate plate(Pose::Identity(), Vec3(100, 100, 10));
  const CellCollision collision(cell, straightWall(3, 20, 2), &plate, CollisionSettings());
  EXPECT_FALSE(collision.anything());
  CellState state;
  state.joints = cell::JointVector::Zero(8);
  state.deposited = 100;
  float clearance = 0.0F;
  collision.evaluate(std::span(&state, 1), std::span(&clearance, 1));
  EXPECT_EQ(clearance, static_cast<float>(collision.settings().reach));
}

TEST(CellCollision, sameOnAnyNumberOfThreads) {
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  const toolpath::Toolpath path = bentTube(20, 100, 1.0);
  const auto states = randomStates(cell, path, 500, 3);
  std::vector<std::vector<float>> results;
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    const CellCollision collision(cell, path, nullptr, CollisionSettings());
    results.emplace_back(states.size());
    collision.evaluate(states, results.back());
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(CellCollision, cancelIsAnswered) {
  std::stop_source stop;
  stop.request_stop();
  const JobContext context(stop.get_token());
  EXPECT_THROW(CellCollision(shippedCell("fanuc_arcmate120ic"), bentTube(20, 100, 1.0), nullptr,
                             CollisionSettings(), context),
               CancelledError);
}

/// Beads without width, height or length, and a path of one point.
TEST(CellCollision, degenerateBeads) {
  const cell::Cell cell = nozzleCell(0.0, 10.0, 60.0);
  toolpath::Toolpath path = straightWall(2, 6.0, 2.0);
  path.layers[0].beads[0].points[1].p = path.layers[0].beads[0].points[0].p;
  path.layers[1].beads[0].points.resize(1);
  for (toolpath::PathPoint& point : path.layers[0].beads[0].points) {
    point.width = 0.0;
    point.height = 0.0;
  }
  const CellCollision collision(cell, path, nullptr, noSafety());
  EXPECT_LT(torchAlone(collision, toolAt(Vec3(3, 0, 1), Vec3::UnitZ()), 10), 0.0F);
  EXPECT_GT(torchAlone(collision, toolAt(Vec3(3, 0, 5), Vec3::UnitZ()), 10), 2.0F);
}

}  // namespace
}  // namespace wcam::collision::test
