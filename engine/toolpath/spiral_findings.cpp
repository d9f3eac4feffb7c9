// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "spiral_findings.hpp"

#include "wcam/base/text.hpp"

namespace wcam::toolpath {

void reportSpiralHeights(const SpiralWish& wish,
                         std::size_t outside,
                         double least,
                         double greatest,
                         const JobContext& context) {
  if (outside == 0) {
    return;
  }
  context.add(
      {Severity::Warning,
       "slicing.spiral_height",
       text("%1 points have a deposit height outside of %2 to %3 mm: %4 to %5 mm",
            {std::to_string(outside), formatFixed(wish.heightMin, 3),
             formatFixed(wish.heightMax, 3), formatFixed(least, 3), formatFixed(greatest, 3)}),
       "a wider modulation range or another decomposition may help",
       {{}, 0, -1, -1},
       {{"points", static_cast<double>(outside)},
        {"height_min_mm", least},
        {"height_max_mm", greatest}}});
}

}  // namespace wcam::toolpath
