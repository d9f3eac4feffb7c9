// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/html_report.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace wcam::project {

namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 sans-serif;color:#20262e;max-width:1000px;margin:2em auto;padding:0 1em}"
    "h1{border-bottom:3px solid #1c70c8}h2{margin-top:2em;border-bottom:1px solid #ccd}"
    "table{border-collapse:collapse;margin:.6em 0}td,th{padding:.2em .8em;border-bottom:1px solid "
    "#dde;"
    "text-align:left;vertical-align:top}td.n{text-align:right;font-variant-numeric:tabular-nums}"
    ".violation,.error{color:#c0281f;font-weight:bold}.warning{color:#b06a00;font-weight:bold}"
    "figure{margin:1em 0}figcaption{font-weight:bold}svg,img{max-width:100%;height:auto}"
    "pre{background:#f4f6f9;padding:.8em;overflow:auto;font-size:13px}";

// Size of a plot and columns of its curve: more points than columns are drawn as their extremes.
constexpr int kWidth = 940;
constexpr int kHeight = 220;
constexpr int kLeft = 60;
constexpr int kBottom = 30;
constexpr std::array<const char*, 8> kColours = {"#3482d2", "#e68c28", "#50aa5a", "#cd464b",
                                                 "#9169be", "#966e5a", "#dc78b9", "#6e7882"};

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string cell(const std::string& html, bool number = false) {
  return (number ? "<td class=\"n\">" : "<td>") + html + "</td>";
}

struct Curve {
  std::string name;
  std::vector<double> values;  ///< NaN leaves a gap
};

struct Axis {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double v) {
    if (std::isfinite(v)) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
};

/// Points of a curve, two per pixel column.
std::string pathOf(const std::vector<double>& times,
                   const std::vector<double>& values,
                   const std::function<double(double)>& x,
                   const std::function<double(double)>& y) {
  std::string path;
  bool open = false;
  for (std::size_t i = 0; i < values.size();) {
    if (!std::isfinite(values[i])) {
      open = false;
      ++i;
      continue;
    }
    const auto column = std::lround(x(times[i]));
    Axis range;
    std::size_t j = i;
    for (; j < values.size() && std::isfinite(values[j]) && std::lround(x(times[j])) == column;
         ++j) {
      range.add(values[j]);
    }
    for (const double v : {range.low, range.high}) {
      path += (open ? "L" : "M") + std::to_string(column) + " " + formatFixed(y(v), 1);
      open = true;
      if (range.low == range.high) {
        break;
      }
    }
    i = j;
  }
  return path;
}

std::string plot(const std::string& title,
                 const std::string& unit,
                 const std::vector<double>& times,
                 const std::vector<Curve>& curves) {
  Axis axis;
  for (const Curve& curve : curves) {
    for (const double v : curve.values) {
      axis.add(v);
    }
  }
  if (times.size() < 2 || !(axis.low <= axis.high) || !(times.back() > times.front())) {
    return {};
  }
  const double span = std::max(axis.high - axis.low, 1e-3 * std::max(std::abs(axis.high), 1.0));
  const double low = axis.low - 0.05 * span;
  const double high = axis.low + 1.05 * span;
  const auto x = [&](double t) {
    return kLeft + (t - times.front()) / (times.back() - times.front()) * (kWidth - kLeft - 10);
  };
  const auto y = [&](double v) { return 8 + (high - v) / (high - low) * (kHeight - kBottom - 8); };
  std::string svg = "<figure><figcaption>" + escaped(title) + " (" + escaped(unit) +
                    ")</figcaption><svg viewBox=\"0 0 " + std::to_string(kWidth) + " " +
                    std::to_string(kHeight) + "\" font-size=\"12\" font-family=\"sans-serif\">";
  constexpr int kLines = 4;
  for (int i = 0; i <= kLines; ++i) {
    const double v = low + (high - low) * i / kLines;
    const std::string at = formatFixed(y(v), 1);
    svg += "<path d=\"M" + std::to_string(kLeft) + " " + at + "H" + std::to_string(kWidth - 10) +
           "\" stroke=\"#dde\"/><text x=\"" + std::to_string(kLeft - 6) + "\" y=\"" + at +
           "\" text-anchor=\"end\" dominant-baseline=\"middle\">" +
           formatFixed(v, span < 10 ? 2 : 0) + "</text>";
    const double t = times.front() + (times.back() - times.front()) * i / kLines;
    svg += "<text x=\"" + formatFixed(x(t), 1) + "\" y=\"" + std::to_string(kHeight - 8) +
           "\" text-anchor=\"" + (i == kLines ? "end" : "middle") + "\">" + formatFixed(t, 0) +
           " s</text>";
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string colour = kColours[i % kColours.size()];
    svg += "<path fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.4\" d=\"" +
           pathOf(times, curves[i].values, x, y) + "\"/><text x=\"" +
           std::to_string(kLeft + 8 + 110 * i) + "\" y=\"20\" fill=\"" + colour + "\">" +
           escaped(curves[i].name) + "</text>";
  }
  return svg + "</svg></figure>\n";
}

