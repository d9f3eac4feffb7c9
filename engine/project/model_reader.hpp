// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/base/param.hpp"
#include "wcam/project/model.hpp"

#include <vector>

namespace wcam::project {

struct ReadModel {
  Project project;
  std::vector<ParamProblem> problems;  ///< in the order of the file
  std::vector<Diagnostic> findings;
};

/// Reads the typed model from a tree that checkWritable has passed. Nodes with problems are left
/// out of the model.
ReadModel readModel(const Value& tree);

}  // namespace wcam::project
