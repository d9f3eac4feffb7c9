// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/plugin/plugin.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace probe {

using wcam::plugin::OutputFile;
using Files = std::vector<OutputFile>;

/// A post that does what it is told.
class Post final : public wcam::plugin::PostProcessor {
public:
  using Function = std::function<Files(const wcam::JobContext&)>;

  explicit Post(Function function) : function_(std::move(function)) {}

  [[nodiscard]] Files post(const wcam::program::Program&,
                           const wcam::Value&,
                           const wcam::JobContext& context) const override {
    return function_(context);
  }

private:
  Function function_;
};

inline void addPost(wcam::plugin::Registrar& registrar,
                    const std::string& id,
                    Post::Function function = {}) {
  registrar.addPost({.id = id, .name = "Probe", .summary = "For tests", .params = {}},
                    [function] { return std::make_unique<Post>(function); });
}

}  // namespace probe
