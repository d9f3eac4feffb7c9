// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace wcam::geometry {

/// A point of an exact surface with its first derivatives (mm per parameter unit).
struct SurfacePoint {
  Vec3 p = Vec3::Zero();
  Vec3 du = Vec3::Zero();
  Vec3 dv = Vec3::Zero();
};

/// A point of an exact curve with its derivatives.
struct CurvePoint {
  Vec3 p = Vec3::Zero();
  Vec3 d1 = Vec3::Zero();
  Vec3 d2 = Vec3::Zero();
};

struct BrepFaceInfo {
  std::string name;
  std::string surfaceType;  ///< "plane", "cylinder", "cone", "sphere", "torus", "bspline", "other"
  std::array<double, 4> uvBounds{};  ///< uMin, uMax, vMin, vMax
  bool reversed = false;             ///< the outward normal is −du×dv
};

struct BrepEdgeInfo {
  std::string name;
  std::array<double, 2> range{};
  double length = 0.0;  ///< mm
  int faceCount = 0;    ///< 0 for a free curve (a guide), 1 on a border or a seam, 2 inside
};

/// Exact surfaces and curves of a CAD part in the part frame, mm. Immutable and shared; faces and
/// edges are numbered from 0 in the order of the file. Evaluation goes through a BrepEvaluator, one
/// per thread.
class Brep {
public:
  struct Impl;
  explicit Brep(std::unique_ptr<const Impl> impl);
  ~Brep();
  Brep(const Brep&) = delete;
  Brep& operator=(const Brep&) = delete;

  [[nodiscard]] int faceCount() const noexcept;
  [[nodiscard]] int edgeCount() const noexcept;
  [[nodiscard]] const BrepFaceInfo& face(int index) const;
  [[nodiscard]] const BrepEdgeInfo& edge(int index) const;

  [[nodiscard]] const Impl& impl() const noexcept { return *impl_; }

private:
  std::unique_ptr<const Impl> impl_;
};

/// Evaluates a Brep. Holds caches, so use one per thread; making one is cheap (adaptors are made on
/// demand). The Brep must outlive it.
class BrepEvaluator {
public:
  explicit BrepEvaluator(const Brep& brep);
  ~BrepEvaluator();
  BrepEvaluator(BrepEvaluator&&) noexcept;
  BrepEvaluator& operator=(BrepEvaluator&&) noexcept;

  [[nodiscard]] SurfacePoint surface(int face, const Vec2& uv) const;
  [[nodiscard]] CurvePoint curve(int edge, double t) const;
  /// Outward unit normal; zero at a singular point.
  [[nodiscard]] Vec3 normal(int face, const Vec2& uv) const;
  /// The same when the surface has been evaluated there already.
  [[nodiscard]] Vec3 normal(int face, const Vec2& uv, const SurfacePoint& point) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Ties each triangle of a tessellation to the exact part: its face, the (u,v) of its corners, and
/// for each of its half-edges that lies on a CAD edge the edge and the curve parameters at both
/// ends. Corners hold (u,v) rather than vertices, since a vertex on a seam has several.
struct BrepBinding {
  std::vector<std::int32_t> face;                ///< per triangle
  std::vector<std::array<Vec2, 3>> uv;           ///< per triangle corner
  std::vector<std::int32_t> edge;                ///< per half-edge 3·t+c, −1 inside a face
  std::vector<std::array<double, 2>> edgeParam;  ///< per half-edge, at its start and its end
};

}  // namespace wcam::geometry
