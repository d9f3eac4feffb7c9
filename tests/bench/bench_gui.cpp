// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front-end as it feels (run it under Xvfb or on a display): time to a usable window and to the
// layers of the elbow, the longest time that the event loop stands still while a part of a million
// triangles is imported, sliced and drawn, and frames per second while a path of a million points
// is scrubbed.

#include "wcam/base/file_io.hpp"
#include "wcam/base/quantity.hpp"

#include "app/application.hpp"
#include "app/main_window.hpp"
#include "test_folder.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTest>
#include <QTimer>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

namespace {

using wcam::gui::MainWindow;

constexpr int kPatienceMs = 300000;

/// With WCAM_BENCH_TRACE=ms in the environment, a standstill that is longer names the events that
/// made it.
class Application : public QApplication {
public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (limit() <= 0.0) {
      return QApplication::notify(receiver, event);
    }
    const std::string what = std::string(receiver->metaObject()->className()) + " '" +
                             receiver->objectName().toStdString() + "' event " +
                             std::to_string(event->type());
    QElapsedTimer clock;
    clock.start();
    const std::size_t place = events_.size();
    ++depth_;
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    const double ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    if (ms > 2.0) {
      char line[32];
      std::snprintf(line, sizeof line, "%*s%.1f ms: ", 2 * depth_ + 2, "", ms);
      events_.insert(events_.begin() + static_cast<std::ptrdiff_t>(std::min(place, events_.size())),
                     line + what);
    }
    return taken;
  }

  /// Ends a turn of the event loop that took some time.
  void turn(double ms) {
    if (limit() > 0.0 && ms > limit()) {
      std::printf("standstill of %.1f ms\n", ms);
      for (const std::string& event : events_) {
        std::printf("%s\n", event.c_str());
      }
    }
    events_.clear();
  }

private:
  static double limit() {
    static const double limit = qEnvironmentVariable("WCAM_BENCH_TRACE").toDouble();
    return limit;
  }

  std::vector<std::string> events_;
  int depth_ = 0;
};

/// Measures how long the event loop stands still: a timer that should come every few milliseconds.
class Watchdog {
public:
  Watchdog() {
    timer_.setInterval(2);
    QObject::connect(&timer_, &QTimer::timeout, [this] {
      const double gap = 1e-6 * static_cast<double>(clock_.nsecsElapsed());
      clock_.restart();
      const double cpu = threadMilliseconds();
      if (gap > worst_) {
        worst_ = gap;
        worstCpu_ = cpu - cpu_;
      }
      static_cast<Application*>(qApp)->turn(gap);
      cpu_ = cpu;
      late_ += gap > kLate ? 1 : 0;
    });
  }

  void start() {
    worst_ = 0.0;
    worstCpu_ = 0.0;
    late_ = 0;
    static_cast<Application*>(qApp)->turn(0.0);
    cpu_ = threadMilliseconds();
    clock_.start();
    timer_.start();
  }

  void stop() { timer_.stop(); }

  [[nodiscard]] double worst() const { return worst_; }

  /// Of the worst: what this thread worked itself; the rest it waited for a processor or a lock.
  [[nodiscard]] double worstCpu() const { return worstCpu_; }

  [[nodiscard]] int late() const { return late_; }

  static constexpr double kLate = 100.0;  ///< ms, the goal

private:
  static double threadMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }

  QTimer timer_;
  QElapsedTimer clock_;
  double worst_ = 0.0;  ///< ms
  double worstCpu_ = 0.0;
  double cpu_ = 0.0;
  int late_ = 0;
};

bool settled(MainWindow& window) {
  return !window.session().stale() && !window.session().generation().busy();
}

