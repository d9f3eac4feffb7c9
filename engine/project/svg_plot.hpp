// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace wcam::project {

/// A curve of a plot. NaN in y breaks the line.
struct PlotSeries {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// A diagram with axes, ticks at round numbers and a legend.
struct Plot {
  std::string title;
  std::string xLabel;  ///< with its unit
  std::string yLabel;
  std::vector<PlotSeries> series;
  std::vector<double> limits;  ///< horizontal lines: what must not be passed
};

/// The plot as an SVG element. Long series are thinned to the least and greatest value of each
/// pixel column, so that no dip is lost. Numbers with a fixed number of decimals: the same input
/// gives the same bytes.
std::string svgPlot(const Plot& plot);

/// A polyline in space with the value that colours it.
struct PathPicture {
  std::vector<geometry::Vec3> points;
  std::vector<double> values;  ///< per point
};

/// Lines seen from above at an angle (isometric), coloured from the least to the greatest value,
/// with a scale beside them.
std::string svgPicture(const std::vector<PathPicture>& lines,
                       const std::string& title,
                       const std::string& valueLabel);

/// Text made safe for HTML and SVG.
std::string htmlEscaped(std::string_view text);

}  // namespace wcam::project
