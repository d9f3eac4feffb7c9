// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/program/program.hpp"

#include <cstddef>

namespace wcam::program {

/// The wire speeds that a program sets, mm/s.
struct WireSpeeds {
  double least = 0.0;
  double greatest = 0.0;
  std::size_t changes = 0;  ///< from one speed to another
};

WireSpeeds wireSpeeds(const Program& program);

/// For a program that switches the arc but writes no wire speeds: a violation
/// (post.wire_not_written) when the wire speed changes, since what is deposited is then not what
/// was planned. A single wire speed is that of the job.
/// @param remedy names the parameter of the post-processor that writes them
void reportUnwrittenWire(const Program& program, const Text& remedy, const JobContext& context);

}  // namespace wcam::program
