// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"

#include <algorithm>

namespace wcam::toolpath {

namespace {

void addSampling(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::chordError,
           {.key = "chord_error",
            .label = "Chord error",
            .help = "Maximum distance between the path and the curve it follows. 0 follows from "
                    "part and bead: 0.01 mm on CAD surfaces; on a mesh as much as the mesh itself "
                    "deviates from its shape, but no more than 2 % of the bead's width.",
            .group = "Sampling",
            .min = 0.0,
            .max = 10.0})
      .add(&PathParams::maxSpacing,
           {.key = "max_spacing",
            .label = "Greatest point spacing",
            .help = "Robots leave the line between far points; 4.9 mm keeps them on it. 0 takes "
                    "these 4.9 mm, or the bead's width if it is narrower.",
            .group = "Sampling",
            .min = 0.0,
            .max = 1000.0});
}

void addSeam(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::seam, {.key = "seam",
                               .label = "Seam",
                               .help = "Where each closed bead starts and ends.",
                               .group = "Seam",
                               .choices = {{"nearest", "Nearest to the end of the bead before"},
                                           {"aligned", "Aligned in one direction"},
                                           {"shifted", "Shifted by a length from layer to layer"},
                                           {"golden", "Golden ratio from layer to layer"},
                                           {"random", "Random, from a seed"},
                                           {"keep_away", "Away from the starts of the last layers"},
                                           {"corner", "In a corner, best a concave one"}}})
      .add(&PathParams::seamShift,
           {.key = "seam_shift",
            .label = "Seam shift",
            .help = "Length along the bead by which the start moves on in each layer.",
            .group = "Seam",
            .min = 0.0,
            .max = 1e4,
            .enabledIf = "seam=shifted"})
      .add(&PathParams::seamDirection,
           {.key = "seam_direction",
            .label = "Seam direction",
            .help = "Direction from the layer's centre, about the build direction, from x.",
            .group = "Seam",
            .level = ParamLevel::Advanced,
            .min = -360.0,
            .max = 360.0})
      .add(&PathParams::seed, {.key = "seam_seed",
                               .label = "Random seed",
                               .help = "The same seed gives the same seams.",
                               .group = "Seam",
                               .level = ParamLevel::Advanced,
                               .min = 0,
                               .max = 2147483647,
                               .enabledIf = "seam=random"})
      .add(&PathParams::seamKeepAway,
           {.key = "seam_keep_away",
            .label = "Distance of seams",
            .help = "Least distance of a start from the starts of the last layers.",
            .group = "Seam",
            .min = 0.0,
            .max = 1e4,
            .enabledIf = "seam=keep_away"})
      .add(&PathParams::seamMemory, {.key = "seam_memory",
                                     .label = "Layers to keep away from",
                                     .help = "Number of layers below whose starts count.",
                                     .group = "Seam",
                                     .level = ParamLevel::Advanced,
                                     .min = 1,
                                     .max = 1000,
                                     .enabledIf = "seam=keep_away"})
      .add(&PathParams::seamExact,
           {.key = "seam_exact",
            .label = "Exact starts",
            .help = "Starts lie exactly where the seam asks for, between the points of the "
                    "contour: a point is put there. Without it the nearest point of the contour "
                    "is taken and no point is added.",
            .group = "Seam",
            .level = ParamLevel::Advanced});
}

void addOrder(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::order,
           {.key = "order",
            .label = "Order of islands",
            .help = "Which bead of a layer comes next.",
            .group = "Order",
            .choices = {{"nearest", "Nearest to the end of the bead before"},
                        {"given", "As the strategy lists them"},
                        {"least_recent", "Where the layer below has cooled longest"},
                        {"thermal", "Farthest from the heat of the beads before"}}})
      .add(&PathParams::heatReach,
           {.key = "heat_reach",
            .label = "Reach of heat",
            .help = "Distance from a bead at which its heat has fallen to 37 %.",
            .group = "Order",
            .level = ParamLevel::Advanced,
            .min = 0.1,
            .max = 1e4,
            .enabledIf = "order=thermal"})
      .add(&PathParams::coolLength,
           {.key = "cool_length",
            .label = "Cooling length",
            .help = "Length of bead that is deposited until the heat of a bead has fallen to "
                    "37 %: travel speed times cooling time.",
            .group = "Order",
            .level = ParamLevel::Advanced,
            .min = 1.0,
            .max = 1e7,
            .enabledIf = "order=thermal"})
      .add(&PathParams::reverseOpen,
           {.key = "reverse_open",
            .label = "Open beads either way",
            .help = "Open beads start at the end that is nearer to the bead before.",
            .group = "Order"})
      .add(&PathParams::alternate, {.key = "alternate",
                                    .label = "Alternate direction",
                                    .help = "Every other layer runs the other way.",
                                    .group = "Order"})
      .add(&PathParams::alternateBy, {.key = "alternate_by",
                                      .label = "Alternate by",
                                      .help = "What changes the direction.",
                                      .group = "Order",
                                      .level = ParamLevel::Advanced,
                                      .enabledIf = "alternate=true",
                                      .choices = {{"layer", "Layer"}, {"bead", "Bead"}}});
}

