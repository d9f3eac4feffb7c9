// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/geometry/brep.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include "sampled_curve.hpp"

#include <optional>
#include <vector>

namespace wcam::toolpath {

/// The piece of a level curve inside one triangle, with exact ends.
struct CurveSegment {
  std::uint32_t triangle = 0;
  geometry::Vec2 uvA = geometry::Vec2::Zero();
  geometry::Vec2 uvB = geometry::Vec2::Zero();
  ContourPoint a, b;
};

/// A level curve on a part, exact where the part is: evaluates any point between the nodes of the
/// mesh contour.
class LevelCurve : public SampledCurve {
public:
  /// @param field null when the field is known at the mesh vertices only: nodes are then moved onto
  /// the surface, not onto the level
  /// @param size diagonal of the part's bounds, mm
  /// @param flat tolerance of flat faces, mm: vertices that the tracing put on the level lie within
  /// some of it
  LevelCurve(const geometry::PartSurface& part,
             geometry::BrepEvaluator* evaluator,
             const LayerField* field,
             std::size_t level,
             double size,
             double flat = 0.0);

  /// Moves the nodes of a mesh contour onto the exact surface and level.
  /// @return the number of nodes that kept their mesh position
  std::size_t assign(const geometry::LevelContour& contour);

  [[nodiscard]] std::size_t pieces() const override { return segments_.size(); }

  [[nodiscard]] bool closed() const override { return closed_; }

  [[nodiscard]] bool exact() const override { return evaluator_ != nullptr; }

  [[nodiscard]] const std::vector<CurveSegment>& segments() const noexcept { return segments_; }

  [[nodiscard]] double length() const;
  [[nodiscard]] ContourPoint at(std::size_t segment, double w) const override;
  [[nodiscard]] Vec3 tangent(std::size_t segment, double w) const override;

  /// Splits the curve where heightAbove is negative; the cuts are exact. Empty when all of it is
  /// below.
  [[nodiscard]] std::vector<LevelCurve> keepAbove(const Substrate& substrate,
                                                  double tolerance) const;

private:
  [[nodiscard]] Vec3 meshNormal(std::uint32_t triangle) const;

  /// A place on a face and what the surface is there, so that it is evaluated once.
  struct FacePoint {
    geometry::Vec2 uv = geometry::Vec2::Zero();
    geometry::SurfacePoint surface;
  };

  /// A node of the mesh contour on the exact level curve.
  struct Node {
    ContourPoint point;
    std::int32_t face = -1;  ///< of uv and normal; negative on CAD edges and for unrefined nodes
    geometry::Vec2 uv = geometry::Vec2::Zero();
  };

  [[nodiscard]] FacePoint faceAt(std::int32_t face, const geometry::Vec2& uv) const;
  [[nodiscard]] ContourPoint contourPoint(std::int32_t face, const FacePoint& at) const;
  [[nodiscard]] std::optional<FacePoint> newtonToLevel(std::int32_t face,
                                                       geometry::Vec2 uv,
                                                       double reach) const;
  [[nodiscard]] FacePoint projectToSurface(std::int32_t face,
                                           const geometry::Vec2& uv,
                                           const Vec3& p) const;
  [[nodiscard]] std::optional<Vec3> solveOnEdge(std::int32_t edge,
                                                double t0,
                                                double t1,
                                                double t) const;
  /// The point of a mesh edge on the level, from the one where a linear field would have it.
  [[nodiscard]] Vec3 onMeshEdge(std::uint32_t halfEdge, const Vec3& start) const;
  /// A vertex that counts as on the level and is left where it is.
  [[nodiscard]] bool settled(const Vec3& vertex, double fraction) const;
  [[nodiscard]] std::optional<Node> refinedNode(std::uint32_t halfEdge, double fraction) const;
  [[nodiscard]] geometry::Vec2 cornerUv(std::uint32_t triangle,
                                        std::uint32_t halfEdge,
                                        double fraction) const;
  [[nodiscard]] bool hasEdge(std::uint32_t triangle, std::uint32_t halfEdge) const;
  void addSegment(const geometry::LevelContour& contour,
                  const std::vector<Node>& nodes,
                  std::size_t from,
                  std::size_t to);
  void smoothMeshNormals();

  const geometry::PartSurface* part_;
  geometry::BrepEvaluator* evaluator_;  ///< null for mesh parts
  const LayerField* field_;             ///< null for a field of vertices
  std::size_t level_;
  double residualTolerance_;
  double flat_;
  bool closed_ = false;
  std::vector<CurveSegment> segments_;
};

}  // namespace wcam::toolpath
