// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What numbers of files can be at all, and how much a run may take.
#include "wcam/base/plausible.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/param.hpp"

#include "error_matchers.hpp"
#include "test_folder.hpp"

#include <limits>

namespace wcam {
namespace {

using ::testing::AllOf;
using testing::errorOf;
using ::testing::HasSubstr;

constexpr int kKinds = static_cast<int>(QuantityKind::Ratio) + 1;

TEST(Plausible, EveryQuantityHasARangeAndRefusesWhatIsBeyond) {
  for (int k = 0; k < kKinds; ++k) {
    const auto kind = static_cast<QuantityKind>(k);
    const PlausibleRange range = plausibleRange(kind);
    SCOPED_TRACE(toString(kind));
    EXPECT_LT(range.min, range.max);
    EXPECT_TRUE(implausible(range.min, kind).empty());
    EXPECT_TRUE(implausible(range.max, kind).empty());
    EXPECT_FALSE(implausible(std::numeric_limits<double>::infinity(), kind).empty());
    EXPECT_FALSE(implausible(std::numeric_limits<double>::quiet_NaN(), kind).empty());
    if (kind != QuantityKind::None) {
      EXPECT_THAT(implausible(1e300, kind).str(), HasSubstr("1e+300"));
    }
  }
}

TEST(Plausible, TellsFigureUnitAndRange) {
  EXPECT_EQ(implausible(2e6, QuantityKind::Length).str(),
            "2000000 mm is not within -1000000 and 1000000 mm");
  EXPECT_EQ(outOfRange(7.5, {0.0, 5.0}, "").str(), "7.5 is not within 0 and 5");
}

struct Sizes {
  Length length{1.0};
};

TEST(Plausible, HoldsForParametersWithoutLimitsOfTheirOwn) {
  const ParamSchema schema = Schema<Sizes>{}.add(&Sizes::length, {.key = "length"}).params();
  EXPECT_TRUE(schema.validate(Value::object({{"length", 1e6}})).empty());
  const auto problems = schema.validate(Value::object({{"length", 1e300}}));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].message.str(), AllOf(HasSubstr("1e+300"), HasSubstr("1000000 mm")));
  EXPECT_EQ(schema.jsonSchema("sizes").at("properties").at("length").at("maximum").asReal(), 1e6);
}

TEST(Budget, IsReadFromTextAndNamesWhatIsWrong) {
  const Budget budget = parseBudget(" memory_mb=100, points=7 ");
  EXPECT_EQ(budget.memoryMb, 100U);
  EXPECT_EQ(budget.points, 7U);
  EXPECT_EQ(budget.layers, Budget{}.layers);
  for (const char* wrong :
       {"memory=1", "points", "points=", "points=-1", "points=0", "points=1.5"}) {
    EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)parseBudget(wrong); }),
                AllOf(HasSubstr(wrong), HasSubstr("memory_mb")));
  }
}

TEST(Budget, RefusalsTellTheFigureAndTheWayOut) {
  const std::uint64_t most = budget().points;
  EXPECT_NO_THROW(requireBudget(most, "points", "the path has some points", "path"));
  EXPECT_THAT(errorOf(ErrorCode::JobFailed,
                      [&] {
                        requireBudget(most + 1, "points", "the path has more points", "path",
                                      ErrorCode::JobFailed);
                      }),
              AllOf(HasSubstr("the path has more points; the budget is " + std::to_string(most)),
                    HasSubstr("points=" + std::to_string(most + 1))));
}

TEST(Budget, JsonWithTooManyValuesIsRefused) {
  const std::uint64_t most = budget().jsonValues;
  setBudget("json_values=1000");
  std::string list = "[0";
  for (int i = 0; i < 998; ++i) {
    list += ",0";
  }
  EXPECT_NO_THROW(parseJson(list + "]", "list.json"));
  EXPECT_THAT(errorOf(ErrorCode::InputInvalid, [&] { parseJson(list + ",0,0]", "list.json"); }),
              AllOf(HasSubstr("list.json"), HasSubstr("1000")));
  setBudget("json_values=" + std::to_string(most));
}

TEST(Budget, LargeFilesAreRefusedBeforeTheyAreRead) {
  const testing::TestFolder folder;
  const std::uint64_t most = budget().fileMb;
  setBudget("file_mb=1");
  writeFileAtomically(folder / "small", std::string(1U << 20U, ' '));
  writeFileAtomically(folder / "large", std::string((1U << 20U) + 1, ' '));
  EXPECT_NO_THROW(readFile(folder / "small"));
  EXPECT_THAT(errorOf(ErrorCode::InputInvalid, [&] { readFile(folder / "large"); }),
              AllOf(HasSubstr("large"), HasSubstr("2 MiB")));
  setBudget("file_mb=" + std::to_string(most));
}

TEST(Json, ObjectsHaveALimitOfKeys) {
  // 200 000 keys took minutes, here or where each was looked up later.
  const auto object = [](int keys) {
    std::string text = "{";
    for (int i = 0; i < keys; ++i) {
      text += (i > 0 ? ",\"k" : "\"k") + std::to_string(i) + "\":0";
    }
    return text;
  };
  EXPECT_EQ(parseJson(object(10000) + "}", "keys.json").size(), 10000U);
  EXPECT_THAT(errorOf(ErrorCode::InputInvalid,
                      [&] { parseJson(object(9000) + ",\"k7\":1}", "keys.json"); }),
              HasSubstr("k7"));
  EXPECT_THAT(
      errorOf(ErrorCode::InputInvalid, [&] { parseJson(object(200000) + "}", "keys.json"); }),
      HasSubstr("more than 10000 keys"));
}

}  // namespace
}  // namespace wcam
