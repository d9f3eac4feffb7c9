// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"

#include "mesh_boolean.hpp"
#include "mesh_order.hpp"
#include "mesh_readers.hpp"
#include "mesh_repair.hpp"
#include "text_scanner.hpp"
#include "three_mf_model.hpp"

#include <algorithm>
#include <utility>

namespace wcam::io {

namespace {

using geometry::TriangleMesh;
using geometry::Vec3;

/// Components refer to objects before them; deeper nesting than this is an attack.
constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxInstances = 1000000;
/// A few kilobytes can repeat an object so often that no memory holds it.
constexpr std::size_t kMaxTriangles = 100000000;
constexpr const char* kDefaultModel = "3D/3dmodel.model";
constexpr const char* kModelType = "/3dmodel";

/// A body of the build in its place.
struct PlacedBody {
  TriangleMesh mesh;
  std::string name;
  std::string colour;
  BodyRole role = BodyRole::Solid;
};

/// Numbers of what is not built.
struct LeftOut {
  std::size_t notPrintable = 0;
  std::size_t supports = 0;
  std::size_t others = 0;
  std::size_t helpers = 0;
  std::size_t beams = 0;
  std::size_t lattices = 0;
};

/// Triangles from `first` to before `end` as a mesh of their own.
TriangleMesh partOf(const TriangleMesh& mesh, std::size_t first, std::size_t end) {
  TriangleMesh part;
  part.vertices = mesh.vertices;
  part.triangles.assign(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first),
                        mesh.triangles.begin() + static_cast<std::ptrdiff_t>(end));
  dropUnusedVertices(part);
  return part;
}

/// Puts the items of the build together.
class Assembler {
public:
  Assembler(const Package& package, std::string root, const JobContext& context)
      : package_(package),
        root_(std::move(root)),
        settings_(readSlicerSettings(package, context)),
        context_(context) {}

  RawMesh run() {
    const ThreeMfModel& model = modelOf(root_);
    raw_.unit = model.unit;
    raw_.millimetresPerUnit = model.millimetresPerUnit;
    if (model.items.empty()) {
      package_.fail("the package has nothing to build",
                    "put a part on the build plate in the program that made the file");
    }
    requireMemory(model);
    for (const ThreeMfReference& item : model.items) {
      if (!item.printable) {
        ++leftOut_.notPrintable;
        continue;
      }
      add(root_, item, identityTransform(), BodyRole::Solid, {});
      finishItem();
    }
    tell();
    if (raw_.mesh.triangles.empty()) {
      nothingLeft();
    }
    sortForLocality(raw_.mesh);
    return std::move(raw_);
  }

private:
  const ThreeMfModel& modelOf(const std::string& part) {
    const auto it = models_.find(part);
    if (it != models_.end()) {
      return it->second;
    }
    return models_.emplace(part, parseThreeMfModel(package_, part, context_)).first->second;
  }

  /// What an object and its components come to. Counted in floating point, which does not overflow.
  struct Size {
    double instances = 0.0;
    double triangles = 0.0;
  };

  /// Refuses what no memory holds before anything is built.
  void requireMemory(const ThreeMfModel& model) {
    Size all;
    for (const ThreeMfReference& item : model.items) {
      const Size size = sizeOf(root_, item, 0);
      all.instances += size.instances;
      all.triangles += size.triangles;
    }
    if (all.instances > kMaxInstances) {
      package_.fail(text("the package repeats its objects more than %1 times",
                         {std::to_string(kMaxInstances)}),
                    "export fewer copies");
    }
    if (all.triangles > kMaxTriangles) {
      package_.fail(text("the package builds %1 triangles; at most %2 are taken",
                         {formatFixed(all.triangles, 0), std::to_string(kMaxTriangles)}),
                    "export fewer copies, or a coarser mesh");
    }
  }

  /// Each object is counted once; it must exist, and not refer to itself.
  Size sizeOf(const std::string& from, const ThreeMfReference& reference, int depth) {
    context_.check();
    const std::string& part = reference.part.empty() ? from : reference.part;
    if (const auto known = sizes_.find({part, reference.id}); known != sizes_.end()) {
      return known->second;
    }
    const ThreeMfModel& model = modelOf(part);
    const auto it = model.objects.find(reference.id);
    if (it == model.objects.end() || depth > kMaxDepth) {
      const std::string id = printableName(reference.id);
      const std::string where = printableName(part);
      package_.fail(
          depth > kMaxDepth
              ? text("part '%1' refers to object '%2' in a circle", {where, id})
              : text("part '%1' refers to object '%2', which does not exist", {where, id}));
    }
    Size size{1.0, static_cast<double>(it->second.mesh.triangles.size())};
    for (const ThreeMfReference& component : it->second.components) {
      const Size own = sizeOf(part, component, depth + 1);
      size.instances += own.instances;
      size.triangles += own.triangles;
    }
    sizes_[{part, reference.id}] = size;
    return size;
  }

