// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"

#include "mesh_order.hpp"
#include "mesh_readers.hpp"
#include "polygon.hpp"
#include "text_scanner.hpp"
#include "weld_mesh.hpp"

#include <charconv>
#include <cmath>

namespace wcam::io {

namespace {

constexpr std::size_t kCheckInterval = 65536;
/// Decimals of a text file: about single precision, like binary formats.
constexpr double kTextPrecision = 1e-7;

class ObjParser {
public:
  ObjParser(std::string_view bytes, const std::string& file, const JobContext& context)
      : scanner_(bytes), file_(file), context_(context) {}

  RawMesh parse() {
    for (std::size_t lines = 0; !scanner_.atEnd(); ++lines) {
      if (lines % kCheckInterval == 0) {
        context_.check();
        context_.report(scanner_.fractionDone());
      }
      const std::string_view word = scanner_.wordOnLine();
      if (word == "v") {
        vertex();
      } else if (word == "f") {
        face();
      } else if ((word == "o" || word == "g") && name_.empty()) {
        name_ = printableName(scanner_.restOfLine());
        continue;
      } else if (!word.empty() && !isKnown(word)) {
        fail(text("%1 is not part of an OBJ file", {quoted(word)}));
      }
      skipLine(word);
    }
    RawMesh raw;
    raw.mesh = std::move(mesh_);
    raw.weldedPoints = weldVertices(raw.mesh);
    raw.relativePrecision = kTextPrecision;
    raw.bodies.push_back({name_, "mesh", {}, 0});
    sortForLocality(raw.mesh);
    return raw;
  }

private:
  [[noreturn]] void fail(const Text& what) const {
    throw Error(ErrorCode::InputInvalid,
                text("line %1: %2", {std::to_string(scanner_.line()), what}), file_,
                "the file is damaged or is not an OBJ file; export it again");
  }

  /// Keywords of the format that carry no triangles, by their letters only: writers invent some.
  static bool isKnown(std::string_view word) {
    if (word.front() == '#') {
      return true;
    }
    for (const char c : word) {
      const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
      if (!letter) {
        return false;
      }
    }
    return true;
  }

  /// Skips the line, and those it is continued on by a backslash.
  void skipLine(std::string_view word) {
    std::string_view rest = scanner_.restOfLine();
    const bool comment = !word.empty() && word.front() == '#';
    while (!comment && !rest.empty() && rest.back() == '\\' && !scanner_.atEnd()) {
      rest = scanner_.restOfLine();
    }
  }

  void vertex() {
    geometry::Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = scanner_.wordOnLine();
      const auto number = scanNumber(word);
      if (!number || !std::isfinite(*number)) {
        fail(text("vertex %1 has %2 instead of a finite number",
                  {std::to_string(mesh_.vertices.size()), quoted(word)}));
      }
      p[k] = *number;
    }
    mesh_.vertices.push_back(p);
  }

  void face() {
    corners_.clear();
    for (std::string_view word = scanner_.wordOnLine(); !word.empty();
         word = scanner_.wordOnLine()) {
      if (word == "\\") {
        scanner_.skipLine();
        continue;
      }
      corners_.push_back(corner(word));
    }
    if (corners_.size() < 3 || corners_.size() > kMaxPolygonCorners) {
      fail(text("a face has %1 corners", {std::to_string(corners_.size())}));
    }
    dividePolygon(mesh_.vertices, corners_, mesh_.triangles);
    if (mesh_.triangles.size() >= geometry::HalfEdges::kNone / 3) {
      fail("there are more triangles than can be handled");
    }
  }

  /// "7", "7/1", "7//3", "-1": vertices count from 1, or back from the last one.
  [[nodiscard]] std::uint32_t corner(std::string_view word) const {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool number = error == std::errc() && (end == word.data() + word.size() || *end == '/');
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t position = index > 0 ? index - 1 : count + index;
    if (!number || index == 0 || position < 0 || position >= count) {
      fail(text("the face refers to vertex %1; there are %2 before it",
                {quoted(word), std::to_string(count)}));
    }
    return static_cast<std::uint32_t>(position);
  }

  TextScanner scanner_;
  const std::string& file_;
  const JobContext& context_;
  geometry::TriangleMesh mesh_;
  std::vector<std::uint32_t> corners_;
  std::string name_;
};

}  // namespace

RawMesh parseObj(std::string_view bytes, const std::string& file, const JobContext& context) {
  return ObjParser(bytes, file, context).parse();
}

}  // namespace wcam::io
