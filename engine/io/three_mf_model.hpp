// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"

#include "three_mf_package.hpp"

#include <map>
#include <string>
#include <vector>

namespace wcam::io {

/// Row vectors are used in the file: [x y z 1]·M, M of 4 rows and 3 columns.
using ThreeMfTransform = Eigen::Matrix<double, 4, 3>;

ThreeMfTransform identityTransform();

/// b after a.
ThreeMfTransform compose(const ThreeMfTransform& a, const ThreeMfTransform& b);

/// Reference to an object, with the model part it stands in ("" for the same).
struct ThreeMfReference {
  std::string part;
  std::string id;
  ThreeMfTransform transform = identityTransform();
  bool printable = true;
};

/// What a body is for; slicers keep other bodies than those to build in the same package.
enum class BodyRole { Solid, Negative, Helper };

/// Triangles of an object that belong together, by their numbers.
struct ThreeMfVolume {
  std::size_t first = 0;
  std::size_t last = 0;
  std::string name;
  BodyRole role = BodyRole::Solid;
};

struct ThreeMfObject {
  std::string name;
  std::string type;
  std::string property;
  std::size_t propertyIndex = 0;
  BodyRole role = BodyRole::Solid;
  geometry::TriangleMesh mesh;
  std::size_t weldedPoints = 0;
  std::size_t beams = 0;
  std::vector<ThreeMfReference> components;
};

struct ThreeMfModel {
  std::string unit = "millimeter";
  double millimetresPerUnit = 1.0;
  std::map<std::string, ThreeMfObject> objects;
  std::map<std::string, std::vector<std::string>> colours;  ///< of base materials
  std::vector<ThreeMfReference> items;
  /// Extensions that describe shapes and are not read, with the number of their elements.
  std::map<std::string, std::size_t> unreadExtensions;
};

/// Reads a model part. Required extensions that are not known are refused.
/// @throws Error(InputInvalid) naming the part and the line
ThreeMfModel parseThreeMfModel(const Package& package,
                               const std::string& part,
                               const JobContext& context);

/// What slicers write beside the model: volumes of the objects of the root model part (PrusaSlicer
/// and its kin), and roles of their components (Bambu Studio, OrcaSlicer).
struct SlicerSettings {
  std::map<std::string, std::vector<ThreeMfVolume>> volumes;  ///< by object
  /// By object and component.
  std::map<std::pair<std::string, std::string>, ThreeMfVolume> components;
};

SlicerSettings readSlicerSettings(const Package& package, const JobContext& context);

}  // namespace wcam::io
