// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/edits.hpp"

#include <algorithm>
#include <map>

namespace wcam::toolpath {

namespace {

constexpr double kFar = 1e5;  // mm; beyond any part
constexpr int kManyLayers = 1000000;
constexpr double kMostTilt = 60.0;  // degrees

void addLayers(Schema<EditParams>& schema) {
  schema
      .add(&EditParams::firstLayer, {.key = "first_layer",
                                     .label = "First layer",
                                     .help = "Counted from 0 in files, from 1 in the window; "
                                             "negative numbers count from the top, whose layer "
                                             "is -1.",
                                     .group = "Selection",
                                     .min = -kManyLayers,
                                     .max = kManyLayers})
      .add(&EditParams::lastLayer, {.key = "last_layer",
                                    .label = "Last layer",
                                    .help = "Belongs to the range; -1 is the top layer.",
                                    .group = "Selection",
                                    .min = -kManyLayers,
                                    .max = kManyLayers});
}

void addBead(Schema<EditParams>& schema) {
  schema.add(&EditParams::bead, {.key = "bead",
                                 .label = "Bead",
                                 .help = "Counted in each layer, from 0 in files, from 1 in the "
                                         "window; -1 is all beads.",
                                 .group = "Selection",
                                 .min = -1,
                                 .max = kManyLayers});
}

void addRegion(Schema<EditParams>& schema) {
  const auto vector = [&schema](std::array<double, 3> EditParams::*field, const char* key,
                                const char* label, const char* help, const char* condition,
                                QuantityKind kind) {
    schema.add(field,
               {.key = key,
                .label = label,
                .help = help,
                .group = "Selection",
                .min = -kFar,
                .max = kFar,
                .enabledIf = condition},
               ParamType::Vector3, kind);
  };
  schema.add(&EditParams::region, {.key = "region",
                                   .label = "Region",
                                   .help = "In the frame of the part; beads are cut exactly at its "
                                           "border.",
                                   .group = "Selection",
                                   .choices = {{"everywhere", "Everywhere"},
                                               {"box", "Inside a box"},
                                               {"sphere", "Inside a sphere"},
                                               {"half_space", "On one side of a plane"},
                                               {"length", "Between two lengths along the bead"}}});
  vector(&EditParams::boxMin, "box_min", "Lowest corner", "Of the box.", "region=box",
         QuantityKind::Length);
  vector(&EditParams::boxMax, "box_max", "Highest corner", "Of the box.", "region=box",
         QuantityKind::Length);
  vector(&EditParams::centre, "centre", "Centre", "Of the sphere.", "region=sphere",
         QuantityKind::Length);
  schema.add(&EditParams::radius, {.key = "radius",
                                   .label = "Radius",
                                   .help = "Of the sphere.",
                                   .group = "Selection",
                                   .min = 0.01,
                                   .max = kFar,
                                   .enabledIf = "region=sphere"});
  vector(&EditParams::planePoint, "plane_point", "Point of the plane", "", "region=half_space",
         QuantityKind::Length);
  vector(&EditParams::planeNormal, "plane_normal", "Normal of the plane",
         "Points to the side that is meant.", "region=half_space", QuantityKind::None);
  schema
      .add(&EditParams::from, {.key = "from",
                               .label = "From",
                               .help = "Length from the start of the bead.",
                               .group = "Selection",
                               .min = 0.0,
                               .max = 1e7,
                               .enabledIf = "region=length"})
      .add(&EditParams::to, {.key = "to",
                             .label = "To",
                             .help = "Length from the start of the bead; 0 is its end.",
                             .group = "Selection",
                             .min = 0.0,
                             .max = 1e7,
                             .enabledIf = "region=length"});
}

Schema<EditParams> selectionSchema(bool beads, bool region) {
  Schema<EditParams> schema;
  addLayers(schema);
  if (beads) {
    addBead(schema);
  }
  if (region) {
    addRegion(schema);
  }
  return schema;
}

Schema<EditParams> moveSeamSchema() {
  Schema<EditParams> schema = selectionSchema(true, false);
  schema
      .add(&EditParams::seam, {.key = "seam",
                               .label = "New start",
                               .help = "Of closed beads; open ones stay.",
                               .group = "Seam",
                               .choices = {{"length", "A length further on"},
                                           {"point", "Nearest to a point"},
                                           {"angle", "In a direction from the centre"}}})
      .add(&EditParams::seamLength, {.key = "length",
                                     .label = "Length",
                                     .help = "Along the bead from its present start; negative "
                                             "lengths run backwards.",
                                     .group = "Seam",
                                     .min = -1e7,
                                     .max = 1e7,
                                     .enabledIf = "seam=length"})
      .add(&EditParams::seamPoint,
           {.key = "point",
            .label = "Point",
            .help = "In the frame of the part.",
            .group = "Seam",
            .min = -kFar,
            .max = kFar,
            .enabledIf = "seam=point"},
           ParamType::Vector3, QuantityKind::Length)
      .add(&EditParams::seamAngle, {.key = "angle",
                                    .label = "Angle",
                                    .help = "About the build direction of the layer, from the "
                                            "part's x axis, seen from the centre of the bead.",
                                    .group = "Seam",
                                    .min = -360.0,
                                    .max = 360.0,
                                    .enabledIf = "seam=angle"})
      .add(&EditParams::exact, {.key = "exact",
                                .label = "Exactly there",
                                .help = "Else at the nearest point of the bead.",
                                .group = "Seam",
                                .level = ParamLevel::Advanced});
  return schema;
}

Schema<EditParams> deleteSchema() {
  Schema<EditParams> schema = selectionSchema(false, false);
  schema.add(&EditParams::closeGap, {.key = "close_gap",
                                     .label = "Close the gap",
                                     .help = "The layers above come down by what is gone.",
                                     .group = "Layers"});
  return schema;
}

Schema<EditParams> repeatSchema() {
  Schema<EditParams> schema = selectionSchema(false, false);
  schema
      .add(&EditParams::count, {.key = "count",
                                .label = "Repetitions",
                                .help = "Beside the range itself; the layers above move up.",
                                .group = "Layers",
                                .min = 1,
                                .max = 10000})
      .add(&EditParams::offsetMode,
           {.key = "offset_mode",
            .label = "Offset",
            .group = "Layers",
            .choices = {{"step", "The thickness of the range"}, {"given", "As given"}}})
      .add(&EditParams::offset,
           {.key = "offset",
            .label = "Offset of a repetition",
            .help = "In the frame of the part.",
            .group = "Layers",
            .min = -kFar,
            .max = kFar,
            .enabledIf = "offset_mode=given"},
           ParamType::Vector3, QuantityKind::Length);
  return schema;
}

void addMode(Schema<EditParams>& schema, const ParamChoice& value) {
  schema
      .add(&EditParams::mode, {.key = "mode",
                               .label = "Change",
                               .group = "Change",
                               .choices = {{"factor", "By a factor of what is planned"}, value}})
      .add(&EditParams::factor,
           {.key = "factor",
            .label = "Factor",
            .help = "100 % changes nothing.",
            .group = "Change",
            .min = 0.01,
            .max = 100.0,
            .enabledIf = "mode=factor"},
           ParamType::Real, QuantityKind::Ratio);
}

Schema<EditParams> speedSchema() {
  Schema<EditParams> schema = selectionSchema(true, true);
  addMode(schema, {"value", "To a travel speed"});
  schema
      .add(&EditParams::speed, {.key = "speed",
                                .label = "Travel speed",
                                .help = "Inside the window of the process.",
                                .group = "Change",
                                .min = 0.01,
                                .max = 1000.0,
                                .enabledIf = "mode=value"})
      .add(&EditParams::speedFollower,
           {.key = "follow",
            .label = "What follows",
            .help = "The layer height stays: a faster torch leaves a narrower bead, or more wire.",
            .group = "Change",
            .choices = {{"width", "The width of the bead"},
                        {"wire", "The wire feed: the section of the bead stays"}}});
  return schema;
}

Schema<EditParams> wireSchema() {
  Schema<EditParams> schema = selectionSchema(true, true);
  addMode(schema, {"value", "To a wire feed speed"});
  schema
      .add(&EditParams::wireSpeed, {.key = "wire_speed",
                                    .label = "Wire feed speed",
                                    .group = "Change",
                                    .min = 0.05,
                                    .max = 60.0,
                                    .enabledIf = "mode=value"})
      .add(&EditParams::wireFollower,
           {.key = "follow",
            .label = "What follows",
            .help = "The layer height stays: more wire makes a wider bead, or a faster torch.",
            .group = "Change",
            .choices = {{"width", "The width of the bead"},
                        {"speed", "The travel speed: the section of the bead stays"}}});
  return schema;
}

Schema<EditParams> pauseSchema() {
  Schema<EditParams> schema = selectionSchema(true, false);
  schema
      .add(&EditParams::seconds, {.key = "time",
                                  .label = "Time",
                                  .help = "The torch stands lifted, with the arc off.",
                                  .group = "Pause",
                                  .min = 0.001,
                                  .max = 86400.0})
      .add(&EditParams::where, {.key = "where",
                                .label = "Where",
                                .group = "Pause",
                                .choices = {{"before", "Before the bead"},
                                            {"after", "After the bead"},
                                            {"at_length", "At a length: the bead is cut there"}}})
      .add(&EditParams::at, {.key = "length",
                             .label = "Length",
                             .help = "From the start of the bead.",
                             .group = "Pause",
                             .min = 0.0,
                             .max = 1e7,
                             .enabledIf = "where=at_length"});
  return schema;
}

Schema<EditParams> tiltSchema(const char* help) {
  Schema<EditParams> schema = selectionSchema(true, true);
  schema
      .add(&EditParams::tiltMode,
           {.key = "mode",
            .label = "Change",
            .group = "Tool axis",
            .choices = {{"add", "Add to what is planned"}, {"replace", "Replace it"}}})
      .add(&EditParams::angle, {.key = "angle",
                                .label = "Angle",
                                .help = help,
                                .group = "Tool axis",
                                .min = -kMostTilt,
                                .max = kMostTilt})
      .add(&EditParams::blend, {.key = "blend",
                                .label = "Blend",
                                .help = "Length outside the region in which the change fades away.",
                                .group = "Tool axis",
                                .level = ParamLevel::Advanced,
                                .min = 0.0,
                                .max = 1000.0});
  return schema;
}

Schema<EditParams> makeSchema(EditType type) {
  switch (type) {
    case EditType::MoveSeam:
      return moveSeamSchema();
    case EditType::DeleteLayers:
      return deleteSchema();
    case EditType::RepeatLayers:
      return repeatSchema();
    case EditType::SetSpeed:
      return speedSchema();
    case EditType::SetWire:
      return wireSchema();
    case EditType::Pause:
      return pauseSchema();
    case EditType::Reverse:
      return selectionSchema(true, false);
    case EditType::SetLead:
      return tiltSchema("In the travel plane; positive leans forward.");
    case EditType::SetLateral:
      return tiltSchema("Across the travel; positive leans to the side of the bead's normal.");
  }
  return {};
}

/// What the schema cannot say about values that are right one by one.
void checkTogether(const EditParams& params,
                   const std::string& path,
                   std::vector<ParamProblem>& problems) {
  const auto place = [&path](const char* key) { return path.empty() ? key : path + "." + key; };
  const bool sameSign = (params.firstLayer < 0) == (params.lastLayer < 0);
  if (sameSign && params.firstLayer > params.lastLayer) {
    problems.push_back({place("last_layer"),
                        "the range ends before it begins; exchange first_layer and last_layer",
                        false});
  }
  if (params.region == EditRegion::Box) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(params.boxMin[i] < params.boxMax[i])) {
        problems.push_back({place("box_max"),
                            "every number must be greater than that of box_min: the box is empty",
                            false});
        break;
      }
    }
  }
  if (params.region == EditRegion::HalfSpace &&
      !(Vec3(params.planeNormal.data()).norm() > 1e-9)) {  // shorter ones have no direction
    problems.push_back(
        {place("plane_normal"), "has no direction; give a vector that is not zero", false});
  }
  if (params.region == EditRegion::Length && params.to.value() > 0.0 &&
      !(params.from < params.to)) {
    problems.push_back({place("to"), "must be greater than from, or 0 for the end", false});
  }
}

}  // namespace

