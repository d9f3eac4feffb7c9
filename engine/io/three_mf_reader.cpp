// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"

#include "mesh_order.hpp"
#include "mesh_readers.hpp"
#include "text_scanner.hpp"
#include "weld_mesh.hpp"
#include <expat.h>
#include <minizip/unzip.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <set>

namespace wcam::io {

namespace {

using geometry::TriangleMesh;
using geometry::Vec3;
/// Row vectors are used in the file: [x y z 1]·M, M of 4 rows and 3 columns.
using Transform = Eigen::Matrix<double, 4, 3>;

constexpr std::size_t kChunk = 1 << 16;
constexpr std::size_t kCheckInterval = 65536;
/// Components refer to objects before them; deeper nesting than this is an attack.
constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxInstances = 1000000;
constexpr const char* kDefaultModel = "3D/3dmodel.model";
constexpr const char* kModelType = "/3dmodel";

struct UnitName {
  const char* name;
  double millimetres;
};

constexpr std::array<UnitName, 6> kUnits{{{"micron", 0.001},
                                          {"millimeter", 1.0},
                                          {"centimeter", 10.0},
                                          {"inch", 25.4},
                                          {"foot", 304.8},
                                          {"meter", 1000.0}}};

Transform identity() {
  Transform m = Transform::Zero();
  m.topRows<3>().setIdentity();
  return m;
}

/// b after a.
Transform compose(const Transform& a, const Transform& b) {
  Transform m;
  m.topRows<3>() = a.topRows<3>() * b.topRows<3>();
  m.row(3) = a.row(3) * b.topRows<3>() + b.row(3);
  return m;
}

/// Reference to an object, with the model part it stands in ("" for the same).
struct Reference {
  std::string part;
  std::string id;
  Transform transform = identity();
};

struct Object {
  std::string name;
  std::string type;
  std::string property;
  std::size_t propertyIndex = 0;
  TriangleMesh mesh;
  std::size_t weldedPoints = 0;
  std::vector<Reference> components;
};

struct Model {
  std::string unit = "millimeter";
  double millimetresPerUnit = 1.0;
  std::map<std::string, Object> objects;
  std::map<std::string, std::vector<std::string>> colours;  ///< of base materials
  std::vector<Reference> items;
};

/// Open package.
class Package {
public:
  Package(const std::filesystem::path& file, const std::string& fileText)
      : fileText_(fileText), zip_(unzOpen64(file.c_str())) {
    if (zip_ == nullptr) {
      fail("is not a readable ZIP package");
    }
  }

  ~Package() { unzClose(zip_); }

  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  [[noreturn]] void fail(const Text& what) const {
    throw Error(ErrorCode::InputInvalid, what, fileText_,
                "the file is damaged or cut off; export it again");
  }

  /// Calls `use` for the unpacked bytes of a part, piece by piece. False when there is no such
  /// part.
  bool read(const std::string& part,
            const JobContext& context,
            const std::function<void(const char*, int, bool)>& use) {
    if (unzLocateFile(zip_, part.c_str(), 2) != UNZ_OK) {
      return false;
    }
    if (unzOpenCurrentFile(zip_) != UNZ_OK) {
      fail(text("part '%1' cannot be unpacked", {part}));
    }
    const std::unique_ptr<void, int (*)(void*)> closer(zip_, unzCloseCurrentFile);
    std::vector<char> chunk(kChunk);
    while (true) {
      context.check();
      const int got = unzReadCurrentFile(zip_, chunk.data(), static_cast<unsigned>(chunk.size()));
      if (got < 0) {
        fail(text("part '%1' is damaged", {part}));
      }
      use(chunk.data(), got, got == 0);
      if (got == 0) {
        return true;
      }
    }
  }

private:
  const std::string& fileText_;
  unzFile zip_;
};

/// Attributes of an element by local name (without namespace).
class Attributes {
public:
  explicit Attributes(const char** pairs) : pairs_(pairs) {}

  [[nodiscard]] std::string_view get(std::string_view name) const {
    for (const char** p = pairs_; *p != nullptr; p += 2) {
      const std::string_view key = *p;
      if (key.substr(key.rfind('|') + 1) == name) {
        return p[1];
      }
    }
    return {};
  }

private:
  const char** pairs_;
};

std::string_view localName(const char* name) {
  const std::string_view text = name;
  return text.substr(text.rfind('|') + 1);
}

/// SAX reading of one XML part; exceptions pass through expat.
class XmlReader {
public:
  using Start = std::function<void(std::string_view, const Attributes&)>;
  using End = std::function<void(std::string_view)>;

