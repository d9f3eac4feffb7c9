// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/spiral.hpp"

#include "wcam/base/remedy.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/wall.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace {

using namespace wcam;
using geometry::Vec3;
using toolpath::Decomposition;
using toolpath::SpiralEnd;
using toolpath::SpiralStart;

enum class Infeasible { Refuse, Report };

enum class Form { Generatrices, Field };

enum class BorderEnd { Mirrored, Literal };

struct Params {
  Form form = Form::Generatrices;
  Length step = 2.0_mm;
  Length heightMin = 0.0_mm;
  Length heightMax = 0.0_mm;
  Decomposition decomposition = Decomposition::IsoValues;
  SpiralStart start = SpiralStart::Exact;
  BorderEnd end = BorderEnd::Mirrored;
  bool centred = true;
  Infeasible infeasible = Infeasible::Refuse;
  Length secondStep = 0.0_mm;
  Length secondFrom = 0.0_mm;
  int transition = 1;
  Length endReserve = 0.0_mm;
  int generatrices = 0;
  Length coverage = 0.0_mm;
  Length edge = 0.0_mm;

  static const Schema<Params>& schema();
};

void addDeposit(Schema<Params>& schema) {
  schema
      .add(&Params::step, {.key = "step",
                           .label = "Mean deposit",
                           .help = "Mean height that a revolution adds.",
                           .group = "Deposit",
                           .min = 0.01,
                           .max = 1000.0})
      .add(&Params::heightMin,
           {.key = "height_min",
            .label = "Least deposit",
            .help = "Lower end of the modulation range; 0 takes 90 % of the mean deposit.",
            .group = "Deposit",
            .min = 0.0,
            .max = 1000.0})
      .add(&Params::heightMax,
           {.key = "height_max",
            .label = "Greatest deposit",
            .help = "Upper end of the modulation range; 0 takes 110 % of the mean deposit.",
            .group = "Deposit",
            .min = 0.0,
            .max = 1000.0})
      .add(&Params::centred,
           {.key = "centred",
            .label = "Centre the mean",
            .help = "Chooses the number of revolutions that brings the mean to the wanted deposit; "
                    "otherwise as many revolutions as the range allows (Diourté 3.14).",
            .group = "Deposit",
            .level = ParamLevel::Advanced})
      .add(&Params::infeasible,
           {.key = "infeasible",
            .label = "When the range cannot be kept",
            .help = "A part whose generatrices differ too much needs a wider range.",
            .group = "Deposit",
            .level = ParamLevel::Advanced,
            .choices = {{"refuse", "Refuse, with the range that would do"},
                        {"report", "Slice all the same and warn"}}});
}

void addChange(Schema<Params>& schema) {
  schema
      .add(&Params::secondStep,
           {.key = "second_step",
            .label = "Second mean deposit",
            .help = "Deposit from a height on, reached without a step in the path (smaller, for a "
                    "cooler end); 0 keeps one deposit.",
            .group = "Change of deposit",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1000.0})
      .add(&Params::secondFrom, {.key = "second_from",
                                 .label = "Changes at",
                                 .help = "Length along the mean generatrix.",
                                 .group = "Change of deposit",
                                 .level = ParamLevel::Advanced,
                                 .min = 0.0,
                                 .max = 1e6})
      .add(&Params::transition, {.key = "transition",
                                 .label = "Revolutions of the change",
                                 .help = "Over how many revolutions the deposit changes.",
                                 .group = "Change of deposit",
                                 .level = ParamLevel::Advanced,
                                 .min = 1,
                                 .max = 100});
}

void addEnds(Schema<Params>& schema) {
  schema
      .add(&Params::start,
           {.key = "start",
            .label = "Start",
            .help = "How the spiral leaves the border.",
            .group = "Start and end",
            .choices = {{"exact", "Ramps inside the range, then no seam step at all"},
                        {"thesis", "Ramps as the thesis plots them"},
                        {"ramp", "One revolution that climbs from zero"},
                        {"none", "No ramp: a step of one layer at every seam"}}})
      .add(&Params::end,
           {.key = "end",
            .label = "End",
            .help = "How the spiral meets the upper border.",
            .group = "Start and end",
            .choices = {{"mirrored", "Ramps as at the start"},
                        {"literal", "Equal steps on every generatrix; the seam drifts"}}})
      .add(&Params::endReserve,
           {.key = "end_reserve",
            .label = "Free length before the closure",
            .help = "Parts that close in a point: where the bead ends; 0 takes half the deposit.",
            .group = "Start and end",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1e4});
}

