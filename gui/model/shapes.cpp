// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/cell/kinematics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace wcam::gui {

namespace {

using geometry::Pose;
using geometry::Vec3;
using viewport::Body;
using viewport::MeshData;
using viewport::Solid;

// Edges of a mesh file that are drawn: those where it folds by more than this, rad.
const double kSharp = degToRad(30.0);

void addPoint(std::vector<float>& to, const Vec3& p) {
  for (int i = 0; i < 3; ++i) {
    to.push_back(static_cast<float>(p[i]));
  }
}

/// CAD edges: the half-edges of each edge in the order of its parameter. An edge between two faces
/// has two half-edges per piece; one of them is drawn.
void addCadEdges(const geometry::PartSurface& surface, MeshData& mesh) {
  struct Piece {
    double begin;
    std::uint32_t from;
    std::uint32_t to;
  };

  std::map<std::int32_t, std::vector<Piece>> pieces;
  const auto& triangles = surface.mesh.triangles;
  for (std::uint32_t h = 0; h < surface.binding.edge.size(); ++h) {
    const std::int32_t edge = surface.binding.edge[h];
    const std::uint32_t twin = surface.halfEdges.twin(h);
    if (edge < 0 || (twin != geometry::HalfEdges::kNone && twin < h)) {
      continue;
    }
    const std::uint32_t a = triangles[h / 3][h % 3];
    const std::uint32_t b = triangles[h / 3][(h + 1) % 3];
    const auto& range = surface.binding.edgeParam[h];
    pieces[edge].push_back(range[0] <= range[1] ? Piece{range[0], a, b} : Piece{range[1], b, a});
  }
  for (auto& [edge, list] : pieces) {
    std::sort(list.begin(), list.end(),
              [](const Piece& a, const Piece& b) { return a.begin < b.begin; });
    std::uint32_t last = geometry::HalfEdges::kNone;
    for (const Piece& piece : list) {
      if (piece.from != last) {
        // A gap (the edge is shared by pieces of another body): a polyline of its own.
        mesh.edgeBegin.push_back(static_cast<std::uint32_t>(mesh.edgePositions.size() / 3));
        mesh.edgeIds.push_back(edge);
        addPoint(mesh.edgePositions, surface.mesh.vertices[piece.from]);
      }
      addPoint(mesh.edgePositions, surface.mesh.vertices[piece.to]);
      last = piece.to;
    }
  }
  // Free curves have no triangles; they are guides, sampled from the exact curve.
  geometry::BrepEvaluator evaluator(*surface.brep);
  for (int e = 0; e < surface.brep->edgeCount(); ++e) {
    const geometry::BrepEdgeInfo& info = surface.brep->edge(e);
    if (info.faceCount != 0) {
      continue;
    }
    constexpr int kSteps = 96;
    mesh.edgeBegin.push_back(static_cast<std::uint32_t>(mesh.edgePositions.size() / 3));
    mesh.edgeIds.push_back(e);
    for (int i = 0; i <= kSteps; ++i) {
      const double t = info.range[0] + (info.range[1] - info.range[0]) * i / kSteps;
      addPoint(mesh.edgePositions, evaluator.curve(e, t).p);
    }
  }
  mesh.edgeBegin.push_back(static_cast<std::uint32_t>(mesh.edgePositions.size() / 3));
}

void addSharpEdges(const geometry::PartSurface& surface, MeshData& mesh) {
  const auto& half = surface.halfEdges;
  const auto& triangles = surface.mesh.triangles;
  for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h) {
    const std::uint32_t twin = half.twin(h);
    if (twin != geometry::HalfEdges::kNone &&
        (twin < h ||
         surface.mesh.normal(h / 3).dot(surface.mesh.normal(twin / 3)) > std::cos(kSharp))) {
      continue;
    }
    mesh.edgeBegin.push_back(static_cast<std::uint32_t>(mesh.edgePositions.size() / 3));
    mesh.edgeIds.push_back(-1);
    addPoint(mesh.edgePositions, surface.mesh.vertices[triangles[h / 3][h % 3]]);
    addPoint(mesh.edgePositions, surface.mesh.vertices[triangles[h / 3][(h + 1) % 3]]);
  }
  mesh.edgeBegin.push_back(static_cast<std::uint32_t>(mesh.edgePositions.size() / 3));
}

