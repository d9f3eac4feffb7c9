// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stl_parser.hpp"

#include "wcam/base/error.hpp"

#include "mesh_order.hpp"
#include "text_scanner.hpp"
#include "weld.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

namespace wcam::io {

namespace {

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kFacetSize = 50;
constexpr std::size_t kNormalSize = 12;
/// Triangles between two looks at the cancel request.
constexpr std::size_t kCheckInterval = 65536;
/// Triangles whose table slots are fetched ahead of their use.
constexpr std::size_t kBatch = 16;

[[noreturn]] void notFinite(const std::string& file, std::size_t triangle) {
  throw Error(ErrorCode::InputInvalid,
              text("triangle %1 has a coordinate that is not a number", {std::to_string(triangle)}),
              file, "export the part again; triangles are counted from 0");
}

std::uint64_t declaredTriangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderSize - sizeof(count), sizeof(count));
  return count;
}

std::uint64_t declaredSize(std::string_view bytes) {
  return kHeaderSize + kFacetSize * declaredTriangles(bytes);
}

/// Where a text begins to look like an ASCII STL file.
constexpr std::size_t kHeadSize = 4096;

/// True when the next words begin a facet; a name may hold the word alone.
bool atFacet(TextScanner scanner) {
  if (!equalNoCase(scanner.word(), "facet")) {
    return false;
  }
  const std::string_view next = scanner.word();
  return equalNoCase(next, "normal") || equalNoCase(next, "outer") || equalNoCase(next, "vertex");
}

bool isComment(std::string_view word) {
  return word.starts_with('#') || word.starts_with("//") || word.starts_with(';');
}

/// True for text that begins with the word "solid" or with a facet, after comments.
bool startsWithSolid(std::string_view head) {
  TextScanner scanner(head);
  while (true) {
    if (atFacet(scanner)) {
      return true;
    }
    const std::string_view word = scanner.word();
    if (!isComment(word)) {
      return equalNoCase(word, "solid");
    }
    scanner.skipLine();
  }
}

bool holdsFacet(std::string_view head) {
  TextScanner scanner(head);
  for (; !scanner.peekWord().empty(); scanner.word()) {
    if (atFacet(scanner)) {
      return true;
    }
  }
  return false;
}

bool sizeFits(std::string_view bytes) {
  return bytes.size() >= kHeaderSize && declaredTriangles(bytes) > 0 &&
         declaredSize(bytes) == bytes.size();
}

/// Both kinds may begin with "solid". A binary file has zeros in its count, unless it has more than
/// 16 million triangles; a text may have its first line filled up with zeros.
bool isAscii(std::string_view bytes) {
  const PlainText head(bytes.substr(0, kHeadSize));
  if (sizeFits(bytes) || !startsWithSolid(head.view())) {
    return false;
  }
  return looksLikeText(head.view()) ||
         (bytes.size() >= kHeaderSize && declaredSize(bytes) > bytes.size() &&
          holdsFacet(head.view()));
}

using FloatWelder = PointWelder<float>;

struct Corners {
  std::array<FloatWelder::Point, 3> point;
  std::array<std::uint32_t, 3> tag;
};

/// Corners of one facet. Summing the products with 0 finds NaN and infinity without a branch each.
bool loadCorners(const char* facet, const FloatWelder& welder, Corners& corners) {
  std::memcpy(&corners.point, facet + kNormalSize, sizeof(corners.point));
  float check = 0.0F;
  for (std::size_t c = 0; c < 3; ++c) {
    for (const float x : corners.point[c]) {
      check += x * 0.0F;
    }
    corners.tag[c] = FloatWelder::tagOf(corners.point[c]);
    welder.prefetch(corners.tag[c]);
  }
  return check == 0.0F;
}

geometry::TriangleMesh toMesh(const std::vector<FloatWelder::Point>& points,
                              std::vector<std::array<std::uint32_t, 3>> triangles) {
  geometry::TriangleMesh mesh;
  mesh.vertices.reserve(points.size());
  for (const auto& p : points) {
    mesh.vertices.emplace_back(p[0], p[1], p[2]);
  }
  mesh.triangles = std::move(triangles);
  return mesh;
}

