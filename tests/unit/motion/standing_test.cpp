// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands inside something else, the configuration that is taken instead of one that breaks
// something, and the cable's limit.

#include "wcam/cell/inverse.hpp"
#include "wcam/collision/cell_collision.hpp"
#include "wcam/motion/collisions.hpp"

#include "paths.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace wcam::motion::test {
namespace {

using collision::CellCollision;
using collision::StandingContact;
using testing::HasSubstr;

toolpath::Substrate plateOf(double width, double depth, double thickness, double x = 0.0) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.translation().x() = x;
  return {pose, Vec3(width, depth, thickness)};
}

cell::Shape box(const std::string& name,
                const std::string& frame,
                const Vec3& centre,
                const Vec3& size) {
  cell::Shape shape;
  shape.name = name;
  shape.kind = cell::ShapeKind::Box;
  shape.frame = frame;
  shape.size = size;
  shape.T_frame_shape.translation() = centre;
  return shape;
}

cell::Shape ball(const std::string& name,
                 const std::string& frame,
                 const Vec3& centre,
                 double radius) {
  cell::Shape shape;
  shape.name = name;
  shape.kind = cell::ShapeKind::Sphere;
  shape.frame = frame;
  shape.radius = radius;
  shape.T_frame_shape.translation() = centre;
  return shape;
}

/// A closed box as triangles.
cell::Shape meshBox(const std::string& name,
                    const std::string& frame,
                    const Vec3& centre,
                    const Vec3& size) {
  cell::Shape shape = box(name, frame, centre, size);
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  for (int corner = 0; corner < 8; ++corner) {
    mesh->vertices.push_back(
        size.cwiseProduct(Vec3((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                               (corner & 4) != 0 ? 0.5 : -0.5)));
  }
  mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  shape.kind = cell::ShapeKind::Mesh;
  shape.mesh = mesh;
  return shape;
}

toolpath::Toolpath beads(int layers, double radius, double width) {
  toolpath::Toolpath path = circles(layers, radius, 36, Vec3::Zero());
  for (toolpath::Layer& layer : path.layers) {
    for (toolpath::PathPoint& point : layer.beads[0].points) {
      point.width = width;
    }
  }
  return path;
}

std::vector<StandingContact> standing(const cell::Cell& cell,
                                      const toolpath::Toolpath& path,
                                      const toolpath::Substrate* substrate) {
  collision::CollisionSettings settings;
  const CellCollision model(cell, path, substrate, settings);
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, MotionParams(), "op", context);
  std::vector<collision::CellState> states;
  for (const Waypoint& waypoint : planned.motion.waypoints) {
    states.push_back({waypoint.joints, waypoint.deposited});
  }
  return model.standingContacts(path, states, context);
}

std::optional<StandingContact> with(const std::vector<StandingContact>& all,
                                    const std::string& first,
                                    const std::string& second) {
  for (const StandingContact& contact : all) {
    if (contact.first.str() == first && contact.second.str() == second) {
      return contact;
    }
  }
  return std::nullopt;
}

std::optional<Diagnostic> first(const JobContext& context, const std::string& code) {
  for (const Diagnostic& finding : context.diagnostics().items()) {
    if (finding.code == code) {
      return finding;
    }
  }
  return std::nullopt;
}

double figure(const Diagnostic& finding, const std::string& name) {
  for (const auto& [key, value] : finding.data) {
    if (key == name) {
      return value;
    }
  }
  ADD_FAILURE() << name;
  return 0.0;
}

// Tables, plates on tables, feet of robots on floors: what is meant to touch does not stand inside.
TEST(Standing, whatTouchesIsNoContactInAnyShippedCell) {
  for (const char* name :
       {"debout_5axis", "debout_7axis", "fanuc_arcmate120ic", "kuka_kr16", "kuka_kr16_positioner",
        "kuka_kr360_platter", "yaskawa_ma1440_mt250", "kuka_kr16_part_carried",
        "kuka_kr360_part_carried", "yaskawa_ma1440_part_carried"}) {
    const cell::Cell cell = shippedCell(name);
    const toolpath::Substrate plate = plateOf(150, 150, 10);
    const auto found = standing(cell, beads(3, 30.0, 6.0), &plate);
    EXPECT_TRUE(found.empty()) << name << ": " << found.front().first.str() << " "
                               << found.front().depth << " in " << found.front().second.str();
  }
}

