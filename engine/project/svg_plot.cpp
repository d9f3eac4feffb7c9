// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "svg_plot.hpp"

#include "wcam/base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace wcam::project {

namespace {

constexpr double kWidth = 760.0;
constexpr double kHeight = 260.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 16.0;
constexpr double kTop = 30.0;
constexpr double kBottom = 44.0;
constexpr double kLegendRow = 16.0;
/// Colours that colour-blind readers tell apart (Okabe and Ito).
constexpr std::array<const char*, 8> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#777777", "#b8a800"};
constexpr double kPictureSize = 560.0;
/// Segments of a picture; more are not seen.
constexpr std::size_t kMostSegments = 20000;
constexpr int kShades = 32;

std::string number(double value) {
  return formatFixed(value, 2);
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }

  /// Never empty, never so narrow that rounding decides where something stands in it.
  [[nodiscard]] Range usable() const {
    if (!(low <= high)) {
      return {0.0, 1.0};
    }
    constexpr double kNarrow = 1e-9;
    if (high - low <= kNarrow * std::max(std::abs(low), std::abs(high))) {
      const double half = std::max(0.5, 0.05 * std::abs(low));
      return {low - half, high + half};
    }
    return *this;
  }
};

/// Step of 1, 2 or 5 times a power of ten that gives about `count` ticks.
double roundStep(const Range& range, int count) {
  const double raw = (range.high - range.low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

/// Multiples of a step within a range: few, whatever the range.
std::vector<double> ticks(const Range& range, double step, double rounding) {
  constexpr int kMostTicks = 100;
  std::vector<double> values;
  const double first = std::ceil(range.low / step);
  for (int i = 0; i < kMostTicks; ++i) {
    const double value = (first + i) * step;
    if (!(value <= range.high * (1.0 + rounding))) {
      break;
    }
    values.push_back(value);
  }
  return values;
}

std::string tickText(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  return formatFixed(std::abs(value) < 1e-9 * step ? 0.0 : value, decimals);
}

/// The curve as moves and lines, one least and one greatest value for each pixel column.
std::string curve(const PlotSeries& series, const Range& xs, const Range& ys, double height) {
  const double plotWidth = kWidth - kLeft - kRight;
  const auto px = [&](double x) { return kLeft + (x - xs.low) / (xs.high - xs.low) * plotWidth; };
  const auto py = [&](double y) {
    return kTop + (ys.high - y) / (ys.high - ys.low) * (height - kTop - kBottom);
  };
  std::string path;
  bool pen = false;
  const auto draw = [&](std::size_t i) {
    path += (pen ? " L" : " M") + number(px(series.x[i])) + " " + number(py(series.y[i]));
    pen = true;
  };
  std::size_t i = 0;
  const std::size_t n = std::min(series.x.size(), series.y.size());
  while (i < n) {
    if (!std::isfinite(series.y[i]) || !std::isfinite(series.x[i])) {
      pen = false;
      ++i;
      continue;
    }
    const double column = std::floor(px(series.x[i]));
    std::size_t least = i;
    std::size_t most = i;
    std::size_t last = i;
    for (; i < n && std::isfinite(series.y[i]) && std::floor(px(series.x[i])) == column; ++i) {
      least = series.y[i] < series.y[least] ? i : least;
      most = series.y[i] > series.y[most] ? i : most;
      last = i;
    }
    draw(std::min(least, most));
    if (least != most) {
      draw(std::max(least, most));
    }
    if (last != least && last != most) {
      draw(last);
    }
  }
  return path;
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
         htmlEscaped(words) + "</text>";
}

std::string line(double x1, double y1, double x2, double y2, const char* style) {
  return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
         "\" y2=\"" + number(y2) + "\" class=\"" + style + "\"/>";
}

std::string opening(double width, double height, const std::string& title) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 " + number(width) +
         " " + number(height) + "\"><title>" + htmlEscaped(title) + "</title>";
}

std::string axes(const Plot& plot, const Range& xs, const Range& ys, double height) {
  std::string svg;
  const double right = kWidth - kRight;
  const double bottom = height - kBottom;
  constexpr int kTicksX = 8;
  constexpr int kTicksY = 5;
  const double stepX = roundStep(xs, kTicksX);
  for (const double tick : ticks(xs, stepX, 1e-12)) {
    const double x = kLeft + (tick - xs.low) / (xs.high - xs.low) * (right - kLeft);
    svg +=
        line(x, kTop, x, bottom, "grid") + text(x, bottom + 14.0, "middle", tickText(tick, stepX));
  }
  const double stepY = roundStep(ys, kTicksY);
  for (const double tick : ticks(ys, stepY, 0.0)) {
    const double y = kTop + (ys.high - tick) / (ys.high - ys.low) * (bottom - kTop);
    svg +=
        line(kLeft, y, right, y, "grid") + text(kLeft - 6.0, y + 4.0, "end", tickText(tick, stepY));
  }
  for (const double limit : plot.limits) {
    if (limit >= ys.low && limit <= ys.high) {
      const double y = kTop + (ys.high - limit) / (ys.high - ys.low) * (bottom - kTop);
      svg += line(kLeft, y, right, y, "limit");
    }
  }
  svg += line(kLeft, bottom, right, bottom, "axis") + line(kLeft, kTop, kLeft, bottom, "axis");
  svg += text(0.5 * (kLeft + right), bottom + 30.0, "middle", plot.xLabel);
  svg += text(kLeft - 56.0, kTop - 10.0, "start", plot.yLabel);
  return svg;
}

/// Blue over green to yellow: even in lightness, readable in grey.
std::string shade(double fraction) {
  struct Stop {
    double r, g, b;
  };

  constexpr std::array<Stop, 5> kStops = {
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {230, 210, 30}}};
  const double at = std::clamp(fraction, 0.0, 1.0) * (kStops.size() - 1);
  const auto k = std::min<std::size_t>(static_cast<std::size_t>(at), kStops.size() - 2);
  const double f = at - static_cast<double>(k);
  const auto mix = [f](double a, double b) {
    return std::to_string(static_cast<int>(std::lround(a + f * (b - a))));
  };
  return "rgb(" + mix(kStops[k].r, kStops[k + 1].r) + "," + mix(kStops[k].g, kStops[k + 1].g) +
         "," + mix(kStops[k].b, kStops[k + 1].b) + ")";
}

