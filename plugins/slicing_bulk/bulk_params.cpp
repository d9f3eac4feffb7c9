// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bulk_params.hpp"

#include "wcam/base/text.hpp"

namespace wcam::bulk {

namespace {

void addLayers(Schema<Params>& schema) {
  schema
      .add(&Params::step, {.key = "step",
                           .label = "Layer step",
                           .help = "Distance between neighbouring planes.",
                           .group = "Layers",
                           .min = 0.01,
                           .max = 1000.0})
      .add(&Params::firstLayer,
           {.key = "first_layer",
            .label = "First layer, in steps",
            .help = "Height of the first layer above the base; 0 puts a layer on the base itself.",
            .group = "Layers",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 100.0})
      .add(&Params::endHeight,
           {.key = "end_height",
            .label = "End height",
            .help = "No layer above this height over the base; 0 slices the whole part.",
            .group = "Layers",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1e6});
  toolpath::addLastLayer(schema, &Params::last);
  schema
      .add(&Params::customDirection,
           {.key = "custom_direction",
            .label = "Own build direction",
            .help = "Otherwise layers grow along the substrate's build direction.",
            .group = "Direction"})
      .add(&Params::direction, {.key = "direction",
                                .label = "Build direction",
                                .help = "In the part frame; any length.",
                                .group = "Direction",
                                .enabledIf = "custom_direction=true"});
}

void addPattern(Schema<Params>& schema) {
  schema
      .add(&Params::pattern,
           {.key = "pattern",
            .label = "Pattern",
            .help = "How the inside of a layer is filled.",
            .group = "Fill",
            .choices = {{"none", "Walls only"},
                        {"raster", "Raster: lines in one direction"},
                        {"zigzag", "Zigzag: lines joined along the border"},
                        {"contour", "Contour: concentric until full"},
                        {"spiral", "Spiral: concentric, one bead from outside to inside"},
                        {"hybrid", "Hybrid: contours outside, zigzag inside"},
                        {"continuous", "Continuous: walls and zigzag in as few beads as possible"},
                        {"medial", "Medial axis: contours and beads of local width"}}})
      .add(&Params::walls, {.key = "walls",
                            .label = "Walls",
                            .help = "Contours along the border before the pattern begins.",
                            .group = "Fill",
                            .min = 0,
                            .max = 1000,
                            .enabledIf = "pattern!=contour and pattern!=medial"})
      .add(&Params::insets, {.key = "insets",
                             .label = "Further contours",
                             .help = "Contours of the hybrid pattern between walls and zigzag.",
                             .group = "Fill",
                             .min = 0,
                             .max = 1000,
                             .enabledIf = "pattern=hybrid"})
      .add(&Params::angle, {.key = "angle",
                            .label = "Line angle",
                            .help = "Direction of the lines in the first layer, about the build "
                                    "direction, from the substrate's x axis.",
                            .group = "Fill",
                            .min = -360.0,
                            .max = 360.0})
      .add(&Params::angleStep, {.key = "angle_step",
                                .label = "Angle step",
                                .help = "By how much the lines turn from layer to layer.",
                                .group = "Fill",
                                .min = -360.0,
                                .max = 360.0})
      .add(&Params::order,
           {.key = "order",
            .label = "Order of contours",
            .help = "Automatic: from inside to outside on medial axes, otherwise from outside.",
            .group = "Fill",
            .level = ParamLevel::Advanced,
            .choices = {{"auto", "Automatic"},
                        {"outside_first", "Outside first"},
                        {"inside_first", "Inside first"}}});
}

void addBead(Schema<Params>& schema) {
  schema
      .add(&Params::width, {.key = "bead_width",
                            .label = "Bead width",
                            .help = "Of a single bead; 0 takes the process's.",
                            .group = "Bead",
                            .min = 0.0,
                            .max = 1000.0})
      .add(&Params::overlap,
           {.key = "overlap",
            .label = "Centre distance, in bead widths",
            .help = "0.667 leaves a level surface (Ding 2015); 1 lays beads side by side.",
            .group = "Bead",
            .min = 0.1,
            .max = 1.0})
      .add(&Params::reference,
           {.key = "reference",
            .label = "What lies on the part's surface",
            .help = "The outermost bead's outer side, its centre or its inner side.",
            .group = "Bead",
            .choices = {{"inside", "Outer side: the bead lies inside the part"},
                        {"centre", "Centre"},
                        {"outside", "Inner side: the bead lies outside, as machining stock"}}})
      .add(&Params::minWidth, {.key = "min_width",
                               .label = "Least bead width",
                               .help = "Of beads whose width is chosen; 0: half the bead width.",
                               .group = "Bead",
                               .min = 0.0,
                               .max = 1000.0})
      .add(&Params::maxWidth, {.key = "max_width",
                               .label = "Greatest bead width",
                               .help = "Of beads whose width is chosen; 0: 1.5 bead widths.",
                               .group = "Bead",
                               .min = 0.0,
                               .max = 1000.0})
      .add(&Params::minLength, {.key = "min_length",
                                .label = "Least bead length",
                                .help = "Shorter open beads are left out; 0: one bead width.",
                                .group = "Bead",
                                .level = ParamLevel::Advanced,
                                .min = 0.0,
                                .max = 1e6});
}

void addLimits(Schema<Params>& schema) {
  schema
      .add(&Params::fillNarrow,
           {.key = "fill_narrow",
            .label = "Fill narrow places",
            .help = "A bead on the medial axis where no contour fits, down to the least width.",
            .group = "Limits"})
      .add(&Params::minArea, {.key = "min_area",
                              .label = "Least area",
                              .help = "Sections smaller than this, in mm², are left out.",
                              .group = "Limits",
                              .level = ParamLevel::Advanced,
                              .min = 0.0,
                              .max = 1e12})
      .add(&Params::openSections,
           {.key = "open_sections",
            .label = "Sections that are not closed",
            .help = "They have no inside. As a bead: the section itself is the path.",
            .group = "Limits",
            .choices = {{"refuse", "Refuse"}, {"bead", "Lay them as a single bead"}}})
      .add(&Params::leastCoverage,
           {.key = "least_coverage",
            .label = "Least coverage",
            .help = "Part of each section that beads must cover, else a finding tells the place.",
            .group = "Limits",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1.0})
      .add(&Params::mostFill,
           {.key = "most_fill",
            .label = "Greatest filling",
            .help = "Deposited material in parts of the room, beyond which a finding warns.",
            .group = "Limits",
            .level = ParamLevel::Advanced,
            .min = 1.0,
            .max = 100.0});
}

Schema<Params> makeSchema() {
  Schema<Params> schema;
  addLayers(schema);
  addPattern(schema);
  addBead(schema);
  addLimits(schema);
  return schema;
}

}  // namespace

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema = makeSchema();
  return schema;
}

