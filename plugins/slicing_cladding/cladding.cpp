// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/plugin/plugin.hpp"

#include "cladding_beads.hpp"
#include "cladding_lines.hpp"
#include "cladding_room.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace wcam;
using namespace wcam::cladding;
using geometry::PartSurface;
using toolpath::Contour;
using toolpath::LayerLevel;
using toolpath::SlicedLayer;
using toolpath::SlicedLayers;

enum class Pattern { Parallel, Zigzag, Concentric };
enum class Margin { Inside, Centre };

struct Params {
  Pattern pattern = Pattern::Zigzag;
  std::array<double, 3> direction{1.0, 0.0, 0.0};
  Length width = 0.0_mm;
  double overlap = 0.667;
  Margin margin = Margin::Inside;
  int layers = 1;
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  Length minLength = 0.0_mm;

  static const Schema<Params>& schema();

  [[nodiscard]] double spacing(double beadWidth) const { return overlap * beadWidth; }
};

Schema<Params> makeSchema() {
  Schema<Params> schema;
  schema
      .add(&Params::pattern, {.key = "pattern",
                              .label = "Pattern",
                              .help = "How beads cover the surface.",
                              .group = "Beads",
                              .choices = {{"parallel", "Parallel lines, all in one direction"},
                                          {"zigzag", "Parallel lines, joined at their ends"},
                                          {"concentric", "Concentric from the border"}}})
      .add(&Params::direction,
           {.key = "direction",
            .label = "Direction across the beads",
            .help = "Lines lie in planes normal to it; in the part frame, any length.",
            .group = "Beads",
            .enabledIf = "pattern!=concentric"})
      .add(&Params::width, {.key = "bead_width",
                            .label = "Bead width",
                            .help = "Of a single bead; 0 takes the process's.",
                            .group = "Beads",
                            .min = 0.0,
                            .max = 1000.0})
      .add(&Params::overlap,
           {.key = "overlap",
            .label = "Centre distance, in bead widths",
            .help = "Measured on the surface; 0.667 leaves a level surface (Ding 2015). It is "
                    "changed a little, so that beads end at both borders.",
            .group = "Beads",
            .min = 0.1,
            .max = 1.0})
      .add(&Params::margin, {.key = "border",
                             .label = "At the border of the surface",
                             .help = "What lies on the border: the bead's side or its centre. A "
                                     "centre on the border adds half a bead distance of stock "
                                     "beyond it.",
                             .group = "Beads",
                             .choices = {{"inside", "The bead's side: it stays on the surface"},
                                         {"centre", "The bead's centre"}}})
      .add(&Params::minLength, {.key = "min_length",
                                .label = "Least bead length",
                                .help = "Shorter beads are left out; 0: one bead width.",
                                .group = "Beads",
                                .level = ParamLevel::Advanced,
                                .min = 0.0,
                                .max = 1e6})
      .add(&Params::layers, {.key = "layers",
                             .label = "Layers",
                             .help = "Stacked along the surface's normal.",
                             .group = "Layers",
                             .min = 1,
                             .max = 10000})
      .add(&Params::step, {.key = "step",
                           .label = "Layer height",
                           .help = "Distance between neighbouring layers, along the normal.",
                           .group = "Layers",
                           .min = 0.01,
                           .max = 1000.0})
      .add(&Params::firstLayer,
           {.key = "first_layer",
            .label = "First layer, in heights",
            .help = "Height of the first layer above the surface; 0 lays it on the surface itself.",
            .group = "Layers",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 100.0});
  return schema;
}

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema = makeSchema();
  return schema;
}

/// On meshes the torch follows the mean normal over this many bead distances: finer facets are
/// those of the file, not of the part.
constexpr double kSmoothing = 0.5;

/// Traces of the levels, not cut by the substrate: what is clad is itself what beads stand on.
std::vector<std::vector<Contour>> byLevel(const SlicedLayers& sliced,
                                          const std::vector<LayerLevel>& levels) {
  std::vector<std::vector<Contour>> result(levels.size());
  std::size_t k = 0;
  for (const SlicedLayer& layer : sliced.layers) {
    while (k < levels.size() && levels[k].value != layer.level) {
      ++k;
    }
    if (k < levels.size()) {
      result[k] = layer.contours;
    }
  }
  return result;
}

/// A plate below all parts.
toolpath::Substrate plateBelow(const plugin::SliceInput& input) {
  double depth = 0.0;
  const Vec3 up = input.substrate->up();
  for (const auto& part : input.parts) {
    for (const Vec3& p : part->mesh.vertices) {
      depth = std::max(depth, -up.dot(p - input.substrate->pose().translation()));
    }
  }
  geometry::Pose pose = input.substrate->pose();
  pose.translation() -= (2.0 * depth + 1.0) * up;
  return {pose, input.substrate->size()};
}

