// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/param.hpp"
#include "wcam/plugin/post.hpp"
#include "wcam/plugin/slicing.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wcam::plugin {

/// Description of a component, read by every form, schema and reference page.
struct ComponentInfo {
  std::string id;       ///< reverse or dotted name, stable: "wcam.slicing.planar"
  std::string name;     ///< short title
  std::string summary;  ///< one sentence
  int version = 1;  ///< raise when the same input gives another result: cached results are dropped
  ParamSchema params;
  bool needsGuide = false;          ///< slicing: the operation must name a guide curve
  std::string automaticGuide = {};  ///< key of a parameter that makes the guide needless when true
  bool needsFile = false;           ///< slicing: the operation must name a file with a path
  /// post: makes of controllers that it writes for, as cells name them ("FANUC"); empty: any. The
  /// user is warned where the cell is of another make.
  std::vector<std::string> controllers = {};
};

using SlicingFactory = std::function<std::unique_ptr<SlicingStrategy>()>;
using PostFactory = std::function<std::unique_ptr<PostProcessor>()>;

/// Where a plugin puts its components.
class Registrar {
public:
  virtual ~Registrar();
  virtual void addSlicing(ComponentInfo info, SlicingFactory factory) = 0;
  virtual void addPost(ComponentInfo info, PostFactory factory) = 0;
};

}  // namespace wcam::plugin