  XmlReader(Package& package, const std::string& part, Start start, End end)
      : package_(package),
        part_(part),
        start_(std::move(start)),
        end_(std::move(end)),
        parser_(XML_ParserCreateNS(nullptr, '|'), XML_ParserFree) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), onStart, onEnd);
    XML_SetStartDoctypeDeclHandler(parser_.get(), onDoctype);
  }

  /// False when the package has no such part.
  bool run(const JobContext& context) {
    return package_.read(part_, context, [&](const char* data, int size, bool last) {
      const XML_Status status = XML_Parse(parser_.get(), data, size, last ? 1 : 0);
      if (failure_) {
        std::rethrow_exception(failure_);
      }
      if (status != XML_STATUS_OK) {
        fail(XML_ErrorString(XML_GetErrorCode(parser_.get())));
      }
    });
  }

  [[noreturn]] void fail(const Text& what) const {
    package_.fail(text("part '%1', line %2: %3",
                       {part_, std::to_string(XML_GetCurrentLineNumber(parser_.get())), what}));
  }

private:
  template <class Work>
  void guarded(const Work& work) {
    if (failure_) {
      return;
    }
    try {
      work();
    } catch (...) {
      failure_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  static void onStart(void* self, const char* name, const char** attributes) {
    auto* reader = static_cast<XmlReader*>(self);
    reader->guarded([&] { reader->start_(localName(name), Attributes(attributes)); });
  }

  static void onEnd(void* self, const char* name) {
    auto* reader = static_cast<XmlReader*>(self);
    reader->guarded([&] { reader->end_(localName(name)); });
  }

  static void onDoctype(void* self, const char*, const char*, const char*, int) {
    auto* reader = static_cast<XmlReader*>(self);
    reader->guarded([&] { reader->fail("a document type is not allowed in 3MF"); });
  }

  Package& package_;
  std::string part_;
  Start start_;
  End end_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser_;
  std::exception_ptr failure_;
};

/// Package paths start with '/', names inside the ZIP do not.
std::string partName(std::string_view path) {
  while (!path.empty() && path.front() == '/') {
    path.remove_prefix(1);
  }
  return std::string(path);
}

class ModelParser {
public:
  ModelParser(Package& package, std::string part, const JobContext& context)
      : context_(context),
        xml_(
            package,
            part,
            [this](std::string_view name, const Attributes& a) { start(name, a); },
            [this](std::string_view name) { end(name); }),
        package_(package),
        part_(std::move(part)) {}

  Model parse() {
    if (!xml_.run(context_)) {
      package_.fail(text("the package has no part '%1'", {part_}));
    }
    return std::move(model_);
  }

private:
  void start(std::string_view name, const Attributes& a) {
    if (name == "triangle") {
      triangle(a);
    } else if (name == "vertex") {
      vertex(a);
    } else if (name == "object") {
      const std::string id(a.get("id"));
      object_ = &model_.objects[id];
      *object_ = Object();
      object_->name = a.get("name");
      object_->type = a.get("type");
      object_->property = a.get("pid");
      object_->propertyIndex = indexOr0(a.get("pindex"));
    } else if (name == "component" && object_ != nullptr) {
      object_->components.push_back(reference(a));
    } else if (name == "item") {
      model_.items.push_back(reference(a));
    } else if (name == "basematerials") {
      materials_ = a.get("id");
    } else if (name == "base") {
      model_.colours[materials_].push_back(std::string(a.get("displaycolor").substr(0, 7)));
    } else if (name == "model") {
      unit(a.get("unit"));
    }
  }

  void end(std::string_view name) {
    if (name == "object" && object_ != nullptr) {
      // Each object on its own: bodies that touch stay apart.
      object_->weldedPoints = weldVertices(object_->mesh);
      object_ = nullptr;
    }
  }

  void unit(std::string_view name) {
    if (name.empty()) {
      return;  // millimetres by the standard
    }
    for (const UnitName& known : kUnits) {
      if (name == known.name) {
        model_.unit = known.name;
        model_.millimetresPerUnit = known.millimetres;
        return;
      }
    }
    xml_.fail(text("unit %1 is not known", {quoted(name)}));
  }

  static std::size_t indexOr0(std::string_view text) {
    std::size_t index = 0;
    std::from_chars(text.data(), text.data() + text.size(), index);
    return index;
  }

  void vertex(const Attributes& a) {
    if (object_ == nullptr) {
      return;
    }
    constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const auto number = scanNumber(a.get(kAxes[static_cast<std::size_t>(k)]));
      if (!number || !std::isfinite(*number)) {
        xml_.fail("a vertex has a coordinate that is not a finite number");
      }
      p[k] = *number;
    }
    object_->mesh.vertices.push_back(p);
  }

  void triangle(const Attributes& a) {
    if (object_ == nullptr) {
      return;
    }
    constexpr std::array<const char*, 3> kNames{"v1", "v2", "v3"};
    std::array<std::uint32_t, 3> t{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::string_view text = a.get(kNames[c]);
      const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), t[c]);
      if (error != std::errc() || last != text.data() + text.size() ||
          t[c] >= object_->mesh.vertices.size()) {
        xml_.fail(wcam::text("triangle %1 refers to a vertex that does not exist",
                             {std::to_string(object_->mesh.triangles.size())}));
      }
    }
    object_->mesh.triangles.push_back(t);
  }

  [[nodiscard]] Reference reference(const Attributes& a) const {
    Reference result;
    result.part = partName(a.get("path"));
    result.id = a.get("objectid");
    const std::string_view text = a.get("transform");
    if (text.empty()) {
      return result;
    }
    TextScanner scanner(text);
    for (int k = 0; k < 12; ++k) {
      const auto number = scanNumber(scanner.word());
      if (!number || !std::isfinite(*number)) {
        xml_.fail("a transform does not have twelve numbers");
      }
      result.transform(k / 3, k % 3) = *number;
    }
    return result;
  }

  const JobContext& context_;
  XmlReader xml_;
  Package& package_;
  std::string part_;
  Model model_;
  Object* object_ = nullptr;
  std::string materials_;
};

