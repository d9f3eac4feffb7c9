// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/linear_elements.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

namespace wcam::geometry {

namespace {

constexpr const char* kPlace = "heat distance";
/// The heat falls by about e at each √t. Beyond this many the numbers of a computer end (e^−700),
/// so that long parts get a greater time step.
constexpr double kMostDecay = 600.0;

using Solver = Eigen::SimplicialLDLT<SparseMatrix>;

double meanEdge(const TriangleMesh& mesh, const HalfEdges& halfEdges) {
  double sum = 0.0;
  for (std::uint32_t e = 0; e < halfEdges.edgeCount(); ++e) {
    const auto& [a, b] = halfEdges.edgeVertices(e);
    sum += (mesh.vertices[b] - mesh.vertices[a]).norm();
  }
  return halfEdges.edgeCount() > 0 ? sum / static_cast<double>(halfEdges.edgeCount()) : 0.0;
}

/// Neighbours of all vertices: those of v are list[offset[v]] to list[offset[v + 1]].
struct Neighbours {
  std::vector<std::size_t> offset;
  std::vector<std::uint32_t> list;

  Neighbours(const HalfEdges& halfEdges, std::size_t vertices) : offset(vertices + 1, 0) {
    for (std::uint32_t e = 0; e < halfEdges.edgeCount(); ++e) {
      ++offset[halfEdges.edgeVertices(e)[0] + 1];
      ++offset[halfEdges.edgeVertices(e)[1] + 1];
    }
    for (std::size_t v = 1; v < offset.size(); ++v) {
      offset[v] += offset[v - 1];
    }
    list.resize(offset.back());
    std::vector<std::size_t> fill(offset.begin(), offset.end() - 1);
    for (std::uint32_t e = 0; e < halfEdges.edgeCount(); ++e) {
      const auto& [a, b] = halfEdges.edgeVertices(e);
      list[fill[a]++] = b;
      list[fill[b]++] = a;
    }
  }
};

/// An upper bound on the edges between any two vertices: twice the greatest number from the first
/// vertex of each component.
std::size_t edgesAcross(const HalfEdges& halfEdges, std::size_t vertices) {
  const Neighbours neighbours(halfEdges, vertices);
  constexpr std::size_t kUnseen = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> edges(vertices, kUnseen);
  std::vector<std::uint32_t> queue;
  std::size_t most = 0;
  for (std::uint32_t start = 0; start < vertices; ++start) {
    if (edges[start] != kUnseen) {
      continue;
    }
    edges[start] = 0;
    queue.assign(1, start);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::uint32_t v = queue[i];
      most = std::max(most, edges[v]);
      for (std::size_t k = neighbours.offset[v]; k < neighbours.offset[v + 1]; ++k) {
        if (edges[neighbours.list[k]] == kUnseen) {
          edges[neighbours.list[k]] = edges[v] + 1;
          queue.push_back(neighbours.list[k]);
        }
      }
    }
  }
  return 2 * most;
}

/// A positive matrix over the vertices that are not held at zero, factorised.
class Factorised {
public:
  /// @param held per vertex: its value is zero
  Factorised(const SparseMatrix& matrix, const std::vector<bool>& held) : row_(held.size(), -1) {
    int rows = 0;
    for (std::size_t v = 0; v < held.size(); ++v) {
      row_[v] = held[v] ? -1 : rows++;
    }
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(matrix.nonZeros()));
    for (int column = 0; column < matrix.outerSize(); ++column) {
      for (SparseMatrix::InnerIterator it(matrix, column); it; ++it) {
        const int i = row_[static_cast<std::size_t>(it.row())];
        const int j = row_[static_cast<std::size_t>(it.col())];
        if (i >= j && j >= 0) {
          entries.emplace_back(i, j, it.value());
        }
      }
    }
    SparseMatrix reduced(rows, rows);
    reduced.setFromTriplets(entries.begin(), entries.end());
    if (rows > 0) {
      solver_.compute(reduced);
    }
    if (rows > 0 && solver_.info() != Eigen::Success) {
      throw Error(ErrorCode::JobFailed, "the mesh is too degenerate to solve for a distance",
                  kPlace, "repair or refine the part's mesh");
    }
    rows_ = rows;
  }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(rhs.size());
    if (rows_ == 0) {
      return result;
    }
    Eigen::VectorXd reduced(rows_);
    for (std::size_t v = 0; v < row_.size(); ++v) {
      if (row_[v] >= 0) {
        reduced[row_[v]] = rhs[static_cast<Eigen::Index>(v)];
      }
    }
    const Eigen::VectorXd solution = solver_.solve(reduced);
    for (std::size_t v = 0; v < row_.size(); ++v) {
      if (row_[v] >= 0) {
        result[static_cast<Eigen::Index>(v)] = solution[row_[v]];
      }
    }
    return result;
  }

private:
  std::vector<int> row_;
  int rows_ = 0;
  Solver solver_;
};

}  // namespace

struct HeatSolver::Impl {
  TriangleMesh mesh;
  std::vector<std::vector<std::uint32_t>> borders;
  std::vector<std::uint32_t> component;
  SparseMatrix heat;  ///< A − t·L_C
  std::unique_ptr<Factorised> poisson;
  /// Heat flow with some borders held at zero, by the borders held; made when first asked for.
  mutable std::mutex mutex;
  mutable std::map<std::vector<std::size_t>, std::shared_ptr<const Factorised>> flows;

