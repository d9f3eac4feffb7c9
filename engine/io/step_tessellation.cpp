// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_tessellation.hpp"

#include "wcam/base/error.hpp"

#include "mesh_order.hpp"
#include "step_text.hpp"
#include "text_scanner.hpp"
#include "weld_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace wcam::io {

namespace {

using geometry::Vec3;

/// Sets within sets; deeper ones are damaged.
constexpr int kMaxDepth = 32;
constexpr double kTextPrecision = 1e-7;

struct Prefix {
  std::string_view name;
  const char* unit;
  double millimetres;
};

/// Of SI_UNIT, for metres.
constexpr std::array<Prefix, 7> kPrefixes{{{"$", "m", 1e3},
                                           {".MILLI.", "mm", 1.0},
                                           {".CENTI.", "cm", 10.0},
                                           {".DECI.", "dm", 100.0},
                                           {".KILO.", "km", 1e6},
                                           {".MICRO.", "um", 1e-3},
                                           {".NANO.", "nm", 1e-6}}};

/// True when an entity of this name is there: the name with an opening parenthesis.
bool hasEntity(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + name.size())) {
    const std::size_t next = text.find_first_not_of(" \t\r\n", at + name.size());
    const bool begins = at > 0 && (text[at - 1] == '=' || text[at - 1] == ' ' ||
                                   text[at - 1] == '\n' || text[at - 1] == '(');
    if (begins && next != std::string_view::npos && text[next] == '(') {
      return true;
    }
  }
  return false;
}

class TessellationParser {
public:
  TessellationParser(std::string_view text, const std::string& file, const JobContext& context)
      : text_(text), file_(file), context_(context), entities_(stepEntities(text)) {}

  RawMesh parse() {
    if (hasEntity(text_, "NEXT_ASSEMBLY_USAGE_OCCURRENCE")) {
      refuse("is an assembly of tessellated geometry, whose placements are not read");
    }
    for (const std::uint64_t number : representations()) {
      representation(number);
    }
    if (raw_.mesh.triangles.empty()) {
      refuse("has tessellated geometry, but no triangles that can be read");
    }
    addCounted(
        context_, Severity::Warning, "import.tessellation_left_out", leftOut_,
        text("%1 tessellated items that are no triangles are left out", {std::to_string(leftOut_)}),
        "check that the part is complete");
    addCounted(context_, Severity::Information, "import.tessellated", raw_.mesh.triangles.size(),
               text("the STEP file has tessellated geometry only: its %1 triangles are read, and "
                    "there are no exact surfaces",
                    {std::to_string(raw_.mesh.triangles.size())}));
    raw_.weldedPoints = weldVertices(raw_.mesh);
    raw_.relativePrecision = kTextPrecision;
    sortForLocality(raw_.mesh);
    return std::move(raw_);
  }

private:
  [[noreturn]] void refuse(const Text& what) const {
    throw Error(ErrorCode::InputInvalid, what, file_,
                "export the part with exact geometry, or as STL or 3MF");
  }

  [[noreturn]] void fail(std::uint64_t number, const Text& what) const {
    throw Error(ErrorCode::InputInvalid, text("entity #%1 %2", {std::to_string(number), what}),
                file_, "the file is damaged; export it again");
  }

  [[nodiscard]] StepCursor cursorOf(std::uint64_t number) const {
    const auto it = entities_.find(number);
    if (it == entities_.end()) {
      fail(number, "does not exist");
    }
    return StepCursor(it->second);
  }

