// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/edits.hpp"

#include <QIcon>

namespace wcam::gui {

/// A small picture of what an edit does to layers.
QIcon editPicture(toolpath::EditType type);

}  // namespace wcam::gui
