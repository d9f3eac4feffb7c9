// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact sections of a lofted B-spline part in a STEP file: importPart and sliceByField, all
// counted, against OpenCASCADE's BRepAlgoAPI_Section on the same file, whose reading is not
// counted. Section takes too long for all planes: it is run on some of them and scaled. On these
// planes the points are compared with the edges of Section in both directions; a run that does not
// agree fails.

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/io/import.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include "timing.hpp"
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Section.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <Extrema_ExtPC.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

using wcam::bench::Times;
using wcam::geometry::Vec3;
using wcam::toolpath::Contour;
using wcam::toolpath::LayerLevel;
using wcam::toolpath::SlicedLayers;

constexpr double kGoal = 50.0;
constexpr double kAgreement = 1e-4;  // mm
constexpr std::size_t kPlanes = 50;
constexpr std::size_t kSectionEvery = 5;
constexpr int kRepetitions = 3;
constexpr double kHeight = 100.0;
constexpr wcam::toolpath::Sampling kSampling{0.005, 1.0};

/// A closed curve like the profile of a blade through 40 points; the sections shrink, turn and
/// lean.
TopoDS_Wire bladeSection(int index, int sections) {
  constexpr int kPoints = 40;
  const double w = static_cast<double>(index) / (sections - 1);
  const double size = 1.0 - 0.35 * w;
  const double turn = 0.6 * w;
  const double lean = 0.08 * std::sin(3.0 * w);
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, kPoints);
  for (int k = 0; k < kPoints; ++k) {
    const double t = 2.0 * wcam::kPi * k / kPoints;
    const double x = size * 40.0 * std::cos(t);
    const double y = size * (9.0 * std::sin(t) * (1.0 + 0.5 * std::cos(t)) +
                             5.0 * std::cos(t) * std::cos(t) + 0.4 * std::sin(5.0 * t));
    points->SetValue(k + 1,
                     gp_Pnt(x * std::cos(turn) - y * std::sin(turn),
                            x * std::sin(turn) + y * std::cos(turn), kHeight * w + lean * x));
  }
  GeomAPI_Interpolate interpolation(points, Standard_True, 1e-7);
  interpolation.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolation.Curve()));
}

/// The loft as a STEP file that lives as long as the object.
class BladeFile {
public:
  BladeFile() {
    std::string folder =
        (std::filesystem::temp_directory_path() / "wcam-bench-brep-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), folder);
    }
    folder_ = folder;
    constexpr int kSections = 8;
    BRepOffsetAPI_ThruSections loft(Standard_True, Standard_False, 1e-6);
    for (int i = 0; i < kSections; ++i) {
      loft.AddWire(bladeSection(i, kSections));
    }
    loft.Build();
    STEPControl_Writer writer;
    writer.Transfer(loft.Shape(), STEPControl_AsIs);
    if (writer.Write(path().c_str()) != IFSelect_RetDone) {
      throw std::runtime_error("cannot write " + path().string());
    }
  }

  ~BladeFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  BladeFile(const BladeFile&) = delete;
  BladeFile& operator=(const BladeFile&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return folder_ / "blade.step"; }

private:
  std::filesystem::path folder_;
};

/// Horizontal planes.
class HeightField : public wcam::toolpath::LayerField {
public:
  explicit HeightField(const std::vector<LayerLevel>& levels) : levels_(levels) {}

  [[nodiscard]] double scalar(const Vec3& p) const override { return p.z(); }

  [[nodiscard]] double residual(const Vec3& p, std::size_t level) const override {
    return p.z() - levels_[level].value;
  }

  [[nodiscard]] Vec3 gradient(const Vec3&, std::size_t) const override { return Vec3::UnitZ(); }

private:
  const std::vector<LayerLevel>& levels_;
};

std::vector<LayerLevel> middleLevels() {
  const double step = kHeight / static_cast<double>(kPlanes);
  std::vector<LayerLevel> levels;
  for (std::size_t k = 0; k < kPlanes; ++k) {
    levels.push_back({(static_cast<double>(k) + 0.5) * step, Vec3::UnitZ(), step});
  }
  return levels;
}

using Part = std::shared_ptr<const wcam::geometry::PartSurface>;

/// The mesh only finds the sections, the points are exact: it may be coarse.
Part import(const std::filesystem::path& file) {
  wcam::io::ImportOptions options;
  options.chordTolerance = wcam::Length(0.1);
  options.angularTolerance = wcam::Angle(wcam::degToRad(15.0));
  return wcam::io::importPart(file, options, wcam::geometry::Pose::Identity(), wcam::JobContext())
      .surface;
}

SlicedLayers slice(const Part& part, const std::vector<LayerLevel>& levels) {
  wcam::geometry::Pose belowPart = wcam::geometry::Pose::Identity();
  belowPart.translation().z() = -kHeight;
  const wcam::toolpath::Substrate plate(belowPart, Vec3(200.0, 200.0, 10.0));
  return wcam::toolpath::sliceByField({part}, HeightField(levels), levels, plate, kSampling,
                                      wcam::JobContext());
}

std::vector<BRepAdaptor_Curve> sectionEdges(const TopoDS_Shape& shape, double height) {
  BRepAlgoAPI_Section section(shape, gp_Pln(gp_Pnt(0.0, 0.0, height), gp::DZ()), Standard_False);
  section.Approximation(Standard_True);
  section.Build();
  std::vector<BRepAdaptor_Curve> edges;
  for (TopExp_Explorer it(section.Shape(), TopAbs_EDGE); it.More(); it.Next()) {
    edges.emplace_back(TopoDS::Edge(it.Current()));
  }
  return edges;
}