const std::vector<EditTypeInfo>& editTypes() {
  static const std::vector<EditTypeInfo> types = {
      {EditType::MoveSeam, "move_seam", "Move the seam", "Closed beads start at another place."},
      {EditType::DeleteLayers, "delete_layers", "Delete layers",
       "Leaves out a range of layers, for example what stands already."},
      {EditType::RepeatLayers, "repeat_layers", "Repeat layers",
       "Builds a range of layers several times, one above the other."},
      {EditType::SetSpeed, "set_speed", "Change the travel speed",
       "In a range of layers, a region or a piece of a bead."},
      {EditType::SetWire, "set_wire", "Change the wire feed",
       "In a range of layers, a region or a piece of a bead."},
      {EditType::Pause, "pause", "Pause",
       "The torch waits with the arc off, for example until a layer is cold."},
      {EditType::Reverse, "reverse", "Reverse", "Beads run the other way."},
      {EditType::SetLead, "set_lead", "Change the lead angle",
       "The torch leans forward or back along the travel."},
      {EditType::SetLateral, "set_lateral", "Change the lateral tilt",
       "The torch leans to the side; positive leans outwards."}};
  return types;
}

std::optional<EditType> editTypeOf(std::string_view key) noexcept {
  for (const EditTypeInfo& info : editTypes()) {
    if (key == info.key) {
      return info.type;
    }
  }
  return std::nullopt;
}

