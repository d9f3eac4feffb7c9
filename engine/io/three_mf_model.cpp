// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "three_mf_model.hpp"

#include "text_scanner.hpp"
#include "weld_mesh.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace wcam::io {

namespace {

using geometry::Vec3;

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

enum class ExtensionUse {
  Harmless,  ///< says nothing about shapes, or only what the mesh says too
  LeftOut,   ///< describes shapes beside the meshes: told
  Refused    ///< when it is required
};

struct Extension {
  const char* space;  ///< begin of the namespace after kSchemas
  const char* name;
  ExtensionUse use;
};

constexpr std::string_view kSchemas = "http://schemas.microsoft.com/3dmanufacturing/";
constexpr std::array<Extension, 11> kExtensions{
    {{"production/alternatives", "alternatives", ExtensionUse::LeftOut},
     {"production/", "production", ExtensionUse::Harmless},
     {"core/", "core", ExtensionUse::Harmless},
     {"material/", "materials", ExtensionUse::Harmless},
     {"trianglesets/", "triangle sets", ExtensionUse::Harmless},
     {"beamlattice/", "beam lattice", ExtensionUse::LeftOut},
     {"slice/", "slice", ExtensionUse::LeftOut},
     {"volumetric/", "volumetric", ExtensionUse::Refused},
     {"implicit/", "implicit", ExtensionUse::Refused},
     {"displacement/", "displacement", ExtensionUse::Refused},
     {"securecontent/", "secure content", ExtensionUse::Refused}}};
/// This one has another root.
constexpr Extension kBooleans{"http://schemas.3mf.io/3dmanufacturing/booleanoperations/",
                              "boolean operations", ExtensionUse::Refused};

const Extension* extensionOf(std::string_view space) {
  if (space.starts_with(kBooleans.space)) {
    return &kBooleans;
  }
  constexpr std::string_view kOtherSchemas = "http://schemas.3mf.io/3dmanufacturing/";
  for (const std::string_view root : {kSchemas, kOtherSchemas}) {
    if (!space.starts_with(root)) {
      continue;
    }
    for (const Extension& known : kExtensions) {
      if (space.substr(root.size()).starts_with(known.space)) {
        return &known;
      }
    }
  }
  return nullptr;
}

std::size_t indexOr0(std::string_view text) {
  std::size_t index = 0;
  std::from_chars(text.data(), text.data() + text.size(), index);
  return index;
}

bool isFalse(std::string_view text) {
  return text == "0" || equalNoCase(text, "false");
}

class ModelParser : public XmlHandler {
public:
  ModelParser(const Package& package, std::string part, const JobContext& context)
      : context_(context), xml_(package, part, *this), package_(package), part_(std::move(part)) {}

  ThreeMfModel parse() {
    if (!xml_.run(context_)) {
      package_.fail(wcam::text("the package has no part '%1'", {printableName(part_)}));
    }
    return std::move(model_);
  }

  void start(const XmlName& name, const Attributes& a) override {
    if (depth_++ == 0) {
      root(name, a);
    } else if (name.space != core_) {
      foreign(name);
    } else if (name.local == "triangle") {
      triangle(a);
    } else if (name.local == "vertex") {
      vertex(a);
    } else if (name.local == "object") {
      object(a);
    } else if (name.local == "component" && object_ != nullptr) {
      object_->components.push_back(reference(a));
    } else if (name.local == "item") {
      model_.items.push_back(reference(a));
    } else if (name.local == "basematerials") {
      materials_ = a.get("id");
    } else if (name.local == "base") {
      model_.colours[materials_].push_back(std::string(a.get("displaycolor").substr(0, 7)));
    } else if (name.local == "metadata") {
      metadata_ = a.get("name");
      metadataText_.clear();
    }
  }

  void text(std::string_view piece) override {
    constexpr std::size_t kLongest = 64;
    if (!metadata_.empty() && metadataText_.size() < kLongest) {
      metadataText_.append(piece.substr(0, kLongest));
    }
  }

