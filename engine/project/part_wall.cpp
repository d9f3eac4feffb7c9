// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "part_wall.hpp"

#include "wcam/base/text.hpp"

#include <utility>

namespace wcam::project {

namespace {

/// A bead that is much wider or narrower than the wall gives another part.
constexpr double kBeadFitsWall = 0.25;

}  // namespace

void takeSide(io::ImportedPart& part,
              geometry::WallSide side,
              const std::string& id,
              const JobContext& context) {
  geometry::SolidWall wall = geometry::solidWall(*part.surface, side, context);
  part.surface = std::make_shared<const geometry::PartSurface>(std::move(wall.surface));
  part.wallThickness = std::move(wall.thickness);
  const geometry::WallThickness& thickness = *part.wallThickness;
  context.add({Severity::Information,
               "part.wall_thickness",
               text("the wall of part '%1' is %2 to %3 mm thick, %4 mm in the mean",
                    {id, formatFixed(thickness.min, 2), formatFixed(thickness.max, 2),
                     formatFixed(thickness.mean, 2)}),
               "",
               {},
               {{"min_mm", thickness.min},
                {"mean_mm", thickness.mean},
                {"max_mm", thickness.max},
                {"thinnest_x_mm", thickness.thinnest.x()},
                {"thinnest_y_mm", thickness.thinnest.y()},
                {"thinnest_z_mm", thickness.thinnest.z()},
                {"thickest_x_mm", thickness.thickest.x()},
                {"thickest_y_mm", thickness.thickest.y()},
                {"thickest_z_mm", thickness.thickest.z()}}});
}

std::vector<Diagnostic> compareWithBead(const io::ImportedPart& part,
                                        const std::string& id,
                                        double beadWidth) {
  if (!part.wallThickness) {
    return {};
  }
  const geometry::WallThickness& wall = *part.wallThickness;
  if (wall.min >= (1.0 - kBeadFitsWall) * beadWidth &&
      wall.max <= (1.0 + kBeadFitsWall) * beadWidth) {
    return {};
  }
  return {
      {Severity::Warning,
       "part.bead_does_not_fit_wall",
       text("the wall of part '%1' is %2 to %3 mm thick, the bead %4 mm wide",
            {id, formatFixed(wall.min, 2), formatFixed(wall.max, 2), formatFixed(beadWidth, 2)}),
       "choose a process with a bead as wide as the wall, or lay several beads beside each "
       "other",
       {},
       {{"min_mm", wall.min}, {"max_mm", wall.max}, {"bead_width_mm", beadWidth}}}};
}

}  // namespace wcam::project
