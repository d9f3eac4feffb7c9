// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad_transfer.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"

#include "brep_impl.hpp"
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <cstring>
#include <sstream>
#include <type_traits>

namespace wcam::io {

namespace {

class ByteWriter {
public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  void text(std::string_view value) {
    put(value.size());
    bytes_.append(value);
  }

  /// Items that are plain numbers side by side.
  template <class T>
  void items(const std::vector<T>& values) {
    put(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }

  void value(const Text& words) {
    text(words.pattern());
    put(words.foreign());
    put(words.arguments().size());
    for (const Text& argument : words.arguments()) {
      value(argument);
    }
  }

  std::string take() { return std::move(bytes_); }

private:
  std::string bytes_;
};

class ByteReader {
public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void get(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&value, take(sizeof(T)), sizeof(T));
  }

  template <class T>
  T get() {
    T value{};
    get(value);
    return value;
  }

  std::string text() {
    const auto size = get<std::size_t>();
    return {take(size), size};
  }

  /// Texts are nested a few times; deeper ones are damaged.
  Text value(int depth = 0) {
    std::string pattern = text();
    const bool foreign = get<char>() != 0;
    const auto count = get<std::size_t>();
    if (depth > kMaxDepth || count > bytes_.size()) {
      fail();
    }
    std::vector<Text> arguments;
    for (std::size_t i = 0; i < count; ++i) {
      arguments.push_back(value(depth + 1));
    }
    return foreign ? Text(std::move(pattern)) : Text(std::move(pattern), std::move(arguments));
  }

  template <class T>
  void items(std::vector<T>& values) {
    const auto count = get<std::size_t>();
    if (count > bytes_.size() / sizeof(T)) {
      fail();
    }
    values.resize(count);
    std::memcpy(static_cast<void*>(values.data()), take(count * sizeof(T)), count * sizeof(T));
  }

private:
  static constexpr int kMaxDepth = 64;

  [[noreturn]] static void fail() {
    throw Error(ErrorCode::Internal, "the answer of the CAD worker is damaged");
  }

  const char* take(std::size_t size) {
    if (bytes_.size() < size) {
      fail();
    }
    const char* at = bytes_.data();
    bytes_.remove_prefix(size);
    return at;
  }

  std::string_view bytes_;
};

// Each structure is written and read by one function, so that the two cannot differ.

template <class Archive>
void transfer(Archive& archive, geometry::BrepFaceInfo& info) {
  archive(info.name);
  archive(info.surfaceType);
  archive(info.uvBounds);
  archive(info.reversed);
}

template <class Archive>
void transfer(Archive& archive, geometry::BrepEdgeInfo& info) {
  archive(info.name);
  archive(info.range);
  archive(info.length);
  archive(info.faceCount);
}

template <class Archive>
void transfer(Archive& archive, ImportedBody& body) {
  archive(body.name);
  archive(body.kind);
  archive(body.colour);
  archive(body.faces);
}

template <class Archive>
void transfer(Archive& archive, std::pair<std::string, double>& item) {
  archive(item.first);
  archive(item.second);
}

template <class Archive>
void transfer(Archive& archive, Diagnostic& finding) {
  archive(finding.severity);
  archive(finding.code);
  archive(finding.message);
  archive(finding.remedy);
  archive(finding.data);
}

/// The part of the report that buildCadPart() fills in.
template <class Archive>
void transfer(Archive& archive, ImportReport& report) {
  archive(report.unit);
  archive(report.unitReason);
  archive(report.millimetresPerUnit);
  archive(report.bodies);
  archive(report.faces);
  archive(report.edges);
  archive(report.freeEdges);
  archive(report.reorientedTriangles);
  archive(report.formulaDeviation);
  archive(report.overlap);
}

class Saver {
public:
  void operator()(Text& value) { writer.value(value); }

  void operator()(std::string& value) { writer.text(value); }

  template <class T>
  void operator()(std::vector<T>& values) {
    writer.put(values.size());
    for (T& value : values) {
      (*this)(value);
    }
  }

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      writer.put(value);
    } else {
      transfer(*this, value);
    }
  }

  ByteWriter writer;
};

class Loader {
public:
  explicit Loader(std::string_view bytes) : reader(bytes) {}

  void operator()(Text& value) { value = reader.value(); }

  void operator()(std::string& value) { value = reader.text(); }

  template <class T>
  void operator()(std::vector<T>& values) {
    const auto count = reader.get<std::size_t>();
    values.clear();
    for (std::size_t i = 0; i < count; ++i) {
      values.emplace_back();
      (*this)(values.back());
    }
  }

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      reader.get(value);
    } else {
      transfer(*this, value);
    }
  }

  ByteReader reader;
};

/// Faces and edges in their order, without triangles.
std::string shapeBytes(const geometry::Brep::Impl& brep) {
  const BRep_Builder builder;
  TopoDS_Compound faces;
  TopoDS_Compound edges;
  TopoDS_Compound both;
  builder.MakeCompound(faces);
  builder.MakeCompound(edges);
  builder.MakeCompound(both);
  for (const TopoDS_Face& face : brep.faces) {
    builder.Add(faces, face);
  }
  for (const TopoDS_Edge& edge : brep.edges) {
    builder.Add(edges, edge);
  }
  builder.Add(both, faces);
  builder.Add(both, edges);
  std::ostringstream stream;
  BinTools::Write(both, stream, Standard_False, Standard_False, BinTools_FormatVersion_CURRENT);
  return std::move(stream).str();
}