TEST(Standing, aPlateInTheTableIsAsDeepAsItIsTooThick) {
  for (const char* name : {"kuka_kr16", "fanuc_arcmate120ic", "kuka_kr16_positioner"}) {
    const toolpath::Substrate plate = plateOf(120, 100, 27);
    const auto found = with(standing(shippedCell(name), beads(1, 30.0, 6.0), &plate), "substrate",
                            "positioner table");
    ASSERT_TRUE(found) << name;
    EXPECT_NEAR(found->depth, 17.0, 1e-6) << name;  // the table's top is 10 below the part frame
    EXPECT_GT(found->way.z(), 0.9999) << name;
    EXPECT_NEAR(found->point.z(), -10.0 - 17.0 / 2, 1e-6) << name;
  }
}

TEST(Standing, aPlateThroughTheFootOfTheRobotIsFound) {
  // The pedestal's top and the plate's top are both 400 above the foot: 10 to go upwards. A plate
  // that just ends before it is free: pedestal to x = 190, table at 1100.
  const cell::Cell cell = shippedCell("kuka_kr16");
  const toolpath::Substrate wide = plateOf(2400, 700, 10, -300.0);
  const auto found =
      with(standing(cell, beads(1, 30.0, 6.0), &wide), "substrate", "robot pedestal");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 10.0, 1e-6);
  const toolpath::Substrate narrow = plateOf(1800, 700, 10);
  EXPECT_FALSE(with(standing(cell, beads(1, 30.0, 6.0), &narrow), "substrate", "robot pedestal"));
}

TEST(Standing, fixturesInPlateAndBeadsAreFoundOnFixedAndTurningTables) {
  for (const char* name : {"kuka_kr16", "fanuc_arcmate120ic"}) {
    cell::Cell cell = shippedCell(name);
    // A post beside the ring's wall of 6 from 27 to 33, and one that the wall passes through.
    cell.shapes.obstacles.push_back(box("beside", "table", Vec3(40, 0, 6), Vec3(10, 10, 12)));
    cell.shapes.obstacles.push_back(box("clamp", "table", Vec3(0, 35, 5), Vec3(8, 8, 10)));
    cell.shapes.obstacles.push_back(ball("screw", "table", Vec3(60, 60, -4), 6.0));
    const toolpath::Substrate plate = plateOf(200, 200, 10);
    const auto found = standing(cell, beads(2, 30.0, 6.0), &plate);
    EXPECT_FALSE(with(found, "part", "obstacle beside")) << name;
    EXPECT_FALSE(with(found, "part", "obstacle screw")) << name;
    const auto clamp = with(found, "part", "obstacle clamp");
    ASSERT_TRUE(clamp) << name;
    // The wall reaches to y = 33, the clamp begins at 31.
    EXPECT_GT(clamp->depth, 1.5) << name;
    EXPECT_LT(clamp->depth, 2.5) << name;
    EXPECT_GT(clamp->points, 0U) << name;
    EXPECT_NEAR(clamp->point.y(), 32.0, 2.0) << name;
    // A ball from z = -10 to 2 in a plate from -10 to 0: out at the top by 10.
    const auto screw = with(found, "substrate", "obstacle screw");
    ASSERT_TRUE(screw) << name;
    EXPECT_NEAR(screw->depth, 10.0, 0.01) << name;
  }
}

