// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"

#include "mesh_order.hpp"
#include "mesh_readers.hpp"
#include "polygon.hpp"
#include "text_scanner.hpp"
#include "weld_mesh.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace wcam::io {

namespace {

constexpr std::size_t kCheckInterval = 65536;
/// Decimals of a text file: about single precision, like binary formats.
constexpr double kTextPrecision = 1e-7;

/// A face with corners that the file had not come to when the face was read.
struct LaterFace {
  std::size_t line = 0;
  std::vector<std::uint32_t> corners;
};

class ObjParser {
public:
  ObjParser(std::string_view text, const std::string& file, const JobContext& context)
      : scanner_(text), file_(file), context_(context) {}

  RawMesh parse() {
    for (std::size_t lines = 0; !scanner_.atEnd(); ++lines) {
      if (lines % kCheckInterval == 0) {
        context_.check();
        context_.report(scanner_.fractionDone());
      }
      line(scanner_.wordOnLine());
    }
    for (const LaterFace& face : laterFaces_) {
      addLater(face);
    }
    tellLeftOut();
    RawMesh raw;
    raw.mesh = std::move(mesh_);
    raw.weldedPoints = weldVertices(raw.mesh);
    raw.relativePrecision = kTextPrecision;
    raw.bodies.push_back({name_, "mesh", {}, 0});
    sortForLocality(raw.mesh);
    return raw;
  }

private:
  void line(std::string_view word) {
    if (word == "v") {
      vertex();
    } else if (word == "f" || word == "fo") {
      face();
    } else if ((word == "o" || word == "g") && name_.empty()) {
      name_ = printableName(scanner_.restOfLine());
      return;
    } else if (word == "l" || word == "p") {
      ++linesAndPoints_;
    } else if (word == "surf" || word == "curv") {
      ++freeForms_;
    } else if (word == "call") {
      ++calls_;
    } else if (!word.empty() && !isKnown(word)) {
      fail(scanner_.line(), text("%1 is not part of an OBJ file", {quoted(word)}));
    }
    skipLine(word);
  }

  [[noreturn]] void fail(std::size_t line, const Text& what) const {
    throw Error(ErrorCode::InputInvalid, text("line %1: %2", {std::to_string(line), what}), file_,
                "the file is damaged or is not an OBJ file; export it again");
  }

  /// Keywords of the format that carry no triangles, by their letters only: writers invent some.
  static bool isKnown(std::string_view word) {
    if (word.front() == '#' || word == "\\") {
      return true;
    }
    const auto isLetter = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    const auto isWordLetter = [&](char c) { return isLetter(c) || (c >= '0' && c <= '9'); };
    return isLetter(word.front()) && std::all_of(word.begin(), word.end(), isWordLetter);
  }

  /// Next word of a line and of those it is continued on by a backslash; empty at the end and at
  /// a comment.
  std::string_view next() {
    while (true) {
      std::string_view word = scanner_.wordOnLine();
      if (word.starts_with('#')) {
        inComment_ = true;
        return {};
      }
      if (word.empty() || word.back() != '\\' || !scanner_.atLineEnd()) {
        return word;
      }
      scanner_.skipLine();
      word.remove_suffix(1);
      if (!word.empty()) {
        return word;
      }
    }
  }

  /// Skips the line, and those it is continued on.
  void skipLine(std::string_view word) {
    const bool comment = inComment_ || word.starts_with('#');
    inComment_ = false;
    std::string_view rest = scanner_.restOfLine();
    if (rest.empty() && word.ends_with('\\')) {
      rest = word;
    }
    while (!comment && rest.ends_with('\\') && !scanner_.atEnd()) {
      rest = scanner_.restOfLine();
    }
  }