void readShapes(const std::string& bytes, geometry::Brep::Impl& brep) {
  std::istringstream stream(bytes);
  TopoDS_Shape both;
  BinTools::Read(both, stream);
  TopoDS_Iterator part(both);
  for (TopoDS_Iterator it(part.Value()); it.More(); it.Next()) {
    brep.faces.push_back(TopoDS::Face(it.Value()));
  }
  part.Next();
  for (TopoDS_Iterator it(part.Value()); it.More(); it.Next()) {
    brep.edges.push_back(TopoDS::Edge(it.Value()));
  }
  if (brep.faces.size() != brep.faceInfos.size() || brep.edges.size() != brep.edgeInfos.size()) {
    throw Error(ErrorCode::Internal, "the answer of the CAD worker is damaged");
  }
}

}  // namespace

std::string encodeRequest(const ImportJob& job) {
  Value pose = Value::array();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      pose.push(job.T_part_file.matrix()(row, column));
    }
  }
  // Internal units: a detour over degrees would not come back to the same bits.
  return toCompactJson(Value::object({{"file", pathText(job.file)},
                                      {"format", static_cast<int>(job.format)},
                                      {"chord_mm", job.options.chordTolerance.value()},
                                      {"angle_rad", job.options.angularTolerance.value()},
                                      {"unit", static_cast<int>(job.options.unit)},
                                      {"weld_mm", job.options.weldTolerance.value()},
                                      {"repair", job.options.repair},
                                      {"pose", pose}}));
}

WorkerRequest decodeRequest(std::string_view text) {
  const Value value = parseJson(text, "request of the CAD worker");
  WorkerRequest request;
  request.file = pathFromText(value.at("file").asString());
  request.format = static_cast<FileFormat>(value.at("format").asInteger());
  request.options.chordTolerance = Length(value.at("chord_mm").asReal());
  request.options.angularTolerance = Angle(value.at("angle_rad").asReal());
  request.options.unit = static_cast<FileUnit>(value.at("unit").asInteger());
  request.options.weldTolerance = Length(value.at("weld_mm").asReal());
  request.options.repair = value.at("repair").asBool();
  const Value::Array& pose = value.at("pose").asArray();
  for (int k = 0; k < 12; ++k) {
    request.T_part_file.matrix()(k % 3, k / 3) = pose.at(static_cast<std::size_t>(k)).asReal();
  }
  return request;
}

std::string encodePart(const geometry::PartSurface& surface,
                       const ImportReport& report,
                       const std::vector<Diagnostic>& findings) {
  const geometry::Brep::Impl& brep = surface.brep->impl();
  Saver saver;
  ImportReport reportCopy = report;
  std::vector<Diagnostic> findingsCopy = findings;
  std::vector<geometry::BrepFaceInfo> faces = brep.faceInfos;
  std::vector<geometry::BrepEdgeInfo> edges = brep.edgeInfos;
  std::string shapes = shapeBytes(brep);
  saver(reportCopy);
  saver(findingsCopy);
  saver(faces);
  saver(edges);
  saver(shapes);
  saver.writer.items(surface.mesh.vertices);
  saver.writer.items(surface.mesh.triangles);
  saver.writer.items(surface.binding.face);
  saver.writer.items(surface.binding.uv);
  saver.writer.items(surface.binding.edge);
  saver.writer.items(surface.binding.edgeParam);
  return saver.writer.take();
}

geometry::PartSurface decodePart(std::string_view bytes,
                                 ImportReport& report,
                                 std::vector<Diagnostic>& findings) {
  Loader loader(bytes);
  auto brep = std::make_unique<geometry::Brep::Impl>();
  std::string shapes;
  loader(report);
  loader(findings);
  loader(brep->faceInfos);
  loader(brep->edgeInfos);
  loader(shapes);
  geometry::PartSurface surface;
  loader.reader.items(surface.mesh.vertices);
  loader.reader.items(surface.mesh.triangles);
  loader.reader.items(surface.binding.face);
  loader.reader.items(surface.binding.uv);
  loader.reader.items(surface.binding.edge);
  loader.reader.items(surface.binding.edgeParam);
  readShapes(shapes, *brep);
  surface.halfEdges = geometry::HalfEdges(surface.mesh);
  surface.brep = std::make_shared<const geometry::Brep>(std::move(brep));
  return surface;
}

std::string encodeError(const Error& error) {
  ByteWriter writer;
  writer.put(error.code());
  writer.value(error.messageText());
  writer.value(error.contextText());
  writer.value(error.hintText());
  return writer.take();
}

Error decodeError(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto code = reader.get<ErrorCode>();
  Text message = reader.value();
  Text context = reader.value();
  return {code, std::move(message), std::move(context), reader.value()};
}

std::string encodeProgress(double fraction, const std::string& label) {
  ByteWriter writer;
  writer.put(fraction);
  writer.text(label);
  return writer.take();
}

std::pair<double, std::string> decodeProgress(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto fraction = reader.get<double>();
  return {fraction, reader.text()};
}

}  // namespace wcam::io
