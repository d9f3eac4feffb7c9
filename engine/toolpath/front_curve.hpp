// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "front_line.hpp"
#include "surface_patch.hpp"

#include <functional>
#include <vector>

namespace wcam::toolpath {

/// A piece of a front inside one triangle.
struct FrontPiece {
  std::uint32_t triangle = 0;
  geometry::Vec2 uvA = geometry::Vec2::Zero();
  geometry::Vec2 uvB = geometry::Vec2::Zero();
  ContourPoint a, b;
  std::int32_t footA = -1;  ///< segment of the layer below that is nearest to a
  std::int32_t footB = -1;
};

/// A curve at constant distance from the layer below, exact at every point.
class FrontCurve : public SampledCurve {
public:
  /// @param below must outlive the curve
  FrontCurve(const SurfacePatch& patch, const FrontLine& below, double step, double size);

  [[nodiscard]] std::size_t pieces() const override { return list.size(); }

  [[nodiscard]] bool closed() const override { return ring; }

  [[nodiscard]] bool exact() const override { return patch_->exact(); }

  [[nodiscard]] ContourPoint at(std::size_t piece, double w) const override;
  [[nodiscard]] Vec3 tangent(std::size_t piece, double w) const override;

  /// Where two branches of the front meet: nodes found by insertCorners().
  std::vector<Vec3> corners;

  /// Puts a node where two branches of the front meet inside a piece.
  void insertCorners();
  /// Facet normals of a mesh are joined where the surface is smooth.
  void smoothMeshNormals();

  std::vector<FrontPiece> list;
  bool ring = false;

private:
  struct Place {
    geometry::Vec2 uv = geometry::Vec2::Zero();
    geometry::SurfacePoint surface;
    FrontLine::Foot foot;
  };

  void markCorners();
  [[nodiscard]] Place evaluate(const FrontPiece& piece, const geometry::Vec2& uv) const;
  [[nodiscard]] Place toDistance(const FrontPiece& piece, const geometry::Vec2& start) const;
  [[nodiscard]] std::optional<std::array<FrontPiece, 2>> splitAtCorner(
      const FrontPiece& piece) const;

  const SurfacePatch* patch_;
  const FrontLine* below_;
  double step_;
  double tolerance_;
};

/// The parts of a curve on which `outside` is not positive, with exact ends.
std::vector<FrontCurve> keepInside(const FrontCurve& curve,
                                   const std::function<double(const Vec3&)>& outside);

}  // namespace wcam::toolpath