const EditTypeInfo& infoOf(EditType type) noexcept {
  return editTypes()[static_cast<std::size_t>(type)];
}

const Schema<EditParams>& editSchema(EditType type) {
  static const std::map<EditType, Schema<EditParams>> schemas = [] {
    std::map<EditType, Schema<EditParams>> all;
    for (const EditTypeInfo& info : editTypes()) {
      all.emplace(info.type, makeSchema(info.type));
    }
    return all;
  }();
  return schemas.at(type);
}

std::vector<ParamProblem> validateEdit(EditType type,
                                       const Value& params,
                                       const std::string& path) {
  const Schema<EditParams>& schema = editSchema(type);
  std::vector<ParamProblem> problems = schema.params().validate(params, path);
  if (std::all_of(problems.begin(), problems.end(), [](const auto& p) { return p.unknown; })) {
    checkTogether(schema.read(params), path, problems);
  }
  return problems;
}

Edit readEdit(const std::string& id, EditType type, const Value& params) {
  std::vector<ParamProblem> problems = validateEdit(type, params);
  std::erase_if(problems, [](const ParamProblem& p) { return p.unknown; });
  throwProblems(problems, ErrorCode::InvalidArgument, text("edit '%1'", {id}));
  return {id, type, editSchema(type).read(params)};
}

bool isEditIndex(std::string_view key) noexcept {
  return key == "first_layer" || key == "last_layer" || key == "bead";
}

}  // namespace wcam::toolpath