class Cladder {
public:
  Cladder(const plugin::SliceInput& input, const Params& params, const JobContext& context)
      : input_(input),
        params_(params),
        context_(context),
        below_(plateBelow(input)),
        width_(params.width.value() > 0.0 ? params.width.value() : input.bead.width),
        spacing_(params.spacing(width_)),
        margin_(params.margin == Margin::Inside ? 0.5 * width_ : 0.0),
        minLength_(params.minLength.value() > 0.0 ? params.minLength.value() : width_) {
    for (const auto& part : input.parts) {
      geometry::SegmentTree& border = borders_.emplace_back();
      const geometry::TriangleMesh& mesh = part->mesh;
      for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
        if (part->halfEdges.twin(h) == geometry::HalfEdges::kNone) {
          const auto& t = mesh.triangles[h / 3];
          border.add(mesh.vertices[t[h % 3]], mesh.vertices[t[(h % 3 + 1) % 3]]);
        }
      }
      border.build();
    }
  }

  [[nodiscard]] SlicedLayers run() const {
    std::vector<std::vector<SurfaceCurve>> beads(input_.parts.size());
    bool any = false;
    for (std::size_t k = 0; k < beads.size(); ++k) {
      context_.check();
      beads[k] = params_.pattern == Pattern::Concentric ? concentric(k) : lines(k);
      any = any || !beads[k].empty();
    }
    if (!any) {
      throw Error(ErrorCode::JobFailed, "no bead fits onto the surface", "cladding",
                  "use a narrower bead, or allow shorter ones (min_length)");
    }
    return stack(beads);
  }

