// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"
#include "wcam/io/import.hpp"

#include "file_format.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace wcam::geometry {
struct Overlaps;
}

namespace wcam::io {

/// What the steps of one import share.
struct ImportJob {
  const std::filesystem::path& file;
  std::string fileText;  ///< for messages
  FileFormat format;
  const ImportOptions& options;
  const geometry::Pose& T_part_file;
};

/// A mesh as it came from a mesh file, in file units and frame.
struct RawMesh {
  geometry::TriangleMesh mesh;
  std::vector<ImportedBody> bodies;
  std::size_t weldedPoints = 0;
  std::string unit;                 ///< of formats that tell it, else empty
  double millimetresPerUnit = 1.0;  ///< when `unit` is told
  /// Smallest difference of coordinates that the file's numbers can tell, relative to their size.
  double relativePrecision = 1e-7;
};

/// Scales, places, repairs and measures a mesh.
geometry::PartSurface buildMeshPart(RawMesh raw,
                                    const ImportJob& job,
                                    ImportReport& report,
                                    const JobContext& context);

/// Reads a CAD file and tessellates it.
geometry::PartSurface buildCadPart(std::string_view bytes,
                                   const ImportJob& job,
                                   ImportReport& report,
                                   const JobContext& context);

/// Millimetres per unit of an option; `Auto` is not allowed.
double millimetresPer(FileUnit unit);
const char* unitName(FileUnit unit);

/// Fills in what is measured on the finished surface, and adds the findings that follow from it.
void measure(const geometry::PartSurface& surface, ImportReport& report, const JobContext& context);

/// Adds the findings about bodies that overlap.
void tellOverlaps(const geometry::Overlaps& overlaps, bool united, const JobContext& context);

/// Adds a finding about `count` things; nothing when it is 0.
void addCounted(const JobContext& context,
                Severity severity,
                const char* code,
                std::size_t count,
                const Text& message,
                const Text& remedy = {});

}  // namespace wcam::io
