// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/param.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/value.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/geometry/solid_wall.hpp"
#include "wcam/geometry/types.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wcam::io {

/// Unit of a file that does not say it (STL, OBJ, PLY, BREP).
enum class FileUnit { Auto, Millimetre, Centimetre, Metre, Inch };

/// How a part is read. Every field is part of the content hash.
struct ImportOptions {
  Length chordTolerance{0.05};  ///< CAD: triangles to exact surface, met within a factor of 2
  Angle angularTolerance{degToRad(15.0)};  ///< CAD: between the normals of neighbouring points
  FileUnit unit = FileUnit::Auto;
  /// Gap that is closed between borders (mesh) or faces without common edges (CAD); 0 chooses one
  /// from the precision of the file's numbers.
  Length weldTolerance{0.0};
  bool repair = true;
};

/// The parameters of an import: keys chord_tolerance, angular_tolerance, unit, weld_tolerance,
/// repair.
const Schema<ImportOptions>& importOptionsSchema();

/// A body of the file: a solid, a shell or a free curve with the name and colour it has there.
struct ImportedBody {
  std::string name;
  std::string kind;    ///< "solid", "shell", "face", "wire", "edge", "compound" or "mesh"
  std::string colour;  ///< "#RRGGBB" (sRGB), empty when the file gives none
  int faces = 0;       ///< CAD faces; 0 in a mesh file
};

/// A loop of edges with material on one side only.
struct BorderLoop {
  double length = 0.0;  ///< mm
  std::size_t vertices = 0;
  geometry::Vec3 start = geometry::Vec3::Zero();  ///< a point on it, part frame
};

/// What came in and what was done to it; lengths in mm, part frame.
struct ImportReport {
  std::string file;
  std::string format;  ///< "STEP", "IGES", "BREP", "STL", "OBJ", "PLY", "3MF" or "formula"
  std::string unit;    ///< "mm", "cm", "m", "in", ... as read
  Text unitReason;     ///< why this unit
  double millimetresPerUnit = 1.0;
  std::vector<ImportedBody> bodies;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  int faces = 0;      ///< CAD faces
  int edges = 0;      ///< CAD edges with a face
  int freeEdges = 0;  ///< CAD edges without a face: possible guide curves
  /// Formula surfaces: largest measured distance of the exact surface from the formulas, mm.
  std::optional<double> formulaDeviation;
  bool closed = false;
  std::size_t components = 0;  ///< pieces that no common edge joins
  std::vector<BorderLoop> borders;
  std::size_t nonManifoldEdges = 0;
  std::size_t weldedVertices = 0;       ///< corners and border points joined to another
  std::size_t degenerateTriangles = 0;  ///< dropped
  std::size_t flatTriangles = 0;        ///< without area but needed for the connection: kept
  std::size_t duplicateTriangles = 0;   ///< dropped
  std::size_t reorientedTriangles = 0;
  geometry::Box bounds;
  double area = 0.0;             ///< mm², of the triangles
  std::optional<double> volume;  ///< mm³, of the triangles, when closed; overlaps count once
  double overlap = 0.0;          ///< mm³ that more than one body of the file filled
  bool overlapsUnited = false;   ///< these bodies are one in the surface

  /// The report as an object with unit-bearing keys; at most 100 border loops are listed.
  [[nodiscard]] Value toValue() const;
};

struct ImportedPart {
  std::shared_ptr<const geometry::PartSurface> surface;
  ImportReport report;
  /// Of a working surface that is one side of a solid wall; filled by who chooses it.
  std::optional<geometry::WallThickness> wallThickness;
};

/// Reads a part: STEP, IGES, BREP and formula surfaces (.wsurf) with their exact geometry; STL,
/// OBJ, PLY and 3MF as meshes.
///
/// The format is taken from the content, else from the extension. `T_part_file` places the file in
/// the part frame; it is applied to mesh and exact geometry alike. Triangles are oriented
/// consistently, outwards where the part is closed. The surface's hash covers the bytes of the
/// file, the options and the placement.
///
/// Findings (codes import.*): units_guessed, welded, degenerate_dropped, flat_triangles,
/// duplicate_dropped, reoriented, open_surface, non_manifold, no_solid, sewn, face_not_meshed,
/// damaged_entities, trailing_bytes, end_missing, reader_message, names_recoded, tessellated,
/// tessellation_left_out, edges_left_out, free_form_left_out, other_file_left_out,
/// overlapping_bodies, inner_shell_outwards, and for 3MF not_printable, support_left_out,
/// other_left_out, modifier_left_out, beam_lattice_left_out, extension_left_out, negative_cut,
/// negative_left_out.
///
/// CAD files are read in a process of their own (wcam-cad-worker beside the engine library), so
/// that a damaged file cannot harm this one and a cancel is answered at once. Safe to call from
/// several threads.
/// @throws Error(InputNotFound) for a missing file; Error(InputInvalid) naming the file and the
///   place for one that cannot be understood or used; Error(InvalidArgument) for a placement that
///   is not rigid; CancelledError
ImportedPart importPart(const std::filesystem::path& file,
                        const ImportOptions& options,
                        const geometry::Pose& T_part_file,
                        const JobContext& context);

/// Extensions that importPart knows, lower case with the dot, for file dialogs.
const std::vector<std::string>& importExtensions();

}  // namespace wcam::io
