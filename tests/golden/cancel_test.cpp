// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A job ends within 200 ms of its own work after somebody wants it to end, wherever it is.
#include "wcam/base/parallel.hpp"
#include "wcam/project/pipeline.hpp"

#include "every_strategy.hpp"
#include "example_project.hpp"
#include "random_source.hpp"
#include "test_folder.hpp"
#include <gtest/gtest.h>
#include <time.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>

namespace wcam::project {
namespace {

/// In the order in which an operation is computed. Edits and remedies stand in few projects.
const std::vector<std::string> kStages = {"part",    "substrate", "slice",  "path",
                                          "process", "cell",      "motion", "program"};

/// The stage that was not finished.
std::string stageCancelled(const StageCache& cache) {
  for (const std::string& stage : kStages) {
    if (cache.runs(stage) == 0) {
      return stage;
    }
  }
  return "none";
}

TEST(Cancel, EndsInTheStageInWhichItIsAskedFor) {
  const Document document = test::exampleDocument("elbow");

  // How far the stages reach, from the fractions that Pipeline gives them.
  struct Portion {
    double begin;
    double end;
    const char* stage;
  };

  constexpr Portion kPortions[] = {
      {0.0, 0.25, "part"}, {0.25, 0.6, "slice"}, {0.7, 0.95, "motion"}};
  for (const Portion& portion : kPortions) {
    std::stop_source stop;
    const JobContext context(stop.get_token(), [&](double fraction, const std::string&) {
      if (fraction > portion.begin && fraction < portion.end) {
        stop.request_stop();
      }
    });
    const auto cache = std::make_shared<StageCache>();
    EXPECT_THROW((void)Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins(), cache)
                     .compute("guide", context),
                 CancelledError)
        << portion.stage;
    EXPECT_EQ(stageCancelled(*cache), portion.stage);
    // Nothing of the stage that was cut off is kept, and what was finished serves the next run.
    const std::size_t parts = cache->runs("part");
    EXPECT_NO_THROW(
        (void)Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins(), cache)
            .compute("guide", JobContext()));
    EXPECT_EQ(cache->runs("part"), std::max<std::size_t>(parts, 1));
    EXPECT_EQ(cache->runs(portion.stage), 1U);
  }
}

/// Processor time of all threads of this process, s: what others do on the machine does not count.
double processorTime() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Job {
  std::string strategy;
  std::string mode;
  std::string step;  ///< JSON; fine enough that the job lasts
};

class CancelAtRandom : public ::testing::TestWithParam<Job> {};

TEST_P(CancelAtRandom, ReturnsWithin200MillisecondsOfWork) {
  constexpr int kThreads = 2;
  constexpr double kMost = 0.2;  // s, of each thread
  constexpr int kMoments = 3;
  const Job& job = GetParam();
  const ThreadLimit limit(kThreads);
  const testing::TestFolder folder;
  const std::filesystem::path file = test::writeEveryStrategy(folder.path(), {job.mode});
  const std::string id = job.strategy + "-" + job.mode;
  Document document = loadProject(file).document;
  if (!job.step.empty()) {
    document = apply(document, {"operation.set", parseJson(R"({"id": ")" + id + R"(", "params": )" +
                                                           job.step + "}")});
  }
  const auto computed = [&](const JobContext& context) {
    try {
      (void)Pipeline(document, file, test::hostOfPlugins()).compute(id, context);
      return true;
    } catch (const CancelledError&) {
      return false;
    } catch (const Error&) {
      return true;  // it came to its end
    }
  };
  const auto start = std::chrono::steady_clock::now();
  (void)computed(JobContext());
  const double whole =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const std::uint64_t seed : testing::testSeeds(kMoments)) {
    SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(seed));
    testing::RandomSource random(seed);
    std::stop_source stop;
    std::atomic<double> atReturn{0.0};
    std::thread worker([&] {
      (void)computed(JobContext(stop.get_token()));
      atReturn = processorTime();
    });
    std::this_thread::sleep_for(std::chrono::duration<double>(random.real(0.0, whole)));
    const double asked = processorTime();
    stop.request_stop();
    worker.join();
    EXPECT_LT(atReturn.load() - asked, kMost * kThreads) << "of " << whole << " s";
  }
}

std::vector<Job> jobs() {
  std::vector<Job> all = {
      {"planar", "optimized", R"({"step": 0.4})"},
      {"guide", "constant", R"({"step": 0.4, "automatic_guide": true})"},
      {"geodesic", "constant", R"({"step": 0.4})"},
      {"isovalues", "constant", R"({"step": 0.4})"},
      {"constant", "constant", R"({"step": 0.4})"},
      {"isoparam", "constant", R"({"step": 0.4})"},
      {"branches", "constant", R"({"step": 0.4})"},
      {"radial", "constant", R"({"step": 0.4, "shape": "cone", "cone_angle": 0})"},
      {"import", "optimized", ""},
      {"spiral", "constant", ""},
      {"bulk", "constant", R"({"step": 0.5})"},
      {"cladding", "constant", R"({"step": 0.5})"},
  };
  for (const char* mode : {"point_by_point", "polynomial", "fixed", "homogeneous"}) {
    all.push_back({"planar", mode, R"({"step": 1})"});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(EveryStrategy,
                         CancelAtRandom,
                         ::testing::ValuesIn(jobs()),
                         [](const auto& info) {
                           return info.param.strategy + "_" + info.param.mode;
                         });

}  // namespace
}  // namespace wcam::project