void addBeads(Schema<PathParams>& schema) {
  schema.add(
      &PathParams::beadReference,
      {.key = "bead_reference",
       .label = "Contour is the bead's",
       .help = "Which side of the bead the part's surface is. The bead is moved by half its "
               "width inside the layer.",
       .group = "Bead",
       .choices = {{"centre", "Middle"}, {"inside", "Inner side"}, {"outside", "Outer side"}}});
}

void addLeads(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::leadIn, {.key = "lead_in",
                                 .label = "Lead-in",
                                 .help = "Straight run onto the start, along the bead's tangent.",
                                 .group = "Start and end",
                                 .min = 0.0,
                                 .max = 1000.0})
      .add(&PathParams::leadOut, {.key = "lead_out",
                                  .label = "Lead-out",
                                  .help = "Straight run on from the end.",
                                  .group = "Start and end",
                                  .min = 0.0,
                                  .max = 1000.0})
      .add(&PathParams::leadArc, {.key = "lead_arc",
                                  .label = "Arc on in lead-in and lead-out",
                                  .help = "Off: the arc is lit where the bead starts.",
                                  .group = "Start and end",
                                  .level = ParamLevel::Advanced})
      .add(&PathParams::overlap,
           {.key = "overlap",
            .label = "Overlap of closed beads",
            .help = "Length for which a closed bead runs on over its own start.",
            .group = "Start and end",
            .min = 0.0,
            .max = 1000.0})
      .add(&PathParams::wipe, {.key = "wipe",
                               .label = "Wipe",
                               .help = "Way back over the bead with the arc off.",
                               .group = "Start and end",
                               .min = 0.0,
                               .max = 1000.0})
      .add(&PathParams::wipeLift, {.key = "wipe_lift",
                                   .label = "Lift of the wipe",
                                   .help = "Height gained on the way back.",
                                   .group = "Start and end",
                                   .level = ParamLevel::Advanced,
                                   .min = 0.0,
                                   .max = 100.0});
}

/// One end's ramp: its length and the two factors.
void addRamp(Schema<PathParams>& schema,
             const std::string& key,
             bool start,
             Length PathParams::*length,
             double PathParams::*speed,
             double PathParams::*wire) {
  const auto factor = [&](const std::string& what) {
    return ParamInfo{
        .key = key + "_" + what,
        .label = what == "wire" ? (start ? "Wire feed at the start" : "Wire feed at the end")
                                : (start ? "Travel speed at the start" : "Travel speed at the end"),
        .help = start ? "Factor at the start; linear to 1 over the ramp."
                      : "Factor at the end; linear to 1 over the ramp.",
        .group = "Start and end",
        .level = ParamLevel::Advanced,
        .min = 0.1,
        .max = 10.0};
  };
  schema
      .add(length, {.key = key,
                    .label = start ? "Ramp at the start" : "Ramp at the end",
                    .help = "Length over which travel speed and wire feed change. The heat is "
                            "least at the start and greatest at the end of a bead.",
                    .group = "Start and end",
                    .min = 0.0,
                    .max = 1000.0})
      .add(speed, factor("speed"), ParamType::Real, QuantityKind::Ratio)
      .add(wire, factor("wire"), ParamType::Real, QuantityKind::Ratio);
}

