// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/types.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// A project with one operation for each strategy, on parts of which closed forms are known: a
/// tube, a sheet and a box.
namespace wcam::test {

inline constexpr double kTubeRadius = 30.0;          // mm
inline constexpr double kTubeHeight = 20.0;          // mm
inline const geometry::Vec3 kBox(60.0, 40.0, 12.0);  // mm

namespace every_strategy {

inline const char* const kTube =
    R"({"format_version": 1, "surface": {"type": "revolution", "radius": 30, "z": [0, 20]}})";
inline const char* const kSheet = R"({"format_version": 1, "surface": {"type": "parametric",
    "x": "u", "y": "v", "z": "0", "u": [-30, 30], "v": [-20, 20]}})";

inline std::string box() {
  std::string text = "solid box\n";
  const auto triangle = [&](const geometry::Vec3& a, const geometry::Vec3& b,
                            const geometry::Vec3& c) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const geometry::Vec3& p : {a, b, c}) {
      text += "vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
              std::to_string(p.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      geometry::Vec3 u = geometry::Vec3::Unit((axis + 1) % 3);
      geometry::Vec3 v = geometry::Vec3::Unit((axis + 2) % 3);
      if (side < 0.0) {
        std::swap(u, v);
      }
      const auto corner = [&](double s, double t) -> geometry::Vec3 {
        return (side * geometry::Vec3::Unit(axis) + s * u + t * v).cwiseProduct(kBox) +
               geometry::Vec3(0.0, 0.0, kBox.z() / 2.0);
      };
      triangle(corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5));
      triangle(corner(-0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5));
    }
  }
  return text + "endsolid box\n";
}

/// Five circles of the tube, as a table of points.
inline std::string circles() {
  constexpr int kPoints = 120;
  std::string text = "layer,bead,x_mm,y_mm,z_mm\n";
  for (int layer = 0; layer < 5; ++layer) {
    for (int i = 0; i <= kPoints; ++i) {
      const double angle = 2.0 * kPi * (i % kPoints) / kPoints;
      text += std::to_string(layer) + ",0," + std::to_string(kTubeRadius * std::cos(angle)) + "," +
              std::to_string(kTubeRadius * std::sin(angle)) + "," +
              std::to_string(4.0 * (layer + 1)) + "\n";
    }
  }
  return text;
}

}  // namespace every_strategy

struct StrategyCase {
  std::string strategy;  ///< also the id of its operation
  std::string part;      ///< file; of a path where the strategy takes one
  std::string params;    ///< JSON
};

inline const std::vector<StrategyCase>& everyStrategy() {
  static const std::vector<StrategyCase> cases = {
      {"planar", "tube.wsurf", R"({"step": 4})"},
      {"guide", "tube.wsurf", R"({"step": 4, "automatic_guide": true})"},
      {"geodesic", "tube.wsurf", R"({"step": 4})"},
      {"isovalues", "tube.wsurf", R"({"step": 4})"},
      {"constant", "tube.wsurf", R"({"step": 4})"},
      {"isoparam", "tube.wsurf", R"({"step": 4})"},
      {"branches", "tube.wsurf", R"({"step": 4})"},
      // Cones of 0 degrees are planes across the axis.
      {"radial", "tube.wsurf", R"({"step": 4, "shape": "cone", "cone_angle": 0})"},
      {"import", "circles.csv", "{}"},
      {"spiral", "tube.wsurf", R"({"step": 4, "height_min": 2, "height_max": 6})"},
      {"bulk", "box.stl", R"({"step": 2})"},
      {"cladding", "sheet.wsurf", R"({"step": 2})"},
  };
  return cases;
}

/// Writes the parts and every.wcam into a folder: a FANUC cell, a plate of 200 mm, wire of 1.2 mm
/// at 6 m/min, beads of 6 mm, and a joint program with speeds of three decimals for each operation.
/// @param modes modes of the motion: an operation for each, named <strategy>-<mode>
/// @return the project file
inline std::filesystem::path writeEveryStrategy(const std::filesystem::path& folder,
                                                const std::vector<std::string>& modes) {
  createFolder(folder);
  writeFileAtomically(folder / "tube.wsurf", every_strategy::kTube);
  writeFileAtomically(folder / "sheet.wsurf", every_strategy::kSheet);
  writeFileAtomically(folder / "box.stl", every_strategy::box());
  writeFileAtomically(folder / "circles.csv", every_strategy::circles());
  Value operations = Value::array();
  for (const StrategyCase& each : everyStrategy()) {
    for (const std::string& mode : modes) {
      Value operation = Value::object({{"id", each.strategy + "-" + mode},
                                       {"strategy", "wcam.slicing." + each.strategy},
                                       {"substrate", "plate"},
                                       {"process", "steel"},
                                       {"params", parseJson(each.params)},
                                       {"motion", Value::object({{"mode", mode}})}});
      if (each.part == "circles.csv") {
        operation.set("parts", Value::array());
        operation.set("file", Value::object({{"path", each.part}}));
      } else {
        operation.set("parts",
                      Value(Value::Array{Value(each.part.substr(0, each.part.find('.')))}));
      }
      operations.push(operation);
    }
  }
  Value project = parseJson(R"({"format": "wcam-project", "format_version": 1, "name": "every",
      "cell": {"path": "wcam:cells/fanuc_arcmate120ic.json"},
      "parts": [{"id": "tube", "file": {"path": "tube.wsurf"}},
                {"id": "sheet", "file": {"path": "sheet.wsurf"}},
                {"id": "box", "file": {"path": "box.stl"}}],
      "substrates": [{"id": "plate", "type": "plate", "size_mm": [200, 200, 10]}],
      "processes": [{"id": "steel",
                     "params": {"wire_diameter": 1.2, "wire_speed": 6.0, "bead_width": 6.0}}],
      "outputs": [{"id": "robot", "post": "wcam.post.fanuc",
                   "params": {"mode": "joint", "speed_decimals": 3}}]})");
  project.set("operations", operations);
  std::filesystem::path file = folder / "every.wcam";
  writeFileAtomically(file, toCanonicalJson(project));
  return file;
}

}  // namespace wcam::test
