// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/plausible.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/shapes.hpp"
#include "wcam/io/import.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wcam::cell {

namespace {

using geometry::Pose;
using geometry::Vec3;

/// A list of shapes in the file.
struct Section {
  const char* parent;  ///< empty: the file itself
  const char* key;
  const char* frame;  ///< where a shape is when it does not tell
  std::vector<Shape> CellShapes::*list;
};

constexpr Section kSections[] = {
    {"torch", "neck", "tcp", &CellShapes::torch},
    {"torch", "collision", "tcp", &CellShapes::torch},
    {"robot", "collision", "base", &CellShapes::robot},
    {"positioner", "collision", "table", &CellShapes::positioner},
    {"part_holder", "collision", "table", &CellShapes::positioner},
    {"", "obstacles", "world", &CellShapes::obstacles},
};

std::string pathOf(const Section& section) {
  return *section.parent == '\0' ? section.key : std::string(section.parent) + "." + section.key;
}

/// The list of a section; null when it is missing or no list.
const Value* listOf(const Value& file, const Section& section) {
  const Value* parent = *section.parent == '\0' ? &file : file.find(section.parent);
  return parent != nullptr && parent->isObject() ? parent->find(section.key) : nullptr;
}

class ShapeReader {
public:
  ShapeReader(const ShapeReading& reading, const JobContext& context)
      : reading_(reading), context_(context) {}

  std::optional<Shape> read(const Value& value, const std::string& path, const char* frame) {
    if (!value.isObject()) {
      reading_.problem(path, wcam::text("expected an object, got %1", {toString(value.type())}));
      return std::nullopt;
    }
    good_ = true;
    Shape shape;
    shape.name = text(value, path, "name", true);
    shape.frame = value.contains("frame") ? text(value, path, "frame", true) : frame;
    checkFrame(path + ".frame", shape.frame);
    readIgnored(value, path, shape);
    const std::string type = text(value, path, "type", true);
    if (type == "sphere") {
      readSphere(value, path, shape);
    } else if (type == "capsule" || type == "cylinder") {
      shape.kind = type == "capsule" ? ShapeKind::Capsule : ShapeKind::Cylinder;
      readAlong(value, path, shape);
    } else if (type == "box") {
      readBox(value, path, shape);
    } else if (type == "mesh") {
      readMesh(value, path, shape);
    } else if (!type.empty()) {
      problem(path + ".type",
              wcam::text("'%1' is not one of sphere, capsule, cylinder, box and mesh", {type}));
    }
    return good_ ? std::optional<Shape>(std::move(shape)) : std::nullopt;
  }

private:
  void problem(const std::string& path, const Text& message) {
    good_ = false;
    reading_.problem(path, message);
  }

  void checkFrame(const std::string& path, const std::string& frame) {
    if (std::find(reading_.frames.begin(), reading_.frames.end(), frame) == reading_.frames.end()) {
      problem(path, wcam::text("the cell has no frame '%1'; it has %2",
                               {frame, joinText(reading_.frames, ", ")}));
    }
  }

  std::string text(const Value& value, const std::string& path, const char* key, bool required) {
    const Value* member = value.find(key);
    if (member == nullptr || !member->isString() || member->asString().empty()) {
      if (required || member != nullptr) {
        problem(path + "." + key, member == nullptr ? "is missing" : "expected a text");
      }
      return {};
    }
    return member->asString();
  }

  /// A length in mm.
  double number(const Value& value, const std::string& path) {
    const Text wrong = value.isNumber()
                           ? implausible(value.asReal(), QuantityKind::Length)
                           : wcam::text("expected a number, got %1", {toString(value.type())});
    if (!wrong.empty()) {
      problem(path, wrong);
      return 0.0;
    }
    return value.asReal();
  }

  double positive(const Value& value, const std::string& path, const char* key) {
    const Value* member = value.find(key);
    if (member == nullptr) {
      problem(path + "." + key, "is missing");
      return 0.0;
    }
    const double result = number(*member, path + "." + key);
    if (member->isNumber() && !(member->asReal() > 0.0)) {
      problem(path + "." + key, "must be greater than 0");
    }
    return result;
  }

  Vec3 vector(const Value& value, const std::string& path, const char* key) {
    const Value* member = value.find(key);
    Vec3 result = Vec3::Zero();
    if (member == nullptr || !member->isArray() || member->size() != 3) {
      problem(path + "." + key, member == nullptr ? "is missing" : "expected a list of 3 numbers");
      return result;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      result(static_cast<Eigen::Index>(i)) =
          number(member->asArray()[i], path + "." + key + "[" + std::to_string(i) + "]");
    }
    return result;
  }

