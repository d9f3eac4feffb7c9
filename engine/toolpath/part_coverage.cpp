// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/part_coverage.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

namespace {

using geometry::PartSurface;

/// A bead covers what is this many times its half width, or its layer's height, from its line.
constexpr double kCovers = 1.1;
/// Pieces of the surface smaller than this part of what a bead covers are covered as a whole or
/// not.
constexpr double kPiece = 0.5;
/// What lies above the last layer, by more than this part of its distance or by more than so many
/// steps, is left out on purpose: by an end height, or as the rest that has a finding of its own.
constexpr double kAbove = 0.5;
constexpr double kBeyond = 1.5;
/// A top of a solid that is nearer to the substrate than so many steps is no layer.
constexpr double kThin = 0.25;
/// Uncovered faces below this part of the part's surface are the rounding of corners.
constexpr double kLeastShare = 1e-3;
/// Cosine between a face's normal and the direction of growth from which on the face is level.
constexpr double kLevel = 0.5;
constexpr std::size_t kTriangleGrain = 64;
/// Noise of a part on its plate, in tolerances of a flat face.
constexpr double kOnPlate = 4.0;

std::vector<Vec3> pointsOf(const Contour& contour) {
  std::vector<Vec3> points;
  points.reserve(contour.points.size());
  for (const ContourPoint& point : contour.points) {
    points.push_back(point.p);
  }
  return points;
}

void addLayer(const SlicedLayer& layer, geometry::SegmentTree& tree) {
  for (const Contour& contour : layer.contours) {
    tree.add(pointsOf(contour), contour.closed);
  }
}

/// What is found on one triangle.
struct Uncovered {
  double area = 0.0;
  double distance = 0.0;  ///< of the farthest place
  Vec3 place = Vec3::Zero();

  void add(const Uncovered& other) {
    area += other.area;
    if (other.distance > distance) {
      distance = other.distance;
      place = other.place;
    }
  }
};

class Coverage {
public:
  Coverage(const SlicedLayers& sliced, const Substrate& substrate, const BeadRange& bead)
      : substrate_(substrate), curved_(sliced.curved) {
    for (const SlicedLayer& layer : sliced.layers) {
      step_ = std::max(step_, layer.nominalHeight);
      addLayer(layer, all_);
    }
    all_.build();
    addLayer(sliced.layers.back(), last_);
    last_.build();
    lastUp_ = sliced.layers.back().up;
    reach_ = kCovers * std::max(0.5 * bead.width, step_);
  }

  [[nodiscard]] double reach() const { return reach_; }

  /// Whether a triangle may lie between layers: plane ones leave nothing of a steep wall.
  [[nodiscard]] bool mayMiss(const Vec3& normal) const {
    return curved_ || std::abs(normal.dot(lastUp_)) > kLevel;
  }

  /// @param top of a solid: no layer that is still to come covers it
  [[nodiscard]] Uncovered of(const std::array<Vec3, 3>& corners, bool top) const {
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
    double radius = 0.0;
    for (const Vec3& corner : corners) {
      radius = std::max(radius, (corner - centre).norm());
    }
    const double distance = all_.distance(centre, reach_ + radius);
    if (distance + radius <= reach_) {
      return {};
    }
    Uncovered result;
    if (radius <= kPiece * reach_) {
      if (distance > reach_ && counts(centre, top)) {
        result.area = 0.5 * (corners[1] - corners[0]).cross(Vec3(corners[2] - corners[0])).norm();
        result.distance = all_.distance(centre);
        result.place = centre;
      }
      return result;
    }
    const std::array<Vec3, 3> middle{0.5 * (corners[0] + corners[1]),
                                     0.5 * (corners[1] + corners[2]),
                                     0.5 * (corners[2] + corners[0])};
    result.add(of({corners[0], middle[0], middle[2]}, top));
    result.add(of({corners[1], middle[1], middle[0]}, top));
    result.add(of({corners[2], middle[2], middle[1]}, top));
    result.add(of(middle, top));
    return result;
  }

private:
  /// False for what lies on or below the substrate or beyond the last layer.
  [[nodiscard]] bool counts(const Vec3& p, bool top) const {
    if (substrate_.heightAbove(p) <= (top ? kThin * step_ : step_)) {
      return false;
    }
    const Vec3 beyond = p - last_.nearest(p);
    return beyond.dot(lastUp_) <= std::min(kBeyond * step_, kAbove * beyond.norm());
  }