void addToolAxis(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::axis,
           {.key = "axis",
            .label = "Tool axis",
            .help = "Build direction that the torch follows and the positioner turns upright.",
            .group = "Tool axis",
            .choices = {{"local", "Local: tangent to the wall at every point"},
                        {"layer", "Layer: one direction for each layer"},
                        {"global", "Global: the substrate's build direction"},
                        {"auto", "Automatic: local for curved layers, else layer"},
                        {"mean", "Mean: the mean of the local directions of a layer"}}})
      .add(&PathParams::axisProject,
           {.key = "axis_project",
            .label = "Project axes on a plane",
            .help = "Keeps the torch from leaning across a plane, for instance towards the "
                    "substrate.",
            .group = "Tool axis",
            .level = ParamLevel::Advanced})
      .add(&PathParams::axisPlaneNormal, {.key = "axis_plane_normal",
                                          .label = "Normal of the plane",
                                          .help = "In the substrate's frame; any length.",
                                          .group = "Tool axis",
                                          .level = ParamLevel::Advanced,
                                          .enabledIf = "axis_project=true"})
      .add(&PathParams::axisLimit,
           {.key = "axis_limit",
            .label = "Greatest inclination",
            .help = "Axes that lean further from the substrate's build direction are turned back "
                    "to this angle, before lead and lateral tilt.",
            .group = "Tool axis",
            .min = 0.0,
            .max = 180.0})
      .add(&PathParams::axisRate,
           {.key = "axis_rate",
            .label = "Greatest turn of the axis",
            .help = "In degrees per mm of path; axes are smoothed until they hold it. 0: no bound.",
            .group = "Tool axis",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 360.0})
      .add(&PathParams::axisDeviation,
           {.key = "axis_deviation",
            .label = "Reported deviation",
            .help = "A finding is given where smoothing turns an axis by more.",
            .group = "Tool axis",
            .level = ParamLevel::Expert,
            .min = 0.0,
            .max = 180.0})
      .add(&PathParams::lead,
           {.key = "lead",
            .label = "Lead angle",
            .help = "Lean of the torch in the travel plane; positive leans forward.",
            .group = "Tool axis",
            .min = -80.0,
            .max = 80.0})
      .add(&PathParams::lateralTilt,
           {.key = "lateral_tilt",
            .label = "Lateral tilt",
            .help = "Lean of the torch across the travel; positive leans outwards.",
            .group = "Tool axis",
            .min = -80.0,
            .max = 80.0});
}

Schema<PathParams> makeSchema() {
  Schema<PathParams> schema;
  addSampling(schema);
  addSeam(schema);
  addOrder(schema);
  addBeads(schema);
  addLeads(schema);
  addRamp(schema, "ramp_in", true, &PathParams::rampIn, &PathParams::rampInSpeed,
          &PathParams::rampInWire);
  addRamp(schema, "ramp_out", false, &PathParams::rampOut, &PathParams::rampOutSpeed,
          &PathParams::rampOutWire);
  addToolAxis(schema);
  return schema;
}

}  // namespace

const Schema<PathParams>& PathParams::schema() {
  static const Schema<PathParams> schema = makeSchema();
  return schema;
}

ZoneParams PathParams::zones() const {
  ZoneParams zones;
  zones.leadIn = leadIn.value();
  zones.leadOut = leadOut.value();
  zones.leadArc = leadArc;
  zones.rampIn = rampIn.value();
  zones.rampOut = rampOut.value();
  zones.rampInSpeed = rampInSpeed;
  zones.rampInWire = rampInWire;
  zones.rampOutSpeed = rampOutSpeed;
  zones.rampOutWire = rampOutWire;
  zones.overlap = overlap.value();
  zones.wipe = wipe.value();
  zones.wipeLift = wipeLift.value();
  return zones;
}

Sampling PathParams::sampling(double width, double meshDeviation) const {
  constexpr double kExactChord = 0.01;     // mm, an accuracy that no robot passes (Chalvin A3)
  constexpr double kShownShare = 0.02;     // of the bead's width: less is lost in its ripple
  constexpr double kMostSpacing = 4.9;     // mm (Chalvin A26)
  constexpr double kFinestChord = 1e-5;    // mm
  constexpr double kFinestSpacing = 0.01;  // mm
  const double chord = chordError.value() > 0.0
                           ? chordError.value()
                           : std::max(kExactChord, std::min(meshDeviation, kShownShare * width));
  const double spacing =
      maxSpacing.value() > 0.0 ? maxSpacing.value() : std::min(kMostSpacing, width);
  return {std::max(chord, kFinestChord), std::max(spacing, kFinestSpacing)};
}

}  // namespace wcam::toolpath
