// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wcam::gui::test {

/// The test program as the program `wcam` with a user who plays a role: `--role NAME [FILE]`.
/// - change: renames the project, says "ready" when the autosave is there, and waits
/// - change-at-once: the same without waiting for the autosave
/// - recover: takes what is offered, says the name of the project, and leaves
/// - import: accepts the dialog for the part, says how many parts there are, and leaves
/// @return whether these arguments are a role; the exit code is stored
bool playRole(int argc, char** argv, int& code);

}  // namespace wcam::gui::test