TEST(Standing, meshesAreComparedToo) {
  cell::Cell cell = shippedCell("kuka_kr16");
  cell.shapes.obstacles.push_back(meshBox("touching", "table", Vec3(0, 140, -5), Vec3(40, 80, 10)));
  cell.shapes.obstacles.push_back(meshBox("inside", "table", Vec3(90, 0, -5), Vec3(40, 40, 40)));
  cell.shapes.obstacles.push_back(
      meshBox("in the wall", "table", Vec3(-30, 0, 5), Vec3(20, 20, 10)));
  const toolpath::Substrate plate = plateOf(200, 200, 10);
  const auto found = standing(cell, beads(3, 30.0, 6.0), &plate);
  EXPECT_FALSE(with(found, "substrate", "obstacle touching"));
  const auto inside = with(found, "substrate", "obstacle inside");
  ASSERT_TRUE(inside);
  EXPECT_GT(inside->depth, 3.0);
  EXPECT_LE(inside->depth, 30.0);
  EXPECT_TRUE(with(found, "part", "obstacle in the wall"));
}

TEST(Standing, ofTheTiltingUnitEveryPositionThatIsReached) {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  // Beside the plate while it is level; the plate turns with J8 beside a post that J7 carries.
  cell::Shape post = box("post", "J7", Vec3::Zero(), Vec3(1, 1, 1));
  const cell::JointVector level = cell::JointVector::Zero(8);
  collision::CollisionSettings settings;
  const toolpath::Toolpath path = beads(1, 30.0, 6.0);
  const toolpath::Substrate plate = plateOf(300, 60, 10);
  const CellCollision bare(cell, path, &plate, settings);
  geometry::Pose T_base_plate = geometry::Pose::Identity();
  geometry::Pose T_base_tilt = geometry::Pose::Identity();
  for (const auto& shape : bare.placedShapes(level)) {
    if (shape.label.str() == "substrate") {
      T_base_plate = shape.T_base_shape;
    }
    if (shape.label.str() == "positioner tilt unit") {
      T_base_tilt = shape.T_base_shape * shape.shape->T_frame_shape.inverse();
    }
  }
  // 100 beside the centre across the plate: free at 0, inside after a quarter turn.
  geometry::Pose aside = geometry::Pose::Identity();
  aside.translation() = Vec3(0, 100, 0);
  post = ball("post", "J7", Vec3::Zero(), 20.0);
  post.T_frame_shape = T_base_tilt.inverse() * T_base_plate * aside;
  cell.shapes.positioner.push_back(post);
  const CellCollision model(cell, path, &plate, settings);
  const auto at = [&](double turnDeg) {
    cell::JointVector q = level;
    q(7) = degToRad(turnDeg);
    const std::vector<collision::CellState> states = {{level, 10}, {q, 20}};
    return with(model.standingContacts(path, states, JobContext()), "substrate", "positioner post");
  };
  EXPECT_FALSE(at(10.0));
  const auto turned = at(90.0);
  ASSERT_TRUE(turned);
  EXPECT_NEAR(turned->depth, 25.0, 0.01);  // ball of 20 in the middle of 10
}

TEST(Standing, isAViolationWithNamesDepthPlaceAndRemedy) {
  cell::Cell cell = shippedCell("kuka_kr16");
  cell.shapes.obstacles.push_back(box("vice", "table", Vec3(0, 35, 5), Vec3(8, 8, 10)));
  const toolpath::Substrate plate = plateOf(200, 200, 22);
  JobContext context;
  const CheckedMotion checked =
      planCheckedMotion(beads(2, 30.0, 6.0), cell, &plate, MotionParams(), "op", context);
  EXPECT_LT(checked.collisions.leastDistance, -1.0);
  std::vector<Diagnostic> found;
  for (const Diagnostic& finding : context.diagnostics().items()) {
    if (finding.code == "motion.standing_collision") {
      EXPECT_EQ(finding.severity, Severity::Violation);
      found.push_back(finding);
    }
  }
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].message.str(), HasSubstr("12.00 mm deep inside positioner table"));
  EXPECT_THAT(found[0].remedy.str(), HasSubstr("12.00 mm along +Z"));
  EXPECT_NEAR(figure(found[0], "depth_mm"), 12.0, 1e-6);
  EXPECT_THAT(found[1].message.str(), HasSubstr("inside obstacle vice"));
  EXPECT_GE(found[1].place.layer, 0);
  // Raised as the remedy says, the table is free.
  cell.T_table_part.translation().z() += 12.0;
  JobContext raised;
  planCheckedMotion(beads(2, 30.0, 6.0), cell, &plate, MotionParams(), "op", raised);
  const auto left = first(raised, "motion.standing_collision");
  EXPECT_FALSE(left && left->message.str().find("table") != std::string::npos);
  // Who does not want collisions looked at does not get them.
  MotionParams off;
  off.checkCollisions = false;
  JobContext silent;
  planCheckedMotion(beads(2, 30.0, 6.0), cell, &plate, off, "op", silent);
  EXPECT_FALSE(first(silent, "motion.standing_collision"));
}

