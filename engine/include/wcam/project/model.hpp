// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/value.hpp"
#include "wcam/geometry/solid_wall.hpp"
#include "wcam/geometry/types.hpp"
#include "wcam/toolpath/edits.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::project {

/// Start of a path to a file that comes with the program: "wcam:cells/fanuc_arcmate120ic.json".
inline constexpr const char* kShippedPrefix = "wcam:";

/// A file that a project uses. `path` is relative to the project file, with '/' separators; an
/// empty `sha256` means that the content is not pinned.
struct FileRef {
  std::string path;
  std::string sha256;

  [[nodiscard]] bool empty() const noexcept { return path.empty(); }

  friend bool operator==(const FileRef&, const FileRef&) = default;
};

/// Where something stands, in file units: mm, and the Bryant angles of rotations about the moving
/// axes x, y, z in this order (R = Rx·Ry·Rz), degrees.
struct Placement {
  std::array<double, 3> positionMm{};
  std::array<double, 3> rotationDeg{};
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// The same as a rigid pose, mm.
geometry::Pose toPose(const Placement& placement);
/// The Bryant angles of a pose; where the middle angle is ±90° the third is 0.
Placement toPlacement(const geometry::Pose& pose);

/// An imported part. `import` follows the schema of wcam::io::ImportOptions.
struct Part {
  std::string id;
  FileRef file;
  Value import;
  Placement placement;
  std::vector<int> faces;  ///< faces of the working surface; empty: all
  /// Side of a solid wall that is worked on; nothing: the surface as it is.
  std::optional<geometry::WallSide> wallSide;
};

/// The side that a word of wallSideWords names; nothing for "whole".
std::optional<geometry::WallSide> wallSideOf(const std::string& word);
/// What a part's key "surface" may say: whole, outer, inner, middle.
const std::vector<std::string>& wallSideWords();

/// What a part is built on: a plate whose top is z = 0 of its frame, or an imported part.
struct Substrate {
  enum class Type { Plate, Part };
  std::string id;
  Type type = Type::Plate;
  Placement placement;
  std::array<double, 3> sizeMm{};  ///< length, width, thickness of a plate
  std::string part;                ///< id of the part, for Type::Part
};

/// A guide curve: an edge of a CAD part (by index or by name), a polyline file, or formulas of t.
struct Guide {
  enum class Type { Edge, Polyline, Formula };
  std::string id;
  Type type = Type::Edge;
  std::string part;
  int edge = -1;         ///< -1 when the edge is given by name
  std::string edgeName;  ///< empty when the edge is given by index
  bool reversed = false;
  FileRef file;
  std::array<std::string, 3> formulas;  ///< x(t), y(t), z(t), mm
  double begin = 0.0;
  double end = 1.0;
};

/// Parameters of the deposition process: from a file, inline, or both (inline ones win).
struct Process {
  std::string id;
  FileRef file;
  Value params;
};

/// A change of the toolpath that an operation generates, see wcam/toolpath/edits.hpp.
struct OperationEdit {
  std::string id;  ///< unique in the operation
  toolpath::EditType type = toolpath::EditType::MoveSeam;
  bool enabled = true;
  Value params;
};

/// A strategy applied to parts on a substrate. The parameter objects are sparse; their schemas
/// belong to the strategy (params), to the path stage (path) and to the motion stage (motion).
struct Operation {
  std::string id;
  std::string strategy;
  std::vector<std::string> parts;
  std::string substrate;
  std::string guide;  ///< empty: none
  FileRef file;       ///< table of a path that was planned elsewhere; empty: none
  std::string process;
  Value params;
  Value path;
  Value motion;
  std::vector<OperationEdit> edits;  ///< in the order in which they are applied
  bool enabled = true;
};

/// A stored job: what `camcli --project` writes without further flags.
struct Output {
  std::string id;
  std::string post;
  std::vector<std::string> operations;  ///< empty: all enabled ones
  Value params;
  std::string folder;  ///< below the output folder; empty: the output folder itself
};

/// A plugin that the project needs.
struct PluginRef {
  std::string id;
  std::string version;  ///< empty: any
};

/// Typed view of a project file, read-only. Derived data never enters it.
struct Project {
  int formatVersion = 0;
  std::string name;
  FileRef cell;  ///< empty: none chosen yet
  std::vector<Part> parts;
  std::vector<Substrate> substrates;
  std::vector<Guide> guides;
  std::vector<Process> processes;
  std::vector<Operation> operations;
  std::vector<Output> outputs;
  std::vector<PluginRef> plugins;

  /// Node by id, or null.
  [[nodiscard]] const Part* part(std::string_view id) const noexcept;
  [[nodiscard]] const Substrate* substrate(std::string_view id) const noexcept;
  [[nodiscard]] const Guide* guide(std::string_view id) const noexcept;
  [[nodiscard]] const Process* process(std::string_view id) const noexcept;
  [[nodiscard]] const Operation* operation(std::string_view id) const noexcept;
  [[nodiscard]] const Output* output(std::string_view id) const noexcept;
};

}  // namespace wcam::project
