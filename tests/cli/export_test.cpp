// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What an export writes: the public format of tables and report, at the numbers of the elbow
// (quarter torus R 50, r 15 about (-50, 0, 0), Chalvin P4).
#include "camcli.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;

constexpr double kGuideRadius = 50.0;
constexpr double kTubeRadius = 15.0;
constexpr double kStep = 5.0;
/// The tables print figures with six decimals.
constexpr double kPrinted = 1e-6;

class Export : public CamcliTest {
protected:
  void SetUp() override {
    const ProcessResult result = camcli({"--project", (exampleFolder("elbow") / "elbow.wcam"),
                                         "--output", "out", "--table", "--quiet"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
  }

  Value report() const { return parseJson(readFile(folder_ / "out/report.json")); }
};

double distanceToTorus(double x, double y, double z) {
  return std::abs(std::hypot(std::hypot(x + kGuideRadius, z) - kGuideRadius, y) - kTubeRadius);
}

/// Section of a wall of stacked discs (Diourté M26): a disc of the bead's width between two planes
/// of the layer's height.
double discSection(double height, double width) {
  const double cut = std::min(height, width);
  return 0.5 * cut * std::sqrt(width * width - cut * cut) +
         0.5 * width * width * std::asin(cut / width);
}

double wireArea() {
  constexpr double kWireDiameter = 1.2;
  return 0.25 * std::numbers::pi * kWireDiameter * kWireDiameter;
}

TEST_F(Export, WritesProgramsTablesAndReport) {
  std::set<std::string> names;
  for (const auto& [name, content] : filesBelow(folder_ / "out")) {
    names.insert(name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"fanuc/GUIDE.LS", "fanuc/PLANAR.LS", "guide.csv",
                                          "planar.csv", "report.json"}));
}

TEST_F(Export, TableHasTheHeaderOfTheFormat) {
  const std::string expected =
      "op,layer,bead,point,x_mm,y_mm,z_mm,nx,ny,nz,bx,by,bz,ax,ay,az,height_mm,width_mm,"
      "speed_mm_s,wire_m_min,arc,time_s,tcp_speed_mm_s,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg,"
      "j7_deg,j8_deg";
  for (const char* name : {"planar", "guide"}) {
    const Table table = readTable(folder_ / ("out/" + std::string(name) + ".csv"));
    EXPECT_EQ(table.header, expected);
    ASSERT_FALSE(table.rows.empty());
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      EXPECT_EQ(table.rows[i][0], name);
      for (std::size_t c = 1; c < table.columns.size(); ++c) {
        EXPECT_TRUE(std::isfinite(table.number(i, table.columns[c]))) << table.columns[c];
      }
    }
  }
}

TEST_F(Export, EveryPointIsOnTheExactTorus) {
  const Table planar = readTable(folder_ / "out/planar.csv");
  double farthest = 0.0;
  double offPlane = 0.0;
  for (std::size_t i = 0; i < planar.rows.size(); ++i) {
    farthest =
        std::max(farthest, distanceToTorus(planar.number(i, "x_mm"), planar.number(i, "y_mm"),
                                           planar.number(i, "z_mm")));
    const double z = kStep * (planar.number(i, "layer") + 1.0);
    offPlane = std::max(offPlane, std::abs(planar.number(i, "z_mm") - z));
  }
  EXPECT_LE(farthest, 1e-9);
  EXPECT_LE(offPlane, 1e-9);
  const Table guide = readTable(folder_ / "out/guide.csv");
  farthest = 0.0;
  for (std::size_t i = 0; i < guide.rows.size(); ++i) {
    farthest = std::max(farthest, distanceToTorus(guide.number(i, "x_mm"), guide.number(i, "y_mm"),
                                                  guide.number(i, "z_mm")));
  }
  EXPECT_LE(farthest, 1e-9);
}

TEST_F(Export, PlanarLayersAreClosedUpToTheSeventh) {
  const Table table = readTable(folder_ / "out/planar.csv");

  struct Ends {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  std::map<int, Ends> layers;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_EQ(table.number(i, "bead"), 0.0);
    const int layer = static_cast<int>(table.number(i, "layer"));
    layers.try_emplace(layer, Ends{i, i}).first->second.last = i;
  }
  ASSERT_EQ(layers.size(), 12U);
  for (const auto& [layer, ends] : layers) {
    const auto gap = std::hypot(table.number(ends.first, "x_mm") - table.number(ends.last, "x_mm"),
                                table.number(ends.first, "y_mm") - table.number(ends.last, "y_mm"));
    if (layer < 7) {
      EXPECT_EQ(gap, 0.0) << "layer " << layer;
    } else {
      EXPECT_GT(gap, kTubeRadius) << "layer " << layer;
    }
  }
}

