// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/project/html_report.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/toolpath/edits.hpp"

#include "svg_plot.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string_view>

namespace wcam::project {

namespace {

constexpr const char* kStyle = R"(
:root{--ink:#1c1e21;--soft:#5d646d;--page:#ffffff;--box:#f4f6f8;--line:#d5dae0;--bad:#b3261e;--warn:#9a6700;--info:#0550ae}
@media (prefers-color-scheme:dark){:root{--ink:#e6e8eb;--soft:#9aa4af;--page:#16191d;--box:#1f242a;--line:#3a424c;--bad:#ff8a80;--warn:#f0c35a;--info:#7db7ff}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--page);max-width:62rem;margin:2rem auto;padding:0 1rem}
h1{font-size:1.7rem;margin:.2em 0}h2{font-size:1.3rem;margin:2em 0 .4em;border-bottom:1px solid var(--line)}h3{font-size:1.05rem;margin:1.4em 0 .3em}
table{border-collapse:collapse;width:100%;margin:.5em 0}th,td{text-align:left;padding:.25em .6em;border-bottom:1px solid var(--line);vertical-align:top}
td.n{text-align:right;font-variant-numeric:tabular-nums}th{color:var(--soft);font-weight:600}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(11rem,1fr));gap:.6rem}
.figures div{background:var(--box);border-radius:6px;padding:.5rem .8rem}.figures b{display:block;font-size:1.15rem}.figures span{color:var(--soft);font-size:.85rem}
.violation{color:var(--bad);font-weight:600}.warning{color:var(--warn)}.information{color:var(--info)}
svg{width:100%;height:auto;background:var(--box);border-radius:6px;margin:.4em 0}svg text{font:11px system-ui,sans-serif;fill:var(--soft)}
.grid{stroke:var(--line);stroke-width:.6}.axis{stroke:var(--soft)}.limit{stroke:var(--bad);stroke-dasharray:5 4}
pre{background:var(--box);border-radius:6px;padding:.8rem;overflow:auto;font-size:.85rem}summary{cursor:pointer;color:var(--soft)}
)";

std::string element(const char* tag, const std::string& plain) {
  return "<" + std::string(tag) + ">" + htmlEscaped(plain) + "</" + tag + ">";
}

/// A number of the report by its path, with its unit; a dash where there is none.
std::string figure(const Value& report,
                   std::initializer_list<const char*> path,
                   int decimals,
                   const char* unit) {
  const Value* value = &report;
  for (const char* key : path) {
    value = value != nullptr && value->isObject() ? value->find(key) : nullptr;
  }
  if (value == nullptr || !value->isNumber()) {
    return "–";
  }
  return formatFixed(value->asReal(), decimals) + (unit[0] != '\0' ? " " : "") + unit;
}

std::string durationText(double seconds) {
  const long whole = std::lround(seconds);
  const auto two = [](long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
  return std::to_string(whole / 3600) + ":" + two(whole / 60 % 60) + ":" + two(whole % 60);
}

std::string figures(const OperationResult& result, const Value& report) {
  std::string html = "<div class=\"figures\">";
  const auto add = [&](const char* name, const std::string& value) {
    html += "<div><b>" + htmlEscaped(value) + "</b><span>" + name + "</span></div>";
  };
  add("layers", figure(report, {"layers"}, 0, ""));
  add("beads (arc starts)", figure(report, {"beads"}, 0, ""));
  add("length of the beads", figure(report, {"length_mm"}, 0, "mm"));
  add("deposited volume", figure(report, {"deposited_volume_mm3"}, 0, "mm³"));
  add("wire", figure(report, {"wire_length_m"}, 2, "m"));
  add("mass", figure(report, {"mass_g"}, 0, "g"));
  add("time (h:min:s)", durationText(result.motion->statistics.totalTime));
  add("of it with the arc on", durationText(result.motion->statistics.arcTime));
  add("layer height, least to greatest", figure(report, {"height_mm", "min"}, 2, "") + " … " +
                                             figure(report, {"height_mm", "max"}, 2, "mm"));
  add("overhang, greatest", figure(report, {"overhang_deg", "max"}, 1, "°"));
  add("dexterity, least", figure(report, {"min_dexterity"}, 3, ""));
  add("joint speed over its limit", figure(report, {"max_joint_speed_ratio"}, 2, ""));
  return html + "</div>";
}

std::string picture(const OperationResult& result) {
  std::vector<PathPicture> lines;
  for (const toolpath::Layer& layer : result.path->layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      PathPicture line;
      for (const toolpath::PathPoint& point : bead.points) {
        line.points.push_back(point.p);
        line.values.push_back(point.height);
      }
      lines.push_back(std::move(line));
    }
  }
  return svgPicture(lines, "The path of " + result.id + ", coloured by layer height",
                    "layer height, mm");
}

std::string processPlots(const OperationResult& result) {
  Plot height{"Layer height along the path", "length of the beads, m", "layer height, mm", {}, {}};
  PlotSeries along;
  double length = 0.0;
  constexpr double kMmPerM = 1000.0;
  for (const toolpath::Layer& layer : result.path->layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (std::size_t i = 0; i < bead.points.size(); ++i) {
        length += i > 0 ? (bead.points[i].p - bead.points[i - 1].p).norm() : 0.0;
        along.x.push_back(length / kMmPerM);
        along.y.push_back(bead.points[i].height);
      }
    }
  }
  height.series.push_back(std::move(along));
  height.limits = {result.process.heightMin.value(), result.process.heightMax.value()};
  Plot speed{
      "Travel speed", "time, s", "speed, mm/s", {{"wanted", {}, {}}, {"predicted", {}, {}}}, {}};
  for (const motion::Waypoint& point : result.motion->motion.waypoints) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    speed.series[0].x.push_back(point.time);
    speed.series[0].y.push_back(point.arc ? point.speed : none);
    speed.series[1].x.push_back(point.time);
    speed.series[1].y.push_back(point.arc ? point.tcpSpeed : none);
  }
  return element("h3", "Heights and speeds") + svgPlot(height) + svgPlot(speed);
}