  /// Numbers of the representations, in order.
  [[nodiscard]] std::vector<std::uint64_t> representations() const {
    std::vector<std::uint64_t> found;
    for (const auto& [number, entity] : entities_) {
      const std::string_view name = StepCursor(entity).keyword();
      if (name.starts_with("TESSELLATED_SHAPE_REPRESENTATION")) {
        found.push_back(number);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  /// (name, items, context)
  void representation(std::uint64_t number) {
    StepCursor cursor = cursorOf(number);
    cursor.keyword();
    if (!cursor.take('(') || !cursor.skip() || !cursor.take(',')) {
      fail(number, "has no items");
    }
    const std::vector<std::uint64_t> items = references(number, cursor);
    if (!cursor.take(',')) {
      fail(number, "has no context");
    }
    const auto [unit, scale] = unitOf(cursor.reference().value_or(0));
    if (raw_.unit.empty()) {
      raw_.unit = unit;
      raw_.millimetresPerUnit = scale;
    }
    scale_ = scale / raw_.millimetresPerUnit;
    const std::string product = productName();
    for (const std::uint64_t item : items) {
      context_.check();
      const std::size_t before = raw_.mesh.triangles.size();
      const std::string name = addItem(item, 0);
      if (raw_.mesh.triangles.size() > before) {
        raw_.bodies.push_back({name.empty() ? product : name, "mesh", {}, 0});
      }
    }
  }

  /// Name of the file's product, or its id; empty where there are several.
  [[nodiscard]] std::string productName() const {
    std::string found;
    for (const auto& [number, entity] : entities_) {
      StepCursor cursor(entity);
      if (cursor.keyword() != "PRODUCT" || !cursor.take('(')) {
        continue;
      }
      const std::string id = printableName(cursor.string().value_or(std::string_view()));
      cursor.take(',');
      const std::string name = printableName(cursor.string().value_or(std::string_view()));
      if (!found.empty()) {
        return {};
      }
      found = name.empty() ? id : name;
    }
    return found;
  }

  std::vector<std::uint64_t> references(std::uint64_t number, StepCursor& cursor) const {
    std::vector<std::uint64_t> list;
    if (!cursor.take('(')) {
      fail(number, "has no list where one belongs");
    }
    while (const auto reference = cursor.reference()) {
      list.push_back(*reference);
      cursor.take(',');
    }
    if (!cursor.take(')')) {
      fail(number, "has a damaged list");
    }
    return list;
  }

  /// Adds an item of a representation. @return its name
  std::string addItem(std::uint64_t number, int depth) {
    StepCursor cursor = cursorOf(number);
    const std::string_view kind = cursor.keyword();
    if (depth > kMaxDepth) {
      fail(number, "refers to itself");
    }
    if (kind.empty() &&
        entities_.at(number).find("REPOSITIONED_TESSELLATED_ITEM") != std::string_view::npos) {
      refuse(text("has tessellated geometry that is placed apart (#%1), which is not read",
                  {std::to_string(number)}));
    }
    if (!cursor.take('(')) {
      ++leftOut_;
      return {};
    }
    const std::string name = printableName(cursor.string().value_or(std::string_view()));
    if (!cursor.take(',')) {
      fail(number, "has too few parameters");
    }
    if (kind == "TESSELLATED_SOLID" || kind == "TESSELLATED_SHELL" ||
        kind == "TESSELLATED_GEOMETRIC_SET") {
      for (const std::uint64_t part : references(number, cursor)) {
        addItem(part, depth + 1);
      }
    } else if (kind == "TRIANGULATED_FACE" || kind == "TRIANGULATED_SURFACE_SET" ||
               kind == "COMPLEX_TRIANGULATED_FACE" || kind == "COMPLEX_TRIANGULATED_SURFACE_SET") {
      face(number, cursor, kind.ends_with("FACE"), kind.starts_with("COMPLEX"));
    } else if (!kind.starts_with("AXIS2_PLACEMENT")) {
      ++leftOut_;  // a placement of the representation is no geometry
    }
    return name;
  }

  /// (name, coordinates, pnmax, normals, [geometric link,] pnindex, triangles) or, at the end,
  /// (…, strips, fans).
  void face(std::uint64_t number, StepCursor& cursor, bool linked, bool complex) {
    const auto coordinates = cursor.reference();
    const auto skip = [&] {
      if (!cursor.take(',') || !cursor.skip()) {
        fail(number, "has too few parameters");
      }
    };
    if (!coordinates) {
      fail(number, "has no coordinates");
    }
    skip();  // pnmax
    skip();  // normals
    if (linked) {
      skip();
    }
    const std::vector<std::uint32_t>& points = pointsOf(*coordinates);
    if (!cursor.take(',')) {
      fail(number, "has too few parameters");
    }
    const std::vector<std::size_t> index = indices(number, cursor);
    const auto vertex = [&](std::size_t local) {
      const std::size_t at = index.empty()                         ? local
                             : local >= 1 && local <= index.size() ? index[local - 1]
                                                                   : 0;
      if (at < 1 || at > points.size()) {
        fail(number, text("refers to point %1, which does not exist", {std::to_string(local)}));
      }
      return points[at - 1];
    };
    eachList(number, cursor, [&](const std::vector<std::size_t>& corners) {
      if (!complex && corners.size() != 3) {
        fail(number, "has a triangle without three corners");
      }
      for (std::size_t k = 0; k + 2 < corners.size(); ++k) {
        const bool turned = k % 2 == 1;
        addTriangle(vertex(corners[turned ? k + 1 : k]), vertex(corners[turned ? k : k + 1]),
                    vertex(corners[k + 2]));
      }
    });
    if (complex) {
      eachList(number, cursor, [&](const std::vector<std::size_t>& corners) {
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
          addTriangle(vertex(corners[0]), vertex(corners[k]), vertex(corners[k + 1]));
        }
      });
    }
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) {
      raw_.mesh.triangles.push_back({a, b, c});
    }
  }

  /// "(1,2,3)"
  std::vector<std::size_t> indices(std::uint64_t number, StepCursor& cursor) const {
    std::vector<std::size_t> list;
    if (!cursor.take('(')) {
      fail(number, "has no list where one belongs");
    }
    while (const auto value = cursor.number()) {
      if (!(*value >= 1.0) || *value != std::floor(*value) || *value > 4294967295.0) {
        fail(number, "has an index that is no positive whole number");
      }
      list.push_back(static_cast<std::size_t>(*value));
      cursor.take(',');
    }
    if (!cursor.take(')')) {
      fail(number, "has a damaged list");
    }
    return list;
  }

  /// ",((1,2,3),(4,5,6))"
  template <class Use>
  void eachList(std::uint64_t number, StepCursor& cursor, const Use& use) {
    if (!cursor.take(',') || !cursor.take('(')) {
      fail(number, "has too few parameters");
    }
    while (!cursor.take(')')) {
      use(indices(number, cursor));
      cursor.take(',');
    }
  }

  /// Vertices of a coordinates list: (name, npoints, ((x,y,z),…)). Each list is read once.
  const std::vector<std::uint32_t>& pointsOf(std::uint64_t number) {
    const auto it = points_.find({number, scale_});
    if (it != points_.end()) {
      return it->second;
    }
    StepCursor cursor = cursorOf(number);
    if (cursor.keyword() != "COORDINATES_LIST" || !cursor.take('(') || !cursor.skip() ||
        !cursor.take(',') || !cursor.skip() || !cursor.take(',') || !cursor.take('(')) {
      fail(number, "is no list of coordinates");
    }
    std::vector<std::uint32_t> list;
    while (!cursor.take(')')) {
      Vec3 p;
      if (!cursor.take('(')) {
        fail(number, "has a damaged list");
      }
      for (int k = 0; k < 3; ++k) {
        const auto value = cursor.number();
        cursor.take(',');
        if (!value || !isCoordinate(*value)) {
          fail(number, text("has a coordinate of point %1 that is no number or too large",
                            {std::to_string(list.size() + 1)}));
        }
        p[k] = *value * scale_;
      }
      if (!cursor.take(')')) {
        fail(number, "has a point without three coordinates");
      }
      cursor.take(',');
      list.push_back(static_cast<std::uint32_t>(raw_.mesh.vertices.size()));
      raw_.mesh.vertices.push_back(p);
    }
    return points_.emplace(std::pair{number, scale_}, std::move(list)).first->second;
  }

  /// Length unit of a representation's context; millimetres when it tells none.
  [[nodiscard]] std::pair<std::string, double> unitOf(std::uint64_t context) const {
    const auto it = entities_.find(context);
    const std::string_view entity = it == entities_.end() ? std::string_view() : it->second;
    constexpr std::string_view kUnits = "GLOBAL_UNIT_ASSIGNED_CONTEXT";
    const std::size_t at = entity.find(kUnits);
    if (at == std::string_view::npos) {
      return {"mm", 1.0};
    }
    StepCursor cursor(entity.substr(at + kUnits.size()));
    cursor.take('(');
    for (const std::uint64_t unit : references(context, cursor)) {
      const auto found = entities_.find(unit);
      if (found != entities_.end() && found->second.find("LENGTH_UNIT") != std::string_view::npos) {
        return lengthUnit(found->second, 0);
      }
    }
    return {"mm", 1.0};
  }

  [[nodiscard]] std::pair<std::string, double> lengthUnit(std::string_view entity,
                                                          int depth) const {
    constexpr std::string_view kSi = "SI_UNIT";
    constexpr std::string_view kConversion = "CONVERSION_BASED_UNIT";
    if (const std::size_t at = entity.find(kConversion);
        at != std::string_view::npos && depth < 2) {
      StepCursor cursor(entity.substr(at + kConversion.size()));
      cursor.take('(');
      const std::string name = printableName(cursor.string().value_or("unit"));
      cursor.take(',');
      const auto measure = entities_.find(cursor.reference().value_or(0));
      if (measure != entities_.end()) {
        return {name, conversion(measure->second, depth)};
      }
    } else if (const std::size_t si = entity.find(kSi); si != std::string_view::npos) {
      const std::string_view rest = entity.substr(si + kSi.size());
      const std::size_t begin = rest.find_first_not_of("( \t\r\n");
      for (const Prefix& prefix : kPrefixes) {
        if (begin != std::string_view::npos && rest.substr(begin).starts_with(prefix.name)) {
          return {prefix.unit, prefix.millimetres};
        }
      }
    }
    refuse("has a length unit that is not known");
  }

  /// "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#4)"
  [[nodiscard]] double conversion(std::string_view measure, int depth) const {
    constexpr std::string_view kMeasure = "LENGTH_MEASURE(";
    const std::size_t at = measure.find(kMeasure);
    if (at == std::string_view::npos) {
      refuse("has a length unit that is not known");
    }
    StepCursor cursor(measure.substr(at + kMeasure.size()));
    const auto factor = cursor.number();
    cursor.take(')');
    cursor.take(',');
    const auto unit = entities_.find(cursor.reference().value_or(0));
    if (!factor || !(*factor > 0.0) || !isCoordinate(*factor) || unit == entities_.end()) {
      refuse("has a length unit that is not known");
    }
    return *factor * lengthUnit(unit->second, depth + 1).second;
  }

  std::string_view text_;
  const std::string& file_;
  const JobContext& context_;
  StepEntities entities_;
  RawMesh raw_;
  std::map<std::pair<std::uint64_t, double>, std::vector<std::uint32_t>> points_;
  double scale_ = 1.0;
  std::size_t leftOut_ = 0;
};

}  // namespace

Tessellation tessellationOf(std::string_view text) {
  const bool tessellated = text.find("TESSELLATED_SHAPE_REPRESENTATION") != std::string_view::npos;
  if (!tessellated) {
    return Tessellation::None;
  }
  for (const char* exact : {"ADVANCED_FACE", "FACE_SURFACE", "FACETED_BREP", "FACE"}) {
    if (hasEntity(text, exact)) {
      return Tessellation::Beside;
    }
  }
  return Tessellation::Only;
}

RawMesh parseTessellatedStep(std::string_view text,
                             const std::string& file,
                             const JobContext& context) {
  return TessellationParser(text, file, context).parse();
}

}  // namespace wcam::io
