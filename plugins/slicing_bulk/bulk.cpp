// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/plugin.hpp"

#include "bulk_params.hpp"
#include "bulk_section.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace {

using namespace wcam;
using namespace wcam::bulk;
using geometry::Region2;
using toolpath::Contour;
using toolpath::FillCoverage;
using toolpath::FillOptions;
using toolpath::FillResult;
using toolpath::SlicedLayer;
using toolpath::SlicedLayers;

/// Part of the chord error that the outline of a section may lose before it is filled.
constexpr double kOutlineShare = 0.25;
/// A layer that holds less of its volume has a finding, and a remedy comes so near to 1.
constexpr double kLeastFill = 0.95;
constexpr double kGoodFill = 0.03;

struct FilledLayer {
  std::vector<Contour> contours;
  std::vector<Diagnostic> findings;
  std::size_t openContours = 0;
};

std::vector<std::pair<std::string, double>> at(const LayerPlane& plane, const Vec2& q) {
  const Vec3 p = plane.toSpace(q);
  return {{"x_mm", p.x()}, {"y_mm", p.y()}, {"z_mm", p.z()}};
}

std::string placeText(const LayerPlane& plane, const Vec2& q) {
  const Vec3 p = plane.toSpace(q);
  return "(" + formatFixed(p.x(), 2) + ", " + formatFixed(p.y(), 2) + ", " + formatFixed(p.z(), 2) +
         ")";
}

void reportCoverage(const FillCoverage& coverage,
                    const Params& params,
                    const LayerPlane& plane,
                    FilledLayer& layer) {
  if (coverage.coveredPart() < params.leastCoverage) {
    auto data = at(plane, coverage.largestVoid);
    data.insert(data.begin(), {{"covered_percent", 100.0 * coverage.coveredPart()},
                               {"void_area_mm2", coverage.largestVoidArea}});
    layer.findings.push_back(
        {Severity::Warning,
         "slicing.voids",
         text("beads cover %1 % of the section; the largest void is at %2",
              {formatFixed(100.0 * coverage.coveredPart(), 1),
               placeText(plane, coverage.largestVoid)}),
         "choose another pattern or line angle, a narrower bead, or a wider range of bead widths",
         {},
         std::move(data)});
  }
}

/// By volume, as the layer height is the same: the narrowest beads may hold more than their room,
/// and no bead reaches everything.
void reportFill(double ratio, const Params& params, const Text& remedy, FilledLayer& layer) {
  if (ratio > params.mostFill) {
    layer.findings.push_back({Severity::Warning,
                              "slicing.overfill",
                              text("the beads hold %1 % of the volume of the layer and pile up",
                                   {formatFixed(100.0 * ratio, 1)}),
                              remedy,
                              {},
                              {{"fill_percent", 100.0 * ratio}}});
  } else if (ratio < kLeastFill) {
    layer.findings.push_back({Severity::Warning,
                              "slicing.underfill",
                              text("the beads hold %1 % of the volume of the layer: they do not "
                                   "reach all of the section",
                                   {formatFixed(100.0 * ratio, 1)}),
                              remedy,
                              {},
                              {{"fill_percent", 100.0 * ratio}}});
  }
}

void reportNarrow(const FillResult& fill, const LayerPlane& plane, FilledLayer& layer) {
  const toolpath::NarrowPlace* worst = nullptr;
  std::size_t unfilled = 0;
  for (const toolpath::NarrowPlace& place : fill.narrow) {
    unfilled += place.filled ? 0U : 1U;
    const bool worse = worst == nullptr || (worst->filled && !place.filled) ||
                       (worst->filled == place.filled && place.thickness < worst->thickness);
    worst = worse ? &place : worst;
  }
  if (worst == nullptr) {
    return;
  }
  auto data = at(plane, worst->p);
  data.insert(data.begin(), {{"places", static_cast<double>(fill.narrow.size())},
                             {"unfilled", static_cast<double>(unfilled)},
                             {"thickness_mm", worst->thickness}});
  layer.findings.push_back(
      {unfilled > 0 ? Severity::Warning : Severity::Information,
       "slicing.narrow",
       text(
           unfilled > 0
               ? "the section is narrower than a bead: %1 mm at %2; nothing is laid there"
               : "the section is narrower than a bead: %1 mm at %2; one bead of that width is laid "
                 "there",
           {formatFixed(worst->thickness, 2), placeText(plane, worst->p)}),
       unfilled > 0 ? "allow narrower beads (min_width, fill_narrow) or thicken the part" : "",
       {},
       std::move(data)});
}

/// What a layer has to fill: from the plane below to its own.
struct Slab {
  double thickness = 0.0;               ///< mm
  const SlicedLayer* middle = nullptr;  ///< section halfway through it, if that plane meets a part
};

