// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/commands.hpp"
#include "wcam/project/document.hpp"

namespace wcam::test {

/// The document with a constant rotation about the torch in all operations: for tests of what
/// stands around the motion. The optimised motion has tests of its own, and takes seconds.
inline project::Document withQuickMotion(project::Document document) {
  for (const project::Operation& operation : document.project().operations) {
    document =
        project::apply(document, {"operation.set_param", Value::object({{"id", operation.id},
                                                                        {"section", "motion"},
                                                                        {"key", "mode"},
                                                                        {"value", "constant"}})});
  }
  return document;
}

}  // namespace wcam::test
