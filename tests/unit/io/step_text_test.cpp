// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_text.hpp"

#include "wcam/base/error.hpp"
#include "wcam/io/import.hpp"

#include "io_files.hpp"
#include "step_tessellation.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iconv.h>

namespace wcam::io {
namespace {

using geometry::Pose;
using geometry::Vec3;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path kTrials = std::filesystem::path(WCAM_TEST_DATA) / "trials";

std::string encoded(const std::string& utf8, const char* encoding) {
  iconv_t handle = iconv_open(encoding, "UTF-8");
  std::string in = utf8;
  std::string out(4 * utf8.size() + 8, '\0');
  char* from = in.data();
  char* to = out.data();
  std::size_t left = in.size();
  std::size_t room = out.size();
  EXPECT_EQ(iconv(handle, &from, &left, &to, &room), 0U) << utf8;
  iconv_close(handle);
  out.resize(out.size() - room);
  return out;
}

TEST(StepText, LegacyEncodingsAreFound) {
  const std::vector<std::array<std::string, 3>> cases{{"GB18030", "GB18030", "海绵2"},
                                                      {"GB18030", "GB18030", "零件 底座"},
                                                      {"GB18030", "GB18030", "焊接夹具-左"},
                                                      {"Shift-JIS", "CP932", "部品"},
                                                      {"Shift-JIS", "CP932", "フランジ 表面"},
                                                      {"EUC-JP", "EUC-JP", "ベース板"},
                                                      {"Big5", "BIG5", "零件底座"},
                                                      {"Windows-1252", "CP1252", "Gehäuse"},
                                                      {"Windows-1252", "CP1252", "Größe Ø20 ±0,1°"},
                                                      {"Windows-1252", "CP1252", "pièce à souder"},
                                                      {"Windows-1251", "CP1251", "Деталь"},
                                                      {"Windows-1251", "CP1251", "корпус насоса"}};
  for (const auto& [name, iconvName, text] : cases) {
    SCOPED_TRACE(text);
    const std::string line = "#9=PRODUCT('" + encoded(text, iconvName.c_str()) + "','',(#3));\n";
    const auto recoded = recodeStep("ISO-10303-21;\n" + line);
    ASSERT_TRUE(recoded);
    EXPECT_EQ(recoded->encoding, name);
    EXPECT_EQ(recoded->text, "ISO-10303-21;\n#9=PRODUCT('" + text + "','',(#3));\n");
    EXPECT_EQ(recoded->strings, 1U);
  }
}

TEST(StepText, AsciiAndUtf8StayAsTheyAre) {
  EXPECT_FALSE(recodeStep("#1=PRODUCT('wall');"));
  EXPECT_FALSE(recodeStep("#1=PRODUCT('Gehäuse 海绵');"));
}

TEST(StepText, UnknownEncodingsAreReplaced) {
  const auto recoded = recodeStep("#1=PRODUCT('a\x81\x8d\x8f\x90\x9d' ,'b');");
  ASSERT_TRUE(recoded);
  EXPECT_THAT(recoded->text, HasSubstr("\xEF\xBF\xBD"));
  for (std::size_t i = 0; i < recoded->text.size(); ++i) {
    EXPECT_NE(recoded->text[i], '\x81');
  }
}

TEST(StepText, CursorAndEntities) {
  const StepEntities entities = stepEntities(
      "HEADER;FILE_NAME('a;b');\n#1=A('it''s; /* no */',(1,(2.5,-3.E1)),.T.,$,*,#2); /* ; #3=X(); "
      "*/"
      "\n#2 = ( B() C(7) );\n");
  ASSERT_EQ(entities.size(), 2U);
  StepCursor cursor(entities.at(1));
  EXPECT_EQ(cursor.keyword(), "A");
  EXPECT_TRUE(cursor.take('('));
  EXPECT_EQ(cursor.string(), "it''s; /* no */");
  EXPECT_TRUE(cursor.take(','));
  EXPECT_TRUE(cursor.skip());
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(cursor.take(','));
    EXPECT_TRUE(cursor.skip());
  }
  EXPECT_TRUE(cursor.take(','));
  EXPECT_EQ(cursor.reference(), 2U);
  EXPECT_TRUE(cursor.take(')'));
}

/// The file of the trials with other names in their place.
ImportedPart readNamed(const std::string& name, const JobContext& context = JobContext()) {
  const TemporaryFolder folder;
  std::string text = test::readBytes(kTrials / "step_name_gb18030.step");
  const std::string old =
      "\xBA\xA3\xC3\xE0"
      "2";
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at)) {
    text.replace(at, old.size(), name);
  }
  test::writeBytes(folder / "a.step", text);
  return importPart(folder / "a.step", {}, Pose::Identity(), context);
}