// The depth of a contact is the least translation that parts the two.
TEST(Contacts, depthIsTheShortestWayOut) {
  cell::Cell cell = shippedCell("kuka_kr16");
  cell.shapes = {};
  cell::Shape nozzle;
  nozzle.name = "nozzle";
  nozzle.kind = cell::ShapeKind::Cylinder;
  nozzle.frame = "tcp";
  nozzle.radius = 9.0;
  nozzle.length = 80.0;
  nozzle.T_frame_shape.translation() = Vec3(0, 0, 55);  // from 15 to 95 above the TCP
  cell.shapes.torch.push_back(nozzle);
  const toolpath::Toolpath path = beads(1, 30.0, 6.0);
  const PlannedMotion planned = planMotion(path, cell, MotionParams(), "op", JobContext());
  const auto at = std::find_if(planned.motion.waypoints.begin(), planned.motion.waypoints.end(),
                               [](const Waypoint& w) { return w.point == 0; });
  ASSERT_NE(at, planned.motion.waypoints.end());
  const Vec3 tcp = at->T_part_tcp.translation();
  // A long bar that reaches 3.5 into the nozzle's side, all along its height.
  const double edge = tcp.y() + 9.0 - 3.5;
  cell.shapes.obstacles.push_back(
      box("bar", "table", Vec3(tcp.x(), edge + 50.0, tcp.z() + 60.0), Vec3(400, 100, 90)));
  collision::CollisionSettings settings;
  const CellCollision model(cell, path, nullptr, settings);
  const auto contacts = model.contacts({at->joints, 1}, 0.0);
  ASSERT_FALSE(contacts.empty());
  EXPECT_EQ(contacts.front().second.str(), "obstacle bar");
  EXPECT_NEAR(-contacts.front().distance, 3.5, 1e-3);
}

/// Violations of the operation in a configuration of the arm.
std::size_t violationsOf(const toolpath::Toolpath& path,
                         const cell::Cell& cell,
                         MotionParams params,
                         int branch) {
  params.branch = static_cast<BranchChoice>(branch + 1);
  JobContext context;
  planCheckedMotion(path, cell, nullptr, params, "op", context);
  EXPECT_FALSE(first(context, "motion.configuration_chosen"));  // who names one gets it
  return context.diagnostics().count(Severity::Violation);
}