/// Values of the points in the order of the motion; NaN on the way between beads.
Curve pointCurve(const OperationResult& operation,
                 const std::string& name,
                 const std::function<double(const toolpath::PathPoint&)>& of) {
  Curve curve{name, {}};
  for (const motion::Waypoint& w : operation.motion->motion.waypoints) {
    curve.values.push_back(w.point < 0
                               ? std::numeric_limits<double>::quiet_NaN()
                               : of(operation.path->layers[static_cast<std::size_t>(w.layer)]
                                        .beads[static_cast<std::size_t>(w.bead)]
                                        .points[static_cast<std::size_t>(w.point)]));
  }
  return curve;
}

std::string plotsOf(const OperationResult& operation) {
  if (operation.motion == nullptr || operation.path == nullptr || operation.cell == nullptr) {
    return {};
  }
  const auto& waypoints = operation.motion->motion.waypoints;
  std::vector<double> times;
  Curve tcp{"predicted TCP speed", {}};
  for (const motion::Waypoint& w : waypoints) {
    times.push_back(w.time);
    tcp.values.push_back(w.point < 0 ? std::numeric_limits<double>::quiet_NaN() : w.tcpSpeed);
  }
  std::string html =
      plot("Height of the beads", "mm", times,
           {pointCurve(operation, "height", [](const auto& p) { return p.height; })});
  html += plot("Speed", "mm/s", times,
               {pointCurve(operation, "travel speed", [](const auto& p) { return p.speed; }), tcp});
  std::vector<Curve> joints;
  for (int j = 0; j < operation.cell->jointCount(); ++j) {
    Curve curve{operation.cell->joint(j).name, {}};
    for (const motion::Waypoint& w : waypoints) {
      curve.values.push_back(radToDeg(w.joints[j]));
    }
    joints.push_back(std::move(curve));
  }
  return html + plot("Joints", "deg", times, joints);
}

/// "layer_distance_mm" as "layer distance (mm)".
std::string figureName(std::string key) {
  static constexpr std::array<std::pair<const char*, const char*>, 7> kUnits = {
      {{"_mm3", " (mm³)"},
       {"_mm_s", " (mm/s)"},
       {"_mm", " (mm)"},
       {"_deg", " (deg)"},
       {"_s", " (s)"},
       {"_m", " (m)"},
       {"_g", " (g)"}}};
  std::string unit;
  for (const auto& [end, text] : kUnits) {
    if (key.ends_with(end)) {
      unit = text;
      key.resize(key.size() - std::string_view(end).size());
      break;
    }
  }
  std::replace(key.begin(), key.end(), '_', ' ');
  return key + unit;
}

std::string numberText(const Value& value) {
  return value.isInteger()  ? std::to_string(value.asInteger())
         : value.isNumber() ? formatFixed(value.asReal(), 3)
         : value.isString() ? escaped(value.asString())
                            : std::string();
}

std::string figuresOf(const Value& operation) {
  std::string html = "<table>";
  for (const auto& [key, value] : operation.asObject()) {
    if (key == "id" || key == "strategy") {
      continue;
    }
    if (value.isNumber() || value.isString()) {
      html += "<tr>" + cell(escaped(figureName(key))) + cell(numberText(value), true) + "</tr>";
    } else if (value.find("mean") != nullptr) {
      html += "<tr>" + cell(escaped(figureName(key))) +
              cell(numberText(value.at("min")) + " / " + numberText(value.at("mean")) + " / " +
                       numberText(value.at("max")),
                   true) +
              "</tr>";
    }
  }
  return html + "</table><p>Three numbers are the least, the mean and the greatest value.</p>\n";
}

