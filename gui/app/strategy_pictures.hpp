// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

#include <string>

namespace wcam::gui {

/// A small picture of how a strategy lays its layers; a general one for strategies of others.
QIcon strategyPicture(const std::string& id);

}  // namespace wcam::gui
