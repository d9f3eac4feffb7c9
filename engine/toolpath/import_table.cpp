// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/import_table.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/plausible.hpp"
#include "wcam/base/text.hpp"

#include "frames.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace wcam::toolpath {

namespace {

enum Column : std::size_t {
  kOp,
  kLayer,
  kBead,
  kX,
  kY,
  kZ,
  kNx,
  kNy,
  kNz,
  kBx,
  kBy,
  kBz,
  kAx,
  kAy,
  kAz,
  kHeight,
  kWidth,
  kArc,
  kColumns
};

constexpr std::array<const char*, kColumns> kNames = {
    "op", "layer", "bead", "x_mm", "y_mm", "z_mm", "nx",        "ny",       "nz",
    "bx", "by",    "bz",   "ax",   "ay",   "az",   "height_mm", "width_mm", "arc"};

/// Beyond it the memory of an ordinary computer ends; a path of this length burns for years.
constexpr std::size_t kMaxPoints = 50'000'000;
/// Coordinates and sizes beyond are damage or another unit, mm.
const double kMaxLength = plausibleRange(QuantityKind::Length).max;
constexpr std::size_t kCheckEvery = 4096;

/// One row, as far as it is used.
struct Row {
  int layer = 0;
  int bead = 0;
  bool arc = true;
  Vec3 b = Vec3::Zero();
  ContourPoint point;
};

class TableReader {
public:
  TableReader(std::string_view text, const std::string& source) : rest_(text), source_(source) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) {
      rest_.remove_prefix(kByteOrderMark.size());
    }
  }

  ImportedPath read(const JobContext& context) {
    readHeader();
    path_.hasNormals = has(kNx) || has(kBx);
    path_.hasAxes = has(kAx);
    std::size_t points = 0;
    while (nextLine()) {
      if (points % kCheckEvery == 0) {
        context.check();
      }
      if (++points > kMaxPoints) {
        fail(text("more than %1 points", {std::to_string(kMaxPoints)}), "divide the path");
      }
      addRow(readRow());
    }
    endRun();
    while (!path_.layers.empty() && path_.layers.back().empty()) {
      path_.layers.pop_back();
    }
    if (path_.layers.empty()) {
      fail("the table holds no bead of at least two points",
           "write one row per point, with the arc on");
    }
    return std::move(path_);
  }