TEST(StepText, NamesOfTheStandard) {
  for (const auto& [written, name] :
       std::vector<std::pair<std::string, std::string>>{{"\\X2\\6D777EF5\\X0\\2", "海绵2"},
                                                        {"Geh\\X\\E4use", "Gehäuse"},
                                                        {"Geh\\S\\duse", "Gehäuse"},
                                                        {"Gehäuse", "Gehäuse"},
                                                        {"\\X4\\0001F600\\X0\\", "😀"},
                                                        {"it''s", "it's"},
                                                        {"a\\\\b", "a\\b"}}) {
    SCOPED_TRACE(written);
    const ImportedPart part = readNamed(written);
    ASSERT_FALSE(part.report.bodies.empty());
    EXPECT_EQ(part.report.bodies[0].name, name);
  }
}

TEST(StepText, NamesInOtherEncodings) {
  const JobContext context;
  EXPECT_EQ(readNamed(encoded("Gehäuse", "CP1252"), context).report.bodies[0].name, "Gehäuse");
  EXPECT_EQ(context.diagnostics().count("import.names_recoded"), 1U);
  EXPECT_EQ(readNamed(encoded("部品表", "CP932")).report.bodies[0].name, "部品表");
}

TEST(StepText, AssembliesInSeveralFilesAreRefused) {
  const TemporaryFolder folder;
  const std::string text = test::readBytes(kTrials / "step_name_gb18030.step");
  const std::size_t end = text.rfind("ENDSEC;");
  for (const std::string name : {"bolt.stp", "../../secret.STEP", "/etc/part.CATPart"}) {
    std::string assembly = text;
    assembly.insert(end, "#9001=DOCUMENT_TYPE('geometry');\n#9000=DOCUMENT_FILE('" + name +
                             "','',$,#9001,'',$);\n");
    test::writeBytes(folder / "a.step", assembly);
    try {
      importPart(folder / "a.step", {}, Pose::Identity(), JobContext());
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("1 other files"), HasSubstr(name)));
      EXPECT_THAT(error.hintText().str(), HasSubstr("as one file"));
    }
  }
  std::string drawing = text;
  drawing.insert(end, "#9000=DOCUMENT_FILE('drawing.pdf','',$,#9001,'',$);\n");
  EXPECT_TRUE(externalFilesOf(drawing).empty());
}

std::string tessellated(const std::string& items, const std::string& unit) {
  return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AP242'));\nENDSEC;\nDATA;\n"
         "#1=" +
         unit +
         ";\n#2=(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#1)) "
         "REPRESENTATION_CONTEXT('',''));\n"
         "#3=COORDINATES_LIST('',4,((0.,0.,0.),(10.,0.,0.),(0.,10.,0.),(0.,0.,10.)));\n" +
         items + "#50=TESSELLATED_SHAPE_REPRESENTATION('',(#40),#2);\nENDSEC;\nEND-ISO-10303-21;\n";
}

const std::string kMillimetre = "(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))";

TEST(StepTessellation, FacesStripsFansAndIndices) {
  // The tetrahedron's four faces in four ways of writing.
  const std::string items =
      "#10=TRIANGULATED_FACE('',#3,3,(),$,(1,3,2),((1,2,3)));\n"
      "#11=COMPLEX_TRIANGULATED_FACE('',#3,4,(),$,(),((1,2,4)),());\n"
      "#12=COMPLEX_TRIANGULATED_SURFACE_SET('',#3,4,(),(),(),((2,3,4)));\n"
      "#13=TRIANGULATED_SURFACE_SET('',#3,4,(),(),((1,4,3)));\n"
      "#39=TESSELLATED_SHELL('',(#12,#13),$);\n"
      "#40=TESSELLATED_SOLID('corner',(#10,#11,#39),$);\n";
  const std::string file = "a.step";
  const RawMesh raw = parseTessellatedStep(tessellated(items, kMillimetre), file, JobContext());
  EXPECT_EQ(raw.mesh.triangles.size(), 4U);
  EXPECT_TRUE(geometry::HalfEdges(raw.mesh).closed());
  EXPECT_NEAR(test::signedVolume(raw.mesh), 1000.0 / 6.0, 1e-9);
  ASSERT_EQ(raw.bodies.size(), 1U);
  EXPECT_EQ(raw.bodies[0].name, "corner");
}