void addDecomposition(Schema<Params>& schema) {
  schema
      .add(
          &Params::form,
          {.key = "form",
           .label = "Form",
           .help = "Generatrices modulate the height along curves from border to border (Diourté); "
                   "the level set follows one field and needs no points per revolution.",
           .group = "Decomposition",
           .choices = {{"generatrices", "Points on generatrices"},
                       {"field", "Level set of a field"}}})
      .add(&Params::decomposition,
           {.key = "decomposition",
            .label = "Decomposition",
            .help = "How the curves from border to border are found.",
            .group = "Decomposition",
            .choices = {{"isovalues", "Iso-values of a field: any single-branch part"},
                        {"geodesic", "Shortest paths: least spread of lengths"},
                        {"envelope", "Projected cylinder: no overhangs"}}})
      .add(&Params::generatrices, {.key = "generatrices",
                                   .label = "Points per revolution",
                                   .help = "0 follows from chord error and spacing.",
                                   .group = "Decomposition",
                                   .level = ParamLevel::Expert,
                                   .min = 0,
                                   .max = 100000})
      .add(&Params::coverage,
           {.key = "coverage",
            .label = "Coverage",
            .help =
                "Greatest gap between neighbouring shortest paths before a curve is added; 0 takes "
                "three times their mean distance.",
            .group = "Decomposition",
            .level = ParamLevel::Expert,
            .min = 0.0,
            .max = 1e4,
            .enabledIf = "decomposition=geodesic"})
      .add(&Params::edge,
           {.key = "edge_length",
            .label = "Mesh edge length",
            .help = "Fineness of the mesh that carries the field; 0 follows from the deposit.",
            .group = "Decomposition",
            .level = ParamLevel::Expert,
            .min = 0.0,
            .max = 1e4});
}

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema = [] {
    Schema<Params> made;
    addDeposit(made);
    addEnds(made);
    addChange(made);
    addDecomposition(made);
    return made;
  }();
  return schema;
}

[[noreturn]] void refuse(const Text& message, const Text& hint) {
  throw Error(ErrorCode::JobFailed, message, "continuous spiral", hint);
}

toolpath::SpiralWish wishOf(const Params& params, const toolpath::WallLimits& limits) {
  // The range that the process of the thesis guarantees (Diourté 3.2).
  constexpr double kGuaranteed = 0.1;
  toolpath::SpiralWish wish;
  wish.height = params.step.value();
  wish.heightMin =
      params.heightMin.value() > 0.0 ? params.heightMin.value() : (1.0 - kGuaranteed) * wish.height;
  wish.heightMax =
      params.heightMax.value() > 0.0 ? params.heightMax.value() : (1.0 + kGuaranteed) * wish.height;
  wish.start = params.start;
  wish.end = limits.upper.empty()                ? SpiralEnd::Point
             : params.end == BorderEnd::Mirrored ? SpiralEnd::Mirrored
                                                 : SpiralEnd::Literal;
  wish.centred = params.centred;
  wish.endReserve = params.endReserve.value() > 0.0 ? params.endReserve.value() : 0.5 * wish.height;
  wish.secondHeight = params.secondStep.value();
  wish.secondFrom = params.secondFrom.value();
  wish.transition = params.transition;
  return wish;
}

/// A spiral with a range, and what was found on the way.
struct Attempt {
  toolpath::SlicedLayers sliced;
  std::vector<Diagnostic> findings;
};

using Make = std::function<Attempt(const toolpath::SpiralWish&, const JobContext&)>;

bool isAboutRange(const Diagnostic& finding) {
  return finding.code == "slicing.spiral_height" || finding.code == "slicing.spiral_infeasible";
}

double numberOf(const Diagnostic& finding, const std::string& key, double otherwise) {
  for (const auto& [name, number] : finding.data) {
    if (name == key) {
      return number;
    }
  }
  return otherwise;
}

/// A range that also holds what was found outside of it, and some more.
toolpath::SpiralRange widened(const toolpath::SpiralRange& range,
                              const Diagnostic& found,
                              const toolpath::SpiralWish& wish) {
  constexpr double kMore = 0.01;  // of the mean deposit
  const double deposit = numberOf(found, "deposit_mm", wish.height);
  const double low = std::min(deposit, numberOf(found, "height_min_mm", wish.height));
  const double high = std::max(deposit, numberOf(found, "height_max_mm", wish.height));
  return toolpath::roundedOutwards(low < range.low ? low - kMore * wish.height : range.low,
                                   high > range.high ? high + kMore * wish.height : range.high);
}