TEST(AutomaticConfiguration, takesAnotherOneOnlyWhereTheFirstHasViolations) {
  const cell::Cell plain = shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = beads(2, 30.0, 6.0);
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  std::size_t cases = 0;
  for (int k = 0; k < 12; ++k) {
    params.torchRotation = Angle(degToRad(30.0 * k));
    JobContext context;
    const CheckedMotion usual = planCheckedMotion(path, plain, nullptr, params, "op", context);
    if (context.diagnostics().count(Severity::Violation) > 0 ||
        first(context, "motion.configuration_chosen")) {
      continue;
    }
    // A lamp where the forearm is: some other configuration may keep clear of it.
    const std::string name = usual.planned.statistics.branch;
    const auto mid =
        std::find_if(usual.planned.motion.waypoints.begin(), usual.planned.motion.waypoints.end(),
                     [](const Waypoint& w) { return w.point == 9; });
    cell::Cell cell = plain;
    const CellCollision model(plain, path, nullptr, collision::CollisionSettings());
    for (const auto& shape : model.placedShapes(mid->joints)) {
      if (shape.label.str() == "robot forearm") {
        cell.shapes.obstacles.push_back(
            ball("lamp", "base", shape.T_base_shape.translation(), 30.0));
      }
    }
    ASSERT_GT(cell.shapes.obstacles.size(), plain.shapes.obstacles.size());
    int free = -1;
    std::size_t ofUsual = 0;
    for (int b = 0; b < cell::Branch::kCount; ++b) {
      const std::size_t count = violationsOf(path, cell, params, b);
      free = free < 0 && count == 0 ? b : free;
      ofUsual = cell.inverse->branchName(b) == name ? count : ofUsual;
    }
    ASSERT_GT(ofUsual, 0U);
    JobContext lamp;
    const CheckedMotion other = planCheckedMotion(path, cell, nullptr, params, "op", lamp);
    const auto told = first(lamp, "motion.configuration_chosen");
    if (free < 0) {
      EXPECT_FALSE(told);
      EXPECT_EQ(other.planned.statistics.branch, name);
      continue;
    }
    ++cases;
    EXPECT_EQ(lamp.diagnostics().count(Severity::Violation), 0U);
    EXPECT_EQ(other.planned.statistics.branch, cell.inverse->branchName(free));
    ASSERT_TRUE(told);
    EXPECT_EQ(told->severity, Severity::Information);
    EXPECT_THAT(told->message.str(), HasSubstr(other.planned.statistics.branch));
    EXPECT_THAT(told->message.str(), HasSubstr(name));
  }
  EXPECT_GE(cases, 1U);
}

TEST(Cable, twistBeyondTheLimitIsAViolationWithFiguresAndARemedyThatIsTried) {
  const cell::Cell cell = shippedCell("kuka_kr16");
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  params.branch = BranchChoice::Nut;
  params.torchRotation = Angle(degToRad(60.0));
  const toolpath::Toolpath path = beads(1, 30.0, 6.0);
  const double twist = planMotion(path, cell, params, "op", JobContext()).statistics.maxCableTwist;
  ASSERT_GT(twist, degToRad(15.0));
  params.cableLimit = Angle(twist - degToRad(12.0));
  JobContext context;
  planCheckedMotion(path, cell, nullptr, params, "op", context);
  const auto finding = first(context, "motion.cable_twist");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::Violation);
  EXPECT_NEAR(std::abs(figure(*finding, "twist_deg")), radToDeg(twist), 1e-3);
  EXPECT_NEAR(figure(*finding, "limit_deg"), radToDeg(twist) - 12.0, 1e-9);
  EXPECT_THAT(finding->message.str(), HasSubstr("its limit is"));
  EXPECT_EQ(finding->place.layer, 0);
  EXPECT_GE(finding->place.point, 0);
  // Followed, the remedy helps.
  params.torchRotation = Angle(degToRad(figure(*finding, "try_rotation_deg")));
  JobContext cured;
  planCheckedMotion(path, cell, nullptr, params, "op", cured);
  EXPECT_FALSE(first(cured, "motion.cable_twist"));
}

TEST(Cable, ofTwoMotionsTheOneThatKeepsTheLimitIsBetter) {
  Evaluation twisted;
  twisted.broken[static_cast<std::size_t>(Constraint::Cable)] = 3;
  Evaluation slow;
  slow.broken[static_cast<std::size_t>(Constraint::Speed)] = 30;
  EXPECT_EQ(twisted.violations(), 3U);
  EXPECT_TRUE(slow.betterThan(twisted));
}

}  // namespace
}  // namespace wcam::motion::test