  void knownKeys(const Value& value, const std::string& path, std::vector<std::string> keys) {
    keys.insert(keys.end(), {"name", "type", "frame", "ignore", "comment"});
    for (const auto& [key, member] : value.asObject()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end() && !key.starts_with("x-")) {
        const auto near = nearestName(key, keys);
        problem(path + "." + key, near
                                      ? wcam::text("is not known here; did you mean '%1'?", {*near})
                                      : wcam::text("is not known here"));
      }
    }
  }

  void readIgnored(const Value& value, const std::string& path, Shape& shape) {
    const Value* list = value.find("ignore");
    if (list == nullptr) {
      return;
    }
    if (!list->isArray()) {
      problem(path + ".ignore", "expected a list of names of frames and shapes");
      return;
    }
    for (const Value& name : list->asArray()) {
      if (name.isString()) {
        shape.ignore.push_back(name.asString());
      } else {
        problem(path + ".ignore", "expected a list of names of frames and shapes");
      }
    }
  }

  void readSphere(const Value& value, const std::string& path, Shape& shape) {
    shape.kind = ShapeKind::Sphere;
    knownKeys(value, path, {"centre", "radius"});
    shape.T_frame_shape.translation() = vector(value, path, "centre");
    shape.radius = positive(value, path, "radius");
  }

  void readAlong(const Value& value, const std::string& path, Shape& shape) {
    knownKeys(value, path, {"from", "to", "radius"});
    const Vec3 from = vector(value, path, "from");
    const Vec3 to = vector(value, path, "to");
    shape.radius = positive(value, path, "radius");
    shape.length = (to - from).norm();
    if (good_ && !(shape.length > 0.0)) {
      problem(path, "from and to are the same point; use a sphere");
      return;
    }
    if (good_) {
      const auto turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), to - from);
      shape.T_frame_shape.linear() = turn.toRotationMatrix();
      shape.T_frame_shape.translation() = 0.5 * (from + to);
    }
  }

  void readBox(const Value& value, const std::string& path, Shape& shape) {
    shape.kind = ShapeKind::Box;
    knownKeys(value, path, {"size", "pose"});
    shape.size = vector(value, path, "size");
    if (good_ && !(shape.size.minCoeff() > 0.0)) {
      problem(path + ".size", "must be greater than 0 in all three directions");
    }
    shape.T_frame_shape = reading_.pose(value, path, "pose");
  }

  void readMesh(const Value& value, const std::string& path, Shape& shape) {
    shape.kind = ShapeKind::Mesh;
    knownKeys(value, path, {"file", "pose"});
    const std::string file = text(value, path, "file", true);
    shape.T_frame_shape = reading_.pose(value, path, "pose");
    if (file.empty()) {
      return;
    }
    try {
      const io::ImportedPart part = io::importPart(reading_.folder / pathFromText(file),
                                                   io::ImportOptions{}, Pose::Identity(), context_);
      shape.mesh = std::make_shared<const geometry::TriangleMesh>(part.surface->mesh);
      if (shape.mesh->triangles.empty()) {
        problem(path + ".file", wcam::text("the mesh '%1' has no triangles", {file}));
      }
    } catch (const CancelledError&) {
      throw;
    } catch (const Error& error) {
      problem(path + ".file", error.whatText());
    }
  }

  const ShapeReading& reading_;
  const JobContext& context_;
  bool good_ = true;
};

}  // namespace

CellShapes readShapes(const Value& file, const ShapeReading& reading, const JobContext& context) {
  CellShapes shapes;
  ShapeReader reader(reading, context);
  for (const Section& section : kSections) {
    const Value* list = listOf(file, section);
    if (list == nullptr) {
      continue;
    }
    if (!list->isArray()) {
      reading.problem(pathOf(section),
                      wcam::text("expected a list of shapes, got %1", {toString(list->type())}));
      continue;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
      auto shape = reader.read(list->asArray()[i], pathOf(section) + "[" + std::to_string(i) + "]",
                               section.frame);
      if (shape) {
        (shapes.*section.list).push_back(std::move(*shape));
      }
    }
  }
  return shapes;
}

std::vector<std::filesystem::path> shapeFiles(const Value& file,
                                              const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const Section& section : kSections) {
    const Value* list = file.isObject() ? listOf(file, section) : nullptr;
    if (list == nullptr || !list->isArray()) {
      continue;
    }
    for (const Value& shape : list->asArray()) {
      const Value* name = shape.isObject() ? shape.find("file") : nullptr;
      if (name != nullptr && name->isString()) {
        files.push_back(folder / pathFromText(name->asString()));
      }
    }
  }
  return files;
}

}  // namespace wcam::cell