/// Points whose height the process cannot deposit.
std::size_t outsideProcess(const toolpath::SlicedLayers& sliced, const toolpath::BeadRange& bead) {
  std::size_t count = 0;
  for (const toolpath::SlicedLayer& layer : sliced.layers) {
    for (const toolpath::Contour& contour : layer.contours) {
      for (const toolpath::ContourPoint& point : contour.points) {
        count +=
            point.height > 0.0 && (point.height < bead.heightMin || point.height > bead.heightMax)
                ? 1U
                : 0U;
      }
    }
  }
  return count;
}

/// A range with which nothing is found outside, and the points that the process cannot deposit
/// then.
struct Proven {
  toolpath::SpiralRange range;
  std::size_t outside = 0;
};

/// The range from a first one on with which the whole spiral is made and nothing is found outside.
/// Heights are measured across the layers, where they are less than along the generatrices, and
/// another range gives other ramps: so each is tried.
std::optional<Proven> provenRange(toolpath::SpiralRange range,
                                  const toolpath::SpiralWish& wish,
                                  const toolpath::BeadRange& bead,
                                  const Make& make,
                                  const JobContext& context) {
  constexpr int kMostTries = 4;
  for (int tries = 0; tries < kMostTries && range.low > 0.0; ++tries) {
    toolpath::SpiralWish wider = wish;
    wider.heightMin = range.low;
    wider.heightMax = range.high;
    try {
      const Attempt attempt = make(wider, context);
      const auto found =
          std::find_if(attempt.findings.begin(), attempt.findings.end(), isAboutRange);
      if (found == attempt.findings.end()) {
        return Proven{range, outsideProcess(attempt.sliced, bead)};
      }
      range = widened(range, *found, wish);
    } catch (const CancelledError&) {
      throw;
    } catch (const Error&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::vector<ParamSetting> settingsOf(const toolpath::SpiralRange& range) {
  return {{"params", "height_min", range.low}, {"params", "height_max", range.high}};
}

/// @param outside points that the process cannot deposit as it is
Text remedyOf(const std::optional<Proven>& proven, std::size_t outside) {
  if (!proven) {
    return "no range about this deposit does on this part: another decomposition or another mean "
           "deposit may help";
  }
  return proven->outside <= outside
             ? text("set the modulation range to %1; this was tried",
                    {toolpath::rangeText(proven->range)})
             : text(
                   "only a modulation range of %1 holds these heights, but %2 points instead of "
                   "%3 would then leave the layer heights of the process: another decomposition "
                   "or planar layers may suit this end better",
                   {toolpath::rangeText(proven->range), std::to_string(proven->outside),
                    std::to_string(outside)});
}

/// The generatrix that breaks the range most.
Diagnostic excessOf(const std::vector<toolpath::Generatrix>& curves,
                    const toolpath::SpiralPlan& plan,
                    const toolpath::SpiralWish& wish) {
  const toolpath::Generatrix& curve = curves[plan.excess->generatrix];
  const Vec3& foot = curve.points().front();
  const double excess =
      std::max(wish.heightMin - plan.excess->height, plan.excess->height - wish.heightMax);
  return {Severity::Warning,
          "slicing.spiral_infeasible",
          text("the generatrix from (%1, %2, %3), %4 mm long, needs a deposit of %5 mm, %6 mm "
               "outside of %7 to %8 mm",
               {formatFixed(foot.x(), 1), formatFixed(foot.y(), 1), formatFixed(foot.z(), 1),
                formatFixed(curve.length(), 2), formatFixed(plan.excess->height, 3),
                formatFixed(excess, 3), formatFixed(wish.heightMin, 3),
                formatFixed(wish.heightMax, 3)}),
          {},
          {{}, 0, 0, -1},
          {{"generatrix", static_cast<double>(plan.excess->generatrix)},
           {"deposit_mm", plan.excess->height},
           {"excess_mm", excess}}};
}

/// Gives the findings about the range their remedy, and refuses where that is wanted.
void tellRange(Attempt& attempt,
               const std::optional<Proven>& proven,
               const toolpath::BeadRange& bead,
               const Params& params) {
  const std::size_t outside = outsideProcess(attempt.sliced, bead);
  // What makes other figures worse is told, not offered.
  const bool offered = proven && proven->outside <= outside;
  for (Diagnostic& finding : attempt.findings) {
    if (!isAboutRange(finding)) {
      continue;
    }
    finding.remedy = remedyOf(proven, outside);
    auto settings = offered ? settingsOf(proven->range) : std::vector<ParamSetting>();
    if (finding.code == "slicing.spiral_infeasible" && params.infeasible == Infeasible::Refuse) {
      // Without it there is no path at all; what it costs is a finding of that path.
      if (proven) {
        finding.remedy = remedyOf(proven, proven->outside);
        settings = settingsOf(proven->range);
      }
      throw RemediedError(
          Error(ErrorCode::JobFailed, finding.message, "continuous spiral", finding.remedy),
          settings);
    }
    for (const ParamSetting& setting : settings) {
      finding.data.push_back(figureOf(setting));
    }
  }
}

/// The spiral of the wish, with findings whose remedies were tried.
/// @param first a range to begin with where the wish does not do
toolpath::SlicedLayers made(const toolpath::SpiralWish& wish,
                            const Params& params,
                            const toolpath::BeadRange& bead,
                            const std::function<toolpath::SpiralRange()>& first,
                            const Make& make,
                            const JobContext& context) {
  Attempt attempt = make(wish, context);
  const auto found = std::find_if(attempt.findings.begin(), attempt.findings.end(), isAboutRange);
  if (found != attempt.findings.end()) {
    // Without progress: nobody knows how many tries it takes.
    const JobContext quiet = context.portion(1.0, 1.0);
    tellRange(attempt, provenRange(widened(first(), *found, wish), wish, bead, make, quiet), bead,
              params);
  }
  for (Diagnostic& finding : attempt.findings) {
    context.add(std::move(finding));
  }
  return std::move(attempt.sliced);
}

class SpiralSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "continuous spiral");
    if (input.parts.size() != 1) {
      refuse(text("a spiral is one bead on one part, and the operation names %1",
                  {std::to_string(input.parts.size())}),
             "make one operation per part");
    }
    const geometry::PartSurface& part = *input.parts.front();
    // The field that orders the generatrices is smooth over many layers, and their points go to the
    // exact surface: the mesh resolves the shape, not the layers.
    constexpr double kLayersPerEdge = 4.0;
    const double edge = params.edge.value() > 0.0
                            ? params.edge.value()
                            : geometry::fieldEdgeLength(part, kLayersPerEdge * params.step.value());
    const toolpath::WallPart wall =
        toolpath::prepareWall(part, *input.substrate, edge, context.portion(0.0, 0.3, "wall"));
    const geometry::PartSurface& fine = wall.surface;
    const toolpath::WallLimits& limits = wall.limits;
    const toolpath::SpiralWish wish = wishOf(params, limits);
    if (params.form == Form::Field) {
      const Make make = [&](const toolpath::SpiralWish& with, const JobContext& own) {
        const JobContext found = own.withOwnDiagnostics();
        toolpath::SlicedLayers sliced =
            toolpath::spiralOnField(fine, part, limits, with, input.sampling, found);
        return Attempt{std::move(sliced), found.diagnostics().items()};
      };
      const auto first = [&] { return toolpath::roundedOutwards(wish.heightMin, wish.heightMax); };
      return made(wish, params, input.bead, first, make, context.portion(0.3, 1.0, "spiral"));
    }
    toolpath::GeneratrixOptions options;
    options.method = params.decomposition;
    options.up = input.substrate->up();
    options.step = wish.height;
    options.sampling = input.sampling;
    options.count = static_cast<std::size_t>(params.generatrices);
    options.coverage = params.coverage.value();
    const toolpath::Generatrices generatrices =
        toolpath::decomposeWall(fine, limits, options, context.portion(0.3, 0.8, "generatrices"));
    std::vector<double> lengths;
    for (const toolpath::Generatrix& curve : generatrices.curves) {
      lengths.push_back(curve.length());
    }
    // The facets of a mesh ask for many generatrices, but few points lie at its edges. Points that
    // were asked for by number stay.
    const std::optional<toolpath::Sampling> thinning =
        params.generatrices > 0 || part.exact() ? std::nullopt : std::optional(input.sampling);
    const Make make = [&](const toolpath::SpiralWish& with, const JobContext& own) {
      const JobContext found = own.withOwnDiagnostics();
      const toolpath::SpiralPlan plan = toolpath::planSpiral(lengths, with);
      Attempt attempt;
      if (plan.excess) {
        found.add(excessOf(generatrices.curves, plan, with));
      }
      if (!plan.excess || params.infeasible == Infeasible::Report) {
        attempt.sliced = toolpath::spiralAlong(part, generatrices, plan, with, found, thinning);
      }
      attempt.findings = found.diagnostics().items();
      return attempt;
    };
    const auto first = [&] {
      return toolpath::rangeThatWouldDo(lengths, wish)
          .value_or(toolpath::roundedOutwards(wish.heightMin, wish.heightMax));
    };
    return made(wish, params, input.bead, first, make, context.portion(0.8, 1.0, "spiral"));
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.spiral",
       .name = "Continuous spiral",
       .summary =
           "One bead without interruption around a thin wall, its height modulated so that it "
           "meets both borders.",
       .version = 3,
       .params = Params::schema().params()},
      [] { return std::make_unique<SpiralSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
