// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/base/json.hpp"
#include "wcam/io/import.hpp"
#include "wcam/plugin/host.hpp"
#include "wcam/toolpath/build.hpp"

#include <memory>
#include <string>

namespace wcam::test {

inline std::shared_ptr<const geometry::PartSurface> importSample(const std::string& relative) {
  return io::importPart(std::string(WCAM_RESOURCES) + "/projects/" + relative, io::ImportOptions{},
                        geometry::Pose::Identity(), JobContext())
      .surface;
}

inline std::shared_ptr<const geometry::PartSurface> meshSurface(geometry::TriangleMesh mesh) {
  auto surface = std::make_shared<geometry::PartSurface>();
  surface->mesh = std::move(mesh);
  surface->halfEdges = geometry::HalfEdges(surface->mesh);
  return surface;
}

inline std::shared_ptr<const toolpath::Substrate> plate(double z = 0.0) {
  geometry::Pose T_part_substrate = geometry::Pose::Identity();
  T_part_substrate.translation().z() = z;
  return std::make_shared<toolpath::Substrate>(T_part_substrate, geometry::Vec3(200, 200, 10));
}

inline const plugin::PluginHost& pluginHost() {
  static const plugin::PluginHost host(plugin::defaultPluginSearch({}, false));
  return host;
}

/// Slices with a plugin's strategy; `params` is JSON text. Tests of methods know their layers by
/// the step that they ask for: where they do not say what the last layer does, the step is kept.
inline toolpath::SlicedLayers slice(const std::string& strategy,
                                    const plugin::SliceInput& input,
                                    const std::string& params,
                                    const JobContext& context = JobContext()) {
  const auto component = pluginHost().findSlicing(strategy);
  Value values = parseJson(params);
  if (component->info.params.find("last_layer") != nullptr && !values.contains("last_layer")) {
    values.set("last_layer", "leave");
  }
  return component->strategy->slice(input, component->info.params.complete(values), context);
}

}  // namespace wcam::test