  const Substrate& substrate_;
  bool curved_;
  geometry::SegmentTree all_;
  geometry::SegmentTree last_;
  Vec3 lastUp_ = Vec3::UnitZ();
  double step_ = 0.0;
  double reach_ = 0.0;
};

/// What covers faces that these layers leave out.
Text remedyFor(const SlicedLayers& sliced, bool closed) {
  bool filled = false;
  bool inset = false;
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      filled = filled || contour.feature == BeadFeature::Fill;
      inset = inset || contour.feature == BeadFeature::Inset;
    }
  }
  if (filled) {
    return "a smaller step, a narrower bead or a smaller maximum width (max_width) covers more";
  }
  if (inset) {
    return "choose a pattern that fills the inside (pattern), or more walls";
  }
  if (closed) {
    return "fill the layers of a solid: strategy 'Filled planar layers' (wcam.slicing.bulk)";
  }
  return sliced.curved
             ? "clad these faces: strategy 'Cladding of a surface' (wcam.slicing.cladding)"
             : "let the layers follow the surface: strategy 'Geodesic distance from the base' "
               "(wcam.slicing.geodesic), or clad level faces (wcam.slicing.cladding)";
}

void reportUncovered(const SlicedLayers& sliced,
                     const std::vector<std::shared_ptr<const PartSurface>>& parts,
                     const Substrate& substrate,
                     const BeadRange& bead,
                     const JobContext& context) {
  const Coverage coverage(sliced, substrate, bead);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const geometry::TriangleMesh& mesh = parts[k]->mesh;
    std::vector<Uncovered> found(mesh.triangles.size());
    std::vector<double> areas(mesh.triangles.size());
    parallelFor(
        mesh.triangles.size(), kTriangleGrain,
        [&](std::size_t t) {
          const auto& c = mesh.triangles[t];
          const std::array<Vec3, 3> corners{mesh.vertices[c[0]], mesh.vertices[c[1]],
                                            mesh.vertices[c[2]]};
          areas[t] = 0.5 * (corners[1] - corners[0]).cross(Vec3(corners[2] - corners[0])).norm();
          if (coverage.mayMiss(mesh.normal(t))) {
            found[t] = coverage.of(corners, parts[k]->halfEdges.closed() &&
                                                mesh.normal(t).dot(substrate.up()) > kLevel);
          }
        },
        context);
    Uncovered sum;
    double area = 0.0;
    for (std::size_t t = 0; t < found.size(); ++t) {
      sum.add(found[t]);
      area += areas[t];
    }
    if (sum.area <= std::max(coverage.reach() * coverage.reach(), kLeastShare * area)) {
      continue;
    }
    context.add(
        {Severity::Warning,
         "slicing.uncovered",
         text("%1 mm² (%2 %) of the surface of part %3 get no layer; the place at (%4, %5, %6) is "
              "%7 mm from the nearest bead",
              {formatFixed(sum.area, 0), formatFixed(100.0 * sum.area / area, 1),
               std::to_string(k + 1), formatFixed(sum.place.x(), 1), formatFixed(sum.place.y(), 1),
               formatFixed(sum.place.z(), 1), formatFixed(sum.distance, 1)}),
         remedyFor(sliced, parts[k]->halfEdges.closed()),
         {},
         {{"area_mm2", sum.area},
          {"area_percent", 100.0 * sum.area / area},
          {"distance_mm", sum.distance},
          {"x_mm", sum.place.x()},
          {"y_mm", sum.place.y()},
          {"z_mm", sum.place.z()}}});
  }
}

/// Moves of a part are those of its frame: on a tilted plate the height alone does not say them.
Text moveText(bool raise, double height, const Substrate& substrate) {
  const double whole = std::ceil(1e3 * height) / 1e3;
  constexpr double kTilted = 1e-6;
  if ((substrate.up() - Vec3::UnitZ()).norm() <= kTilted) {
    return raise ? text("raise the part by %1 mm", {formatFixed(whole, 3)})
                 : text("lower the part by %1 mm", {formatFixed(height, 3)});
  }
  const Vec3 move = (raise ? whole : -height) * substrate.up();
  return text("move the part by (%1, %2, %3) mm, along the plate's normal",
              {formatFixed(move.x(), 3), formatFixed(move.y(), 3), formatFixed(move.z(), 3)});
}

/// Layers around an axis may run on through the plate.
void reportInside(const SlicedLayers& sliced,
                  const Substrate& substrate,
                  double tolerance,
                  const JobContext& context) {
  if (!substrate.isPlate()) {
    return;
  }
  const geometry::Pose T_plate_part = substrate.pose().inverse();
  const Vec3 half = 0.5 * substrate.size();
  double deepest = 0.0;
  Vec3 place = Vec3::Zero();
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (const ContourPoint& point : contour.points) {
        const Vec3 p = T_plate_part * point.p;
        const bool within = std::abs(p.x()) < half.x() && std::abs(p.y()) < half.y() &&
                            p.z() > -substrate.size().z();
        if (within && -p.z() > deepest) {
          deepest = -p.z();
          place = point.p;
        }
      }
    }
  }
  if (deepest > tolerance) {
    context.add(
        {Severity::Violation,
         "slicing.bead_in_plate",
         text("beads lie up to %1 mm inside the plate, deepest at (%2, %3, %4)",
              {formatFixed(deepest, 3), formatFixed(place.x(), 1), formatFixed(place.y(), 1),
               formatFixed(place.z(), 1)}),
         text("%1, or choose a strategy whose layers begin at the plate",
              {moveText(true, deepest, substrate)}),
         {},
         {{"depth_mm", deepest}, {"x_mm", place.x()}, {"y_mm", place.y()}, {"z_mm", place.z()}}});
  }
}

