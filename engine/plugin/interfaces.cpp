// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The destructors are the key functions of the interfaces: type information lives in the engine
// library alone, so that exceptions and casts work across plugins.
#include "wcam/plugin/registrar.hpp"

namespace wcam::plugin {

SlicingStrategy::~SlicingStrategy() = default;
PostProcessor::~PostProcessor() = default;
Registrar::~Registrar() = default;

}  // namespace wcam::plugin