  /// @param outer transform of what refers to this; `role` and `name` given by it
  void add(const std::string& from,
           const ThreeMfReference& reference,
           const ThreeMfTransform& outer,
           BodyRole role,
           const std::string& name) {
    context_.check();
    const std::string& part = reference.part.empty() ? from : reference.part;
    const ThreeMfModel& model = modelOf(part);
    const ThreeMfObject& object = model.objects.at(reference.id);
    if (object.type == "support" || object.type == "solidsupport" || object.type == "other") {
      ++(object.type == "other" ? leftOut_.others : leftOut_.supports);
      return;
    }
    ThreeMfTransform transform = compose(reference.transform, outer);
    for (const ThreeMfReference& component : object.components) {
      const auto given = settings_.components.find({reference.id, component.id});
      const bool known = part == root_ && given != settings_.components.end();
      const bool own = known && given->second.role != BodyRole::Solid;
      add(part, component, transform, own ? given->second.role : role,
          known ? given->second.name : std::string());
    }
    if (object.beams > 0) {
      leftOut_.beams += object.beams;
      ++leftOut_.lattices;
    }
    if (!object.mesh.triangles.empty()) {
      // Lengths of another model part are in its own unit.
      transform *= model.millimetresPerUnit / raw_.millimetresPerUnit;
      PlacedBody body{{},
                      object.name.empty() ? name : object.name,
                      colourOf(model, object),
                      object.role != BodyRole::Solid ? object.role : role};
      raw_.weldedPoints += object.weldedPoints;
      addVolumes(part == root_ ? reference.id : std::string(), object, transform, body);
    }
  }

  static std::string colourOf(const ThreeMfModel& model, const ThreeMfObject& object) {
    const auto it = model.colours.find(object.property);
    const bool known = it != model.colours.end() && object.propertyIndex < it->second.size();
    return known ? it->second[object.propertyIndex] : std::string();
  }

  /// Adds the mesh of an object, apart where a slicer has put several bodies into one.
  void addVolumes(const std::string& id,
                  const ThreeMfObject& object,
                  const ThreeMfTransform& transform,
                  const PlacedBody& body) {
    const auto it = settings_.volumes.find(id);
    const bool plain =
        it == settings_.volumes.end() ||
        std::all_of(it->second.begin(), it->second.end(),
                    [](const ThreeMfVolume& v) { return v.role == BodyRole::Solid; });
    if (plain) {
      addBody(object.mesh, transform, body);
      return;
    }
    std::vector<ThreeMfVolume> volumes = it->second;
    std::sort(volumes.begin(), volumes.end(),
              [](const ThreeMfVolume& a, const ThreeMfVolume& b) { return a.first < b.first; });
    std::size_t done = 0;
    const std::size_t count = object.mesh.triangles.size();
    volumes.push_back({count, count, {}, BodyRole::Solid});  // what lies after the last
    for (const ThreeMfVolume& volume : volumes) {
      const std::size_t first = std::clamp(volume.first, done, count);
      const std::size_t end = std::clamp(volume.last + 1, first, count);
      if (first > done) {
        addBody(partOf(object.mesh, done, first), transform, body);
      }
      if (end > first) {
        PlacedBody own = body;
        own.role = volume.role != BodyRole::Solid ? volume.role : body.role;
        own.name = volume.name.empty() ? body.name : volume.name;
        addBody(partOf(object.mesh, first, end), transform, own);
      }
      done = end;
    }
  }

  void addBody(const TriangleMesh& mesh, const ThreeMfTransform& m, PlacedBody body) {
    if (body.role == BodyRole::Helper) {
      ++leftOut_.helpers;
      return;
    }
    body.mesh = mesh;
    const Eigen::Matrix3d linear = m.topRows<3>();
    for (Vec3& p : body.mesh.vertices) {
      p = (p.transpose() * linear + m.row(3)).transpose();
      if (!isCoordinate(p.x()) || !isCoordinate(p.y()) || !isCoordinate(p.z())) {
        package_.fail(text("object '%1' has a coordinate that is too large: %2",
                           {body.name, formatReal(p.cwiseAbs().maxCoeff())}));
      }
    }
    if (linear.determinant() < 0.0) {
      for (auto& t : body.mesh.triangles) {
        std::swap(t[1], t[2]);
      }
    }
    bodies_.push_back(std::move(body));
  }

  /// Cuts the negative bodies of an item out of its others and adds what is left.
  void finishItem() {
    for (const PlacedBody& cutter : bodies_) {
      if (cutter.role == BodyRole::Negative) {
        cut(cutter);
      }
    }
    for (PlacedBody& body : bodies_) {
      if (body.role == BodyRole::Solid && !body.mesh.triangles.empty()) {
        append(body.mesh);
        raw_.bodies.push_back({std::move(body.name), "mesh", std::move(body.colour), 0});
      }
    }
    bodies_.clear();
  }