std::string jointRows(const OperationResult& result, const Value& report) {
  std::string html =
      "<table><tr><th>Joint</th><th>least</th><th>greatest</th><th>margin to a limit</th>"
      "<th>greatest speed over its limit</th></tr>";
  const Value& joints = report.at("joints");
  for (const Value& joint : joints.asArray()) {
    const bool linear = joint.find("min_mm") != nullptr;
    const char* unit = linear ? "mm" : "°";
    const auto cell = [&](const char* degrees, const char* millimetres, int decimals) {
      return "<td class=\"n\">" +
             htmlEscaped(figure(joint, {linear ? millimetres : degrees}, decimals, unit)) + "</td>";
    };
    html += "<tr><td>" + htmlEscaped(joint.at("name").asString()) + "</td>" +
            cell("min_deg", "min_mm", 1) + cell("max_deg", "max_mm", 1) +
            cell("margin_deg", "margin_mm", 1) + "<td class=\"n\">" +
            figure(joint, {"max_speed_ratio"}, 3, "") + "</td></tr>";
  }
  html += "</table>";
  Plot plot{"Joints", "time, s", "joint, °", {}, {}};
  for (std::size_t j = 0; j < result.motion->statistics.joints.size(); ++j) {
    PlotSeries series;
    series.name = result.cell->joint(static_cast<int>(j)).name;
    for (const motion::Waypoint& point : result.motion->motion.waypoints) {
      const auto i = static_cast<Eigen::Index>(j);
      series.x.push_back(point.time);
      series.y.push_back(point.joints.size() > i ? radToDeg(point.joints(i))
                                                 : std::numeric_limits<double>::quiet_NaN());
    }
    plot.series.push_back(std::move(series));
  }
  return element("h3", "Joints") + html + svgPlot(plot);
}

std::string findingRows(const std::vector<Diagnostic>& findings) {
  if (findings.empty()) {
    return "<p>No findings.</p>";
  }
  std::string html = "<table><tr><th></th><th>Where</th><th>What</th><th>Remedy</th></tr>";
  for (const Diagnostic& finding : findings) {
    std::string place;
    const auto add = [&](const char* name, int index) {
      if (index >= 0) {
        place += (place.empty() ? "" : ", ") + std::string(name) + " " + std::to_string(index + 1);
      }
    };
    add("layer", finding.place.layer);
    add("bead", finding.place.bead);
    add("point", finding.place.point);
    html += "<tr><td class=\"" + std::string(toString(finding.severity)) + "\">" +
            toString(finding.severity) + "</td>" + element("td", place) + "<td>" +
            htmlEscaped(finding.message.str()) + "<br><small>" + htmlEscaped(finding.code) +
            "</small></td>" + element("td", finding.remedy.str()) + "</tr>";
  }
  return html + "</table>";
}

std::string numberText(const Value& number) {
  std::string text = toCompactJson(number);
  if (text.ends_with(".0")) {
    text.resize(text.size() - 2);
  }
  return text;
}

std::string valueText(const ParamDef& def, const Value& value) {
  if (value.isArray()) {
    std::string text;
    for (const Value& item : value.asArray()) {
      text += (text.empty() ? "" : ", ") + numberText(item);
    }
    return text;
  }
  if (value.isInteger() && toolpath::isEditIndex(def.info.key) && value.asInteger() >= 0) {
    return std::to_string(value.asInteger() + 1);
  }
  if (!value.isString()) {
    return numberText(value);
  }
  for (const ParamChoice& choice : def.info.choices) {
    if (choice.key == value.asString() && !choice.label.empty()) {
      return choice.label;
    }
  }
  return value.asString();
}