std::string jointsOf(const Value& operation) {
  const Value* joints = operation.find("joints");
  if (joints == nullptr || !joints->isArray() || joints->size() == 0) {
    return {};
  }
  std::string html = "<h3>Joints</h3><table><tr>";
  for (const auto& [key, value] : joints->asArray().front().asObject()) {
    html += "<th>" + escaped(figureName(key)) + "</th>";
  }
  html += "</tr>";
  for (const Value& joint : joints->asArray()) {
    html += "<tr>";
    for (const auto& [key, value] : joint.asObject()) {
      html += cell(numberText(value), value.isNumber());
    }
    html += "</tr>";
  }
  return html + "</table>\n";
}

std::string findingsOf(const std::vector<Diagnostic>& findings) {
  if (findings.empty()) {
    return "<p>Nothing was found.</p>\n";
  }
  std::string html = "<table><tr><th></th><th>Place</th><th>Finding</th><th>Remedy</th></tr>";
  for (const Diagnostic& d : findings) {
    std::string place;
    // People count from 1.
    for (const auto& [name, index] :
         {std::pair("layer ", d.place.layer), std::pair("bead ", d.place.bead),
          std::pair("point ", d.place.point)}) {
      if (index >= 0) {
        place += (place.empty() ? "" : ", ") + std::string(name) + std::to_string(index + 1);
      }
    }
    html += "<tr><td class=\"" + std::string(toString(d.severity)) + "\">" + toString(d.severity) +
            "</td>" + cell(place) +
            cell(escaped(d.message) + "<br><code>" + escaped(d.code) + "</code>") +
            cell(escaped(d.remedy)) + "</tr>";
  }
  return html + "</table>\n";
}

std::string parametersOf(const Document& document, const std::string& operation) {
  const Value* operations = document.tree().find("operations");
  if (operations == nullptr) {
    return {};
  }
  for (const Value& node : operations->asArray()) {
    if (node.at("id").asString() == operation) {
      return "<h3>Settings</h3><pre>" + escaped(toCanonicalJson(node)) + "</pre>\n";
    }
  }
  return {};
}

}  // namespace

std::string htmlReport(const Document& document,
                       const RunResult& result,
                       const std::vector<ReportPicture>& pictures) {
  const Project& project = document.project();
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                     escaped(project.name) + "</title><style>" + kStyle +
                     "</style></head><body>\n<h1>" + escaped(project.name) + "</h1>\n";
  html += "<p>Cell: " + escaped(project.cell.path) + "</p>\n";
  for (const ReportPicture& picture : pictures) {
    html += "<figure><figcaption>" + escaped(picture.title) + "</figcaption><img alt=\"" +
            escaped(picture.title) + "\" src=\"" + escaped(picture.uri) + "\"></figure>\n";
  }
  for (const RunFailure& failure : result.failures) {
    html += "<p class=\"error\">" + escaped(failure.error.what()) + "</p><p>" +
            escaped(failure.error.hint()) + "</p>\n";
  }
  const Value* figures = result.report.find("operations");
  for (const OperationResult& operation : result.operations) {
    html += "<h2>Operation " + escaped(operation.id) +
            "</h2>\n<p>Strategy: " + escaped(operation.strategy) + "</p>\n";
    for (std::size_t i = 0; figures != nullptr && i < figures->size(); ++i) {
      const Value& own = figures->asArray()[i];
      if (own.at("id").asString() == operation.id) {
        html += figuresOf(own) + jointsOf(own);
      }
    }
    html += plotsOf(operation) + "<h3>Findings</h3>" + findingsOf(operation.findings) +
            parametersOf(document, operation.id);
  }
  if (!result.projectFindings.empty()) {
    html += "<h2>Project</h2>" + findingsOf(result.projectFindings);
  }
  if (!result.files.empty()) {
    html += "<h2>Files</h2><ul>";
    for (const WrittenFile& file : result.files) {
      html += "<li>" + escaped(file.path) + " (" + std::to_string(file.bytes) + " bytes)</li>";
    }
    html += "</ul>\n";
  }
  return html + "</body></html>\n";
}

}  // namespace wcam::project