private:
  [[noreturn]] void fail(const Text& message, const Text& hint) const {
    throw Error(ErrorCode::InputInvalid, message,
                line_ > 0 ? text("%1, line %2", {source_, std::to_string(line_)}) : Text(source_),
                hint);
  }

  [[nodiscard]] bool has(Column column) const { return place_[column].has_value(); }

  /// The next line that says something, in cells_.
  bool nextLine() {
    while (!rest_.empty()) {
      ++line_;
      const std::size_t end = rest_.find('\n');
      const std::string_view line = trimText(rest_.substr(0, end));
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      if (!line.empty() && line.front() != '#') {
        split(line);
        return true;
      }
    }
    return false;
  }

  void split(std::string_view line) {
    cells_.clear();
    for (std::size_t comma = line.find(','); comma != std::string_view::npos;
         comma = line.find(',')) {
      cells_.push_back(trimText(line.substr(0, comma)));
      line.remove_prefix(comma + 1);
    }
    cells_.push_back(trimText(line));
  }

  void readHeader() {
    if (!nextLine()) {
      fail("the file is empty", "give a table of points with a header line");
    }
    columns_ = cells_.size();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      for (std::size_t c = 0; c < kColumns; ++c) {
        if (cells_[i] == kNames[c]) {
          if (place_[c]) {
            fail(text("the column %1 stands twice in the header", {std::string(kNames[c])}),
                 "remove one of them");
          }
          place_[c] = i;
        }
      }
    }
    checkUnits();
    for (const Column needed : {kLayer, kBead, kX, kY, kZ}) {
      if (!has(needed)) {
        fail(text("the header has no column %1", {std::string(kNames[needed])}),
             "the header names the columns: layer,bead,x_mm,y_mm,z_mm and more");
      }
    }
    for (const Column first : {kNx, kBx, kAx}) {
      if (has(first) != has(static_cast<Column>(first + 1)) ||
          has(first) != has(static_cast<Column>(first + 2))) {
        fail(text("only a part of the columns %1, %2, %3 is there",
                  {std::string(kNames[first]), kNames[first + 1], kNames[first + 2]}),
             "give all three or none");
      }
    }
  }

  /// A column that differs from a known one in its unit alone would be read wrongly, or not at all.
  void checkUnits() const {
    for (const std::string_view cell : cells_) {
      for (const char* name : kNames) {
        const std::string_view known(name);
        const std::size_t unit = known.find("_mm");
        if (unit == std::string_view::npos || cell == known) {
          continue;
        }
        const std::string_view quantity = known.substr(0, unit);
        if (cell == quantity ||
            (cell.starts_with(quantity) && cell.substr(quantity.size()).starts_with('_'))) {
          fail(text("the column '%1' is not in mm", {std::string(cell)}),
               text("convert it and name it %1", {std::string(known)}));
        }
      }
    }
  }

  [[nodiscard]] std::string_view cell(Column column) const { return cells_[*place_[column]]; }

  [[nodiscard]] double number(Column column, double limit) const {
    const std::optional<double> value = parseReal(cell(column));
    if (!value || std::abs(*value) > limit) {
      fail(text("%1 is '%2', not a number within %3",
                {std::string(kNames[column]), std::string(cell(column)), formatFixed(limit, 0)}),
           "numbers have a decimal point and no unit");
    }
    return *value;
  }

  [[nodiscard]] int index(Column column) const {
    constexpr double kLargest = 1e9;
    const double value = number(column, kLargest);
    if (value < 0.0 || value != std::floor(value)) {
      fail(text("%1 is '%2', not a whole number from 0",
                {std::string(kNames[column]), std::string(cell(column))}),
           "count layers and beads from 0");
    }
    return static_cast<int>(value);
  }

  [[nodiscard]] Vec3 vector(Column first) const {
    Vec3 v;
    for (std::size_t k = 0; k < 3; ++k) {
      v[static_cast<Eigen::Index>(k)] = number(static_cast<Column>(first + k), kMaxLength);
    }
    return v;
  }

  /// A direction; the table's digits make it a unit vector only nearly.
  [[nodiscard]] Vec3 direction(Column first) const {
    const Vec3 v = vector(first);
    constexpr double kShortest = 1e-6;
    if (!(v.norm() > kShortest)) {
      fail(text("the vector %1, %2, %3 has no length",
                {kNames[first], kNames[first + 1], kNames[first + 2]}),
           "give a direction, or leave the three columns out");
    }
    return v.normalized();
  }

  [[nodiscard]] double size(Column column) const {
    const double value = number(column, kMaxLength);
    if (value < 0.0) {
      fail(text("%1 is negative", {std::string(kNames[column])}),
           "give a length, or 0 where it is not known");
    }
    return value;
  }

  Row readRow() {
    if (cells_.size() != columns_) {
      fail(text("the line has %1 cells, the header %2",
                {std::to_string(cells_.size()), std::to_string(columns_)}),
           "write one cell per column");
    }
    if (has(kOp)) {
      if (operation_ && *operation_ != cell(kOp)) {
        fail(text("a second operation '%1' begins", {std::string(cell(kOp))}),
             "give each operation a table of its own");
      }
      operation_ = cell(kOp);
    }
    Row row;
    row.layer = index(kLayer);
    row.bead = index(kBead);
    row.point.p = vector(kX);
    row.point.n = has(kNx) ? direction(kNx) : Vec3::Zero();
    row.b = has(kBx) ? direction(kBx) : Vec3::Zero();
    row.point.axis = has(kAx) ? direction(kAx) : Vec3::Zero();
    row.point.height = has(kHeight) ? size(kHeight) : 0.0;
    row.point.width = has(kWidth) ? size(kWidth) : 0.0;
    row.arc = !has(kArc) || number(kArc, 1.0) != 0.0;
    return row;
  }

  void addRow(const Row& row) {
    const bool newLayer = !last_ || row.layer != last_->layer;
    const bool newBead = newLayer || row.bead != last_->bead;
    if (last_ &&
        (row.layer < last_->layer || (row.layer == last_->layer && row.bead < last_->bead))) {
      fail(text("layer %1, bead %2 follows layer %3, bead %4",
                {std::to_string(row.layer), std::to_string(row.bead), std::to_string(last_->layer),
                 std::to_string(last_->bead)}),
           "order the rows by layer, bead and point");
    }
    if (newBead) {
      endRun();
      if (newLayer) {
        path_.layers.emplace_back();
      }
    } else if (!row.arc) {
      endRun();
    }
    // The first point of a bead, and one that is reached with the arc off, begin a run.
    run_.push_back(row);
    last_ = Row{row.layer, row.bead, row.arc, {}, {}};
  }

  void endRun() {
    std::vector<Row> run = std::move(run_);
    run_.clear();
    if (run.size() < 2) {
      return;
    }
    Contour contour;
    contour.feature = BeadFeature::Imported;
    constexpr std::size_t kLeastRing = 4;
    contour.closed = run.size() >= kLeastRing && run.front().point.p == run.back().point.p;
    if (contour.closed) {
      run.pop_back();
    }
    for (std::size_t i = 0; i < run.size(); ++i) {
      contour.points.push_back(run[i].point);
    }
    if (!has(kNx) && has(kBx)) {
      setNormalsFromBuildDirection(contour, run);
    }
    if (has(kNx) && has(kBx)) {
      contour.back = runsBack(contour.closed, run);
    }
    path_.layers.back().push_back(std::move(contour));
  }

  /// Travel and outward normal give the opposite of the build direction: the bead was reversed.
  static bool runsBack(bool closed, const std::vector<Row>& run) {
    const std::size_t n = run.size();
    double sum = 0.0;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
      const Vec3 way = run[(i + 1) % n].point.p - run[i].point.p;
      sum += way.cross(run[i].point.n).dot(run[i].b);
    }
    return sum < 0.0;
  }

  static void setNormalsFromBuildDirection(Contour& contour, const std::vector<Row>& run) {
    const std::size_t n = run.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = i > 0 ? i - 1 : (contour.closed ? n - 1 : 0);
      const std::size_t after = i + 1 < n ? i + 1 : (contour.closed ? 0 : n - 1);
      const Vec3 t = tangentAt(run[before].point.p, run[i].point.p, run[after].point.p);
      const Vec3 normal = run[i].b.cross(t);
      contour.points[i].n =
          normal.norm() > kNoDirection ? Vec3(normal.normalized()) : t.unitOrthogonal();
    }
  }

  std::string_view rest_;
  std::string source_;
  std::size_t line_ = 0;
  std::size_t columns_ = 0;
  std::array<std::optional<std::size_t>, kColumns> place_;
  std::vector<std::string_view> cells_;
  std::optional<std::string> operation_;
  std::optional<Row> last_;
  std::vector<Row> run_;
  ImportedPath path_;
};

}  // namespace

ImportedPath readPathTable(std::string_view text,
                           const std::string& source,
                           const JobContext& context) {
  return TableReader(text, source).read(context);
}

}  // namespace wcam::toolpath
