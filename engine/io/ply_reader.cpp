// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"

#include "mesh_order.hpp"
#include "mesh_readers.hpp"
#include "polygon.hpp"
#include "text_scanner.hpp"
#include "weld_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

namespace wcam::io {

namespace {

constexpr std::size_t kCheckInterval = 65536;

enum class Scalar { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

struct ScalarName {
  const char* text;
  Scalar scalar;
};

constexpr std::array<ScalarName, 16> kScalarNames{{{"char", Scalar::Int8},
                                                   {"int8", Scalar::Int8},
                                                   {"uchar", Scalar::Uint8},
                                                   {"uint8", Scalar::Uint8},
                                                   {"short", Scalar::Int16},
                                                   {"int16", Scalar::Int16},
                                                   {"ushort", Scalar::Uint16},
                                                   {"uint16", Scalar::Uint16},
                                                   {"int", Scalar::Int32},
                                                   {"int32", Scalar::Int32},
                                                   {"uint", Scalar::Uint32},
                                                   {"uint32", Scalar::Uint32},
                                                   {"float", Scalar::Float32},
                                                   {"float32", Scalar::Float32},
                                                   {"double", Scalar::Float64},
                                                   {"float64", Scalar::Float64}}};

std::size_t sizeOf(Scalar scalar) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(scalar)];
}

struct Property {
  std::string name;
  Scalar type = Scalar::Float32;
  std::optional<Scalar> count;  ///< of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  /// Fewest bytes that one takes: an empty list still has its count.
  [[nodiscard]] std::uint64_t leastSize(bool ascii) const {
    std::uint64_t size = 0;
    for (const Property& p : properties) {
      size += ascii ? 2 : sizeOf(p.count ? *p.count : p.type);
    }
    return size;
  }
};

enum class Encoding { Ascii, LittleEndian, BigEndian };

class PlyParser {
public:
  PlyParser(std::string_view bytes, const std::string& file, const JobContext& context)
      : bytes_(bytes), file_(file), context_(context), scanner_(bytes) {}

  RawMesh parse() {
    header();
    checkSizes();
    countVertices();
    for (const Element& element : elements_) {
      if (element.name == "vertex") {
        vertices(element);
      } else if (element.name == "face") {
        faces(element);
      } else if (element.name == "tristrips") {
        strips(element);
      } else {
        skip(element);
      }
    }
    for (const std::vector<std::uint32_t>& polygon : laterPolygons_) {
      dividePolygon(mesh_.vertices, polygon, mesh_.triangles);
    }
    addCounted(context_, Severity::Information, "import.edges_left_out", thinFaces_,
               text(thinFaces_ == 1
                        ? "%1 line, point or face with fewer than three corners is left out"
                        : "%1 lines, points and faces with fewer than three corners are left out",
                    {std::to_string(thinFaces_)}));
    RawMesh raw;
    raw.relativePrecision = singlePrecision_ ? 1e-7 : 1e-12;
    raw.mesh = std::move(mesh_);
    raw.weldedPoints = weldVertices(raw.mesh);
    raw.bodies.push_back({{}, "mesh", {}, 0});
    sortForLocality(raw.mesh);
    return raw;
  }

private:
  [[noreturn]] void fail(const Text& what) const {
    throw Error(ErrorCode::InputInvalid, what, file_,
                "the file is damaged or cut off; export it again");
  }

  [[noreturn]] void failInHeader(const Text& what) const {
    fail(text("header line %1: %2", {std::to_string(scanner_.line()), what}));
  }

