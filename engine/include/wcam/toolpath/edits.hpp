// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/param.hpp"
#include "wcam/toolpath/build.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Edits of a generated toolpath: parametric steps that are applied again after each regeneration,
/// in their order, each to what the ones before it left. An edit finds its layers and beads by
/// index and its moves by a region in the part frame, so that it holds when the step or the part
/// changes; one that then finds nothing says so.
namespace wcam::toolpath {

enum class EditType {
  MoveSeam,
  DeleteLayers,
  RepeatLayers,
  SetSpeed,
  SetWire,
  Pause,
  Reverse,
  SetLead,
  SetLateral
};

struct EditTypeInfo {
  EditType type;
  const char* key;      ///< in files and commands: "move_seam"
  const char* name;     ///< for people
  const char* summary;  ///< one sentence
};

/// All types, in the order of menus.
const std::vector<EditTypeInfo>& editTypes();
/// Nothing for an unknown key.
std::optional<EditType> editTypeOf(std::string_view key) noexcept;
const EditTypeInfo& infoOf(EditType type) noexcept;

enum class EditRegion { Everywhere, Box, Sphere, HalfSpace, Length };
enum class SeamTarget { Length, Point, Angle };
enum class EditMode { Factor, Value };
enum class SpeedFollower { Width, Wire };
enum class WireFollower { Width, Speed };
enum class PausePlace { Before, After, AtLength };
enum class RepeatOffset { Step, Given };
enum class TiltMode { Add, Replace };

/// The values of all types; each type declares those that it uses (editSchema).
struct EditParams {
  // selection
  int firstLayer = 0;  ///< from 0; negative: counted from the last layer, which is −1
  int lastLayer = -1;
  int bead = -1;  ///< index in each layer; −1: all
  EditRegion region = EditRegion::Everywhere;
  std::array<double, 3> boxMin{-50.0, -50.0, 0.0};  ///< mm, part frame
  std::array<double, 3> boxMax{50.0, 50.0, 50.0};
  std::array<double, 3> centre{0.0, 0.0, 0.0};  ///< of the sphere
  Length radius = 20.0_mm;
  std::array<double, 3> planePoint{0.0, 0.0, 0.0};   ///< on the border of the half space
  std::array<double, 3> planeNormal{0.0, 0.0, 1.0};  ///< into the half space
  Length from = 0.0_mm;                              ///< along the bead, from the start of its body
  Length to = 0.0_mm;                                ///< 0: to the end
  // move_seam
  SeamTarget seam = SeamTarget::Length;
  Length seamLength = 10.0_mm;                     ///< forward from the present start
  std::array<double, 3> seamPoint{0.0, 0.0, 0.0};  ///< mm, part frame
  Angle seamAngle = 0.0_deg;
  bool exact = true;
  // delete_layers
  bool closeGap = false;
  // repeat_layers
  int count = 1;
  RepeatOffset offsetMode = RepeatOffset::Step;
  std::array<double, 3> offset{0.0, 0.0, 2.0};  ///< mm, of each repetition
  // set_speed, set_wire
  EditMode mode = EditMode::Factor;
  double factor = 1.0;
  Speed speed = 8.0_mm_s;
  WireSpeed wireSpeed = 6.0_m_min;
  SpeedFollower speedFollower = SpeedFollower::Width;
  WireFollower wireFollower = WireFollower::Width;
  // pause
  Duration seconds = 30.0_s;
  PausePlace where = PausePlace::Before;
  Length at = 0.0_mm;
  // set_lead, set_lateral
  TiltMode tiltMode = TiltMode::Add;
  Angle angle = 0.0_deg;
  Length blend = 10.0_mm;
};

struct Edit {
  std::string id;
  EditType type = EditType::MoveSeam;
  EditParams params;
};

/// The parameters of a type, with their texts.
const Schema<EditParams>& editSchema(EditType type);

/// True for parameters that are indices of layers and beads. Files and camcli count them from 0,
/// forms and reports for people from 1; negative ones mean the same in both.
bool isEditIndex(std::string_view key) noexcept;

/// All that is wrong with the parameters of an edit: those of the schema, and values that
/// contradict each other (a layer range that ends before it begins, an empty box, a normal without
/// direction).
std::vector<ParamProblem> validateEdit(EditType type,
                                       const Value& params,
                                       const std::string& path = {});

/// @throws Error(InvalidArgument) listing all problems
Edit readEdit(const std::string& id, EditType type, const Value& params);

/// The toolpath after an edit. Where a region's border crosses a move, a point is put exactly there
/// on the chord, with all values interpolated; lengths stay. Runs onto and off beads, ramps,
/// overlaps and wipes are made anew where an edit moves the end of a bead.
///
/// - move_seam: closed beads start elsewhere: a length further on, nearest to a point, or where
///   the angle about the build direction of the layer from the part's x, seen from the bead's
///   centre, is the wanted one. Only at points of the bead unless `exact`.
/// - delete_layers: the layers above stay, or come down by what is gone (closeGap). Above a gap
///   distance and height are measured again.
/// - repeat_layers: copies above the range, each moved by the thickness of the range along the
///   build direction or by a given offset; what lies above moves with the last copy.
/// - set_speed, set_wire: marks moves; the process stage follows (process::applyProcess).
/// - pause: the torch waits above the start or the end of a bead; at a length the bead is cut in
///   two and the torch waits between them.
/// - reverse: beads run the other way; lead stays relative to the travel. Beads of several
///   revolutions climb and are left alone.
/// - set_lead, set_lateral: the tool axis leans, fading over `blend` outside the region.
///
/// @param zones what stands at the ends of beads, as in buildToolpath
/// Findings: edit.selects_nothing, edit.range_clipped, edit.layer_gap, edit.repeat_turns,
/// edit.tilt_limited, edit.nothing_left; they name the edit.
/// Cost: linear in points; delete_layers and repeat_layers also O(n log n) of a few layers.
Toolpath applyEdit(const Toolpath& path,
                   const Edit& edit,
                   const ZoneParams& zones,
                   const JobContext& context);

/// One after the other.
Toolpath applyEdits(const Toolpath& path,
                    const std::vector<Edit>& edits,
                    const ZoneParams& zones,
                    const JobContext& context);

}  // namespace wcam::toolpath
