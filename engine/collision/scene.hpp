// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/cell.hpp"
#include "wcam/collision/cell_collision.hpp"

#include "exact.hpp"
#include "mesh_field.hpp"
#include "primitive.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace wcam::collision::detail {

/// What moves as one: 0 is fixed in the base, then the robot's joints, then the positioner's.
using BodyPoses = std::array<Pose, 13>;

/// A shape on its body.
struct Item {
  Shape shape;
  BodyKind kind = BodyKind::Obstacle;
  Text label;
  int body = 0;
  Pose T_body_shape = Pose::Identity();
  Pose T_shape_body = Pose::Identity();
  Primitive solid;             ///< not of a mesh
  Vec3 centre = Vec3::Zero();  ///< of the ball that holds it, body frame
  double ball = 0.0;
  std::vector<CoverSphere> cover;  ///< body frame
  std::shared_ptr<const MeshField> field;
  ExactShape exact;

  [[nodiscard]] bool isMesh() const { return shape.kind == ShapeKind::Mesh; }
};

/// Two items that are compared: the spheres of the first with the field of the second.
struct Pair {
  int spheres = 0;
  int field = 0;
};

/// What is compared.
struct Selection {
  std::vector<int> againstPart;  ///< items with the deposit, the torch's first
  std::vector<Pair> pairs;       ///< the substrate's first
  std::vector<int> items;        ///< all that stand in one of these
  std::vector<int> bodies;       ///< those of the pairs' fields
  std::vector<int> partBodies;   ///< those of againstPart
};

/// What never moves against each other, or by one joint alone: not compared in every state, but it
/// must not stand inside each other either.
struct Standing {
  struct With {
    int item = 0;
    int joint = -1;  ///< the joint between it and the part, −1: none
  };

  int substrate = -1;               ///< item; −1: none
  std::vector<With> withSubstrate;  ///< items
  std::vector<With> withPart;       ///< items, with the deposit
};

/// Shapes of a cell with the substrate, who is compared with whom, and where they are.
class Scene {
public:
  Scene(const cell::Cell& cell,
        const toolpath::Substrate* substrate,
        const CollisionSettings& settings,
        const JobContext& context);

  /// With the part and the substrate elsewhere on the table.
  [[nodiscard]] Scene moved(const Pose& T_table_part) const;

  [[nodiscard]] const std::vector<Item>& items() const noexcept { return items_; }

  [[nodiscard]] const Selection& all() const noexcept { return all_; }

  /// What is fixed to the TCP, with the deposit and the substrate.
  [[nodiscard]] const Selection& torch() const noexcept { return torch_; }

  [[nodiscard]] const Standing& standing() const noexcept { return standing_; }

  [[nodiscard]] bool prismatic(int joint) const { return cell_.joint(joint).prismatic(); }

  [[nodiscard]] int torchBody() const noexcept { return torchBody_; }

  [[nodiscard]] const Pose& T_tcp_body() const noexcept { return T_tcp_body_; }

  [[nodiscard]] const Pose& T_part_body() const noexcept { return T_part_body_; }

  [[nodiscard]] int partBody() const noexcept { return partBody_; }

  [[nodiscard]] const Pose& T_body_part() const noexcept { return T_body_part_; }

  /// Bodies in the base frame; `q` as the cell orders it.
  void place(const double* q, BodyPoses& poses) const;
  [[nodiscard]] Pose T_base_tcp(const BodyPoses& poses) const;

private:
  struct Frame {
    int body = 0;
    Pose T_body_frame = Pose::Identity();
  };

  [[nodiscard]] Frame frameOf(const std::string& name) const;

  /// What a mesh's grid is made with.
  struct Making {
    const CollisionSettings& settings;
    const JobContext& context;
  };

  void addShapes(const std::vector<Shape>& shapes, BodyKind kind, const Making& making);
  void addSubstrate(const toolpath::Substrate& substrate, const Making& making);
  void addItem(Shape shape, BodyKind kind, Text label, const Frame& frame, const Making& making);
  [[nodiscard]] int chainOf(int body) const;
  /// Joined by a single joint.
  [[nodiscard]] bool neighbours(int first, int second) const;
  [[nodiscard]] bool isLink(const Item& item) const;
  [[nodiscard]] bool comparable(const Item& a, const Item& b) const;
  void findPairs();
  void findStanding();
  void complete(Selection& selection) const;

  cell::Cell cell_;
  std::vector<Item> items_;
  Selection all_;
  Selection torch_;
  Standing standing_;
  int partBody_ = 0;
  int torchBody_ = 0;
  Pose T_body_part_ = Pose::Identity();
  Pose T_body_tcp_ = Pose::Identity();
  Pose T_part_body_ = Pose::Identity();
  Pose T_tcp_body_ = Pose::Identity();
};

}  // namespace wcam::collision::detail
