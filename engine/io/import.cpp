// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/io/import.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/sha256.hpp"

#include "cad_process.hpp"
#include "file_bytes.hpp"
#include "file_format.hpp"
#include "mesh_readers.hpp"
#include "part_builder.hpp"
#include "step_tessellation.hpp"
#include "step_text.hpp"
#include "stl_parser.hpp"

namespace wcam::io {

namespace {

/// Raised whenever the same file gives another result, so that cached stages are computed anew.
constexpr std::int64_t kImportVersion = 2;
/// Rounding that a pose read from a file may carry.
constexpr double kRigidTolerance = 1e-9;

void requireRigid(const geometry::Pose& T_part_file) {
  const Eigen::Matrix3d r = T_part_file.linear();
  const bool rigid = T_part_file.matrix().allFinite() &&
                     (r * r.transpose() - Eigen::Matrix3d::Identity()).norm() < kRigidTolerance &&
                     r.determinant() > 0.0;
  if (!rigid) {
    throw Error(ErrorCode::InvalidArgument, "the placement is not a rotation and a translation",
                "part placement");
  }
}

std::string contentHash(std::string_view bytes,
                        const ImportOptions& options,
                        const geometry::Pose& T_part_file) {
  Sha256 hash;
  hash.text("wcam import").integer(kImportVersion);
  hash.integer(static_cast<std::int64_t>(bytes.size())).bytes(bytes.data(), bytes.size());
  hash.number(options.chordTolerance.value()).number(options.angularTolerance.value());
  hash.integer(static_cast<std::int64_t>(options.unit)).number(options.weldTolerance.value());
  hash.integer(options.repair ? 1 : 0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      hash.number(T_part_file.matrix()(row, column) + 0.0);
    }
  }
  return hash.hex();
}

bool isCad(FileFormat format) {
  return format == FileFormat::Step || format == FileFormat::Iges ||
         format == FileFormat::BrepText || format == FileFormat::BrepBinary ||
         format == FileFormat::Formula;
}

RawMesh readStl(std::string_view bytes, const ImportJob& job, const JobContext& context) {
  ParsedMesh parsed = parseStl(bytes, job.fileText, context);
  addCounted(
      context, Severity::Warning, "import.trailing_bytes", parsed.trailingBytes,
      text("%1 bytes after the last triangle are ignored", {std::to_string(parsed.trailingBytes)}),
      "check that the part is complete");
  addCounted(context, Severity::Warning, "import.end_missing", parsed.endMissing ? 1 : 0,
             "the file ends without its last line and may be cut off",
             "check that the part is complete");
  RawMesh raw;
  raw.mesh = std::move(parsed.mesh);
  raw.weldedPoints = parsed.weldedPoints;
  raw.bodies.push_back({parsed.name, "mesh", {}, 0});
  return raw;
}

/// Parts of an assembly in other files would have to be found, and their changes noticed: refused.
void requireOneFile(std::string_view bytes, const ImportJob& job) {
  const std::vector<std::string> files = externalFilesOf(bytes);
  if (!files.empty()) {
    throw Error(ErrorCode::InputInvalid,
                text("is an assembly whose parts stand in %1 other files, the first is '%2'",
                     {std::to_string(files.size()), files.front()}),
                job.fileText, "export the assembly as one file");
  }
}

/// True for a file that has triangles where other STEP files have exact faces.
bool isTessellated(std::string_view bytes, const ImportJob& job, const JobContext& context) {
  if (job.format != FileFormat::Step) {
    return false;
  }
  requireOneFile(bytes, job);
  const Tessellation tessellation = tessellationOf(bytes);
  addCounted(context, Severity::Information, "import.tessellation_left_out",
             tessellation == Tessellation::Beside ? 1 : 0,
             "the STEP file has tessellated shapes beside exact ones; the exact ones are read",
             "check that the part is complete");
  return tessellation == Tessellation::Only;
}

RawMesh readMesh(std::string_view bytes, const ImportJob& job, const JobContext& context) {
  switch (job.format) {
    case FileFormat::Stl:
      return readStl(bytes, job, context);
    case FileFormat::Obj:
      return parseObj(bytes, job.fileText, context);
    case FileFormat::Step:
      return parseTessellatedStep(bytes, job.fileText, context);
    case FileFormat::Ply:
      return parsePly(bytes, job.fileText, context);
    default:
      return parseThreeMf(bytes, job.fileText, context);
  }
}

}  // namespace