toolpath::PlaneStackOptions Params::planes(const toolpath::BeadRange& process) const {
  toolpath::PlaneStackOptions options{
      {step.value(), firstLayer, last, process.heightMin, process.heightMax},
      endHeight.value(),
      std::nullopt};
  if (customDirection) {
    options.direction = toolpath::Vec3(direction[0], direction[1], direction[2]);
  }
  return options;
}

toolpath::FillOptions Params::fill(const toolpath::BeadRange& process,
                                   const toolpath::Sampling& sampling) const {
  constexpr double kLeast = 0.5;
  constexpr double kGreatest = 1.5;
  toolpath::FillOptions options;
  options.pattern = pattern;
  options.walls = walls;
  options.insets = insets;
  options.width = width.value() > 0.0 ? width.value() : process.width;
  options.overlap = overlap;
  options.minWidth = minWidth.value() > 0.0 ? minWidth.value() : kLeast * options.width;
  options.maxWidth = maxWidth.value() > 0.0 ? maxWidth.value() : kGreatest * options.width;
  options.minLength = minLength.value() > 0.0 ? minLength.value() : options.width;
  options.fillNarrow = fillNarrow;
  options.reference = reference;
  options.order = order;
  options.tolerance = sampling.chordError;
  if (!(options.minWidth <= options.width && options.width <= options.maxWidth)) {
    throw Error(ErrorCode::InvalidArgument,
                text("the bead width of %1 mm is outside its range of %2 to %3 mm",
                     {formatFixed(options.width, 2), formatFixed(options.minWidth, 2),
                      formatFixed(options.maxWidth, 2)}),
                "min_width, max_width", "choose a range that holds the bead width");
  }
  return options;
}

}  // namespace wcam::bulk