TEST_F(Export, FramesAreUnitAndRightAngled) {
  for (const char* name : {"planar", "guide"}) {
    const Table table = readTable(folder_ / ("out/" + std::string(name) + ".csv"));
    const auto vector = [&](std::size_t row, const std::string& letter) {
      return std::array{table.number(row, letter + "x"), table.number(row, letter + "y"),
                        table.number(row, letter + "z")};
    };
    const auto dot = [](const auto& a, const auto& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const auto n = vector(i, "n");
      const auto b = vector(i, "b");
      const auto a = vector(i, "a");
      // Nine decimals are printed.
      ASSERT_NEAR(dot(n, n), 1.0, 1e-8);
      ASSERT_NEAR(dot(b, b), 1.0, 1e-8);
      ASSERT_NEAR(dot(a, a), 1.0, 1e-8);
      ASSERT_NEAR(dot(n, b), 0.0, 1e-8);
    }
  }
}

TEST_F(Export, SpeedTimesSectionIsTheWire) {
  constexpr double kMmPerSecond = 1000.0 / 60.0;
  for (const char* name : {"planar", "guide"}) {
    const Table table = readTable(folder_ / ("out/" + std::string(name) + ".csv"));
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const double section = discSection(table.number(i, "height_mm"), table.number(i, "width_mm"));
      const double wire = wireArea() * table.number(i, "wire_m_min") * kMmPerSecond;
      const double speed = table.number(i, "speed_mm_s");
      ASSERT_NEAR(speed * section, wire, wire * 4.0 * kPrinted) << name << " row " << i;
    }
  }
}

TEST_F(Export, DepositedVolumeIsWireVolume) {
  const Value tree = report();
  for (const Value& operation : tree.at("operations").asArray()) {
    const double volume = operation.at("deposited_volume_mm3").asReal();
    EXPECT_GT(volume, 0.0);
    EXPECT_NEAR(operation.at("wire_length_m").asReal() * 1000.0 * wireArea(), volume,
                1e-9 * volume);
    EXPECT_NEAR(operation.at("wanted_volume_mm3").asReal(), volume, 1e-9 * volume);
    // The same from the table: every move lays its length times the mean of the sections at its
    // ends; the planner may take another mean, so only nearly.
    const Table table = readTable(folder_ / ("out/" + operation.at("id").asString() + ".csv"));
    double laid = 0.0;
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
      if (table.rows[i][table.column("arc")] != "1") {
        continue;
      }
      const auto move = [&](const char* axis) {
        return table.number(i, axis) - table.number(i - 1, axis);
      };
      const auto section = [&](std::size_t row) {
        return discSection(table.number(row, "height_mm"), table.number(row, "width_mm"));
      };
      laid += std::hypot(move("x_mm"), move("y_mm"), move("z_mm")) * 0.5 *
              (section(i) + section(i - 1));
    }
    EXPECT_NEAR(laid, volume, 2e-3 * volume) << operation.at("id").asString();
  }
}

TEST_F(Export, TimesAndArcFollowTheRows) {
  const Table table = readTable(folder_ / "out/guide.csv");
  double time = 0.0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const bool first = table.number(i, "point") == 0.0;
    EXPECT_EQ(table.rows[i][table.column("arc")], first ? "0" : "1");
    EXPECT_GT(table.number(i, "time_s"), time);
    time = table.number(i, "time_s");
    if (!first) {
      EXPECT_NEAR(table.number(i, "tcp_speed_mm_s"), table.number(i, "speed_mm_s"), 1e-3);
    }
  }
}