  void cut(const PlacedBody& cutter) {
    context_.check();
    bool cutAny = false;
    for (PlacedBody& body : bodies_) {
      if (body.role != BodyRole::Solid) {
        continue;
      }
      std::optional<TriangleMesh> rest = geometry::subtract(body.mesh, cutter.mesh);
      if (!rest) {
        context_.add({Severity::Warning,
                      "import.negative_left_out",
                      text("the negative volume '%1' cannot be cut out of '%2' and is left out; "
                           "the part is solid there",
                           {cutter.name, body.name}),
                      "cut it with the program that made it and export the result",
                      {},
                      {}});
        continue;
      }
      cutAny = true;
      body.mesh = std::move(*rest);
    }
    if (cutAny) {
      context_.add({Severity::Information,
                    "import.negative_cut",
                    text("the negative volume '%1' was cut out of the part", {cutter.name}),
                    {},
                    {},
                    {}});
    }
  }

  void append(const TriangleMesh& body) {
    TriangleMesh& mesh = raw_.mesh;
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), body.vertices.begin(), body.vertices.end());
    for (const auto& t : body.triangles) {
      mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }

  void tell() const {
    const auto number = [](std::size_t n) { return std::to_string(n); };
    const auto one = [](std::size_t n) { return n == 1; };
    addCounted(
        context_, Severity::Warning, "import.not_printable", leftOut_.notPrintable,
        text(one(leftOut_.notPrintable) ? "%1 item that is marked as not printable is left out"
                                        : "%1 items that are marked as not printable are left out",
             {number(leftOut_.notPrintable)}),
        "mark them as printable in the program that made the file if they are wanted");
    addCounted(context_, Severity::Information, "import.support_left_out", leftOut_.supports,
               text(one(leftOut_.supports) ? "%1 support is left out" : "%1 supports are left out",
                    {number(leftOut_.supports)}));
    addCounted(context_, Severity::Warning, "import.other_left_out", leftOut_.others,
               text(one(leftOut_.others) ? "%1 object of the type 'other' is left out"
                                         : "%1 objects of the type 'other' are left out",
                    {number(leftOut_.others)}),
               "give them the type 'model' if they are to be built");
    addCounted(
        context_, Severity::Information, "import.modifier_left_out", leftOut_.helpers,
        text(one(leftOut_.helpers) ? "%1 modifier, support blocker or the like is left out"
                                   : "%1 modifiers, support blockers and the like are left out",
             {number(leftOut_.helpers)}));
    addCounted(context_, Severity::Warning, "import.beam_lattice_left_out", leftOut_.lattices,
               text(one(leftOut_.lattices) ? "%1 beam lattice is left out (beams: %2)"
                                           : "%1 beam lattices are left out (beams: %2)",
                    {number(leftOut_.lattices), number(leftOut_.beams)}),
               "turn the beams into a mesh with the program that made the file");
    std::map<std::string, std::size_t> unread;
    for (const auto& [part, model] : models_) {
      for (const auto& [name, count] : model.unreadExtensions) {
        unread[name] += count;
      }
    }
    for (const auto& [name, count] : unread) {
      addCounted(
          context_, Severity::Warning, "import.extension_left_out", count,
          text("shapes of the 3MF extension '%1' are left out; only meshes are read", {name}),
          "turn them into a mesh with the program that made the file");
    }
  }

  [[noreturn]] void nothingLeft() const {
    if (leftOut_.lattices > 0) {
      package_.fail("the package has no triangles, only beam lattices",
                    "turn the beams into a mesh with the program that made the file");
    }
    if (leftOut_.notPrintable > 0) {
      package_.fail("the package has nothing to build: its items are marked as not printable",
                    "mark them as printable in the program that made the file if they are wanted");
    }
    package_.fail("the package has no triangles to build",
                  "export the part as a mesh of triangles");
  }

  const Package& package_;
  std::string root_;
  SlicerSettings settings_;
  const JobContext& context_;
  std::map<std::string, ThreeMfModel> models_;
  RawMesh raw_;
  LeftOut leftOut_;
  std::vector<PlacedBody> bodies_;                             ///< of the item
  std::map<std::pair<std::string, std::string>, Size> sizes_;  ///< by part and object
};

/// The model part that the package's relations name.
class RelationsParser : public XmlHandler {
public:
  void start(const XmlName& name, const Attributes& a) override {
    if (name.local == "Relationship" && a.get("Type").ends_with(kModelType)) {
      target = a.get("Target");
    }
  }

  std::string target = kDefaultModel;
};

std::string rootModel(const Package& package, const JobContext& context) {
  RelationsParser parser;
  XmlReader(package, Package::partName("_rels/.rels"), parser).run(context);
  std::string root = Package::partName(parser.target);
  if (!package.has(root)) {
    package.fail(text("the ZIP archive has no 3MF model '%1'; its first file is '%2'",
                      {printableName(parser.target), package.firstName()}),
                 "unpack the archive and open the part in it");
  }
  return root;
}

}  // namespace

RawMesh parseThreeMf(std::string_view bytes, const std::string& file, const JobContext& context) {
  const Package package(bytes, file);
  return Assembler(package, rootModel(package, context), context).run();
}

}  // namespace wcam::io
