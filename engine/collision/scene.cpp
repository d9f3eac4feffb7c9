// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene.hpp"

#include "wcam/base/error.hpp"
#include "wcam/cell/chain.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace wcam::collision::detail {

namespace {

/// Usual names of shapes, as in the cells that come with the program, can be said in other
/// languages.
Text shapeName(const std::string& name) {
  static const std::vector<Text> kUsual = {
      text("pedestal"), text("shoulder"), text("upper arm"),      text("elbow"),
      text("forearm"),  text("wrist"),    text("wrist plate"),    text("torch body"),
      text("neck"),     text("nozzle"),   text("cable envelope"), text("table"),
      text("holder"),   text("platter"),  text("tilt unit"),      text("floor"),
      text("stand"),    text("spindle"),  text("clamp"),          text("fixture"),
      text("column"),   text("wall"),     text("fence"),          text("cabinet")};
  const auto usual = std::find_if(kUsual.begin(), kUsual.end(),
                                  [&](const Text& own) { return own.pattern() == name; });
  return usual != kUsual.end() ? *usual : Text(name);
}

Text labelOf(BodyKind kind, const std::string& name) {
  switch (kind) {
    case BodyKind::Torch:
      return text("torch %1", {shapeName(name)});
    case BodyKind::Robot:
      return text("robot %1", {shapeName(name)});
    case BodyKind::Positioner:
      return text("positioner %1", {shapeName(name)});
    case BodyKind::Obstacle:
      return text("obstacle %1", {shapeName(name)});
    case BodyKind::Substrate:
    case BodyKind::Part:
      break;
  }
  return name;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// One of them says not to compare it with the other.
bool ignored(const Item& a, const Item& b) {
  return contains(a.shape.ignore, b.shape.name) || contains(b.shape.ignore, a.shape.name) ||
         contains(a.shape.ignore, b.shape.frame) || contains(b.shape.ignore, a.shape.frame);
}

/// How good the spheres of a shape are: round shapes are covered tightly.
double looseness(const Item& item) {
  double loosest = 0.0;
  for (const CoverSphere& sphere : item.cover) {
    loosest = std::max(loosest, sphere.radius);
  }
  return item.shape.kind == ShapeKind::Mesh || item.shape.kind == ShapeKind::Box ||
                 item.shape.length < item.shape.radius
             ? loosest + item.ball
             : loosest * 0.1;
}

}  // namespace

Scene::Scene(const cell::Cell& cell,
             const toolpath::Substrate* substrate,
             const CollisionSettings& settings,
             const JobContext& context)
    : cell_(cell) {
  const Making making{settings, context};
  const Frame table = frameOf("table");
  partBody_ = table.body;
  T_body_part_ = table.T_body_frame * cell_.T_table_part;
  const Frame tcp = frameOf("tcp");
  torchBody_ = tcp.body;
  T_body_tcp_ = tcp.T_body_frame;
  T_part_body_ = T_body_part_.inverse(Eigen::Isometry);
  T_tcp_body_ = T_body_tcp_.inverse(Eigen::Isometry);
  addShapes(cell_.shapes.torch, BodyKind::Torch, making);
  addShapes(cell_.shapes.robot, BodyKind::Robot, making);
  addShapes(cell_.shapes.positioner, BodyKind::Positioner, making);
  addShapes(cell_.shapes.obstacles, BodyKind::Obstacle, making);
  // A substrate alone has nothing to collide with.
  if (substrate != nullptr && !items_.empty()) {
    addSubstrate(*substrate, making);
  }
  findPairs();
}

Scene Scene::moved(const Pose& T_table_part) const {
  Scene result = *this;
  result.cell_.T_table_part = T_table_part;
  result.T_body_part_ = frameOf("table").T_body_frame * T_table_part;
  result.T_part_body_ = result.T_body_part_.inverse(Eigen::Isometry);
  const Pose move = result.T_body_part_ * T_body_part_.inverse(Eigen::Isometry);
  for (Item& item : result.items_) {
    if (item.kind != BodyKind::Substrate) {
      continue;
    }
    item.T_body_shape = move * item.T_body_shape;
    item.T_shape_body = item.T_body_shape.inverse(Eigen::Isometry);
    item.centre = move * item.centre;
    for (CoverSphere& sphere : item.cover) {
      sphere.centre = move * sphere.centre;
    }
  }
  return result;
}

Scene::Frame Scene::frameOf(const std::string& name) const {
  const int robot = cell_.robotJoints();
  if (name == "world") {
    return {0, cell_.T_world_base.inverse()};
  }
  if (name == "base") {
    return {0, Pose::Identity()};
  }
  if (name == "flange") {
    return {robot, cell_.robot.T_last_tip};
  }
  if (name == "tcp") {
    return cell_.partCarried() ? Frame{0, cell_.T_base_tcp}
                               : Frame{robot, cell_.robot.T_last_tip * cell_.T_flange_tcp};
  }
  if (name == "table") {
    if (cell_.partCarried()) {
      return {robot, cell_.robot.T_last_tip * cell_.T_flange_table};
    }
    const int joints = cell_.positionerJoints();
    return joints > 0 ? Frame{robot + joints, cell_.positioner.T_last_tip}
                      : Frame{0, cell_.positioner.T_root_first * cell_.positioner.T_last_tip};
  }
  for (int j = 0; j < cell_.jointCount(); ++j) {
    if (cell_.joint(j).name == name) {
      return {j + 1, Pose::Identity()};
    }
  }
  throw Error(ErrorCode::ProjectInvalid, text("the cell has no frame '%1'", {name}),
              text("cell %1", {cell_.name}), "name world, base, a joint, flange, tcp or table");
}

void Scene::addItem(
    Shape shape, BodyKind kind, Text label, const Frame& frame, const Making& making) {
  Item item;
  item.kind = kind;
  item.label = std::move(label);
  item.body = frame.body;
  item.T_body_shape = frame.T_body_frame * shape.T_frame_shape;
  item.T_shape_body = item.T_body_shape.inverse();
  item.cover = coverOf(shape);
  for (CoverSphere& sphere : item.cover) {
    sphere.centre = item.T_body_shape * sphere.centre;
  }
  item.exact = ExactShape(shape);
  if (shape.kind == ShapeKind::Mesh) {
    const geometry::Box box = shape.mesh->bounds();
    item.centre = item.T_body_shape * Vec3(0.5 * (box.min + box.max));
    item.ball = 0.5 * box.diagonal();
    item.field = std::make_shared<const MeshField>(*shape.mesh, making.settings.reach + item.ball,
                                                   making.settings.maxVoxels, making.context);
  } else {
    item.solid = primitiveOf(shape);
    item.centre = item.T_body_shape.translation();
    item.ball = outerRadius(item.solid);
  }
  item.shape = std::move(shape);
  items_.push_back(std::move(item));
}

void Scene::addShapes(const std::vector<Shape>& shapes, BodyKind kind, const Making& making) {
  for (const Shape& shape : shapes) {
    addItem(shape, kind, labelOf(kind, shape.name), frameOf(shape.frame), making);
  }
}

void Scene::addSubstrate(const toolpath::Substrate& substrate, const Making& making) {
  Shape shape;
  shape.name = "substrate";
  shape.frame = "part";
  if (substrate.isPlate()) {
    shape.kind = ShapeKind::Box;
    shape.size = substrate.size();
    shape.T_frame_shape = substrate.pose();
    shape.T_frame_shape.translation() -= 0.5 * shape.size.z() * substrate.up();
    if (!(shape.size.minCoeff() > 0.0)) {
      return;  // a plane without thickness holds nothing
    }
  } else {
    shape.kind = ShapeKind::Mesh;
    shape.mesh =
        std::shared_ptr<const geometry::TriangleMesh>(substrate.body(), &substrate.body()->mesh);
    if (shape.mesh->triangles.empty()) {
      return;
    }
  }
  addItem(std::move(shape), BodyKind::Substrate, "substrate", {partBody_, T_body_part_}, making);
}

/// 0 base, 1 robot, 2 positioner.
int Scene::chainOf(int body) const {
  return body == 0 ? 0 : body <= cell_.robotJoints() ? 1 : 2;
}

bool Scene::neighbours(int first, int second) const {
  const int low = std::min(first, second);
  const int high = std::max(first, second);
  const bool rooted = low == 0 && (high == 1 || high == cell_.robotJoints() + 1);
  return rooted || (high - low == 1 && low > 0 && chainOf(low) == chainOf(high));
}

/// Belongs to the arm or to what carries the part: an obstacle does not, nor does a torch that
/// stands in the cell.
bool Scene::isLink(const Item& item) const {
  return item.kind != BodyKind::Obstacle && (item.kind != BodyKind::Torch || !cell_.partCarried());
}

bool Scene::comparable(const Item& a, const Item& b) const {
  if (a.body == b.body || ignored(a, b)) {
    return false;
  }
  // The base belongs to the robot for the robot, to the positioner for the positioner.
  const bool robotA = a.kind == BodyKind::Robot || a.kind == BodyKind::Torch;
  const bool robotB = b.kind == BodyKind::Robot || b.kind == BodyKind::Torch;
  const bool oneChain = cell_.partCarried() || robotA == robotB;
  return !(oneChain && isLink(a) && isLink(b) && neighbours(a.body, b.body));
}

void Scene::findPairs() {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    const bool carries = item.kind == BodyKind::Positioner || cell_.partCarried();
    if (item.body != partBody_ && !contains(item.shape.ignore, "part") &&
        !(carries && isLink(item) && neighbours(item.body, partBody_))) {
      all_.againstPart.push_back(static_cast<int>(i));
    }
    for (std::size_t k = i + 1; k < items_.size(); ++k) {
      if (!comparable(items_[i], items_[k])) {
        continue;
      }
      const bool swap = looseness(items_[k]) < looseness(items_[i]);
      all_.pairs.push_back({static_cast<int>(swap ? k : i), static_cast<int>(swap ? i : k)});
    }
  }
  const auto atTcp = [this](int i) {
    const Item& item = items_[static_cast<std::size_t>(i)];
    return item.kind == BodyKind::Torch && item.body == torchBody_;
  };
  const auto isSubstrate = [this](int i) {
    return items_[static_cast<std::size_t>(i)].kind == BodyKind::Substrate;
  };
  std::copy_if(all_.againstPart.begin(), all_.againstPart.end(),
               std::back_inserter(torch_.againstPart), atTcp);
  std::copy_if(all_.pairs.begin(), all_.pairs.end(), std::back_inserter(torch_.pairs),
               [&](const Pair& pair) {
                 return (atTcp(pair.spheres) && isSubstrate(pair.field)) ||
                        (atTcp(pair.field) && isSubstrate(pair.spheres));
               });
  complete(all_);
  complete(torch_);
  findStanding();
}