/// The slab of each layer. Layers and sections stand in the order of the planes.
std::vector<Slab> slabsOf(const SlicedLayers& sliced,
                          const SlicedLayers& middles,
                          const toolpath::PlaneStack& stack,
                          const toolpath::PlaneStack& halfway) {
  std::vector<Slab> slabs;
  std::size_t plane = 0;
  auto middle = middles.layers.begin();
  for (const SlicedLayer& layer : sliced.layers) {
    while (stack.levels[plane].value != layer.level) {
      ++plane;
    }
    const double below = plane > 0 ? stack.levels[plane - 1].value : 0.0;
    Slab slab{layer.level > below ? layer.level - below : layer.nominalHeight, nullptr};
    const double value = halfway.levels[plane].value;
    while (middle != middles.layers.end() && middle->level < value) {
      ++middle;
    }
    if (middle != middles.layers.end() && middle->level == value) {
      slab.middle = &*middle;
    }
    slabs.push_back(slab);
  }
  return slabs;
}

class LayerFiller {
public:
  LayerFiller(const plugin::SliceInput& input,
              const Params& params,
              const toolpath::PlaneStack& stack)
      : input_(input),
        params_(params),
        stack_(stack),
        options_(params.fill(input.bead, input.sampling)) {}

  /// @param index of the layer among those that meet a part
  [[nodiscard]] FilledLayer fill(const SlicedLayer& layer,
                                 const Slab& slab,
                                 std::size_t index) const {
    FilledLayer result;
    const LayerPlane plane(layer.up, stack_.base + layer.level, *input_.substrate);
    FillOptions options = options_;
    options.angle = params_.angle.value() + static_cast<double>(index) * params_.angleStep.value();
    std::set<int> parts;
    for (const Contour& contour : layer.contours) {
      parts.insert(contour.part);
      if (!contour.closed) {
        ++result.openContours;
        result.contours.push_back(contour);
      }
    }
    for (const int part : parts) {
      fillPart(layer, slab, part, plane, options, result);
    }
    for (Contour& contour : result.contours) {
      setHeights(contour, layer, slab.thickness);
    }
    return result;
  }

private:
  [[nodiscard]] Region2 regionOf(const SlicedLayer& layer,
                                 int part,
                                 const LayerPlane& plane) const {
    Region2 region = sectionRegion(layer, part, plane, kOutlineShare * input_.sampling.chordError);
    return input_.substrate->isPlate() ? abovePlate(region, plane, *input_.substrate) : region;
  }

  void fillPart(const SlicedLayer& layer,
                const Slab& slab,
                int part,
                const LayerPlane& plane,
                const FillOptions& options,
                FilledLayer& result) const {
    Region2 region = regionOf(layer, part, plane);
    if (params_.minArea > 0.0) {
      Region2 kept;
      for (const Region2& island : geometry::islandsOf(region)) {
        if (island.area() >= params_.minArea) {
          kept.loops.insert(kept.loops.end(), island.loops.begin(), island.loops.end());
        }
      }
      region = std::move(kept);
    }
    if (region.empty()) {
      return;
    }
    const FillResult fill = toolpath::fillRegion(region, options);
    // Where borders slope, the section halfway through the layer has its volume.
    Region2 room = slab.middle != nullptr ? regionOf(*slab.middle, part, plane) : Region2{};
    room = withoutHollow(grownByReference(room.empty() ? region : room, options), options);
    const std::vector<toolpath::FillRoom> rooms =
        toolpath::shareRoom(room, fill.beads, options, slab.thickness);
    for (std::size_t i = 0; i < fill.beads.size(); ++i) {
      result.contours.push_back(toContour(fill.beads[i], rooms[i], part, plane, input_.sampling));
    }
    reportNarrow(fill, plane, result);
    if (options.pattern != toolpath::FillPattern::None) {
      reportCoverage(toolpath::fillCoverage(region, fill.beads, options), params_, plane, result);
    }
    const double ratio = toolpath::fillRatio(room, rooms);
    const bool bad = ratio > params_.mostFill || ratio < kLeastFill;
    reportFill(ratio, params_, bad ? remedyFor(region, room, options, slab.thickness) : Text(),
               result);
  }

