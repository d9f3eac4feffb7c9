// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"

namespace wcam::toolpath {

namespace {

void addSampling(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::chordError,
           {.key = "chord_error",
            .label = "Chord error",
            .help = "Greatest distance between the path and the curve it follows.",
            .group = "Sampling",
            .min = 1e-5,
            .max = 10.0})
      .add(&PathParams::maxSpacing,
           {.key = "max_spacing",
            .label = "Greatest point spacing",
            .help = "Robots leave the line between far points; 4.9 mm keeps them on it.",
            .group = "Sampling",
            .min = 0.01,
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
                                           {"random", "Random, from a seed"}}})
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
                               .enabledIf = "seam=random"});
}

void addOrder(Schema<PathParams>& schema) {
  schema.add(&PathParams::alternate, {.key = "alternate",
                                      .label = "Alternate direction",
                                      .help = "Every other layer runs the other way.",
                                      .group = "Order"});
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
                        {"auto", "Automatic: local for curved layers, else layer"}}})
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
  addToolAxis(schema);
  return schema;
}

}  // namespace

const Schema<PathParams>& PathParams::schema() {
  static const Schema<PathParams> schema = makeSchema();
  return schema;
}

}  // namespace wcam::toolpath