private:
  [[nodiscard]] std::vector<SurfaceCurve> lines(std::size_t part) const {
    const PartSurface& surface = *input_.parts[part];
    const LinePlanes planes = linePlanes(surface, across(), spacing_, marginsOf(part));
    report(planes, part);
    std::vector<SurfaceCurve> curves = traces(planes, planes.stack, part);
    if (params_.pattern == Pattern::Zigzag) {
      constexpr double kReach = 2.0;
      curves = zigzag(curves, geometry::AabbTree(surface.mesh), kReach * spacing_,
                      input_.sampling.maxSpacing);
    }
    return curves;
  }

  [[nodiscard]] Vec3 across() const {
    return {params_.direction[0], params_.direction[1], params_.direction[2]};
  }

  [[nodiscard]] std::vector<SurfaceCurve> traces(const LinePlanes& planes,
                                                 const toolpath::PlaneStack& stack,
                                                 std::size_t part) const {
    const SlicedLayers sliced =
        toolpath::sliceByField({input_.parts[part]}, toolpath::PlaneField(stack), stack.levels,
                               below_, input_.sampling, context_.withOwnDiagnostics());
    // A surface narrower than a bead has its bead in the middle.
    constexpr double kInside = 0.49;
    return curvesOf(byLevel(sliced, stack.levels), std::min(margin_, kInside * planes.width), part);
  }

  /// How far the first and the last line stay from the ends. Where the border is round, a line at
  /// the bead's distance from its end would be a point: it moves inwards until a bead fits.
  [[nodiscard]] std::array<double, 2> marginsOf(std::size_t part) const {
    std::array<double, 2> margins{margin_, margin_};
    if (borders_[part].empty()) {
      return margins;
    }
    const auto fits = [&](const std::array<double, 2>& tried, bool last, double length) {
      const LinePlanes planes = linePlanes(*input_.parts[part], across(), spacing_, tried);
      toolpath::PlaneStack stack = planes.stack;
      stack.levels = {last ? planes.stack.levels.back() : planes.stack.levels.front()};
      try {
        const std::vector<SurfaceCurve> found = traces(planes, stack, part);
        return std::any_of(found.begin(), found.end(),
                           [&](const SurfaceCurve& curve) { return curveLength(curve) >= length; });
      } catch (const Error& error) {
        if (error.code() != ErrorCode::CheckFailed && error.code() != ErrorCode::JobFailed) {
          throw;
        }
        return false;  // the plane meets nothing
      }
    };
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      // Rather a bead worth its start; where the surface is small, any bead.
      for (const double length : {std::max(minLength_, 2.0 * width_), minLength_}) {
        std::array<double, 2> tried = margins;
        tried[side] = margin_ + spacing_;
        if (fits(margins, side == 1, length)) {
          break;
        }
        if (!fits(tried, side == 1, length)) {
          continue;
        }
        double low = margin_;
        double high = margin_ + spacing_;
        constexpr int kBisections = 8;
        for (int k = 0; k < kBisections; ++k) {
          tried[side] = 0.5 * (low + high);
          (fits(tried, side == 1, length) ? high : low) = tried[side];
        }
        margins[side] = high;
        break;
      }
    }
    return margins;
  }

  [[nodiscard]] std::vector<SurfaceCurve> concentric(std::size_t part) const {
    const PartSurface& whole = *input_.parts[part];
    if (whole.halfEdges.borderEdgeCount() == 0) {
      throw Error(ErrorCode::JobFailed,
                  "the surface is closed: it has no border that beads could follow",
                  text("cladding, part %1", {std::to_string(part + 1)}),
                  "pick the faces to clad, or take parallel lines");
    }
    const auto fine = std::make_shared<const PartSurface>(
        // The innermost beads turn around half a spacing: edges half as long follow them.
        geometry::refineSurface(whole, geometry::fieldEdgeLength(whole, 0.25 * spacing_),
                                context_));
    geometry::GeodesicSource source;
    for (std::uint32_t h = 0; h < 3 * fine->mesh.triangles.size(); ++h) {
      if (fine->halfEdges.twin(h) == geometry::HalfEdges::kNone) {
        source.borderEdges.push_back(h);
      }
    }
    const geometry::GeodesicSolver solver(fine->mesh, fine->halfEdges);
    std::vector<double> distance =
        solver.distance(source, std::numeric_limits<double>::infinity(), context_);
    double farthest = 0.0;
    for (double& d : distance) {
      if (std::isfinite(d)) {
        farthest = std::max(farthest, d);
      } else {
        d = std::numeric_limits<double>::quiet_NaN();
      }
    }
    const double room = farthest - margin_;
    if (!(room > 0.0)) {
      return {};
    }
    requireFewLines(room / spacing_);
    // The innermost beads lie half a spacing from the middle line that they share.
    const int rings = std::max(1, gapsOf(room + 0.5 * spacing_, spacing_));
    const double spacing = room / (rings - 0.5);
    std::vector<LayerLevel> levels;
    for (int k = 0; k < rings; ++k) {
      levels.push_back({margin_ + k * spacing, input_.substrate->up(), spacing});
    }
    const SlicedLayers sliced =
        toolpath::sliceByField({fine}, toolpath::VertexField{{std::move(distance)}}, levels, below_,
                               input_.sampling, context_.withOwnDiagnostics());
    return curvesOf(byLevel(sliced, levels), 0.0, part);
  }

  [[nodiscard]] std::vector<SurfaceCurve> curvesOf(const std::vector<std::vector<Contour>>& traces,
                                                   double margin,
                                                   std::size_t part) const {
    std::vector<SurfaceCurve> curves;
    for (std::size_t line = 0; line < traces.size(); ++line) {
      for (const Contour& contour : traces[line]) {
        SurfaceCurve curve = toCurve(contour, line, input_.sampling.chordError);
        if (!input_.parts[part]->exact()) {
          smoothNormals(curve, kSmoothing * spacing_);
        }
        for (SurfaceCurve& piece : insideBorder(curve, borders_[part], margin)) {
          if (piece.points.size() > 1 && curveLength(piece) >= minLength_) {
            curves.push_back(std::move(piece));
          }
        }
      }
    }
    return curves;
  }

  void report(const LinePlanes& planes, std::size_t part) const {
    if (planes.uncoveredArea > spacing_ * spacing_) {
      context_.add({Severity::Warning,
                    "slicing.uncovered",
                    text("%1 mm² of part %2 run along the planes of the lines and are not covered",
                         {formatFixed(planes.uncoveredArea, 0), std::to_string(part + 1)}),
                    "clad these faces by an operation of their own, with another direction",
                    {},
                    {{"area_mm2", planes.uncoveredArea}}});
    }
    constexpr double kDenseShare = 0.1;
    if (planes.denseArea > kDenseShare * planes.area) {
      context_.add(
          {Severity::Warning,
           "slicing.overfill",
           text("on %1 % of the surface of part %2 lines lie clearly nearer than the bead "
                "distance, since the surface slopes differently along them",
                {formatFixed(100.0 * planes.denseArea / planes.area, 0), std::to_string(part + 1)}),
           "clad the faces one by one, or take the concentric pattern",
           {},
           {{"area_mm2", planes.denseArea}}});
    }
  }

  /// What the beads of each part have to fill.
  [[nodiscard]] std::vector<SurfaceRoom> roomsOf(
      const std::vector<std::vector<SurfaceCurve>>& beads) const {
    std::vector<SurfaceRoom> rooms;
    for (std::size_t part = 0; part < beads.size(); ++part) {
      context_.check();
      const PartSurface& surface = *input_.parts[part];
      const Vec3 direction = across().normalized();
      const auto counts = [&](std::uint32_t t) {
        const double cosine = surface.mesh.normal(t).dot(direction);
        return params_.pattern == Pattern::Concentric ||
               1.0 - cosine * cosine >= kLeastSlope * kLeastSlope;
      };
      // A corner of the border is as far from its bead as the diagonal of half its width.
      constexpr double kReach = 1.5;
      const SurfaceRoom& room = rooms.emplace_back(
          surface, beads[part], counts, borders_[part],
          RoomOptions{width_, spacing_, params_.margin == Margin::Centre ? 0.5 * spacing_ : 0.0,
                      kReach * std::max(spacing_, margin_)});
      if (room.uncoveredArea() > spacing_ * spacing_) {
        context_.add({Severity::Warning,
                      "slicing.uncovered",
                      text("%1 mm² of part %2 lie too far from every bead and are not covered",
                           {formatFixed(room.uncoveredArea(), 0), std::to_string(part + 1)}),
                      "use narrower beads, allow shorter ones (min_length), or take another "
                      "pattern or direction",
                      {},
                      {{"area_mm2", room.uncoveredArea()}}});
      }
    }
    return rooms;
  }

  [[nodiscard]] SlicedLayers stack(const std::vector<std::vector<SurfaceCurve>>& beads) const {
    const std::vector<SurfaceRoom> rooms = roomsOf(beads);
    SlicedLayers sliced;
    sliced.curved = true;
    sliced.asGiven = params_.pattern != Pattern::Concentric;
    Vec3 mean = Vec3::Zero();
    for (const auto& part : beads) {
      for (const SurfaceCurve& curve : part) {
        for (const Vec3& normal : curve.normals) {
          mean += normal;
        }
      }
    }
    // Around a closed surface the normals cancel: the substrate's direction stands for all.
    constexpr double kNoDirection = 1e-6;
    const Vec3 up = mean.norm() > kNoDirection ? Vec3(mean.normalized()) : input_.substrate->up();
    for (int j = 0; j < params_.layers; ++j) {
      SlicedLayer layer;
      layer.level = (params_.firstLayer + j) * params_.step.value();
      layer.up = up;
      layer.nominalHeight = params_.step.value();
      std::size_t folded = 0;
      std::size_t cut = 0;
      int group = 0;
      for (std::size_t part = 0; part < beads.size(); ++part) {
        for (std::size_t c = 0; c < beads[part].size(); ++c) {
          const SurfaceCurve& curve = beads[part][c];
          // A layer has the area of its middle.
          const double middle = std::max(0.0, layer.level - 0.5 * params_.step.value());
          Contour contour = raised(curve, layer.level, params_.step.value(), params_.width.value(),
                                   rooms[part].at(c, middle), folded);
          contour.part = static_cast<int>(part);
          contour.group = group++;
          std::vector<Contour> pieces = aboveSubstrate(contour, *input_.substrate);
          cut += pieces.size() == 1 && pieces[0].points.size() == contour.points.size() ? 0U : 1U;
          for (Contour& piece : pieces) {
            densify(piece, input_.sampling.maxSpacing);
            layer.contours.push_back(std::move(piece));
          }
        }
      }
      if (cut > 0) {
        context_.add({Severity::Information,
                      "slicing.below_substrate",
                      "parts of the layer lie below the substrate and were cut away",
                      "pick the faces to clad, or raise the part above its plate",
                      {{}, j, -1, -1},
                      {{"beads", static_cast<double>(cut)}}});
      }
      if (layer.contours.empty()) {
        continue;
      }
      if (folded > 0) {
        context_.add({Severity::Warning,
                      "slicing.fold",
                      text("at %1 mm above the surface %2 points run backwards: the surface is "
                           "hollow with a smaller radius",
                           {formatFixed(layer.level, 2), std::to_string(folded)}),
                      "use fewer or thinner layers there",
                      {{}, j, -1, -1},
                      {{"points", static_cast<double>(folded)}}});
      }
      sliced.layers.push_back(std::move(layer));
    }
    if (sliced.layers.empty()) {
      throw Error(ErrorCode::CheckFailed, "all beads lie below the substrate", "cladding",
                  "raise the part above the substrate");
    }
    return sliced;
  }

  const plugin::SliceInput& input_;
  const Params& params_;
  const JobContext& context_;
  toolpath::Substrate below_;
  double width_;
  double spacing_;
  double margin_;
  double minLength_;
  std::vector<geometry::SegmentTree> borders_;  ///< per part
};

class CladdingSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] SlicedLayers slice(const plugin::SliceInput& input,
                                   const Value& values,
                                   const JobContext& context) const override {
    const Params params = Params::schema().read(values, "cladding");
    SlicedLayers sliced = Cladder(input, params, context).run();
    context.report(1.0);
    return sliced;
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.cladding",
       .name = "Cladding of a surface",
       .summary = "Beads side by side on faces or a whole surface, in layers along the normal.",
       .version = 2,
       .params = Params::schema().params()},
      [] { return std::make_unique<CladdingSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