ParsedMesh parseBinary(std::string_view bytes, const std::string& file, const JobContext& context) {
  const std::size_t count = declaredTriangles(bytes);
  FloatWelder welder(count / 2 + 2);
  std::vector<std::array<std::uint32_t, 3>> triangles(count);
  std::array<Corners, kBatch> batch;
  for (std::size_t begin = 0; begin < count; begin += kBatch) {
    if (begin % kCheckInterval == 0) {
      context.check();
      context.report(static_cast<double>(begin) / static_cast<double>(count));
    }
    const std::size_t size = std::min(kBatch, count - begin);
    for (std::size_t k = 0; k < size; ++k) {
      if (!loadCorners(bytes.data() + kHeaderSize + kFacetSize * (begin + k), welder, batch[k])) {
        notFinite(file, begin + k);
      }
    }
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        triangles[begin + k][c] = welder.add(batch[k].point[c], batch[k].tag[c]);
      }
    }
  }
  ParsedMesh result;
  result.mesh = toMesh(welder.points(), std::move(triangles));
  result.weldedPoints = 3 * count - result.mesh.vertices.size();
  result.trailingBytes = bytes.size() - declaredSize(bytes);
  return result;
}

/// Reads "facet … endfacet" blocks: words in any case, on lines or not; comments and colours are
/// skipped.
class AsciiParser {
public:
  AsciiParser(std::string_view text, const std::string& file, const JobContext& context)
      : scanner_(text), file_(file), context_(context), welder_(text.size() / 512) {}

  ParsedMesh parse() {
    ParsedMesh result;
    bool ended = false;
    while (true) {
      if (atFacet(scanner_)) {
        scanner_.word();
        facet();
        ended = false;
        continue;
      }
      const std::string_view word = scanner_.word();
      if (word.empty()) {
        break;
      }
      if (equalNoCase(word, "solid")) {
        const std::string_view name = nameOnLine();
        if (result.name.empty()) {
          result.name = printableName(name);
        }
      } else if (equalNoCase(word, "endsolid") || endOf(word, "solid")) {
        nameOnLine();
        ended = true;
      } else if (!skipAside(word)) {
        fail(text("%1 is not part of an STL file", {quoted(word)}));
      }
    }
    result.endMissing = !ended;
    for (const auto& p : welder_.points()) {
      result.mesh.vertices.emplace_back(p[0], p[1], p[2]);
    }
    result.weldedPoints = 3 * triangles_.size() - result.mesh.vertices.size();
    result.mesh.triangles = std::move(triangles_);
    return result;
  }

private:
  [[noreturn]] void fail(const Text& what) const {
    throw Error(ErrorCode::InputInvalid,
                text("line %1: %2", {std::to_string(scanner_.line()), what}), file_,
                "the file is damaged or cut off; export it again");
  }

  /// What is left of the line, as far as no facet begins on it and no other solid.
  std::string_view nameOnLine() {
    std::string_view name;
    while (!scanner_.atLineEnd() && !atFacet(scanner_) && !atSolidWithFacet()) {
      const std::string_view word = scanner_.wordOnLine();
      name = name.empty() ? word
                          : std::string_view(
                                name.data(),
                                static_cast<std::size_t>(word.data() + word.size() - name.data()));
    }
    return name;
  }

  /// "solid … facet …" on one line, in files without line ends.
  [[nodiscard]] bool atSolidWithFacet() const {
    TextScanner ahead = scanner_;
    if (!equalNoCase(ahead.wordOnLine(), "solid")) {
      return false;
    }
    while (!ahead.atLineEnd() && !atFacet(ahead)) {
      ahead.wordOnLine();
    }
    return !ahead.atLineEnd();
  }

  /// "end" and the word apart; takes both.
  bool endOf(std::string_view word, std::string_view what) {
    const bool apart = equalNoCase(word, "end") && equalNoCase(scanner_.peekWord(), what);
    if (apart) {
      scanner_.word();
    }
    return apart;
  }

  /// Comments, and colours that some writers add.
  bool skipAside(std::string_view word) {
    if (isComment(word)) {
      scanner_.skipLine();
      return true;
    }
    if (!equalNoCase(word, "color") && !equalNoCase(word, "colour")) {
      return false;
    }
    while (scanNumber(scanner_.peekWord())) {
      scanner_.word();
    }
    return true;
  }

  /// Recomputed from the vertices; some writers put nan here, or leave numbers out.
  void skipNormal() {
    for (int k = 0; k < 3 && !isKeyword(scanner_.peekWord()); ++k) {
      scanner_.word();
    }
  }