viewport::Point pointOf(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

constexpr viewport::Colour kRobot = {232, 176, 42};
constexpr viewport::Colour kJoint = {72, 78, 88};
constexpr viewport::Colour kTable = {120, 130, 142};
constexpr viewport::Colour kObstacle = {150, 140, 128};

/// Place on the axis of the next joint, seen from a joint's frame.
Vec3 onNextAxis(const cell::Joint& next, double along) {
  return {next.d, -std::sin(next.alpha) * along, std::cos(next.alpha) * along};
}

/// Where the origin of the next joint's frame may stand: one place of a rotary joint, a rail of a
/// linear one, which its carriage moves along.
struct NextOrigin {
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
};

NextOrigin nextOrigin(const cell::Joint& next) {
  if (!next.prismatic() || !std::isfinite(next.min) || !std::isfinite(next.max)) {
    return {onNextAxis(next, next.r), onNextAxis(next, next.r)};
  }
  return {onNextAxis(next, next.r + next.sign * next.min),
          onNextAxis(next, next.r + next.sign * next.max)};
}

/// Nearest point of the next joint's origins to a point.
Vec3 nearestOrigin(const NextOrigin& origin, const Vec3& p) {
  const Vec3 rail = origin.to - origin.from;
  const double square = rail.squaredNorm();
  return origin.from +
         (square > 0.0 ? std::clamp((p - origin.from).dot(rail) / square, 0.0, 1.0) : 0.0) * rail;
}

void addLink(Body& body, const Vec3& knee, const Vec3& end, double radius) {
  const double least = 1.0;  // mm: shorter pieces are no solid
  if (knee.norm() > least) {
    body.solids.push_back({Solid::Kind::Capsule, {0, 0, 0}, pointOf(knee), radius, kRobot});
  }
  if ((end - knee).norm() > least) {
    body.solids.push_back({Solid::Kind::Capsule, pointOf(knee), pointOf(end), radius, kRobot});
  }
}

/// From a joint's frame to the next joint, with the rail of a linear one.
void addLinkTo(Body& body, const cell::Joint& next, double radius) {
  const NextOrigin origin = nextOrigin(next);
  const Vec3 knee(next.d, 0, 0);
  addLink(body, knee, nearestOrigin(origin, knee), radius);
  if (origin.from != origin.to) {
    body.solids.push_back(
        {Solid::Kind::Capsule, pointOf(origin.from), pointOf(origin.to), 0.5 * radius, kRobot});
  }
}

/// Radius of a link: thick at the base, thin at the wrist.
double linkRadius(double reach, int joint, int joints) {
  return reach * (0.052 - 0.032 * joint / std::max(joints, 1));
}

void addRobot(const cell::Cell& cell, std::vector<Body>& bodies) {
  double reach = 0.0;
  bool linear = false;
  for (const cell::Joint& joint : cell.robot.joints) {
    reach += std::abs(joint.d) + std::abs(joint.r);
    linear = linear || joint.prismatic();
  }
  // The lengths of a machine are strokes: these tell nothing about how thick it is.
  constexpr double kMachine = 1500.0;  // mm
  reach = linear ? std::max(reach, kMachine) : reach;
  const int count = cell.robotJoints();
  for (int i = 0; i < count; ++i) {
    Body body;
    body.name = cell.robot.joints[static_cast<std::size_t>(i)].name;
    const double radius = linkRadius(reach, i, count);
    body.solids.push_back({Solid::Kind::Cylinder,
                           {0, 0, -1.25 * radius},
                           {0, 0, 1.25 * radius},
                           1.1 * radius,
                           kJoint});
    if (i + 1 < count) {
      const cell::Joint& next = cell.robot.joints[static_cast<std::size_t>(i) + 1];
      addLinkTo(body, next, radius);
    } else {
      addLink(body, Vec3::Zero(), cell.robot.T_last_tip.translation(), radius);
      if (!cell.partCarried()) {
        // From the flange to where the drawn torch begins, 150 mm behind the tip of the wire.
        const Pose T_last_tcp = cell.robot.T_last_tip * cell.T_flange_tcp;
        const Vec3 back = T_last_tcp * Vec3(0, 0, 150);
        body.solids.push_back({Solid::Kind::Capsule, pointOf(cell.robot.T_last_tip.translation()),
                               pointOf(back), 0.6 * radius, kJoint});
      }
    }
    bodies.push_back(std::move(body));
  }
}

void addPositioner(const cell::Cell& cell, std::vector<Body>& bodies) {
  const int count = cell.positionerJoints();
  constexpr double kRadius = 45.0;  // mm, of a drawn axis
  for (int i = 0; i < count; ++i) {
    Body body;
    body.name = cell.positioner.joints[static_cast<std::size_t>(i)].name;
    body.solids.push_back(
        {Solid::Kind::Cylinder, {0, 0, -1.5 * kRadius}, {0, 0, 0}, kRadius, kJoint});
    if (i + 1 < count) {
      const cell::Joint& next = cell.positioner.joints[static_cast<std::size_t>(i) + 1];
      addLinkTo(body, next, 0.6 * kRadius);
    }
    bodies.push_back(std::move(body));
  }
}

}  // namespace