/// Puts the items of the build together.
class Assembler {
public:
  Assembler(Package& package, std::string root, const JobContext& context)
      : package_(package), root_(std::move(root)), context_(context) {}

  RawMesh run() {
    const Model& model = modelOf(root_);
    raw_.unit = model.unit;
    raw_.millimetresPerUnit = model.millimetresPerUnit;
    if (model.items.empty()) {
      package_.fail("the package has nothing to build");
    }
    for (const Reference& item : model.items) {
      add(root_, item, identity(), 0);
    }
    sortForLocality(raw_.mesh);
    return std::move(raw_);
  }

private:
  const Model& modelOf(const std::string& part) {
    const auto it = models_.find(part);
    if (it != models_.end()) {
      return it->second;
    }
    return models_.emplace(part, ModelParser(package_, part, context_).parse()).first->second;
  }

  /// @param outer transform of what refers to this
  void add(const std::string& from, const Reference& reference, const Transform& outer, int depth) {
    context_.check();
    const std::string& part = reference.part.empty() ? from : reference.part;
    const Model& model = modelOf(part);
    const auto it = model.objects.find(reference.id);
    if (++instances_ > kMaxInstances) {
      package_.fail(text("the package repeats its objects more than %1 times",
                         {std::to_string(kMaxInstances)}));
    }
    if (it == model.objects.end() || depth > kMaxDepth) {
      package_.fail(depth > kMaxDepth
                        ? text("part '%1' refers to object '%2' in a circle", {part, reference.id})
                        : text("part '%1' refers to object '%2', which does not exist",
                               {part, reference.id}));
    }
    const Object& object = it->second;
    if (object.type == "support" || object.type == "solidsupport") {
      return;
    }
    // Lengths of another model part are in its own unit.
    Transform transform = compose(reference.transform, outer);
    for (const Reference& component : object.components) {
      add(part, component, transform, depth + 1);
    }
    if (!object.mesh.triangles.empty()) {
      transform.topRows<3>() *= model.millimetresPerUnit / raw_.millimetresPerUnit;
      addMesh(object, transform);
      raw_.weldedPoints += object.weldedPoints;
      raw_.bodies.push_back({object.name, "mesh", colourOf(model, object), 0});
    }
  }

  static std::string colourOf(const Model& model, const Object& object) {
    const auto it = model.colours.find(object.property);
    const bool known = it != model.colours.end() && object.propertyIndex < it->second.size();
    return known ? it->second[object.propertyIndex] : std::string();
  }

  void addMesh(const Object& object, const Transform& m) {
    TriangleMesh& mesh = raw_.mesh;
    const std::size_t base = mesh.vertices.size();
    if (base + object.mesh.vertices.size() >= geometry::HalfEdges::kNone ||
        mesh.triangles.size() + object.mesh.triangles.size() >= geometry::HalfEdges::kNone / 3) {
      package_.fail("the package has more triangles than can be handled");
    }
    const Eigen::Matrix3d linear = m.topRows<3>();
    for (const Vec3& p : object.mesh.vertices) {
      mesh.vertices.push_back((p.transpose() * linear + m.row(3)).transpose());
    }
    const bool mirrored = linear.determinant() < 0.0;
    for (auto t : object.mesh.triangles) {
      if (mirrored) {
        std::swap(t[1], t[2]);
      }
      for (std::uint32_t& v : t) {
        v += static_cast<std::uint32_t>(base);
      }
      mesh.triangles.push_back(t);
    }
  }

  Package& package_;
  std::string root_;
  const JobContext& context_;
  std::map<std::string, Model> models_;
  RawMesh raw_;
  std::size_t instances_ = 0;
};

/// The model part that the package's relations name.
std::string rootModel(Package& package, const JobContext& context) {
  std::string target = kDefaultModel;
  XmlReader relations(
      package, "_rels/.rels",
      [&](std::string_view name, const Attributes& a) {
        if (name == "Relationship" && a.get("Type").ends_with(kModelType)) {
          target = partName(a.get("Target"));
        }
      },
      [](std::string_view) {});
  relations.run(context);
  return target;
}

}  // namespace

RawMesh readThreeMf(const std::filesystem::path& file, const JobContext& context) {
  const std::string fileText = pathText(file);
  Package package(file, fileText);
  const std::string root = rootModel(package, context);
  return Assembler(package, root, context).run();
}

}  // namespace wcam::io