  static bool isKeyword(std::string_view word) {
    constexpr std::array<std::string_view, 8> kWords{"outer",    "loop", "vertex", "endloop",
                                                     "endfacet", "end",  "color",  "colour"};
    return isComment(word) ||
           std::any_of(kWords.begin(), kWords.end(),
                       [&](std::string_view known) { return equalNoCase(word, known); });
  }

  void facet() {
    if (triangles_.size() % kCheckInterval == 0) {
      context_.check();
      context_.report(scanner_.fractionDone());
    }
    std::array<std::uint32_t, 3> triangle{};
    std::size_t corners = 0;
    for (std::string_view word = scanner_.word();; word = scanner_.word()) {
      if (equalNoCase(word, "vertex")) {
        if (corners == 3) {
          fail("a facet has more than three vertices");
        }
        triangle[corners++] = welder_.add(point());
      } else if (equalNoCase(word, "endfacet") || endOf(word, "facet")) {
        break;
      } else if (equalNoCase(word, "normal")) {
        skipNormal();
      } else if (word.empty()) {
        fail(text("the file ends inside facet %1", {std::to_string(triangles_.size())}));
      } else if (!equalNoCase(word, "outer") && !equalNoCase(word, "loop") &&
                 !equalNoCase(word, "endloop") && !endOf(word, "loop") && !skipAside(word)) {
        fail(text("%1 is not part of a facet", {quoted(word)}));
      }
    }
    if (corners != 3) {
      fail(text("a facet has %1 vertices instead of three", {std::to_string(corners)}));
    }
    triangles_.push_back(triangle);
  }

  PointWelder<double>::Point point() {
    PointWelder<double>::Point p{};
    for (double& x : p) {
      const std::string_view word = scanner_.word();
      const std::optional<double> number = scanNumber(word);
      if (!number) {
        fail(text("%1 is not a number", {quoted(word)}));
      }
      if (!std::isfinite(*number)) {
        notFinite(file_, triangles_.size());
      }
      x = *number;
    }
    return p;
  }

  TextScanner scanner_;
  const std::string& file_;
  const JobContext& context_;
  PointWelder<double> welder_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

bool looksLikeStl(std::string_view bytes) {
  return sizeFits(bytes) || isAscii(bytes);
}

ParsedMesh parseStl(std::string_view bytes, const std::string& file, const JobContext& context) {
  if (isAscii(bytes)) {
    const PlainText text(bytes);
    ParsedMesh result = AsciiParser(text.view(), file, context.portion(0.0, 0.8)).parse();
    sortForLocality(result.mesh);
    return result;
  }
  if (const std::string_view first = TextScanner(bytes).word();
      looksLikeText(bytes) && !first.empty() && !sizeFits(bytes)) {
    throw Error(ErrorCode::InputInvalid,
                text("is a text that begins with %1 instead of 'solid'", {quoted(first)}), file,
                "the file is damaged or is not an STL file; export it again");
  }
  if (bytes.size() < kHeaderSize) {
    throw Error(ErrorCode::InputInvalid,
                text("is too short for an STL file (%1 bytes)", {std::to_string(bytes.size())}),
                file, "export the part again");
  }
  const std::uint64_t count = declaredTriangles(bytes);
  if (count == 0 && bytes.size() > kHeaderSize) {
    throw Error(ErrorCode::InputInvalid,
                text("the header tells no triangles, but %1 bytes follow it",
                     {std::to_string(bytes.size() - kHeaderSize)}),
                file, "the file was not finished or is not an STL file; export it again");
  }
  if (declaredSize(bytes) > bytes.size()) {
    throw Error(ErrorCode::InputInvalid,
                text("the header tells %1 triangles (%2 bytes), the file has only %3 bytes",
                     {std::to_string(count), std::to_string(declaredSize(bytes)),
                      std::to_string(bytes.size())}),
                file, "the file is cut off or is not an STL file; export it again");
  }
  if (count >= geometry::HalfEdges::kNone / 3) {
    throw Error(ErrorCode::InputInvalid,
                text("has %1 triangles, more than can be handled", {std::to_string(count)}), file,
                "export the part with a larger tolerance");
  }
  ParsedMesh result = parseBinary(bytes, file, context.portion(0.0, 0.8));
  sortForLocality(result.mesh);
  return result;
}

}  // namespace wcam::io
