// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "solids.hpp"

#include <vtkCubeSource.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPolyDataNormals.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>

namespace wcam::viewport {

namespace {

constexpr int kSides = 28;
constexpr double kFullTurn = 6.283185307179586;

struct Axes {
  Point u;
  Point v;
  Point w;
  double length;
};

Axes axesOf(const Point& from, const Point& to) {
  Point w = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  const double length = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  w = length > 0.0 ? Point{w[0] / length, w[1] / length, w[2] / length} : Point{0, 0, 1};
  // Any direction that is not along w.
  const Point help = std::abs(w[0]) < 0.9 ? Point{1, 0, 0} : Point{0, 1, 0};
  Point u = {help[1] * w[2] - help[2] * w[1], help[2] * w[0] - help[0] * w[2],
             help[0] * w[1] - help[1] * w[0]};
  const double size = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  u = {u[0] / size, u[1] / size, u[2] / size};
  const Point v = {w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]};
  return {u, v, w, length};
}

struct Ring {
  double along;
  double radius;
};

/// A solid of revolution from rings along the axis.
vtkSmartPointer<vtkPolyData> revolve(const Point& from,
                                     const Axes& axes,
                                     const std::vector<Ring>& rings) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Ring& ring : rings) {
    for (int k = 0; k < kSides; ++k) {
      const double a = kFullTurn * k / kSides;
      Point p{};
      for (int i = 0; i < 3; ++i) {
        p[i] = from[i] + axes.w[i] * ring.along +
               ring.radius * (std::cos(a) * axes.u[i] + std::sin(a) * axes.v[i]);
      }
      points->InsertNextPoint(p.data());
    }
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (int k = 0; k < kSides; ++k) {
      const int next = (k + 1) % kSides;
      const auto at = [](std::size_t ring, int side) {
        return static_cast<vtkIdType>(ring * kSides + static_cast<std::size_t>(side));
      };
      const vtkIdType quad[4] = {at(r, k), at(r, next), at(r + 1, next), at(r + 1, k)};
      cells->InsertNextCell(4, quad);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SetFeatureAngle(50.0);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

}  // namespace

vtkSmartPointer<vtkPolyData> solidMesh(const Solid& solid) {
  const Axes axes = axesOf(solid.from, solid.to);
  switch (solid.kind) {
    case Solid::Kind::Box: {
      vtkNew<vtkCubeSource> box;
      box->SetBounds(solid.from[0], solid.to[0], solid.from[1], solid.to[1], solid.from[2],
                     solid.to[2]);
      box->Update();
      return box->GetOutput();
    }
    case Solid::Kind::Cylinder:
      return revolve(
          solid.from, axes,
          {{0.0, 0.0}, {0.0, solid.radius}, {axes.length, solid.radius}, {axes.length, 0.0}});
    case Solid::Kind::Cone:
      return revolve(solid.from, axes,
                     {{0.0, 0.0}, {axes.length, solid.radius}, {axes.length, 0.0}});
    case Solid::Kind::Capsule:
      break;
  }
  std::vector<Ring> rings;
  constexpr int kSteps = 7;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = 0.25 * kFullTurn * i / kSteps;
    rings.push_back({-solid.radius * std::cos(a), solid.radius * std::sin(a)});
  }
  for (int i = 0; i <= kSteps; ++i) {
    const double a = 0.25 * kFullTurn * i / kSteps;
    rings.push_back({axes.length + solid.radius * std::sin(a), solid.radius * std::cos(a)});
  }
  return revolve(solid.from, axes, rings);
}

vtkSmartPointer<vtkPolyData> sphereMesh(double radius) {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(14);
  sphere->Update();
  return sphere->GetOutput();
}

std::vector<Solid> torchSolids() {
  const Colour copper = {196, 120, 70};
  const Colour steel = {150, 156, 165};
  const Colour body = {60, 66, 74};
  return {{Solid::Kind::Cylinder, {0, 0, 0}, {0, 0, 15}, 0.6, steel},
          {Solid::Kind::Cone, {0, 0, 10}, {0, 0, 40}, 9.0, copper},
          {Solid::Kind::Cylinder, {0, 0, 40}, {0, 0, 95}, 11.0, steel},
          {Solid::Kind::Cylinder, {0, 0, 95}, {0, 0, 150}, 15.0, body}};
}

}  // namespace wcam::viewport