viewport::Matrix matrixOf(const geometry::Pose& pose) {
  viewport::Matrix m{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      m[static_cast<std::size_t>(4 * i + j)] = pose.matrix()(i, j);
    }
  }
  return m;
}

viewport::MeshData meshOf(const geometry::PartSurface& surface) {
  MeshData mesh;
  mesh.positions.reserve(3 * surface.mesh.vertices.size());
  for (const Vec3& p : surface.mesh.vertices) {
    addPoint(mesh.positions, p);
  }
  mesh.triangles.reserve(3 * surface.mesh.triangles.size());
  for (const auto& triangle : surface.mesh.triangles) {
    mesh.triangles.insert(mesh.triangles.end(), triangle.begin(), triangle.end());
  }
  mesh.faces = surface.binding.face;
  if (surface.exact()) {
    addCadEdges(surface, mesh);
  } else {
    addSharpEdges(surface, mesh);
  }
  return mesh;
}

viewport::MeshData meshOf(const toolpath::Substrate& substrate) {
  MeshData mesh;
  if (!substrate.isPlate()) {
    mesh = meshOf(*substrate.body());
    return mesh;
  }
  const Vec3 half(0.5 * substrate.size().x(), 0.5 * substrate.size().y(), 0.0);
  for (const double z : {-substrate.size().z(), 0.0}) {
    for (const auto& [x, y] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      addPoint(mesh.positions, substrate.pose() * Vec3(x * half.x(), y * half.y(), z));
    }
  }
  mesh.triangles = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                    1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  mesh.faces = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
  const auto line = [&mesh](std::initializer_list<std::uint32_t> corners) {
    mesh.edgeBegin.push_back(static_cast<std::uint32_t>(mesh.edgePositions.size() / 3));
    mesh.edgeIds.push_back(-1);
    for (const std::uint32_t c : corners) {
      mesh.edgePositions.insert(mesh.edgePositions.end(), &mesh.positions[3 * c],
                                &mesh.positions[3 * c] + 3);
    }
  };
  line({0, 1, 2, 3, 0});
  line({4, 5, 6, 7, 4});
  for (std::uint32_t c = 0; c < 4; ++c) {
    line({c, c + 4});
  }
  mesh.edgeBegin.push_back(static_cast<std::uint32_t>(mesh.edgePositions.size() / 3));
  return mesh;
}

namespace {

/// A box as triangles, one face per side.
MeshData boxMesh(const Vec3& size, const Pose& pose) {
  MeshData mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                    (corner & 4) != 0 ? 0.5 : -0.5);
    addPoint(mesh.positions, pose * Vec3(size.cwiseProduct(sign)));
  }
  mesh.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  mesh.faces = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
  return mesh;
}

void addShape(Body& body, const cell::Shape& shape, const viewport::Colour& colour) {
  const Pose& T = shape.T_frame_shape;
  const Vec3 half(0.0, 0.0, 0.5 * shape.length);
  switch (shape.kind) {
    case cell::ShapeKind::Sphere:
      body.solids.push_back({Solid::Kind::Capsule, pointOf(T.translation()),
                             pointOf(T.translation()), shape.radius, colour});
      break;
    case cell::ShapeKind::Capsule:
    case cell::ShapeKind::Cylinder:
      body.solids.push_back(
          {shape.kind == cell::ShapeKind::Capsule ? Solid::Kind::Capsule : Solid::Kind::Cylinder,
           pointOf(T * Vec3(-half)), pointOf(T * half), shape.radius, colour});
      break;
    case cell::ShapeKind::Box:
      body.meshes.push_back(boxMesh(shape.size, T));
      body.meshColour = colour;
      break;
    case cell::ShapeKind::Mesh:
      if (shape.mesh != nullptr) {
        MeshData mesh;
        for (const Vec3& p : shape.mesh->vertices) {
          addPoint(mesh.positions, T * p);
        }
        for (const auto& triangle : shape.mesh->triangles) {
          mesh.triangles.insert(mesh.triangles.end(), triangle.begin(), triangle.end());
        }
        body.meshes.push_back(std::move(mesh));
        body.meshColour = colour;
      }
      break;
  }
}