void reportBelow(const SlicedLayers& sliced,
                 const std::vector<std::shared_ptr<const PartSurface>>& parts,
                 const Substrate& substrate,
                 const JobContext& context) {
  double lowestBead = std::numeric_limits<double>::infinity();
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (const ContourPoint& point : contour.points) {
        lowestBead = std::min(lowestBead, substrate.heightAbove(point.p));
      }
    }
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& v : parts[k]->mesh.vertices) {
      lowest = std::min(lowest, substrate.heightAbove(v));
    }
    // Layers around an axis go on below the plate.
    const double leftOut = std::min(lowestBead, 0.0) - lowest;
    if (!(leftOut > kOnPlate * geometry::flatTolerance(parts[k]->mesh))) {
      continue;
    }
    const bool plate = substrate.isPlate();
    context.add(
        {plate ? Severity::Warning : Severity::Information,
         "slicing.below_plate",
         text(plate ? "part %1 reaches %2 mm below the plate; what lies there gets no layers"
                    : "part %1 reaches %2 mm into the substrate; what lies there gets no layers",
              {std::to_string(k + 1), formatFixed(leftOut, 3)}),
         plate ? text("%1, so that it stands on the plate", {moveText(true, leftOut, substrate)})
               : Text(),
         {},
         {{"depth_mm", leftOut}}});
  }
}

/// A part that stands neither on the plate nor on another part: its first layer would have to fill
/// what is between.
void reportFloating(const SlicedLayers& sliced,
                    const std::vector<std::shared_ptr<const PartSurface>>& parts,
                    const Substrate& substrate,
                    const JobContext& context) {
  if (!substrate.isPlate() || !sliced.onSubstrate) {
    return;
  }
  // Less than this part of a layer is no gap.
  constexpr double kGap = 0.02;
  const geometry::Pose T_plate_part = substrate.pose().inverse();
  std::vector<geometry::Box> boxes;
  for (const auto& part : parts) {
    geometry::Box& box = boxes.emplace_back();
    for (const Vec3& v : part->mesh.vertices) {
      box.add(T_plate_part * v);
    }
  }
  double step = 0.0;
  for (const SlicedLayer& layer : sliced.layers) {
    step = std::max(step, layer.nominalHeight);
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double gap = boxes[k].min.z();
    const bool stands = std::any_of(boxes.begin(), boxes.end(), [&](const geometry::Box& other) {
      return other.min.z() < gap && other.min.x() < boxes[k].max.x() &&
             other.min.y() < boxes[k].max.y() && other.max.x() > boxes[k].min.x() &&
             other.max.y() > boxes[k].min.y();
    });
    if (stands ||
        !(gap > std::max(kGap * step, kOnPlate * geometry::flatTolerance(parts[k]->mesh)))) {
      continue;
    }
    context.add({Severity::Warning,
                 "slicing.floating",
                 text("part %1 floats %2 mm above the plate; its first layer fills what is between",
                      {std::to_string(k + 1), formatFixed(gap, 3)}),
                 text("%1, so that it stands on the plate", {moveText(false, gap, substrate)}),
                 {},
                 {{"gap_mm", gap}}});
  }
}

}  // namespace

void reportLeftOut(const SlicedLayers& sliced,
                   const std::vector<std::shared_ptr<const PartSurface>>& parts,
                   const Substrate& substrate,
                   const BeadRange& bead,
                   const JobContext& context) {
  bool own = sliced.layers.empty();
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      own = own || contour.feature == BeadFeature::Cladding ||
            contour.feature == BeadFeature::Imported;
    }
  }
  if (own) {
    return;
  }
  double tolerance = 0.0;
  for (const auto& part : parts) {
    tolerance = std::max(tolerance, kOnPlate * geometry::flatTolerance(part->mesh));
  }
  reportInside(sliced, substrate, tolerance, context);
  reportBelow(sliced, parts, substrate, context);
  reportFloating(sliced, parts, substrate, context);
  reportUncovered(sliced, parts, substrate, bead, context);
}

}  // namespace wcam::toolpath