/// The edits of an operation in the order in which they are applied, with what is set in them.
/// Layers and beads count from 1 here, as in the findings.
std::string editRows(const Operation& operation) {
  if (operation.edits.empty()) {
    return {};
  }
  std::string html = "<table><tr><th>Edit</th><th>What</th><th>Settings</th><th></th></tr>";
  for (const OperationEdit& edit : operation.edits) {
    std::string settings;
    const ParamSchema schema = toolpath::editSchema(edit.type).params();
    for (const ParamDef& def : schema.defs()) {
      const Value* value = edit.params.find(def.info.key);
      if (value != nullptr && !value->isNull()) {
        const std::string unit = fileUnit(def.quantity);
        settings += (settings.empty() ? "" : "<br>") +
                    htmlEscaped(def.info.label + ": " + valueText(def, *value) +
                                (unit.empty() || value->isString() ? "" : " " + unit));
      }
    }
    html += "<tr>" + element("td", edit.id) + element("td", toolpath::infoOf(edit.type).name) +
            "<td>" + settings + "</td>" + element("td", edit.enabled ? "" : "left out") + "</tr>";
  }
  return element("h3", "Edits of the toolpath") + html + "</table>";
}

const Value* nodeOf(const Value& tree, const char* list, const std::string& id) {
  const Value* nodes = tree.find(list);
  if (nodes == nullptr || !nodes->isArray()) {
    return nullptr;
  }
  for (const Value& node : nodes->asArray()) {
    const Value* own = node.find("id");
    if (own != nullptr && own->isString() && own->asString() == id) {
      return &node;
    }
  }
  return nullptr;
}

std::string parameters(const Document& document, const std::string& operation) {
  const Value* node = nodeOf(document.tree(), "operations", operation);
  if (node == nullptr) {
    return {};
  }
  return "<details><summary>Parameters</summary><pre>" + htmlEscaped(toCanonicalJson(*node)) +
         "</pre></details>";
}

/// Programs that were not written, with the violations that keep them back.
std::string keptBack(const RunResult& result) {
  if (result.keptBack.empty()) {
    return {};
  }
  std::string html = "\n" + element("h2", "Kept back") +
                     "<table><tr><th>Operation</th><th>Output</th><th>Why</th></tr>";
  for (const KeptBack& kept : result.keptBack) {
    std::vector<std::string> why;
    for (const OperationResult& operation : result.operations) {
      for (const Diagnostic& finding : operation.findings) {
        // Of an output: what its post-processor found; else what stops all outputs.
        const bool ofPost = finding.code.starts_with("post.");
        if (operation.id == kept.operation && finding.severity == Severity::Violation &&
            ofPost == !kept.output.empty() &&
            std::find(why.begin(), why.end(), finding.code) == why.end()) {
          why.push_back(finding.code);
        }
      }
    }
    html += "<tr>" + element("td", kept.operation) +
            element("td", kept.output.empty() ? "all outputs" : kept.output) + "<td>" +
            htmlEscaped("violates checks: " + joinText(why, ", ")) + "</td></tr>";
  }
  return html + "</table>";
}

}  // namespace

std::string htmlReport(const Document& document, const RunResult& result) {
  const std::string& name = document.project().name;
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\">" +
      element("title", name.empty() ? "WCAM report" : name + " – WCAM report") + "<style>" +
      kStyle + "</style></head><body>" + element("h1", name.empty() ? "WCAM report" : name);
  for (const RunFailure& failure : result.failures) {
    html += "<p class=\"violation\">" +
            htmlEscaped((failure.place.empty() ? "" : failure.place.str() + ": ") +
                        failure.error.what()) +
            "</p>";
    if (!failure.error.hint().empty()) {
      html += element("p", failure.error.hint());
    }
  }
  if (!result.projectFindings.empty()) {
    html += element("h2", "Project") + findingRows(result.projectFindings);
  }
  for (const OperationResult& operation : result.operations) {
    const Value report = operationReport(operation);
    const Operation* planned = document.project().operation(operation.id);
    html += "\n" + element("h2", operation.id + " (" + operation.strategy + ")") +
            figures(operation, report) + picture(operation) +
            (planned != nullptr ? editRows(*planned) : std::string()) + element("h3", "Findings") +
            findingRows(operation.findings) + processPlots(operation) +
            jointRows(operation, report) + parameters(document, operation.id);
  }
  html += keptBack(result);
  if (!result.files.empty()) {
    html += "\n" + element("h2", "Files") + "<table><tr><th>File</th><th>Bytes</th></tr>";
    for (const WrittenFile& file : result.files) {
      html += "<tr>" + element("td", file.path) + "<td class=\"n\">" + std::to_string(file.bytes) +
              "</td></tr>";
    }
    html += "</table>";
  } else {
    html += "\n" + element("h2", "Files") + element("p", "No file was written.");
  }
  if (!result.leftFiles.empty()) {
    html += element("p", "Not written again by this run, and perhaps out of date: " +
                             joinText(result.leftFiles, ", "));
  }
  return html + "</body></html>\n";
}

}  // namespace wcam::project
