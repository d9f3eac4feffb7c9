// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Files as people really have them: what each of tests/data/trials is read as, or refused for.
#include "wcam/base/error.hpp"
#include "wcam/io/import.hpp"

#include "io_files.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wcam::io {
namespace {

using geometry::Pose;
using geometry::Vec3;
using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path kTrials = std::filesystem::path(WCAM_TEST_DATA) / "trials";

struct Read {
  ImportedPart part;
  std::vector<Diagnostic> findings;

  [[nodiscard]] const Diagnostic* finding(const std::string& code) const {
    for (const Diagnostic& d : findings) {
      if (d.code == code) {
        return &d;
      }
    }
    return nullptr;
  }
};

Read readTrial(const std::string& name) {
  const JobContext context;
  Read read;
  read.part = importPart(kTrials / name, {}, Pose::Identity(), context);
  read.findings = context.diagnostics().items();
  return read;
}

/// What is said of a file that is refused: message, place and remedy.
std::string refusalOf(const std::string& name) {
  try {
    readTrial(name);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    EXPECT_FALSE(error.hintText().empty()) << name;
    return std::string(error.what()) + " | " + error.hintText().str();
  }
  ADD_FAILURE() << name << " was read";
  return {};
}

/// 20 × 30 × 40 mm, 12 triangles, closed.
void expectBox(const ImportReport& report) {
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(report.triangles, 12U);
  EXPECT_EQ(report.vertices, 8U);
  EXPECT_NEAR(report.volume.value_or(0.0), 24000.0, 1e-6);
  EXPECT_NEAR((report.bounds.max - report.bounds.min - Vec3(20, 30, 40)).norm(), 0.0, 1e-9);
}

class TrialBox : public testing::TestWithParam<const char*> {};

TEST_P(TrialBox, IsRead) {
  expectBox(readTrial(GetParam()).part.report);
}

INSTANTIATE_TEST_SUITE_P(Files,
                         TrialBox,
                         testing::Values("stl_end_loop.stl",
                                         "stl_ansa_color.stl",
                                         "stl_ctrl_z.stl",
                                         "stl_one_line.stl",
                                         "stl_bom.stl",
                                         "bin_solid_trailing.stl",
                                         "obj_faces_first.obj",
                                         "obj_continued_no_space.obj",
                                         "obj_cr_only.obj",
                                         "obj_curv2_freeform.obj",
                                         "ply_tristrips_be.ply",
                                         "ply_msvc_nan_normals.ply",
                                         "ply_edge_faces.ply",
                                         "3mf_beams_and_mesh.3mf",
                                         "3mf_not_printable.3mf",
                                         "step_ap242_tessellated.step"),
                         [](const auto& name) {
                           std::string text = name.param;
                           std::replace(text.begin(), text.end(), '.', '_');
                           return "File_" + text;
                         });

TEST(TrialFiles, WhatIsLeftOutIsTold) {
  EXPECT_NE(readTrial("bin_solid_trailing.stl").finding("import.trailing_bytes"), nullptr);
  EXPECT_NE(readTrial("ply_edge_faces.ply").finding("import.edges_left_out"), nullptr);
  EXPECT_NE(readTrial("obj_curv2_freeform.obj").part.surface, nullptr);
  EXPECT_NE(readTrial("step_ap242_tessellated.step").finding("import.tessellated"), nullptr);
  const Read beams = readTrial("3mf_beams_and_mesh.3mf");
  const Diagnostic* lattice = beams.finding("import.beam_lattice_left_out");
  ASSERT_NE(lattice, nullptr);
  EXPECT_EQ(lattice->severity, Severity::Warning);
  EXPECT_THAT(lattice->message.str(), HasSubstr("1 beam lattice is left out (beams: 1)"));
  const Read items = readTrial("3mf_not_printable.3mf");
  ASSERT_NE(items.finding("import.not_printable"), nullptr);
  EXPECT_EQ(items.part.report.bodies.size(), 1U);
}

TEST(TrialFiles, AnotherKindOfFileIsNamed) {
  EXPECT_THAT(refusalOf("html_saved_as.stl"), AllOf(HasSubstr("an HTML page"), HasSubstr("STL"),
                                                    HasSubstr("download the file itself")));
  EXPECT_THAT(refusalOf("pdf_then_stl.stl"), HasSubstr("a PDF document"));
  EXPECT_THAT(refusalOf("stl_two_line_header.stl"),
              AllOf(HasSubstr("line 2"), HasSubstr("exported")));
  EXPECT_THAT(refusalOf("ply_points_scan.ply"), HasSubstr("a point cloud of 8 points"));
}

TEST(TrialFiles, NegativeVolumesAreCutOut) {
  const Read read = readTrial("3mf_prusa_negative.3mf");
  EXPECT_TRUE(read.part.report.closed);
  EXPECT_NEAR(read.part.report.volume.value_or(0.0), 13500.0, 1e-6);
  EXPECT_EQ(read.part.report.bodies.size(), 1U);
  EXPECT_EQ(read.part.report.bodies[0].name, "body");
  const Diagnostic* cut = read.finding("import.negative_cut");
  ASSERT_NE(cut, nullptr);
  EXPECT_THAT(cut->message.str(), HasSubstr("cutter"));
}

TEST(TrialFiles, EscapesInPartNames) {
  const ImportReport report = readTrial("3mf_space_in_part_name.3mf").part.report;
  EXPECT_NEAR((report.bounds.max - report.bounds.min - Vec3(25.4, 50.8, 76.2)).norm(), 0.0, 1e-9);
  EXPECT_EQ(report.unit, "inch");
}

TEST(TrialFiles, StepNamesInGb18030) {
  const Read read = readTrial("step_name_gb18030.step");
  ASSERT_FALSE(read.part.report.bodies.empty());
  EXPECT_EQ(read.part.report.bodies[0].name, "海绵2");
  const Diagnostic* recoded = read.finding("import.names_recoded");
  ASSERT_NE(recoded, nullptr);
  EXPECT_THAT(recoded->message.str(), HasSubstr("GB18030"));
  EXPECT_NEAR(read.part.report.volume.value_or(0.0), 24000.0, 1e-6);
}

TEST(TrialFiles, OverlapsCountOnce) {
  const Read boxes = readTrial("two_boxes_overlap.stl");
  EXPECT_TRUE(boxes.part.report.closed);
  EXPECT_EQ(boxes.part.report.components, 1U);
  EXPECT_NEAR(boxes.part.report.volume.value_or(0.0), 56000.0, 1e-6);
  EXPECT_NEAR(boxes.part.report.overlap, 8000.0, 1e-6);
  const Diagnostic* overlap = boxes.finding("import.overlapping_bodies");
  ASSERT_NE(overlap, nullptr);
  EXPECT_THAT(overlap->message.str(),
              AllOf(HasSubstr("2 bodies overlap by 8000.0 mm³"), HasSubstr("(30.0, 30.0, 10.0)")));
  const Read shell = readTrial("void_inside_same_way.stl");
  EXPECT_EQ(shell.part.report.components, 1U);
  EXPECT_NEAR(shell.part.report.volume.value_or(0.0), 144000.0, 1e-6);
  const Diagnostic* inner = shell.finding("import.inner_shell_outwards");
  ASSERT_NE(inner, nullptr);
  EXPECT_THAT(inner->message.str(), HasSubstr("1 shells inside others (18000.0 mm³"));
}

TEST(TrialFiles, NumbersBeyondMeasureAreRefusedWithTheirPlace) {
  EXPECT_THAT(refusalOf("exit2_overflow.obj"),
              AllOf(HasSubstr("line 6"), HasSubstr("-1e308"), HasSubstr("too large")));
  EXPECT_THAT(refusalOf("exit2.3mf"), AllOf(HasSubstr("3dmodel.model"), HasSubstr("line 1"),
                                            HasSubstr("1e200"), HasSubstr("too large")));
  EXPECT_THAT(refusalOf("exit2.step"), AllOf(HasSubstr("exit2.step"), HasSubstr("face 0")));
  EXPECT_THAT(refusalOf("decimal_comma.wsurf"),
              AllOf(HasSubstr("position 3"), HasSubstr("write 32.5")));
}

}  // namespace
}  // namespace wcam::io