void append(std::string& bytes, float value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A vase with waves: a binary STL of rows × columns × 2 triangles.
void writeVase(const std::filesystem::path& file, int rows, int columns) {
  const auto at = [&](int i, int k) {
    const double z = 150.0 * i / rows;
    const double a = 2.0 * wcam::kPi * k / columns;
    const double r = 60.0 + 6.0 * std::sin(3.0 * a + 0.03 * z) + 10.0 * std::sin(0.02 * z);
    return std::array<float, 3>{static_cast<float>(r * std::cos(a)),
                                static_cast<float>(r * std::sin(a)), static_cast<float>(z)};
  };
  std::string bytes(80, ' ');
  const auto count = static_cast<std::uint32_t>(2 * rows * columns);
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const auto a = at(i, k);
      const auto b = at(i, (k + 1) % columns);
      const auto c = at(i + 1, (k + 1) % columns);
      const auto d = at(i + 1, k);
      for (const auto& triangle : {std::array{a, b, c}, std::array{a, c, d}}) {
        append(bytes, 0.0F);
        append(bytes, 0.0F);
        append(bytes, 0.0F);
        for (const auto& corner : triangle) {
          for (const float x : corner) {
            append(bytes, x);
          }
        }
        bytes.append(2, '\0');
      }
    }
  }
  wcam::writeFileAtomically(file, bytes);
}

/// Rings of points as the table that the import strategy reads.
void writeRings(const std::filesystem::path& file, int layers, int points) {
  std::string text = "layer,bead,x_mm,y_mm,z_mm\n";
  char line[96];
  for (int l = 0; l < layers; ++l) {
    for (int i = 0; i <= points; ++i) {
      const double a = 2.0 * wcam::kPi * (i % points) / points;
      const double r = 100.0 + 5.0 * std::sin(5.0 * a);
      std::snprintf(line, sizeof line, "%d,0,%.5f,%.5f,%.5f\n", l, r * std::cos(a), r * std::sin(a),
                    2.0 * (l + 1));
      text += line;
    }
  }
  wcam::writeFileAtomically(file, text);
}

std::string projectText(const std::string& part, const std::string& operation) {
  return R"({"format": "wcam-project", "format_version": 1, "name": "bench", )" + part +
         R"("substrates": [{"id": "plate", "type": "plate", "position_mm": [-150, -150, 0], "size_mm": [300, 300, 10]}],
 "processes": [{"id": "steel", "params": {"wire_diameter": 1.2, "wire_speed": 6.0, "bead_width": 8.0}}],
 "operations": [)" +
         operation + "]}\n";
}