  void header() {
    // Binary data may begin with LF: after a header with CR alone it is not part of the line end.
    const std::size_t firstEnd = bytes_.find_first_of("\r\n");
    const bool bareReturns = firstEnd != std::string_view::npos && bytes_[firstEnd] == '\r' &&
                             bytes_.substr(firstEnd, 2) != "\r\n";
    scanner_.skipLine();  // "ply"
    bool format = false;
    while (!scanner_.atEnd()) {
      const std::string_view word = scanner_.wordOnLine();
      if (word == "end_header") {
        const std::size_t lineEnd = bytes_.find_first_of("\r\n", scanner_.position());
        scanner_.skipLine();
        position_ =
            bareReturns && lineEnd != std::string_view::npos ? lineEnd + 1 : scanner_.position();
        if (!format) {
          fail("the header does not tell the format");
        }
        return;
      }
      if (word == "format") {
        readFormat(scanner_.wordOnLine());
        format = true;
      } else if (word == "element") {
        readElement();
      } else if (word == "property") {
        readProperty();
      } else if (!word.empty() && word != "comment" && word != "obj_info") {
        failInHeader(text("%1 is not known", {quoted(word)}));
      }
      scanner_.skipLine();
    }
    fail("the header has no end");
  }

  void readFormat(std::string_view word) {
    if (word == "ascii") {
      encoding_ = Encoding::Ascii;
    } else if (word == "binary_little_endian") {
      encoding_ = Encoding::LittleEndian;
    } else if (word == "binary_big_endian") {
      encoding_ = Encoding::BigEndian;
    } else {
      failInHeader(text("format %1 is not known", {quoted(word)}));
    }
  }

  void readElement() {
    Element element;
    element.name = scanner_.wordOnLine();
    const std::string_view count = scanner_.wordOnLine();
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (element.name.empty() || error != std::errc() || end != count.data() + count.size()) {
      failInHeader("an element has no number");
    }
    elements_.push_back(std::move(element));
  }

  void readProperty() {
    if (elements_.empty()) {
      failInHeader("a property without element");
    }
    Property property;
    std::string_view word = scanner_.wordOnLine();
    if (word == "list") {
      property.count = scalar(scanner_.wordOnLine());
      word = scanner_.wordOnLine();
    }
    property.type = scalar(word);
    property.name = scanner_.wordOnLine();
    elements_.back().properties.push_back(std::move(property));
  }

  [[nodiscard]] Scalar scalar(std::string_view word) const {
    for (const ScalarName& known : kScalarNames) {
      if (word == known.text) {
        return known.scalar;
      }
    }
    failInHeader(text("type %1 is not known", {quoted(word)}));
  }

  /// Before anything is allocated.
  void checkSizes() const {
    const bool ascii = encoding_ == Encoding::Ascii;
    std::uint64_t left = bytes_.size() - position_;
    left += ascii ? 1 : 0;  // the last number needs no blank after it
    for (const Element& element : elements_) {
      const std::uint64_t least = element.leastSize(ascii);
      const bool fits = least == 0 ? element.count <= left : element.count <= left / least;
      if (!fits || element.count >= geometry::HalfEdges::kNone / 3) {
        fail(text("the header tells %1 of element '%2', the file has only %3 bytes",
                  {std::to_string(element.count), element.name, std::to_string(bytes_.size())}));
      }
      left -= least * element.count;
    }
  }

  void countVertices() {
    for (const Element& element : elements_) {
      vertexCount_ += element.name == "vertex" ? element.count : 0;
    }
  }

  void look(const Element& element, std::uint64_t i) {
    if (i % kCheckInterval == 0) {
      context_.check();
      context_.report(
          static_cast<double>(encoding_ == Encoding::Ascii ? scanner_.position() : position_) /
          static_cast<double>(bytes_.size()));
    }
    current_ = &element;
    index_ = i;
  }

  [[nodiscard]] std::string place() const { return current_->name + " " + std::to_string(index_); }

  std::string_view asciiWord() {
    std::string_view word = scanner_.word();
    while (word == "comment" || word.starts_with('#')) {
      scanner_.skipLine();
      word = scanner_.word();
    }
    if (word.empty()) {
      fail(text("the file ends in %1", {place()}));
    }
    return word;
  }