  void end(const XmlName& name) override {
    --depth_;
    if (name.space != core_) {
      return;
    }
    if (name.local == "object" && object_ != nullptr) {
      // Each object on its own: bodies that touch stay apart.
      object_->weldedPoints = weldVertices(object_->mesh);
      object_ = nullptr;
    } else if (name.local == "metadata") {
      curaRole();
      metadata_.clear();
    }
  }

private:
  void root(const XmlName& name, const Attributes& a) {
    if (name.local != "model") {
      xml_.fail(wcam::text("is no 3MF model, its first element is %1", {quoted(name.local)}));
    }
    core_ = name.space;
    unit(a.get("unit"));
    TextScanner prefixes(a.get("requiredextensions"));
    for (std::string_view word = prefixes.word(); !word.empty(); word = prefixes.word()) {
      const std::string prefix(word);
      const std::string space = xml_.namespaceOf(prefix);
      const Extension* known = extensionOf(space);
      if (known == nullptr) {
        xml_.fail(wcam::text("the model needs the 3MF extension '%1' (%2), which is not known",
                             {printableName(prefix),
                              space.empty() ? "not declared" : printableName(space)}),
                  "export it without this extension");
      }
      if (known->use == ExtensionUse::Refused) {
        xml_.fail(
            wcam::text("the model needs the 3MF extension '%1', which is not read", {known->name}),
            "export it without this extension");
      }
    }
  }

  /// Elements of extensions: beams are counted, other shapes are told.
  void foreign(const XmlName& name) {
    const Extension* known = extensionOf(name.space);
    if (known == nullptr || known->use == ExtensionUse::Harmless) {
      return;
    }
    if (object_ != nullptr && name.local == "beam") {
      ++object_->beams;
    } else if (std::string_view(known->name) != "beam lattice") {
      ++model_.unreadExtensions[known->name];
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
    xml_.fail(wcam::text("unit %1 is not known", {quoted(name)}));
  }

  void object(const Attributes& a) {
    const auto [it, added] = model_.objects.emplace(a.get("id"), ThreeMfObject());
    if (!added) {
      xml_.fail(wcam::text("object '%1' is there twice", {printableName(a.get("id"))}));
    }
    object_ = &it->second;
    object_->name = printableName(a.get("name"));
    object_->type = a.get("type");
    object_->property = a.get("pid");
    object_->propertyIndex = indexOr0(a.get("pindex"));
  }

  double coordinate(std::string_view word, const char* what) const {
    const auto number = scanNumber(word);
    if (!number || !std::isfinite(*number)) {
      xml_.fail(wcam::text("%1 has %2 instead of a finite number", {what, quoted(word)}));
    }
    if (!isCoordinate(*number)) {
      xml_.fail(wcam::text("%1 has %2, which is too large", {what, quoted(word)}));
    }
    return *number;
  }

  void vertex(const Attributes& a) {
    if (object_ == nullptr) {
      return;
    }
    object_->mesh.vertices.emplace_back(coordinate(a.get("x"), "a vertex"),
                                        coordinate(a.get("y"), "a vertex"),
                                        coordinate(a.get("z"), "a vertex"));
  }

  void triangle(const Attributes& a) {
    if (object_ == nullptr) {
      return;
    }
    constexpr std::array<const char*, 3> kNames{"v1", "v2", "v3"};
    std::array<std::uint32_t, 3> t{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::string_view index = a.get(kNames[c]);
      const auto [last, error] = std::from_chars(index.data(), index.data() + index.size(), t[c]);
      if (error != std::errc() || last != index.data() + index.size() ||
          t[c] >= object_->mesh.vertices.size()) {
        xml_.fail(wcam::text("triangle %1 refers to a vertex that does not exist",
                             {std::to_string(object_->mesh.triangles.size())}));
      }
    }
    object_->mesh.triangles.push_back(t);
  }

  [[nodiscard]] ThreeMfReference reference(const Attributes& a) const {
    ThreeMfReference result;
    result.part = Package::partName(a.get("path"));
    result.id = a.get("objectid");
    result.printable = !isFalse(a.get("printable"));
    const std::string_view numbers = a.get("transform");
    if (numbers.empty()) {
      return result;
    }
    TextScanner scanner(numbers);
    for (int k = 0; k < 12; ++k) {
      const std::string_view word = scanner.word();
      if (word.empty()) {
        xml_.fail("a transform does not have twelve numbers");
      }
      result.transform(k / 3, k % 3) = coordinate(word, "a transform");
    }
    if (!scanner.word().empty()) {
      xml_.fail("a transform does not have twelve numbers");
    }
    return result;
  }

  /// Cura keeps meshes that change others, or supports, as objects of the model.
  void curaRole() {
    constexpr std::array<const char*, 4> kHelpers{"cura:infill_mesh", "cura:cutting_mesh",
                                                  "cura:support_mesh", "cura:anti_overhang_mesh"};
    const bool helper = std::find(kHelpers.begin(), kHelpers.end(), metadata_) != kHelpers.end();
    if (object_ != nullptr && helper && equalNoCase(metadataText_, "true")) {
      object_->role = BodyRole::Helper;
    }
  }

  const JobContext& context_;
  XmlReader xml_;
  const Package& package_;
  std::string part_;
  ThreeMfModel model_;
  ThreeMfObject* object_ = nullptr;
  std::string core_;
  std::string materials_;
  std::string metadata_;
  std::string metadataText_;
  int depth_ = 0;
};

/// Roles as slicers name them: "NegativeVolume", "negative_part", "ParameterModifier",
/// "modifier_part", "SupportBlocker", "support_enforcer" and so on.
BodyRole roleOf(std::string_view type) {
  if (type == "NegativeVolume" || type == "negative_part") {
    return BodyRole::Negative;
  }
  const bool solid = type.empty() || type == "ModelPart" || type == "normal_part";
  return solid ? BodyRole::Solid : BodyRole::Helper;
}

class SettingsParser : public XmlHandler {
public:
  void start(const XmlName& name, const Attributes& a) override {
    if (name.local == "object") {
      object_ = a.get("id");
    } else if (name.local == "volume") {
      volume_ = {indexOr0(a.get("firstid")), indexOr0(a.get("lastid")), {}, BodyRole::Solid};
      inVolume_ = true;
    } else if (name.local == "part") {
      component_ = a.get("id");
      volume_ = {0, 0, {}, roleOf(a.get("subtype"))};
      inVolume_ = true;
    } else if (name.local == "metadata" && inVolume_) {
      const std::string_view key = a.get("key");
      if (key == "name") {
        volume_.name = printableName(a.get("value"));
      } else if (key == "volume_type") {
        volume_.role = roleOf(a.get("value"));
      } else if (key == "modifier" && a.get("value") == "1") {
        volume_.role = BodyRole::Helper;
      }
    }
  }

