// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QString;

namespace wcam::gui {

/// Palette and style sheet of the whole program.
void applyTheme(bool dark);
/// Whether the desktop's palette is dark.
bool systemIsDark();

}  // namespace wcam::gui