  [[nodiscard]] std::shared_ptr<const Factorised> flow(const std::vector<std::size_t>& held) const {
    const std::lock_guard lock(mutex);
    std::shared_ptr<const Factorised>& entry = flows[held];
    if (entry == nullptr) {
      std::vector<bool> zero(mesh.vertices.size(), false);
      for (const std::size_t border : held) {
        for (const std::uint32_t v : borders[border]) {
          zero[v] = true;
        }
      }
      entry = std::make_shared<const Factorised>(heat, zero);
    }
    return entry;
  }

  /// Unit vectors against the gradient of the heat, per triangle (Diourté A.4).
  [[nodiscard]] std::vector<Vec3> directions(const Eigen::VectorXd& u) const {
    std::vector<Vec3> result(mesh.triangles.size(), Vec3::Zero());
    for (std::size_t t = 0; t < result.size(); ++t) {
      const auto& corners = mesh.triangles[t];
      // The direction alone counts: scaled, heat near the end of the number range keeps its digits.
      const double scale =
          std::max({std::abs(u[corners[0]]), std::abs(u[corners[1]]), std::abs(u[corners[2]])});
      if (!(scale >= std::numeric_limits<double>::min())) {
        continue;
      }
      const FlatTriangle flat = flatten(mesh, t);
      Vec2 gradient = Vec2::Zero();
      for (std::size_t c = 0; c < 3; ++c) {
        gradient += u[corners[c]] / scale * flat.gradients[c];
      }
      if (gradient.norm() > 0.0) {
        result[t] = flat.toSpace(-gradient.normalized());
      }
    }
    return result;
  }
};

HeatSolver::HeatSolver(const TriangleMesh& mesh, const HalfEdges& halfEdges, double timeFactor)
    : impl_(std::make_unique<Impl>()) {
  if (!(timeFactor > 0.0) || !std::isfinite(timeFactor)) {
    throw Error(ErrorCode::InvalidArgument, "the time factor must be greater than zero", kPlace);
  }
  impl_->mesh = mesh;
  impl_->borders = halfEdges.borderLoops(mesh);
  impl_->component = componentsOf(mesh);
  const double h = meanEdge(mesh, halfEdges);
  const double hops = static_cast<double>(edgesAcross(halfEdges, mesh.vertices.size()));
  const double root = h * std::max(std::sqrt(timeFactor), hops / kMostDecay);
  const SparseMatrix stiffness = stiffnessMatrix(mesh);
  impl_->heat = root * root * stiffness;
  const std::vector<double> areas = vertexAreas(mesh);
  std::vector<bool> pinned(mesh.vertices.size(), false);
  for (std::size_t v = 0; v < areas.size(); ++v) {
    // A vertex without area is alone: any positive entry keeps the matrix regular.
    impl_->heat.coeffRef(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(v)) +=
        areas[v] > 0.0 ? areas[v] : 1.0;
  }
  // One vertex of each component holds the constant that the distance leaves free.
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (impl_->component[v] == next) {
      pinned[v] = true;
      ++next;
    }
  }
  impl_->poisson = std::make_unique<Factorised>(stiffness, pinned);
}

HeatSolver::~HeatSolver() = default;
HeatSolver::HeatSolver(HeatSolver&&) noexcept = default;
HeatSolver& HeatSolver::operator=(HeatSolver&&) noexcept = default;

std::vector<double> HeatSolver::distance(const std::vector<std::uint32_t>& sourceVertices) const {
  const TriangleMesh& mesh = impl_->mesh;
  const auto n = static_cast<Eigen::Index>(mesh.vertices.size());
  std::vector<bool> source(mesh.vertices.size(), false);
  Eigen::VectorXd delta = Eigen::VectorXd::Zero(n);
  for (const std::uint32_t v : sourceVertices) {
    if (v >= mesh.vertices.size()) {
      throw Error(ErrorCode::InvalidArgument, text("there is no vertex %1", {std::to_string(v)}),
                  kPlace);
    }
    source[v] = true;
    delta[v] = 1.0;
  }
  if (sourceVertices.empty()) {
    throw Error(ErrorCode::InvalidArgument, "no vertex is a source", kPlace,
                "choose a border or points of the part");
  }
  std::vector<std::size_t> freeBorders;
  for (std::size_t b = 0; b < impl_->borders.size(); ++b) {
    const auto& loop = impl_->borders[b];
    if (std::none_of(loop.begin(), loop.end(), [&](std::uint32_t v) { return source[v]; })) {
      freeBorders.push_back(b);
    }
  }
  Eigen::VectorXd u = impl_->flow({})->solve(delta);
  if (!freeBorders.empty()) {
    u = 0.5 * (u + impl_->flow(freeBorders)->solve(delta));
  }
  const Eigen::VectorXd phi = impl_->poisson->solve(divergence(mesh, impl_->directions(u)));
  // The constant of each component: the mean over its sources is zero.
  std::vector<double> sum(mesh.vertices.size(), 0.0);
  std::vector<double> count(mesh.vertices.size(), 0.0);
  for (Eigen::Index v = 0; v < n; ++v) {
    if (source[static_cast<std::size_t>(v)]) {
      sum[impl_->component[static_cast<std::size_t>(v)]] += phi[v];
      count[impl_->component[static_cast<std::size_t>(v)]] += 1.0;
    }
  }
  std::vector<double> distance(mesh.vertices.size(), std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const std::uint32_t c = impl_->component[v];
    if (count[c] > 0.0) {
      distance[v] = phi[static_cast<Eigen::Index>(v)] - sum[c] / count[c];
    }
  }
  return distance;
}

}  // namespace wcam::geometry