  double number(Scalar type) {
    if (encoding_ == Encoding::Ascii) {
      const std::string_view word = asciiWord();
      const auto value = scanNumber(word);
      if (!value) {
        fail(text("%1 has %2 instead of a number", {place(), quoted(word)}));
      }
      return *value;
    }
    const std::size_t size = sizeOf(type);
    if (bytes_.size() - position_ < size) {
      fail(text("the file ends in %1", {place()}));
    }
    std::array<unsigned char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + position_, size);
    position_ += size;
    if ((encoding_ == Encoding::BigEndian) == (std::endian::native == std::endian::little)) {
      std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    }
    return decode(type, raw.data());
  }

  template <class T>
  static double as(const unsigned char* raw) {
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return static_cast<double>(value);
  }

  static double decode(Scalar type, const unsigned char* raw) {
    switch (type) {
      case Scalar::Int8:
        return as<std::int8_t>(raw);
      case Scalar::Uint8:
        return as<std::uint8_t>(raw);
      case Scalar::Int16:
        return as<std::int16_t>(raw);
      case Scalar::Uint16:
        return as<std::uint16_t>(raw);
      case Scalar::Int32:
        return as<std::int32_t>(raw);
      case Scalar::Uint32:
        return as<std::uint32_t>(raw);
      case Scalar::Float32:
        return as<float>(raw);
      case Scalar::Float64:
        return as<double>(raw);
    }
    return 0.0;
  }

  std::size_t listSize(const Property& property) {
    const double count = number(*property.count);
    if (!(count >= 0.0) || count != std::floor(count) || count > 4294967295.0) {
      fail(text("%1 has a list of impossible length", {place()}));
    }
    return static_cast<std::size_t>(count);
  }

  void skipProperty(const Property& property) {
    const std::size_t count = property.count ? listSize(property) : 1;
    if (encoding_ == Encoding::Ascii) {
      // Nobody needs them, so that they may be no numbers ("-1.#IND" from some compilers).
      for (std::size_t k = 0; k < count; ++k) {
        asciiWord();
      }
      return;
    }
    const std::size_t size = sizeOf(property.type);
    if (count > (bytes_.size() - position_) / size) {
      fail(text("the file ends in %1", {place()}));
    }
    position_ += count * size;
  }