geometry::Vec2 isometric(const geometry::Vec3& p) {
  const double c = std::cos(0.5235987755982988);  // 30 degrees
  return {(p.x() - p.y()) * c, -(p.x() + p.y()) * 0.5 * 0.7 - p.z() * 0.9};
}

}  // namespace

std::string htmlEscaped(std::string_view plain) {
  std::string escaped;
  for (const char c : plain) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        // Controls are no characters of XML.
        escaped += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return escaped;
}

std::string svgPlot(const Plot& plot) {
  Range xs;
  Range ys;
  for (const PlotSeries& series : plot.series) {
    for (const double x : series.x) {
      xs.add(x);
    }
    for (const double y : series.y) {
      ys.add(y);
    }
  }
  xs = xs.usable();
  ys = ys.usable();
  const double room = 0.05 * (ys.high - ys.low);
  ys = {ys.low - room, ys.high + room};
  const double height = kHeight + (plot.series.size() > 1 ? kLegendRow : 0.0);
  std::string svg = opening(kWidth, height, plot.title);
  const double drawn = kHeight;
  svg += axes(plot, xs, ys, drawn);
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    svg += "<path fill=\"none\" stroke-width=\"1.4\" stroke=\"" +
           std::string(kColours[s % kColours.size()]) + "\" d=\"" +
           curve(plot.series[s], xs, ys, drawn) + "\"/>";
  }
  if (plot.series.size() > 1) {
    double x = kLeft;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
      const double y = height - 6.0;
      svg += "<rect x=\"" + number(x) + "\" y=\"" + number(y - 8.0) +
             "\" width=\"10\" height=\"10\" fill=\"" + kColours[s % kColours.size()] + "\"/>" +
             text(x + 14.0, y, "start", plot.series[s].name);
      x += 26.0 + 7.0 * static_cast<double>(plot.series[s].name.size());
    }
  }
  return svg + "</svg>";
}

std::string svgPicture(const std::vector<PathPicture>& lines,
                       const std::string& title,
                       const std::string& valueLabel) {
  Range xs;
  Range ys;
  Range values;
  std::size_t segments = 0;
  for (const PathPicture& path : lines) {
    segments += path.points.size();
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const geometry::Vec2 p = isometric(path.points[i]);
      xs.add(p.x());
      ys.add(p.y());
      values.add(path.values[i]);
    }
  }
  const bool flat = !(values.low < values.high);
  xs = xs.usable();
  ys = ys.usable();
  const double scale = std::min((kPictureSize - 20.0) / (xs.high - xs.low),
                                (kPictureSize - 20.0) / (ys.high - ys.low));
  const double height = (ys.high - ys.low) * scale + 20.0;
  const std::size_t stride = 1 + segments / kMostSegments;
  // One path per shade: few elements, whatever the number of points.
  std::array<std::string, kShades> paths;
  for (const PathPicture& path : lines) {
    for (std::size_t i = 0; i + 1 < path.points.size(); i += stride) {
      const std::size_t j = std::min(i + stride, path.points.size() - 1);
      const geometry::Vec2 a = isometric(path.points[i]);
      const geometry::Vec2 b = isometric(path.points[j]);
      const double fraction =
          flat ? 0.5 : (path.values[j] - values.low) / (values.high - values.low);
      const auto k = static_cast<std::size_t>(
          std::clamp(static_cast<int>(fraction * kShades), 0, kShades - 1));
      paths[k] += " M" + number((a.x() - xs.low) * scale + 10.0) + " " +
                  number((a.y() - ys.low) * scale + 10.0) + " L" +
                  number((b.x() - xs.low) * scale + 10.0) + " " +
                  number((b.y() - ys.low) * scale + 10.0);
    }
  }
  std::string svg = opening(kWidth, std::max(height, 160.0), title);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    if (!paths[k].empty()) {
      svg += "<path fill=\"none\" stroke-width=\"1\" stroke=\"" +
             shade((static_cast<double>(k) + 0.5) / kShades) + "\" d=\"" + paths[k] + "\"/>";
    }
  }
  constexpr int kSteps = 8;
  for (int k = 0; k < kSteps && !flat; ++k) {
    const double f = static_cast<double>(k) / (kSteps - 1);
    const double y = 34.0 + 14.0 * (kSteps - 1 - k);
    svg += "<rect x=\"" + number(kPictureSize + 40.0) + "\" y=\"" + number(y - 9.0) +
           "\" width=\"14\" height=\"14\" fill=\"" + shade(f) + "\"/>" +
           text(kPictureSize + 60.0, y + 2.0, "start",
                formatFixed(values.low + f * (values.high - values.low), 2));
  }
  if (!flat) {
    svg += text(kPictureSize + 40.0, 14.0, "start", valueLabel);
  }
  return svg + "</svg>";
}

}  // namespace wcam::project