/// Adds shapes to the bodies of their frames.
void addShapes(std::vector<Body>& bodies,
               const std::vector<cell::Shape>& shapes,
               const viewport::Colour& colour) {
  for (const cell::Shape& shape : shapes) {
    const auto body = std::find_if(bodies.begin(), bodies.end(),
                                   [&](const Body& b) { return b.name == shape.frame; });
    if (body != bodies.end()) {
      addShape(*body, shape, colour);
    }
  }
}

Body named(const std::string& name) {
  Body body;
  body.name = name;
  return body;
}

}  // namespace

std::vector<viewport::Body> bodiesOf(const cell::Cell& cell) {
  std::vector<Body> bodies;
  const bool ownRobot = !cell.shapes.robot.empty();
  const bool ownPositioner = !cell.shapes.positioner.empty();
  if (ownRobot) {
    for (const cell::Joint& joint : cell.robot.joints) {
      bodies.push_back(named(joint.name));
    }
  } else {
    addRobot(cell, bodies);
  }
  if (ownPositioner) {
    for (const cell::Joint& joint : cell.positioner.joints) {
      bodies.push_back(named(joint.name));
    }
  } else {
    addPositioner(cell, bodies);
  }
  Body base = named("base");
  if (!ownRobot) {
    base.solids.push_back({Solid::Kind::Cylinder, {0, 0, 0}, {0, 0, 60}, 150.0, kJoint});
    if (!cell.robot.joints.empty()) {
      const NextOrigin origin = nextOrigin(cell.robot.joints.front());
      const Pose& T = cell.robot.T_root_first;
      const Vec3 foot(0, 0, 30);
      const Vec3 first = T * nearestOrigin(origin, T.inverse() * foot);
      base.solids.push_back({Solid::Kind::Capsule, pointOf(foot), pointOf(first), 95.0, kRobot});
      if (origin.from != origin.to) {
        base.solids.push_back(
            {Solid::Kind::Capsule, pointOf(T * origin.from), pointOf(T * origin.to), 50.0, kRobot});
      }
    }
  }
  bodies.push_back(std::move(base));
  Body table = named("table");
  if (!ownPositioner) {
    table.solids.push_back({Solid::Kind::Cylinder, {0, 0, -25}, {0, 0, 0}, 200.0, kTable});
  }
  bodies.push_back(std::move(table));
  for (const char* frame : {"world", "flange", "tcp"}) {
    bodies.push_back(named(frame));
  }
  addShapes(bodies, cell.shapes.robot, kRobot);
  addShapes(bodies, cell.shapes.positioner, kTable);
  addShapes(bodies, cell.shapes.torch, kJoint);
  addShapes(bodies, cell.shapes.obstacles, kObstacle);
  return bodies;
}

std::vector<geometry::Pose> bodyPoses(const cell::Cell& cell, const cell::JointVector& q) {
  std::vector<Pose> poses;
  const auto along = [&poses](const cell::Chain& chain, const double* values) {
    std::vector<Pose> frames(static_cast<std::size_t>(chain.size()) + 1);
    cell::chainFrames(chain, values, frames.data());
    poses.insert(poses.end(), frames.begin(), frames.end() - 1);
  };
  along(cell.robot, q.data());
  along(cell.positioner, q.data() + cell.robotJoints());
  poses.push_back(Pose::Identity());
  poses.push_back(cell::T_base_table(cell, q));
  poses.push_back(cell.T_world_base.inverse());
  poses.push_back(cell::T_base_flange(cell, q));
  poses.push_back(cell::T_base_tcp(cell, q));
  return poses;
}

}  // namespace wcam::gui
