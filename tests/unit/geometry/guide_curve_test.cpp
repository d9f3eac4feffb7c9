// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/guide_curve.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace wcam::geometry {
namespace {

/// Quarter circle of radius 50 about (−50, 0, 0), from the origin along +z (Chalvin P4).
std::shared_ptr<const GuideCurve> quarterCircle() {
  return guideFromFormula({"50*cos(t)-50", "0", "50*sin(t)"}, 0.0, kPi / 2.0);
}

TEST(GuideCurve, FormulaHasExactPositionAndDerivatives) {
  const auto guide = quarterCircle();
  for (const double t : {0.0, 0.3, 1.0, kPi / 2.0}) {
    const CurvePoint c = guide->evaluate(t);
    EXPECT_NEAR((c.p - Vec3(50 * std::cos(t) - 50, 0, 50 * std::sin(t))).norm(), 0.0, 1e-12);
    EXPECT_NEAR((c.d1 - Vec3(-50 * std::sin(t), 0, 50 * std::cos(t))).norm(), 0.0, 1e-8);
    EXPECT_NEAR((c.d2 - Vec3(-50 * std::cos(t), 0, -50 * std::sin(t))).norm(), 0.0, 1e-5);
  }
}

TEST(GuideCurve, ChordStepsOfTheQuarterTorus) {
  // Chalvin AT-06: u step 0.100042 rad, 15 whole steps in a quarter turn.
  const auto guide = quarterCircle();
  const std::vector<double> t = chordSteps(*guide, 5.0, 0.0);
  ASSERT_EQ(t.size(), 16U);
  for (std::size_t i = 1; i < t.size(); ++i) {
    EXPECT_NEAR(t[i] - t[i - 1], std::acos(1.0 - 25.0 / 5000.0), 1e-12);
    EXPECT_NEAR(t[i] - t[i - 1], 0.100042, 5e-7);
  }
}

TEST(GuideCurve, GeneralTubeOfChalvinP6) {
  const auto guide = guideFromFormula({"(0.005*t^3-0.22*t^2)/6", "0.02*t^2", "t"}, 0.0, 40.0);
  EXPECT_NEAR((guide->evaluate(40.0).p - Vec3(-5.33333, 32, 40)).norm(), 0.0, 1e-4);
  EXPECT_NEAR(arcLength(*guide, 0.0, 40.0), 56.154, 1e-3);
  const CurvePoint c = guide->evaluate(0.0);
  EXPECT_NEAR(c.d1.cross(c.d2).norm() / std::pow(c.d1.norm(), 3), std::hypot(0.44 / 6, 0.04), 1e-7);
}

TEST(GuideCurve, FrenetFrameIsDirectAndTellsStraightLines) {
  bool valid = false;
  const CurveFrame frame = frenetFrame(quarterCircle()->evaluate(0.7), &valid);
  EXPECT_TRUE(valid);
  EXPECT_NEAR((frame.normal.cross(frame.binormal) - frame.tangent).norm(), 0.0, 1e-12);
  // The normal points to the centre of curvature.
  EXPECT_NEAR((frame.normal - Vec3(-std::cos(0.7), 0, -std::sin(0.7))).norm(), 0.0, 1e-6);
  const CurveFrame straight =
      frenetFrame(guideFromPoints({{0, 0, 0}, {0, 0, 9}})->evaluate(2.0), &valid);
  EXPECT_FALSE(valid);
  EXPECT_NEAR(straight.tangent.dot(straight.normal), 0.0, 1e-12);
}

TEST(GuideCurve, RotationMinimisingFramesDoNotTurnAboutTheTangent) {
  const auto helix = guideFromFormula({"10*cos(t)", "10*sin(t)", "3*t"}, 0.0, 12.0);
  std::vector<double> t;
  for (int i = 0; i <= 600; ++i) {
    t.push_back(12.0 * i / 600);
  }
  const auto frames = rotationMinimisingFrames(*helix, t, Vec3::UnitX());
  double turn = 0.0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_NEAR(frames[i].tangent.dot(frames[i].normal), 0.0, 1e-12);
    const Vec3 change = frames[i].normal - frames[i - 1].normal;
    turn =
        std::max(turn, std::abs(change.dot(0.5 * (frames[i].binormal + frames[i - 1].binormal))));
  }
  EXPECT_LT(turn, 1e-6);
}

TEST(GuideCurve, SplineThroughPointsIsExactAtThemAndSmooth) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 20; ++i) {
    const double u = kPi / 2.0 * i / 20;
    points.emplace_back(50 * std::cos(u) - 50, 0, 50 * std::sin(u));
  }
  const auto guide = guideFromPoints(points);
  double s = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    s += i > 0 ? (points[i] - points[i - 1]).norm() : 0.0;
    EXPECT_NEAR((guide->evaluate(s).p - points[i]).norm(), 0.0, 1e-12);
  }
  for (int i = 0; i <= 200; ++i) {
    const Vec3 p = guide->evaluate(guide->end() * i / 200).p;
    EXPECT_NEAR((p - Vec3(-50, 0, 0)).norm(), 50.0, 1e-4);
  }
}

