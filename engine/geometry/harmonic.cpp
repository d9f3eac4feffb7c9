// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/harmonic.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/linear_elements.hpp"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <limits>

namespace wcam::geometry {

namespace {

constexpr const char* kPlace = "harmonic field";
constexpr std::uint32_t kNotFree = HalfEdges::kNone;

/// The fixed values by vertex, NaN elsewhere. @throws Error(InvalidArgument)
std::vector<double> fixedByVertex(const TriangleMesh& mesh, const std::vector<FixedValues>& fixed) {
  std::vector<double> field(mesh.vertices.size(), std::numeric_limits<double>::quiet_NaN());
  bool any = false;
  for (const FixedValues& values : fixed) {
    if (!std::isfinite(values.value)) {
      throw Error(ErrorCode::InvalidArgument, "a fixed value is not a number", kPlace,
                  "give each border a finite value");
    }
    for (const std::uint32_t v : values.vertices) {
      if (v >= field.size()) {
        throw Error(ErrorCode::InvalidArgument,
                    text("there is no vertex %1; the mesh has %2",
                         {std::to_string(v), std::to_string(field.size())}),
                    kPlace);
      }
      if (!std::isnan(field[v]) && field[v] != values.value) {
        const Vec3& p = mesh.vertices[v];
        throw Error(ErrorCode::InvalidArgument,
                    text("two borders with different values share the point %1, %2, %3",
                         {formatFixed(p.x(), 3), formatFixed(p.y(), 3), formatFixed(p.z(), 3)}),
                    kPlace, "choose borders that do not touch, or give them the same value");
      }
      field[v] = values.value;
      any = true;
    }
  }
  if (!any) {
    throw Error(ErrorCode::InvalidArgument, "no vertex has a fixed value", kPlace,
                "choose at least one border");
  }
  return field;
}

/// @throws Error(InvalidArgument)
void checkConductivity(const TriangleMesh& mesh, const std::vector<Conductivity>& conductivity) {
  if (conductivity.empty()) {
    return;
  }
  if (conductivity.size() != mesh.triangles.size()) {
    throw Error(ErrorCode::InvalidArgument,
                text("conductivity is given for %1 of %2 triangles",
                     {std::to_string(conductivity.size()), std::to_string(mesh.triangles.size())}),
                kPlace, "give one per triangle or none");
  }
  for (std::size_t t = 0; t < conductivity.size(); ++t) {
    const Conductivity& c = conductivity[t];
    if (!(c.weight > 0.0) || !std::isfinite(c.weight) || !(c.along > 0.0) ||
        !std::isfinite(c.along) || !c.direction.allFinite()) {
      throw Error(ErrorCode::InvalidArgument,
                  text("the conductivity of triangle %1 is not positive", {std::to_string(t)}),
                  kPlace, "weights must be finite and greater than zero");
    }
  }
}

/// Stiffness of a triangle: area·∇hᵢ·κ·∇hⱼ.
Eigen::Matrix3d stiffness(const FlatTriangle& flat, const Conductivity& conductivity) {
  if (flat.area == 0.0) {
    // A point: its corners are one place, so any positive coupling holds them together. That of an
    // equilateral triangle has the size of the others.
    const double cotangent = conductivity.weight * 0.5 / std::sqrt(3.0);
    return cotangent * (3.0 * Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Ones());
  }
  Eigen::Matrix2d kappa = Eigen::Matrix2d::Identity();
  if (conductivity.along != 1.0 && conductivity.direction.norm() > 0.0) {
    const Vec2 d = flat.toPlane(conductivity.direction.normalized());
    kappa += (conductivity.along - 1.0) * d * d.transpose();
  }
  Eigen::Matrix<double, 2, 3> gradients;
  for (int c = 0; c < 3; ++c) {
    gradients.col(c) = flat.gradients[static_cast<std::size_t>(c)];
  }
  return conductivity.weight * flat.area * gradients.transpose() * kappa * gradients;
}

/// The linear system of the free vertices: matrix·u = rhs.
struct System {
  std::vector<std::uint32_t> freeIndex;  ///< per vertex: row, or kNotFree
  std::vector<std::uint32_t> vertexOf;   ///< per row
  SparseMatrix matrix;
  Eigen::VectorXd rhs;
};

/// Numbers the vertices that are not fixed, lie in a triangle and in a component with a fixed one.
void numberFree(const TriangleMesh& mesh, const std::vector<double>& field, System& system) {
  const std::vector<std::uint32_t> component = componentsOf(mesh);
  std::vector<bool> reached(mesh.vertices.size(), false);
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (!std::isnan(field[v])) {
      reached[component[v]] = true;
    }
  }
  system.freeIndex.assign(field.size(), kNotFree);
  for (std::uint32_t v = 0; v < field.size(); ++v) {
    if (std::isnan(field[v]) && reached[component[v]]) {
      system.freeIndex[v] = static_cast<std::uint32_t>(system.vertexOf.size());
      system.vertexOf.push_back(v);
    }
  }
}

void assemble(const TriangleMesh& mesh,
              const std::vector<double>& field,
              const std::vector<Conductivity>& conductivity,
              System& system) {
  const auto n = static_cast<Eigen::Index>(system.vertexOf.size());
  system.rhs = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    const Eigen::Matrix3d k =
        stiffness(flatten(mesh, t), conductivity.empty() ? Conductivity{} : conductivity[t]);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t row = system.freeIndex[corners[static_cast<std::size_t>(i)]];
      if (row == kNotFree) {
        continue;
      }
      for (int j = 0; j < 3; ++j) {
        const std::uint32_t vertex = corners[static_cast<std::size_t>(j)];
        const std::uint32_t column = system.freeIndex[vertex];
        if (column == kNotFree) {
          system.rhs[row] -= k(i, j) * field[vertex];
        } else if (column <= row) {
          entries.emplace_back(static_cast<int>(row), static_cast<int>(column), k(i, j));
        }
      }
    }
  }
  system.matrix.resize(n, n);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace

std::vector<double> harmonicField(const TriangleMesh& mesh,
                                  const HalfEdges&,
                                  const std::vector<FixedValues>& fixed,
                                  const std::vector<Conductivity>& conductivity,
                                  const JobContext& context) {
  std::vector<double> field = fixedByVertex(mesh, fixed);
  checkConductivity(mesh, conductivity);
  System system;
  numberFree(mesh, field, system);
  if (system.vertexOf.empty()) {
    return field;
  }
  context.check();
  assemble(mesh, field, conductivity, system);
  context.check();
  const Eigen::SimplicialLDLT<SparseMatrix> solver(system.matrix);
  context.check();
  Eigen::VectorXd u;
  if (solver.info() == Eigen::Success) {
    u = solver.solve(system.rhs);
    // One step of refinement takes back what large ratios of weights cost.
    u += solver.solve(system.rhs - system.matrix.selfadjointView<Eigen::Lower>() * u);
  }
  if (solver.info() != Eigen::Success || !u.allFinite()) {
    throw Error(ErrorCode::JobFailed, "the mesh is too degenerate to solve for a field", kPlace,
                "repair or refine the part's mesh");
  }
  for (std::size_t i = 0; i < system.vertexOf.size(); ++i) {
    field[system.vertexOf[i]] = u[static_cast<Eigen::Index>(i)];
  }
  context.report(1.0);
  return field;
}

}  // namespace wcam::geometry
