// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/collision/clearance.hpp"
#include "wcam/collision/deposit.hpp"
#include "wcam/toolpath/substrate.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <memory>
#include <string>
#include <vector>

namespace wcam::collision {

struct CollisionSettings {
  double safetyDistance = 5.0;           ///< mm
  double reach = 60.0;                   ///< clearances above this are cut off, mm
  std::size_t maxVoxels = 256UL * 1024;  ///< of each look-up grid
  /// Ask the exact geometry about states that the grids cannot free; else evaluate() gives the
  /// bound of the grids alone, of which a negative value only tells that it is negative.
  bool refine = true;
};

/// The tool alone at a moment of the build.
struct ToolState {
  geometry::Pose T_part_tcp = geometry::Pose::Identity();
  std::size_t deposited = 0;  ///< see CellState
};

/// Which part of the cell something belongs to.
enum class BodyKind { Torch, Robot, Positioner, Obstacle, Substrate, Part };

/// Overlap of two bodies, or how near they are.
struct Contact {
  Text first;   ///< "torch nozzle", "robot forearm", …
  Text second;  ///< … "part", "substrate", "positioner table", "obstacle floor"
  BodyKind firstKind = BodyKind::Torch;
  BodyKind secondKind = BodyKind::Part;
  /// mm; negative: the least translation that parts them, of meshes how deep one reaches into the
  /// other.
  double distance = 0.0;
  geometry::Vec3 point = geometry::Vec3::Zero();  ///< where, part frame
  /// With the part: the rod of the deposit (index of CellCollision::deposit()); else −1.
  std::ptrdiff_t rod = -1;
};

/// The substrate or beads that stand inside a shape of the cell.
struct StandingContact {
  Text first;   ///< "substrate", "part"
  Text second;  ///< "positioner table", "obstacle clamp", …
  BodyKind firstKind = BodyKind::Substrate;
  double depth = 0.0;                             ///< mm: the least translation that parts them
  geometry::Vec3 point = geometry::Vec3::Zero();  ///< where, part frame
  /// Unit vector in the part frame along which the substrate leaves by the depth; zero where that
  /// is not known (meshes, beads).
  geometry::Vec3 way = geometry::Vec3::Zero();
  std::size_t beadPoint = 0;  ///< of beads: the number of the deepest point, over the whole path
  std::size_t points = 0;     ///< of beads: how many points
};

/// Deeper than this is no contact of things that stand on one another, mm: what tables, plates and
/// the poses of cells are measured to.
inline constexpr double kStandingContact = 0.5;

/// A shape where it is at some joints.
struct PlacedShape {
  const cell::Shape* shape = nullptr;
  BodyKind kind = BodyKind::Obstacle;
  Text label;
  geometry::Pose T_base_shape = geometry::Pose::Identity();
};

/// Collision of torch, robot and positioner with each other, the cell, the substrate and the part
/// as it grows (issue: only what is deposited before a point counts; Diourté M33).
///
/// What is compared: every two shapes that can move against each other, but for links of one arm
/// that a single joint connects (they overlap there) and what a shape says to ignore; the deposit
/// and the substrate with every shape that does not carry them.
///
/// The contact zone: the torch meets fresh material at the TCP on purpose. Material that lies
/// wholly below the plane through the TCP across the tool axis cannot be touched by a torch above
/// that plane whatever its form, and its distance is the stick-out, a value of the process: the
/// safety distance is not asked of it, touching it is a collision all the same.
///
/// Three stages: look-up grids with spheres for thousands of states per call (about 1 µs each, with
/// forward kinematics); exact distances of rods and convex solids in a bounding hierarchy that
/// grows with the build (order-aware nodes); FCL for meshes and pairs of boxes and cylinders.
class CellCollision final : public Clearance {
public:
  /// @param substrate may be null. Cost: about 1 s for 100 000 points.
  CellCollision(const cell::Cell& cell,
                const toolpath::Toolpath& path,
                const toolpath::Substrate* substrate,
                const CollisionSettings& settings,
                const JobContext& context = JobContext());
  ~CellCollision() override;

  /// The same with part and substrate elsewhere on the table. Cheap: what the part's own frame
  /// holds is shared.
  [[nodiscard]] std::unique_ptr<CellCollision> moved(const geometry::Pose& T_table_part) const;

  /// False when the cell has no shapes: nothing can collide.
  [[nodiscard]] bool anything() const;
  [[nodiscard]] const CollisionSettings& settings() const;

  void evaluate(std::span<const CellState> states, std::span<float> clearance) const override;

  /// The same for what is fixed to the TCP alone, against the deposit and the substrate: which tool
  /// poses are free, whatever the robot does.
  void evaluateTorch(std::span<const ToolState> states, std::span<float> clearance) const;

  /// Exact distances of all pairs nearer than `within` (mm), the nearest first; of each shape
  /// against the part the nearest rod. Slower than evaluate(): for reports.
  [[nodiscard]] std::vector<Contact> contacts(const CellState& state, double within) const;

  [[nodiscard]] std::vector<Contact> torchContacts(const ToolState& state, double within) const;

  /// What evaluate() does not compare since nothing, or one joint alone, moves it: the substrate
  /// and the beads (with the section that they have, by the path) with every shape that carries
  /// them or stands beside them, at the positions that the states reach. Only what is deeper than
  /// kStandingContact, of beads only what reaches their core; the deepest place of each pair.
  /// @param path that the model was made of
  [[nodiscard]] std::vector<StandingContact> standingContacts(const toolpath::Toolpath& path,
                                                              std::span<const CellState> states,
                                                              const JobContext& context) const;

  /// Every shape of the scene where it is, for displays and checks.
  [[nodiscard]] std::vector<PlacedShape> placedShapes(const cell::JointVector& joints) const;
  /// True when evaluate() compares the two shapes (indices of placedShapes); with −1 the deposit.
  [[nodiscard]] bool compares(std::ptrdiff_t first, std::ptrdiff_t second) const;
  [[nodiscard]] const std::vector<DepositRod>& deposit() const;

private:
  struct Impl;
  explicit CellCollision(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::collision