void Scene::findStanding() {
  const auto jointTo = [this](const Item& item) {
    return item.body == partBody_ ? -1 : std::max(item.body, partBody_) - 1;
  };
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (items_[i].kind == BodyKind::Substrate) {
      standing_.substrate = static_cast<int>(i);
    }
  }
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    const auto k = static_cast<int>(i);
    if (item.kind == BodyKind::Substrate) {
      continue;
    }
    const std::vector<int>& moving = all_.againstPart;
    if (!contains(item.shape.ignore, "part") &&
        std::find(moving.begin(), moving.end(), k) == moving.end()) {
      standing_.withPart.push_back({k, jointTo(item)});
    }
    if (standing_.substrate < 0) {
      continue;
    }
    const Item& substrate = items_[static_cast<std::size_t>(standing_.substrate)];
    if (!ignored(item, substrate) && !comparable(item, substrate)) {
      standing_.withSubstrate.push_back({k, jointTo(item)});
    }
  }
}

/// Substrate first, since it is what the torch is nearest to; then the lists that follow from the
/// pairs.
void Scene::complete(Selection& selection) const {
  std::stable_partition(selection.pairs.begin(), selection.pairs.end(), [this](const Pair& pair) {
    const auto substrate = [this](int i) {
      return items_[static_cast<std::size_t>(i)].kind == BodyKind::Substrate;
    };
    return substrate(pair.spheres) || substrate(pair.field);
  });
  std::set<int> items(selection.againstPart.begin(), selection.againstPart.end());
  std::set<int> bodies;
  std::set<int> partBodies;
  for (const int i : selection.againstPart) {
    partBodies.insert(items_[static_cast<std::size_t>(i)].body);
  }
  for (const Pair& pair : selection.pairs) {
    items.insert({pair.spheres, pair.field});
    bodies.insert(items_[static_cast<std::size_t>(pair.field)].body);
  }
  selection.items.assign(items.begin(), items.end());
  selection.bodies.assign(bodies.begin(), bodies.end());
  selection.partBodies.assign(partBodies.begin(), partBodies.end());
}

void Scene::place(const double* q, BodyPoses& poses) const {
  const int robot = cell_.robotJoints();
  poses[0].setIdentity();
  // The frame after the last joint of a chain (flange, table) is fixed to that joint.
  BodyPoses scratch;
  cell::chainFrames(cell_.robot, q, scratch.data());
  std::copy_n(scratch.begin(), robot, poses.begin() + 1);
  if (cell_.positionerJoints() > 0) {
    cell::chainFrames(cell_.positioner, q + robot, scratch.data());
    std::copy_n(scratch.begin(), cell_.positionerJoints(), poses.begin() + 1 + robot);
  }
}

Pose Scene::T_base_tcp(const BodyPoses& poses) const {
  return poses[static_cast<std::size_t>(torchBody_)] * T_body_tcp_;
}

}  // namespace wcam::collision::detail