const Schema<ImportOptions>& importOptionsSchema() {
  static const Schema<ImportOptions> schema = [] {
    Schema<ImportOptions> s;
    s.add(&ImportOptions::chordTolerance,
          {.key = "chord_tolerance",
           .label = "Chord tolerance",
           .help = "Largest distance of the triangles from the exact surface of a CAD part. "
                   "Contours are moved onto the exact surface afterwards.",
           .group = "Import",
           .min = 0.0001,
           .max = 100.0});
    s.add(&ImportOptions::angularTolerance,
          {.key = "angular_tolerance",
           .label = "Angular tolerance",
           .help = "Largest angle between the directions of neighbouring edges of the triangles "
                   "of a CAD part.",
           .group = "Import",
           .min = 0.5,
           .max = 60.0});
    s.add(&ImportOptions::unit, {.key = "unit",
                                 .label = "Unit",
                                 .help = "Unit of files that do not tell it (STL, OBJ, PLY, BREP). "
                                         "auto: metres when the part is smaller than 2 units, "
                                         "else millimetres.",
                                 .group = "Import",
                                 .choices = {{"auto", "Automatic"},
                                             {"mm", "Millimetres"},
                                             {"cm", "Centimetres"},
                                             {"m", "Metres"},
                                             {"in", "Inches"}}});
    s.add(&ImportOptions::weldTolerance,
          {.key = "weld_tolerance",
           .label = "Weld tolerance",
           .help = "Gaps up to this width are closed: between borders of a mesh, and between CAD "
                   "faces that share no edge. 0 chooses it from the precision of the file.",
           .group = "Import",
           .level = ParamLevel::Advanced,
           .min = 0.0,
           .max = 10.0});
    s.add(&ImportOptions::repair,
          {.key = "repair",
           .label = "Repair",
           .help = "Joins borders, drops degenerate and duplicate triangles, and turns triangles "
                   "so that all normals agree.",
           .group = "Import",
           .level = ParamLevel::Advanced});
    return s;
  }();
  return schema;
}

ImportedPart importPart(const std::filesystem::path& file,
                        const ImportOptions& options,
                        const geometry::Pose& T_part_file,
                        const JobContext& context) {
  requireRigid(T_part_file);
  context.check();
  ImportedPart part;
  auto bytes = std::make_unique<FileBytes>(file, context.portion(0.0, 0.05, "Reading file"));
  const ImportJob job{file, pathText(file), detectFormat(file, bytes->view()), options,
                      T_part_file};
  part.report.file = pathText(file.filename());
  part.report.format = toString(job.format);
  const std::string hash = contentHash(bytes->view(), options, T_part_file);
  geometry::PartSurface surface;
  if (isCad(job.format) && !isTessellated(bytes->view(), job, context)) {
    surface = buildCadPartApart(bytes->view(), job, part.report,
                                context.portion(0.05, 0.95, "Reading CAD part"));
  } else {
    RawMesh raw = readMesh(bytes->view(), job, context.portion(0.05, 0.5, "Reading mesh"));
    bytes.reset();
    surface = buildMeshPart(std::move(raw), job, part.report,
                            context.portion(0.5, 0.95, "Repairing mesh"));
  }
  surface.hash = hash;
  measure(surface, part.report, context);
  part.surface = std::make_shared<const geometry::PartSurface>(std::move(surface));
  context.report(1.0);
  return part;
}

}  // namespace wcam::io