double distanceToEdges(const Vec3& p, const std::vector<BRepAdaptor_Curve>& edges) {
  const gp_Pnt point(p.x(), p.y(), p.z());
  double nearest = std::numeric_limits<double>::infinity();
  for (const BRepAdaptor_Curve& edge : edges) {
    nearest = std::min({nearest, point.Distance(edge.Value(edge.FirstParameter())),
                        point.Distance(edge.Value(edge.LastParameter()))});
    const Extrema_ExtPC feet(point, edge);
    for (int i = 1; feet.IsDone() && i <= feet.NbExt(); ++i) {
      nearest = std::min(nearest, std::sqrt(feet.SquareDistance(i)));
    }
  }
  return nearest;
}

double distanceToContours(const Vec3& p, const std::vector<Contour>& contours) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Contour& contour : contours) {
    const std::size_t n = contour.points.size();
    for (std::size_t k = 0; k + (contour.closed ? 0 : 1) < n; ++k) {
      nearest = std::min(nearest, wcam::geometry::distanceToSegment(p, contour.points[k].p,
                                                                    contour.points[(k + 1) % n].p));
    }
  }
  return nearest;
}

struct Difference {
  double ours = 0.0;    ///< greatest distance of our points to the edges of Section
  double theirs = 0.0;  ///< greatest distance of points of Section to our polylines
};

void compare(const std::vector<Contour>& contours,
             const std::vector<BRepAdaptor_Curve>& edges,
             Difference& worst) {
  for (const Contour& contour : contours) {
    for (const auto& point : contour.points) {
      worst.ours = std::max(worst.ours, distanceToEdges(point.p, edges));
    }
  }
  constexpr int kSamples = 200;
  for (const BRepAdaptor_Curve& edge : edges) {
    const double first = edge.FirstParameter();
    const double step = (edge.LastParameter() - first) / kSamples;
    for (int i = 0; i <= kSamples; ++i) {
      const gp_Pnt p = edge.Value(first + step * i);
      worst.theirs =
          std::max(worst.theirs, distanceToContours(Vec3(p.X(), p.Y(), p.Z()), contours));
    }
  }
}

std::size_t pointCount(const SlicedLayers& sliced) {
  std::size_t count = 0;
  for (const auto& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      count += contour.points.size();
    }
  }
  return count;
}

/// Import and sections on so many threads (0: all).
struct OwnTimes {
  int threads = 1;
  Times import, slicing;

  [[nodiscard]] double total() const { return import.min() + slicing.min(); }
};

int run() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const BladeFile file;
  const std::vector<LayerLevel> levels = middleLevels();
  STEPControl_Reader reader;
  reader.ReadFile(file.path().c_str());
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();

  std::array<OwnTimes, 2> own;
  own[1].threads = 0;
  Times section;
  SlicedLayers sliced;
  std::size_t triangles = 0;
  Difference worst;
  std::size_t next = kSectionEvery / 2;
  std::size_t compared = 0;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    for (OwnTimes& times : own) {
      const wcam::ThreadLimit limit(times.threads);
      const Part part = times.import.measure([&] { return import(file.path()); });
      sliced = times.slicing.measure([&] { return slice(part, levels); });
      triangles = part->mesh.triangles.size();
    }
    // The planes of Section are spread over the repetitions.
    const std::size_t end = kPlanes * static_cast<std::size_t>(repetition + 1) / kRepetitions;
    for (; next < end && sliced.layers.size() == kPlanes; next += kSectionEvery) {
      const auto edges = section.measure([&] { return sectionEdges(shape, levels[next].value); });
      compare(sliced.layers[next].contours, edges, worst);
      ++compared;
    }
  }
  if (compared == 0) {
    std::printf("%zu of %zu planes met the part: the run is invalid\n", sliced.layers.size(),
                kPlanes);
    return 1;
  }
  const double anchor = section.median() * static_cast<double>(kPlanes);
  const std::size_t points = pointCount(sliced);
  std::printf("loft of 8 B-spline sections, %zu triangles, %zu planes, %zu points\n", triangles,
              kPlanes, points);
  for (const OwnTimes& times : own) {
    std::printf(
        "  own, %s threads: import %.3f s, sections %.4f s (%.3f ms/plane, %.0f ns/point)\n",
        times.threads == 1 ? "1  " : "all", times.import.min(), times.slicing.min(),
        times.slicing.min() * 1e3 / kPlanes,
        times.slicing.min() * 1e9 / static_cast<double>(points));
  }
  std::printf("  Section: %.1f ms/plane (median of %zu planes), scaled to %zu planes: %.2f s\n",
              section.median() * 1e3, compared, kPlanes, anchor);
  std::printf("  ratio with import: 1 thread %.1f, all threads %.1f, goal %.0f; without: %.0f\n",
              anchor / own[0].total(), anchor / own[1].total(), kGoal,
              anchor / own[0].slicing.min());
  std::printf(
      "  worst distance of points to Section's edges %.1e mm (bound %.0e), of Section's "
      "edges to the polylines %.1e mm\n",
      worst.ours, kAgreement, worst.theirs);
  const bool agree = worst.ours <= kAgreement && worst.theirs <= kSampling.chordError + kAgreement;
  if (!agree) {
    std::printf("  the results do not agree: the run is invalid\n");
  }
  return agree ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_brep: %s\n", error.what());
    return 1;
  }
}