  void end(const XmlName& name) override {
    if (name.local == "volume") {
      settings.volumes[object_].push_back(volume_);
      inVolume_ = false;
    } else if (name.local == "part") {
      settings.components[{object_, component_}] = volume_;
      inVolume_ = false;
    }
  }

  SlicerSettings settings;

private:
  std::string object_;
  std::string component_;
  ThreeMfVolume volume_;
  bool inVolume_ = false;
};

}  // namespace

ThreeMfTransform identityTransform() {
  ThreeMfTransform m = ThreeMfTransform::Zero();
  m.topRows<3>().setIdentity();
  return m;
}

ThreeMfTransform compose(const ThreeMfTransform& a, const ThreeMfTransform& b) {
  ThreeMfTransform m;
  m.topRows<3>() = a.topRows<3>() * b.topRows<3>();
  m.row(3) = a.row(3) * b.topRows<3>() + b.row(3);
  return m;
}

ThreeMfModel parseThreeMfModel(const Package& package,
                               const std::string& part,
                               const JobContext& context) {
  return ModelParser(package, part, context).parse();
}

SlicerSettings readSlicerSettings(const Package& package, const JobContext& context) {
  SettingsParser parser;
  for (const char* part : {"Metadata/Slic3r_PE_model.config", "Metadata/Slic3r_model.config",
                           "Metadata/model_settings.config"}) {
    XmlReader(package, Package::partName(part), parser).run(context);
  }
  return std::move(parser.settings);
}

}  // namespace wcam::io