  void skip(const Element& element) {
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      look(element, i);
      for (const Property& property : element.properties) {
        skipProperty(property);
      }
    }
  }

  void vertices(const Element& element) {
    std::array<bool, 3> found{};
    for (const Property& property : element.properties) {
      const int axis = axisOf(property);
      if (axis >= 0) {
        found[static_cast<std::size_t>(axis)] = true;
        singlePrecision_ = singlePrecision_ && property.type != Scalar::Float64;
      }
    }
    if (!found[0] || !found[1] || !found[2]) {
      fail("element 'vertex' has no x, y and z");
    }
    mesh_.vertices.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      look(element, i);
      geometry::Vec3 p = geometry::Vec3::Zero();
      for (const Property& property : element.properties) {
        const int axis = axisOf(property);
        if (axis >= 0) {
          p[axis] = number(property.type);
        } else {
          skipProperty(property);
        }
      }
      if (!p.allFinite()) {
        fail(text("%1 has a coordinate that is not a number", {place()}));
      }
      for (const double x : p) {
        if (!isCoordinate(x)) {
          fail(text("%1 has a coordinate of %2, which is too large", {place(), formatReal(x)}));
        }
      }
      mesh_.vertices.push_back(p);
    }
  }

  static int axisOf(const Property& property) {
    for (int axis = 0; axis < 3; ++axis) {
      const char name = static_cast<char>('x' + axis);
      if (!property.count && equalNoCase(property.name, std::string_view(&name, 1))) {
        return axis;
      }
    }
    return -1;
  }

  /// The list of a face's or a strip's corners: by its usual names, else the first list of whole
  /// numbers. Null when there is none.
  static const Property* cornersOf(const Element& element) {
    const Property* other = nullptr;
    for (const Property& property : element.properties) {
      const bool whole = property.type != Scalar::Float32 && property.type != Scalar::Float64;
      if (!property.count || !whole) {
        continue;
      }
      if (property.name == "vertex_indices" || property.name == "vertex_index") {
        return &property;
      }
      other = other == nullptr ? &property : other;
    }
    return other;
  }

  /// Calls `use` with the list of corners of each item.
  template <class Use>
  void eachList(const Element& element, const Use& use) {
    const Property* corners = cornersOf(element);
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      look(element, i);
      for (const Property& property : element.properties) {
        if (&property == corners) {
          use(property);
        } else {
          skipProperty(property);
        }
      }
    }
  }

  void faces(const Element& element) {
    mesh_.triangles.reserve(mesh_.triangles.size() + element.count);
    std::vector<std::uint32_t> corners;
    eachList(element, [&](const Property& property) {
      readCorners(property, corners);
      if (corners.size() < 3) {
        ++thinFaces_;
      } else if (corners.size() == 3) {
        mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
      } else if (mesh_.vertices.size() == vertexCount_) {
        dividePolygon(mesh_.vertices, corners, mesh_.triangles);
      } else {
        laterPolygons_.push_back(corners);  // vertices follow the faces
      }
    });
  }

  void readCorners(const Property& property, std::vector<std::uint32_t>& corners) {
    const std::size_t count = listSize(property);
    if (count > kMaxPolygonCorners) {
      fail(text("%1 has %2 corners", {place(), std::to_string(count)}));
    }
    corners.clear();
    for (std::size_t k = 0; k < count; ++k) {
      corners.push_back(vertexIndex(number(property.type)));
    }
  }

  [[nodiscard]] std::uint32_t vertexIndex(double index) const {
    if (!(index >= 0.0) || index >= static_cast<double>(vertexCount_) ||
        index != std::floor(index)) {
      fail(text("%1 refers to a vertex that does not exist", {place()}));
    }
    return static_cast<std::uint32_t>(index);
  }

  /// Triangle strips: each corner makes a triangle with the two before it, every other one turned;
  /// −1 begins a new strip.
  void strips(const Element& element) {
    eachList(element, [&](const Property& property) {
      const std::size_t count = listSize(property);
      std::array<std::uint32_t, 3> last{};
      std::size_t length = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const double index = number(property.type);
        if (index == -1.0 || index == kRestart) {
          length = 0;
          continue;
        }
        last = {last[1], last[2], vertexIndex(index)};
        if (++length >= 3) {
          addOfStrip(last, length % 2 == 0);
        }
      }
    });
  }

  void addOfStrip(std::array<std::uint32_t, 3> t, bool turned) {
    if (turned) {
      std::swap(t[0], t[1]);
    }
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {  // else it only leads on
      mesh_.triangles.push_back(t);
    }
    if (mesh_.triangles.size() >= geometry::HalfEdges::kNone / 3) {
      fail("there are more triangles than can be handled");
    }
  }

  /// −1 in a list without sign.
  static constexpr double kRestart = 4294967295.0;

  std::string_view bytes_;
  const std::string& file_;
  const JobContext& context_;
  TextScanner scanner_;       ///< header and ASCII body
  std::size_t position_ = 0;  ///< binary body
  Encoding encoding_ = Encoding::Ascii;
  std::vector<Element> elements_;
  const Element* current_ = nullptr;
  std::uint64_t index_ = 0;
  bool singlePrecision_ = true;
  std::uint64_t vertexCount_ = 0;
  std::size_t thinFaces_ = 0;
  std::vector<std::vector<std::uint32_t>> laterPolygons_;
  geometry::TriangleMesh mesh_;
};

}  // namespace

RawMesh parsePly(std::string_view bytes, const std::string& file, const JobContext& context) {
  const PlainText text(bytes);
  return PlyParser(text.view(), file, context).parse();
}

}  // namespace wcam::io