TEST(StepTessellation, APlacementIsNoItemLeftOutAndTheProductGivesTheName) {
  std::string text = tessellated(
      "#40=COMPLEX_TRIANGULATED_SURFACE_SET('',#3,4,(),(),(),((1,2,3)));\n"
      "#41=AXIS2_PLACEMENT_3D('',#42,$,$);\n#42=CARTESIAN_POINT('',(0.,0.,0.));\n"
      "#60=PRODUCT('id','bracket','',(#61));\n",
      kMillimetre);
  text.replace(text.find("(#40),#2"), 8, "(#41,#40),#2");
  const std::string file = "a.step";
  const JobContext context;
  const RawMesh raw = parseTessellatedStep(text, file, context);
  ASSERT_EQ(raw.bodies.size(), 1U);
  EXPECT_EQ(raw.bodies[0].name, "bracket");
  EXPECT_EQ(context.diagnostics().count("import.tessellation_left_out"), 0U);
}

TEST(StepTessellation, Strips) {
  const std::string items =
      "#40=COMPLEX_TRIANGULATED_SURFACE_SET('',#3,4,(),(),((1,2,3,4)),((1,2,3,4)));\n";
  const std::string file = "a.step";
  const RawMesh raw = parseTessellatedStep(tessellated(items, kMillimetre), file, JobContext());
  ASSERT_EQ(raw.mesh.triangles.size(), 4U);
}

TEST(StepTessellation, UnitsOfTheFile) {
  const std::string items = "#40=TRIANGULATED_FACE('',#3,4,(),$,(),((1,2,3)));\n";
  const std::string file = "a.step";
  const auto scale = [&](const std::string& unit) {
    return parseTessellatedStep(tessellated(items, unit), file, JobContext()).millimetresPerUnit;
  };
  EXPECT_EQ(scale(kMillimetre), 1.0);
  EXPECT_EQ(scale("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.))"), 1000.0);
  EXPECT_NEAR(scale("(CONVERSION_BASED_UNIT('INCH',#60) LENGTH_UNIT() NAMED_UNIT(#61));\n"
                    "#60=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#62);\n"
                    "#62=(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))"),
              25.4, 1e-12);
}

TEST(StepTessellation, DamageNamesTheEntity) {
  const std::string file = "a.step";
  const auto refusal = [&](const std::string& items) -> std::string {
    try {
      parseTessellatedStep(tessellated(items, kMillimetre), file, JobContext());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
      return error.what();
    }
    return "was read";
  };
  EXPECT_THAT(refusal("#40=TRIANGULATED_FACE('',#3,4,(),$,(),((1,2,5)));\n"),
              AllOf(HasSubstr("#40"), HasSubstr("point 5")));
  EXPECT_THAT(refusal("#40=TRIANGULATED_FACE('',#7,4,(),$,(),((1,2,3)));\n"),
              HasSubstr("#7 does not exist"));
  EXPECT_THAT(refusal("#40=TESSELLATED_SOLID('',(#40),$);\n"), HasSubstr("refers to itself"));
  EXPECT_THAT(refusal("#40=TRIANGULATED_FACE('',#3,4,(),$,(),((1,2)));\n"),
              HasSubstr("three corners"));
  EXPECT_THAT(refusal("#40=TESSELLATED_CURVE_SET('',#3,((1,2)));\n"), HasSubstr("no triangles"));
  EXPECT_THAT(refusal("#40=(GEOMETRIC_REPRESENTATION_ITEM() REPOSITIONED_TESSELLATED_ITEM(#1));\n"),
              HasSubstr("placed apart"));
  EXPECT_THAT(refusal("#41=NEXT_ASSEMBLY_USAGE_OCCURRENCE('','','',#1,#2,$);\n"
                      "#40=TRIANGULATED_FACE('',#3,4,(),$,(),((1,2,3)));\n"),
              HasSubstr("assembly"));
}

TEST(StepTessellation, CutOffAnywhereNeverCrashes) {
  const std::string valid = test::readBytes(kTrials / "step_ap242_tessellated.step");
  const std::string file = "a.step";
  for (std::size_t size = 0; size < valid.size(); size += 3) {
    try {
      parseTessellatedStep(valid.substr(0, size), file, JobContext());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    }
  }
}

}  // namespace
}  // namespace wcam::io