  void vertex() {
    geometry::Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = next();
      const auto number = scanNumber(word);
      if (!number || !std::isfinite(*number)) {
        fail(scanner_.line(), text("vertex %1 has %2 instead of a finite number",
                                   {std::to_string(mesh_.vertices.size()), quoted(word)}));
      }
      if (!isCoordinate(*number)) {
        fail(scanner_.line(), text("vertex %1 has a coordinate of %2, which is too large",
                                   {std::to_string(mesh_.vertices.size()), quoted(word)}));
      }
      p[k] = *number;
    }
    mesh_.vertices.push_back(p);
  }

  void face() {
    const std::size_t line = scanner_.line();
    corners_.clear();
    bool later = false;
    for (std::string_view word = next(); !word.empty(); word = next()) {
      corners_.push_back(corner(word));
      later = later || corners_.back() >= mesh_.vertices.size();
    }
    if (corners_.empty() || corners_.size() > kMaxPolygonCorners) {
      fail(line, text("a face has %1 corners", {std::to_string(corners_.size())}));
    }
    if (corners_.size() < 3) {
      ++thinFaces_;
    } else if (later) {
      laterFaces_.push_back({line, corners_});
    } else {
      add(line, corners_);
    }
  }

  void add(std::size_t line, const std::vector<std::uint32_t>& corners) {
    dividePolygon(mesh_.vertices, corners, mesh_.triangles);
    if (mesh_.triangles.size() >= geometry::HalfEdges::kNone / 3) {
      fail(line, "there are more triangles than can be handled");
    }
  }

  void addLater(const LaterFace& face) {
    for (const std::uint32_t v : face.corners) {
      if (v >= mesh_.vertices.size()) {
        fail(face.line,
             text("the face refers to vertex %1; the file has %2",
                  {std::to_string(std::uint64_t{v} + 1), std::to_string(mesh_.vertices.size())}));
      }
    }
    add(face.line, face.corners);
  }

  /// "7", "7/1", "7//3", "-1": vertices count from 1, or back from the last one before the face.
  [[nodiscard]] std::uint32_t corner(std::string_view word) const {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool number = error == std::errc() && (end == word.data() + word.size() || *end == '/');
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t position = index > 0 ? index - 1 : count + index;
    if (!number || index == 0 || position < 0 || position >= geometry::HalfEdges::kNone) {
      fail(scanner_.line(), text("the face refers to vertex %1; there are %2 before it",
                                 {quoted(word), std::to_string(count)}));
    }
    return static_cast<std::uint32_t>(position);
  }

  void tellLeftOut() const {
    addCounted(context_, Severity::Information, "import.edges_left_out",
               thinFaces_ + linesAndPoints_,
               text(thinFaces_ + linesAndPoints_ == 1
                        ? "%1 line, point or face with fewer than three corners is left out"
                        : "%1 lines, points and faces with fewer than three corners are left out",
                    {std::to_string(thinFaces_ + linesAndPoints_)}));
    addCounted(
        context_, Severity::Warning, "import.free_form_left_out", freeForms_,
        text(freeForms_ == 1 ? "%1 free-form curve or surface of the OBJ file is left out"
                             : "%1 free-form curves and surfaces of the OBJ file are left out",
             {std::to_string(freeForms_)}),
        "export the part as a mesh or as STEP");
    addCounted(context_, Severity::Warning, "import.other_file_left_out", calls_,
               text(calls_ == 1 ? "%1 call of another file in the OBJ file is not followed"
                                : "%1 calls of other files in the OBJ file are not followed",
                    {std::to_string(calls_)}),
               "export the part as one file");
  }

  TextScanner scanner_;
  const std::string& file_;
  const JobContext& context_;
  geometry::TriangleMesh mesh_;
  std::vector<std::uint32_t> corners_;
  std::vector<LaterFace> laterFaces_;
  std::string name_;
  bool inComment_ = false;
  std::size_t thinFaces_ = 0;
  std::size_t linesAndPoints_ = 0;
  std::size_t freeForms_ = 0;
  std::size_t calls_ = 0;
};

}  // namespace

RawMesh parseObj(std::string_view bytes, const std::string& file, const JobContext& context) {
  const PlainText text(bytes);
  return ObjParser(text.view(), file, context).parse();
}

}  // namespace wcam::io
