// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "camcli.hpp"

namespace wcam::testing {
namespace {

using ::testing::HasSubstr;

class Place : public CamcliTest {};

TEST_F(Place, mapsMarginsAndMovesThePart) {
  const std::filesystem::path project = example("elbow");
  const std::vector<std::string> arguments = {
      "place",  "--project", project.native(), "--operation", "planar", "--range", "60",
      "--step", "60",        "--turn",         "180",         "--map",  "map.csv", "--json"};
  const ProcessResult search = camcli(arguments);
  EXPECT_EQ(search.exitCode, 0) << search.err;
  EXPECT_THAT(search.err, HasSubstr("now:  move (0.00, 0.00, 0.00) mm"));
  EXPECT_THAT(search.err, HasSubstr("best: move ("));
  const Value map = parseJson(search.out);
  EXPECT_FALSE(map.at("applied").asBool());
  const auto& places = map.at("places").asArray();
  ASSERT_GE(places.size(), 18U);
  EXPECT_EQ(places[0].at("dx_mm").asReal(), 0.0);
  const Value& best = places.at(static_cast<std::size_t>(map.at("best").asInteger()));
  EXPECT_EQ(best.at("failing_points").asReal(), 0.0);
  EXPECT_GE(best.at("score").asReal(), places[0].at("score").asReal());
  EXPECT_THAT(readFile(folder_ / "map.csv"),
              HasSubstr("dx_mm,dy_mm,dz_mm,turn_deg,failing_points,score"));
  // The same again, byte by byte; then the part is moved there.
  EXPECT_EQ(camcli(arguments).out, search.out);
  const std::string before = readFile(project);
  std::vector<std::string> applying = arguments;
  applying.emplace_back("--apply");
  const ProcessResult applied = camcli(applying);
  EXPECT_EQ(applied.exitCode, 0) << applied.err;
  const bool moved = map.at("best").asInteger() != 0;
  EXPECT_EQ(parseJson(applied.out).at("applied").asBool(), moved);
  EXPECT_EQ(readFile(project) != before, moved);
  EXPECT_EQ(camcli({"check", project.native(), "--operation", "planar"}).exitCode, 0);
}

TEST_F(Place, refusesWhatItCannotDo) {
  const std::filesystem::path project = example("elbow");
  EXPECT_EQ(camcli({"place", "--project", project.native()}).exitCode, 1);
  const ProcessResult unknown =
      camcli({"place", "--project", project.native(), "--operation", "plana"});
  EXPECT_EQ(unknown.exitCode, 1);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'planar'?"));
  EXPECT_EQ(camcli({"place", "--project", project.native(), "--operation", "planar", "--step", "0"})
                .exitCode,
            1);
  EXPECT_EQ(camcli({"place", "--project", "missing.wcam", "--operation", "planar"}).exitCode, 3);
}

}  // namespace
}  // namespace wcam::testing