  /// What fills a section better, tried.
  [[nodiscard]] static Text remedyFor(const Region2& region,
                                      const Region2& room,
                                      const FillOptions& options,
                                      double thickness) {
    const auto ratioOf = [&](const FillOptions& tried) {
      return toolpath::fillRatio(
          room,
          toolpath::shareRoom(room, toolpath::fillRegion(region, tried).beads, tried, thickness));
    };
    const auto isGood = [](double ratio) { return std::abs(ratio - 1.0) <= kGoodFill; };
    if (options.pattern == toolpath::FillPattern::None) {
      return "choose a pattern that fills the inside, or another bead width";
    }
    for (const double part : {1.125, 1.25, 1.75, 2.0}) {
      FillOptions tried = options;
      tried.maxWidth = part * options.width;
      const double ratio = ratioOf(tried);
      if (isGood(ratio)) {
        return text("set max_width to %1 mm: %2 % of the volume are then filled (this was tried)",
                    {formatFixed(tried.maxWidth, 2), formatFixed(100.0 * ratio, 1)});
      }
    }
    for (const auto& [pattern, name] : {std::pair{toolpath::FillPattern::Zigzag, "zigzag"},
                                        std::pair{toolpath::FillPattern::Contour, "contour"},
                                        std::pair{toolpath::FillPattern::Medial, "medial"}}) {
      FillOptions tried = options;
      tried.pattern = pattern;
      const double ratio = ratioOf(tried);
      if (isGood(ratio)) {
        return text("set pattern to %1: %2 % of the volume are then filled (this was tried)",
                    {name, formatFixed(100.0 * ratio, 1)});
      }
    }
    for (const double part : {0.85, 0.7, 0.55}) {
      FillOptions tried = options;
      tried.width = part * options.width;
      tried.minWidth = std::min(options.minWidth, tried.width);
      const double ratio = ratioOf(tried);
      if (isGood(ratio)) {
        return text("set bead_width to %1 mm: %2 % of the volume are then filled (this was tried)",
                    {formatFixed(tried.width, 2), formatFixed(100.0 * ratio, 1)});
      }
    }
    return "use another pattern, fewer walls or a narrower bead";
  }

  /// Walls without a pattern fill the ring that they reach over, not the hollow inside it.
  [[nodiscard]] Region2 withoutHollow(const Region2& room, const FillOptions& options) const {
    if (options.pattern != toolpath::FillPattern::None) {
      return room;
    }
    const double outer = std::max(0.0, 0.5 * options.width - options.firstCentreLine());
    const double reach = outer + options.firstCentreLine() +
                         (options.walls - 1) * options.spacing() + 0.5 * options.width;
    return geometry::subtract(
        room, geometry::offsetRegion(
                  room, -reach, {geometry::CornerJoin::Miter, 2.0, input_.sampling.chordError}));
  }

  /// Where the outermost bead reaches over the section's border, as stock, its room does too.
  [[nodiscard]] Region2 grownByReference(Region2 region, const FillOptions& options) const {
    const double grown = 0.5 * options.width - options.firstCentreLine();
    return grown > 0.0
               ? geometry::offsetRegion(
                     region, grown, {geometry::CornerJoin::Miter, 2.0, input_.sampling.chordError})
               : region;
  }

  /// Beads grow by the distance of the planes, or from the substrate where it is nearer.
  void setHeights(Contour& contour, const SlicedLayer& layer, double whole) const {
    const double steep = layer.up.dot(input_.substrate->up());
    // A plane that stands upright on the substrate has no height above it.
    constexpr double kUpright = 1e-3;
    for (toolpath::ContourPoint& point : contour.points) {
      const double above =
          steep > kUpright ? input_.substrate->heightAbove(point.p) / steep : whole;
      point.height = above > 0.0 ? std::min(whole, above) : whole;
    }
  }

  const plugin::SliceInput& input_;
  const Params& params_;
  const toolpath::PlaneStack& stack_;
  FillOptions options_;
};

/// Planes halfway through the layers, for their volume.
toolpath::PlaneStack middlesOf(const toolpath::PlaneStack& stack) {
  toolpath::PlaneStack middles = stack;
  double below = 0.0;
  for (std::size_t l = 0; l < stack.levels.size(); ++l) {
    const double value = stack.levels[l].value;
    middles.levels[l].value = value > below ? 0.5 * (below + value) : value;
    below = value;
  }
  return middles;
}

/// The planes' sections, not cut by a plate: closed contours stay closed and are cut as areas.
SlicedLayers sections(const plugin::SliceInput& input,
                      const toolpath::PlaneStack& stack,
                      const JobContext& context) {
  if (!input.substrate->isPlate()) {
    return toolpath::sliceByField(input.parts, toolpath::PlaneField(stack), stack.levels,
                                  *input.substrate, input.sampling, context);
  }
  double depth = 0.0;
  for (const auto& part : input.parts) {
    for (const Vec3& p : part->mesh.vertices) {
      depth = std::max(depth, -input.substrate->heightAbove(p));
    }
  }
  geometry::Pose below = input.substrate->pose();
  below.translation() -= 2.0 * depth * input.substrate->up();
  return toolpath::sliceByField(input.parts, toolpath::PlaneField(stack), stack.levels,
                                toolpath::Substrate(below, input.substrate->size()), input.sampling,
                                context);
}