void benchStart(QElapsedTimer& clock,
                const std::shared_ptr<const wcam::plugin::PluginHost>& plugins,
                double loaded) {
  MainWindow window{plugins};
  window.resize(1240, 960);
  window.show();
  (void)QTest::qWaitForWindowExposed(&window);
  QApplication::processEvents();
  const double usable = 1e-3 * static_cast<double>(clock.elapsed());
  Watchdog watchdog;
  clock.restart();
  watchdog.start();
  window.openFile(std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/elbow.wcam");
  (void)QTest::qWaitFor([&] { return window.viewState().layerCount() > 0; }, kPatienceMs);
  QApplication::processEvents();
  const double layers = 1e-3 * static_cast<double>(clock.elapsed());
  (void)QTest::qWaitFor([&] { return settled(window); }, kPatienceMs);
  const double all = 1e-3 * static_cast<double>(clock.elapsed());
  (void)QTest::qWaitFor([] { return false; }, 500);
  watchdog.stop();
  std::printf(
      "start: usable window after %.2f s (of it plugins %.2f s; goal 1.5), layers of the elbow "
      "%.2f s later (goal 2), all computed %.2f s\n",
      usable, loaded, layers, all);
  std::printf("elbow: the event loop stood still for %.0f ms at most (%.0f ms of it own work)\n",
              watchdog.worst(), watchdog.worstCpu());
}

void benchMillionTriangles(const std::shared_ptr<const wcam::plugin::PluginHost>& plugins,
                           const std::filesystem::path& folder) {
  writeVase(folder / "vase.stl", 707, 708);
  wcam::writeFileAtomically(
      folder / "vase.wcam",
      projectText(
          R"("parts": [{"id": "vase", "file": {"path": "vase.stl", "sha256": ""}}], )",
          R"({"id": "planar", "strategy": "wcam.slicing.planar", "parts": ["vase"], "substrate": "plate",
 "process": "steel", "params": {"step": 2.0}})"));
  MainWindow window{plugins};
  window.resize(1240, 960);
  window.show();
  (void)QTest::qWaitForWindowExposed(&window);
  Watchdog watchdog;
  QElapsedTimer clock;
  clock.start();
  watchdog.start();
  window.openFile(folder / "vase.wcam");
  (void)QTest::qWaitFor([&] { return settled(window); }, kPatienceMs);
  (void)QTest::qWaitFor([] { return false; }, 300);
  watchdog.stop();
  std::printf(
      "a million triangles: %d layers after %.2f s; the event loop stood still for %.0f ms at "
      "most (%.0f ms of it own work), %d times above %.0f ms\n",
      window.viewState().layerCount(), 1e-3 * static_cast<double>(clock.elapsed()),
      watchdog.worst(), watchdog.worstCpu(), watchdog.late(), Watchdog::kLate);
}

void benchMillionPoints(const std::shared_ptr<const wcam::plugin::PluginHost>& plugins,
                        const std::filesystem::path& folder) {
  writeRings(folder / "rings.csv", 500, 2000);
  wcam::writeFileAtomically(
      folder / "rings.wcam",
      projectText(
          R"("parts": [], )",
          R"({"id": "rings", "strategy": "wcam.slicing.import", "parts": [], "substrate": "plate",
 "process": "steel", "file": {"path": "rings.csv", "sha256": ""}})"));
  MainWindow window{plugins};
  window.resize(1240, 960);
  window.show();
  (void)QTest::qWaitForWindowExposed(&window);
  Watchdog watchdog;
  watchdog.start();
  window.openFile(folder / "rings.wcam");
  (void)QTest::qWaitFor([&] { return settled(window); }, kPatienceMs);
  (void)QTest::qWaitFor([] { return false; }, 300);
  watchdog.stop();
  const auto path = window.viewState().path();
  if (path == nullptr) {
    std::printf("a million points: no path\n");
    return;
  }
  constexpr int kFrames = 60;
  QElapsedTimer clock;
  clock.start();
  double slowest = 0.0;
  int painted = 0;
  QObject::connect(window.view(), &wcam::gui::VtkWidget::painted, &window, [&] { ++painted; });
  for (int k = 0; k < kFrames; ++k) {
    const double before = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    window.viewState().setMove(path->size() * static_cast<std::size_t>(k + 1) / (kFrames + 1));
    const int shown = painted;
    while (painted == shown) {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    slowest = std::max(slowest, 1e-6 * static_cast<double>(clock.nsecsElapsed()) - before);
  }
  const double seconds = 1e-9 * static_cast<double>(clock.nsecsElapsed());
  std::printf(
      "a path of %zu moves: opened with the event loop standing still for %.0f ms at most; "
      "scrubbing %.1f "
      "frames/s, slowest frame %.0f ms\n",
      path->size(), watchdog.worst(), kFrames / seconds, slowest);
}

}  // namespace

int main(int argc, char** argv) {
  QElapsedTimer clock;
  clock.start();
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  wcam::gui::prepareApplication();
  QCoreApplication::setApplicationName("wcam-bench");
  Application application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  wcam::gui::loadTranslations(application, "en");
  QSettings().clear();
  const double begin = 1e-3 * static_cast<double>(clock.elapsed());
  const auto plugins = std::make_shared<const wcam::plugin::PluginHost>(
      wcam::plugin::defaultPluginSearch({}, false));
  const double loaded = 1e-3 * static_cast<double>(clock.elapsed()) - begin;
  const std::string part = argc > 1 ? argv[1] : "";
  const wcam::testing::TestFolder folder;
  if (part.empty() || part == "start") {
    benchStart(clock, plugins, loaded);
  }
  if (part.empty() || part == "triangles") {
    benchMillionTriangles(plugins, folder.path());
  }
  if (part.empty() || part == "points") {
    benchMillionPoints(plugins, folder.path());
  }
  return 0;
}