TEST(GuideCurve, ListsAndAssignmentsAreNoFormulas) {
  const auto refusal = [](const std::string& formula) -> std::string {
    try {
      guideFromFormula({formula, "0", "t"}, 0.0, 1.0);
    } catch (const Error& error) {
      return std::string(error.what()) + " | " + error.hintText().str();
    }
    return "taken";
  };
  const auto holds = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                                : testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(holds(refusal("32,5"), "position 3"));
  EXPECT_TRUE(holds(refusal("32,5"), "write 32.5,"));
  EXPECT_TRUE(holds(refusal("max(1, 2) + 0,5*t"), "write max(1, 2) + 0.5*t,"));
  EXPECT_TRUE(holds(refusal("t, 2*t"), "a list"));
  EXPECT_TRUE(holds(refusal("t=5"), "an assignment (position 2)"));
  EXPECT_TRUE(holds(refusal("t = t + 1"), "an assignment"));
  EXPECT_TRUE(holds(refusal("t += 1"), "assignment"));
  EXPECT_EQ(refusal("max(t, 0.5)"), "taken");
  EXPECT_EQ(refusal("t >= 0.5 ? t : t <= 0.2 ? t : t == 0.3 ? t : t != 0.4 ? t : 0.4"), "taken");
}

TEST(GuideCurve, ThreadsShareAFormula) {
  const auto guide = quarterCircle();
  const ThreadLimit limit(8);
  std::vector<Vec3> points(2000);
  parallelFor(points.size(), 10, [&](std::size_t i) {
    points[i] = guide->evaluate(1e-3 * static_cast<double>(i % 1500)).p;
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i], guide->evaluate(1e-3 * static_cast<double>(i % 1500)).p) << i;
  }
}

TEST(GuideCurve, BadInputNamesThePlace) {
  const auto messageOf = [](const auto& make) {
    try {
      make();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(messageOf([] {
              guideFromFormula({"50*cos(t", "0", "t"}, 0, 1);
            }).find("x(t)"),
            std::string::npos);
  EXPECT_NE(messageOf([] {
              guideFromFormula({"t", "foo(t)", "t"}, 0, 1);
            }).find("y(t)"),
            std::string::npos);
  EXPECT_NE(messageOf([] {
              guideFromFormula({"1/t", "0", "t"}, 0, 1);
            }).find("finite"),
            std::string::npos);
  EXPECT_NE(messageOf([] {
              guideFromFormula({"t", "0", "t"}, 1, 1);
            }).find("ascend"),
            std::string::npos);
  EXPECT_NE(messageOf([] { guideFromPoints({{0, 0, 0}}); }).find("two points"), std::string::npos);
  EXPECT_NE(messageOf([] {
              guideFromPoints({{0, 0, 0}, {0, 0, 0}});
            }).find("point 2"),
            std::string::npos);
  const std::string file = ::testing::TempDir() + "guide.csv";
  std::ofstream(file) << "x,y,z\n0,0,0\n1;2;3\n4 5\n";
  EXPECT_NE(messageOf([&] { guideFromFile(file); }).find("line 4"), std::string::npos);
  std::ofstream(file) << "# guide\nx,y,z\n0,0,0\n1;2;3\n\n4\t5 6\n";
  EXPECT_NEAR((guideFromFile(file)->evaluate(0.0).p).norm(), 0.0, 1e-15);
  std::remove(file.c_str());
  EXPECT_NE(messageOf([&] { guideFromFile(file); }).find("does not exist"), std::string::npos);
}

std::string refusalOf(const std::string& z) {
  try {
    const auto guide = guideFromFormula({"0", "0", z}, 0.0, 12.0);
    (void)chordSteps(*guide, 4.0, guide->begin());
  } catch (const Error& error) {
    return std::string(error.what()) + " | " + error.hint();
  }
  return "nothing";
}

TEST(Guide, PolesJumpsAndHugeValuesAreRefusedWithTheirPlace) {
  using ::testing::HasSubstr;
  EXPECT_THAT(refusalOf("1/(t-5)"), HasSubstr("leaves its range at t = 5.0"));
  EXPECT_THAT(refusalOf("1/(t-5)^2"), HasSubstr("leaves its range at t = "));
  EXPECT_THAT(refusalOf("t*1e200"), HasSubstr("leaves its range at t = "));
  EXPECT_THAT(refusalOf("t < 5 ? t : t + 3"), HasSubstr("jumps by 3.000 mm at t = 5.000000"));
  EXPECT_THAT(refusalOf("0,5*t"), HasSubstr("write 0.5*t"));
  EXPECT_THAT(refusalOf("z=5"), HasSubstr("assignment (position 2)"));
  // Steep, but smooth enough.
  EXPECT_EQ(refusalOf("sqrt(t)"), "nothing");
  EXPECT_EQ(refusalOf("t < 5 ? t : 2*t-5"), "nothing");
}

TEST(Guide, ChordsEndByCountAndOnCancel) {
  const auto guide = guideFromFormula({"0", "0", "t"}, 0.0, 12.0);
  const std::uint64_t most = budget().layers;
  setBudget("layers=100");
  EXPECT_EQ(chordSteps(*guide, 0.25, 0.0).size(), 49U);
  EXPECT_THROW((void)chordSteps(*guide, 0.01, 0.0), Error);
  setBudget("layers=" + std::to_string(most));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)chordSteps(*guide, 0.25, 0.0, JobContext(stop.get_token())), CancelledError);
}

TEST(Guide, DecimalCommasInAFileAreRefused) {
  const std::string file = ::testing::TempDir() + "comma_guide.csv";
  for (const char* row : {"1,5;2", "0,5 2", "1,5;2,5;3,5"}) {
    std::ofstream(file) << "0 0 0\n" << row << "\n";
    try {
      (void)guideFromFile(file);
      ADD_FAILURE() << row;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("line 2: decimal commas")) << row;
    }
  }
  for (const char* row : {"1,2,3", "1, 2, 3", "1;2;3", "1.5 2 3"}) {
    std::ofstream(file) << "0 0 0\n" << row << "\n";
    EXPECT_NO_THROW((void)guideFromFile(file)) << row;
  }
  std::remove(file.c_str());
}

}  // namespace
}  // namespace wcam::geometry