void reportOpenSurfaces(const plugin::SliceInput& input, const JobContext& context) {
  for (std::size_t k = 0; k < input.parts.size(); ++k) {
    const std::size_t borders = input.parts[k]->halfEdges.borderEdgeCount();
    if (borders > 0) {
      context.add({Severity::Information,
                   "slicing.open_surface",
                   text("the surface of part %1 is not closed; its closed sections are filled as "
                        "those of a solid",
                        {std::to_string(k + 1)}),
                   "repair the part if it should be a solid; take a wall strategy if it is a shell",
                   {},
                   {{"border_edges", static_cast<double>(borders)}}});
    }
  }
}

void refuseOpenSection(const SlicedLayer& layer, std::size_t index) {
  for (const Contour& contour : layer.contours) {
    if (!contour.closed) {
      const Vec3& p = contour.points.front().p;
      throw Error(
          ErrorCode::JobFailed,
          text("the section is not closed, so it has no inside to fill: it ends at (%1, %2, %3)",
               {formatFixed(p.x(), 3), formatFixed(p.y(), 3), formatFixed(p.z(), 3)}),
          text("bulk slicing, layer %1", {std::to_string(index + 1)}),
          "repair the part's surface, take a wall strategy, or set open_sections=bead to "
          "lay the section itself as a bead");
    }
  }
}

class BulkSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] SlicedLayers slice(const plugin::SliceInput& input,
                                   const Value& values,
                                   const JobContext& context) const override {
    const Params params = Params::schema().read(values, "bulk slicing");
    const toolpath::PlaneStack stack =
        toolpath::planeStack(input.parts, *input.substrate, params.planes(input.bead));
    toolpath::reportSteps(stack.ends, stack.levels, params.planes(input.bead).layers, stack.step,
                          stack.tolerance, context);
    const LayerFiller filler(input, params, stack);
    SlicedLayers sliced = sections(input, stack, context.portion(0.0, 0.15, "sections"));
    const toolpath::PlaneStack halfway = middlesOf(stack);
    const SlicedLayers middles =
        sections(input, halfway, context.portion(0.15, 0.3, "sections").withOwnDiagnostics());
    if (params.openSections == OpenSections::Refuse) {
      for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
        refuseOpenSection(sliced.layers[l], l);
      }
    }
    reportOpenSurfaces(input, context);
    const std::vector<Slab> slabs = slabsOf(sliced, middles, stack, halfway);
    const JobContext filling = context.portion(0.3, 1.0, "filling");
    std::vector<FilledLayer> filled(sliced.layers.size());
    parallelFor(
        filled.size(), 1,
        [&](std::size_t l) { filled[l] = filler.fill(sliced.layers[l], slabs[l], l); }, filling);
    return assemble(std::move(sliced), std::move(filled), context);
  }

private:
  static SlicedLayers assemble(SlicedLayers sliced,
                               std::vector<FilledLayer> filled,
                               const JobContext& context) {
    SlicedLayers result;
    std::size_t open = 0;
    for (std::size_t l = 0; l < filled.size(); ++l) {
      const int index = static_cast<int>(result.layers.size());
      if (filled[l].contours.empty()) {
        context.diagnostics().append(filled[l].findings);
        context.add({Severity::Warning,
                     "slicing.empty_layer",
                     text("no bead fits into the section at %1 mm",
                          {formatFixed(sliced.layers[l].level, 3)}),
                     "allow narrower or shorter beads (min_width, min_length)",
                     {},
                     {{"level", sliced.layers[l].level}}});
        continue;
      }
      for (Diagnostic& finding : filled[l].findings) {
        finding.place.layer = index;
        context.add(std::move(finding));
      }
      open += filled[l].openContours;
      sliced.layers[l].contours = std::move(filled[l].contours);
      result.layers.push_back(std::move(sliced.layers[l]));
    }
    if (result.layers.empty()) {
      throw Error(
          ErrorCode::JobFailed, "no bead fits into any section", "bulk slicing",
          "use a narrower bead, or allow narrower or shorter beads (min_width, min_length)");
    }
    if (open > 0) {
      context.add({Severity::Warning,
                   "slicing.open_section",
                   text("%1 contours are not closed and are laid as single beads along the section",
                        {std::to_string(open)}),
                   "repair the part's surface if it should be a solid",
                   {},
                   {{"contours", static_cast<double>(open)}}});
    }
    context.report(1.0);
    return result;
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.bulk",
       .name = "Filled planar layers",
       .summary = "Planar layers of a solid, filled with walls and a pattern at the bead overlap.",
       .version = 3,
       .params = Params::schema().params()},
      [] { return std::make_unique<BulkSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