TEST_F(Export, ReportIsComplete) {
  const Value tree = report();
  EXPECT_EQ(tree.at("format").asString(), "wcam-report");
  EXPECT_EQ(tree.at("format_version").asInteger(), 1);
  EXPECT_EQ(tree.at("project").asString(), "elbow");
  EXPECT_TRUE(tree.at("errors").asArray().empty());
  ASSERT_EQ(tree.at("operations").asArray().size(), 2U);
  for (const Value& operation : tree.at("operations").asArray()) {
    const Table table = readTable(folder_ / ("out/" + operation.at("id").asString() + ".csv"));
    EXPECT_EQ(operation.at("points").asInteger(), static_cast<std::int64_t>(table.rows.size()));
    const double lastLayer = table.number(table.rows.size() - 1, "layer");
    EXPECT_EQ(operation.at("layers").asInteger(), static_cast<std::int64_t>(lastLayer) + 1);
    EXPECT_EQ(operation.at("arc_starts").asInteger(), operation.at("beads").asInteger());
    for (const char* key :
         {"length_mm", "travel_length_mm", "deposited_volume_mm3", "wire_length_m", "mass_g",
          "time_s", "arc_time_s", "min_dexterity", "max_joint_speed_ratio"}) {
      EXPECT_GT(operation.at(key).asReal(), 0.0) << key;
    }
    for (const char* key :
         {"height_mm", "layer_distance_mm", "speed_mm_s", "tilt_deg", "overhang_deg"}) {
      const Value& range = operation.at(key);
      EXPECT_LE(range.at("min").asReal(), range.at("mean").asReal()) << key;
      EXPECT_LE(range.at("mean").asReal(), range.at("max").asReal()) << key;
    }
    ASSERT_EQ(operation.at("joints").asArray().size(), 8U);
    for (std::size_t j = 0; j < 8; ++j) {
      const Value& joint = operation.at("joints").asArray()[j];
      const std::string column = "j" + std::to_string(j + 1) + "_deg";
      for (std::size_t i = 0; i < table.rows.size(); ++i) {
        ASSERT_GE(table.number(i, column), joint.at("min_deg").asReal() - kPrinted);
        ASSERT_LE(table.number(i, column), joint.at("max_deg").asReal() + kPrinted);
      }
      const Value& margin = joint.at("margin_deg");
      EXPECT_TRUE(margin.isNull() || margin.asReal() > 0.0);
      EXPECT_LE(joint.at("max_speed_ratio").asReal(), 1.0);
    }
    EXPECT_TRUE(operation.at("diagnostics_by_code").isObject());
  }
  for (const Value& file : tree.at("files").asArray()) {
    const std::string content = readFile(folder_ / ("out/" + file.at("path").asString()));
    EXPECT_EQ(file.at("bytes").asInteger(), static_cast<std::int64_t>(content.size()));
  }
}

/// Chalvin P4: distance between layers normal to the guide.
TEST_F(Export, ReportTellsTheDistanceOfTheGuideLayers) {
  const Value tree = report();
  const Value& guide = tree.at("operations").asArray()[1];
  EXPECT_EQ(guide.at("id").asString(), "guide");
  // The step of 5 mm is fitted to the quarter circle of 50 mm.
  constexpr double kStep = 25.0 * 3.14159265358979 / 16.0;
  EXPECT_NEAR(guide.at("layer_distance_mm").at("min").asReal(), 0.7 * kStep, 0.005);
  EXPECT_NEAR(guide.at("layer_distance_mm").at("max").asReal(), 1.3 * kStep, 0.005);
}

class Examples : public CamcliTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(Examples, ExportWithoutError) {
  const std::string name = GetParam();
  const fs::path project = example(name);
  const ProcessResult result = camcli({"--project", project, "--table"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out, "");
  const Files files = filesBelow(project.parent_path() / (name + "-out"));
  // At least one program for the cell's controller, a table, the report.
  EXPECT_GE(files.size(), 3U);
  for (const auto& [path, content] : files) {
    EXPECT_FALSE(content.empty()) << path;
    EXPECT_NE(result.err.find(path), std::string::npos) << path << " is not told";
    // As a word of its own: "provenance" has the letters too.
    for (std::size_t at = content.find("nan"); at != std::string::npos;
         at = content.find("nan", at + 1)) {
      EXPECT_TRUE(at > 0 && std::isalpha(static_cast<unsigned char>(content[at - 1])) != 0) << path;
    }
  }
}

TEST_P(Examples, AreCanonicalAndPinned) {
  const fs::path project = example(GetParam());
  const std::string before = readFile(project);
  const ProcessResult check = camcli({"check", project});
  EXPECT_EQ(check.exitCode, 0) << check.err;
  EXPECT_EQ(check.err.find("not_canonical"), std::string::npos) << check.err;
  EXPECT_EQ(check.err.find("hash_changed"), std::string::npos) << check.err;
  const Value tree = parseJson(before);
  for (const Value& part : tree.at("parts").asArray()) {
    EXPECT_EQ(part.at("file").at("sha256").asString().size(), 64U);
  }
  // A cell that comes with the program may change with it.
  EXPECT_EQ(tree.at("cell").at("sha256").asString(), "");
  writeFileAtomically(folder_ / "nothing.jsonl", "");
  EXPECT_EQ(camcli({"apply", project, "nothing.jsonl"}).exitCode, 0);
  EXPECT_EQ(readFile(project), before) << "saving changes the file";
}

std::vector<const char*> exampleNames() {
  static std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(WCAM_RESOURCES) / "projects")) {
    names.insert(entry.path().filename().native());
  }
  std::vector<const char*> list;
  for (const std::string& name : names) {
    list.push_back(name.c_str());
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Shipped,
                         Examples,
                         ::testing::ValuesIn(exampleNames()),
                         [](const auto& example) { return std::string(example.param); });

}  // namespace
}  // namespace wcam::testing
