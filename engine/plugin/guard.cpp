// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/remedy.hpp"

#include "library.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace wcam::plugin {

namespace {

/// Longest name that common file systems take, bytes.
constexpr std::size_t kMaxFileName = 255;

class Guard {
public:
  Guard(const std::string& plugin, const std::string& component)
      : place_(text("plugin %1, component %2", {plugin, component})) {}

  [[noreturn]] void fail(const Text& message, const Text& hint = {}) const {
    throw Error(ErrorCode::JobFailed, message, place_, hint);
  }

  /// Runs a call into the plugin. A cancel passes only when it was asked for.
  template <class Call>
  auto run(const JobContext& context, const Call& call) const {
    try {
      return call();
    } catch (const CancelledError&) {
      if (context.cancelled()) {
        throw;
      }
      fail("stopped as if it were cancelled, but nobody asked for it",
           "report this to the vendor of the plugin");
    } catch (const RemediedError& error) {
      throw RemediedError(Error(ErrorCode::JobFailed, error.whatText(), place_, error.hintText()),
                          error.settings());
    } catch (const Error& error) {
      fail(error.whatText(), error.hintText());
    } catch (...) {
      fail(text("failed: %1", {currentExceptionText()}), "report this to the vendor of the plugin");
    }
  }

private:
  Text place_;
};

Text contourProblem(const toolpath::Contour& contour, std::size_t parts) {
  if (contour.part < 0 || static_cast<std::size_t>(contour.part) >= parts) {
    return text("names part %1, which does not exist", {std::to_string(contour.part)});
  }
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const toolpath::ContourPoint& point = contour.points[i];
    if (!point.p.allFinite() || !point.n.allFinite() || !point.axis.allFinite() ||
        !std::isfinite(point.height) || !std::isfinite(point.width)) {
      return text("has a number that is not finite at point %1", {std::to_string(i + 1)});
    }
    if (point.height < 0.0 || point.width < 0.0) {
      return text("has a negative height or width at point %1", {std::to_string(i + 1)});
    }
  }
  for (std::size_t k = 0; k < contour.turns.size(); ++k) {
    if (contour.turns[k] >= contour.points.size() ||
        (k > 0 && contour.turns[k] <= contour.turns[k - 1])) {
      return "has revolutions that do not ascend inside its points";
    }
  }
  return {};
}

/// A path from a file may come without a part: it then belongs to the first one.
std::size_t partCount(const SliceInput& input) {
  return input.parts.empty() && input.imported != nullptr ? 1 : input.parts.size();
}

class GuardedSlicing final : public SlicingStrategy {
public:
  GuardedSlicing(std::shared_ptr<const SlicingStrategy> inner, Guard guard)
      : inner_(std::move(inner)), guard_(std::move(guard)) {}

  [[nodiscard]] toolpath::SlicedLayers slice(const SliceInput& input,
                                             const Value& params,
                                             const JobContext& context) const override {
    toolpath::SlicedLayers result =
        guard_.run(context, [&] { return inner_->slice(input, params, context); });
    for (std::size_t i = 0; i < result.layers.size(); ++i) {
      const toolpath::SlicedLayer& layer = result.layers[i];
      const bool finite =
          std::isfinite(layer.level) && layer.up.allFinite() && std::isfinite(layer.nominalHeight);
      if (!finite) {
        guard_.fail(text("layer %1 has a number that is not finite", {std::to_string(i + 1)}));
      }
      for (std::size_t k = 0; k < layer.contours.size(); ++k) {
        const Text problem = contourProblem(layer.contours[k], partCount(input));
        if (!problem.empty()) {
          guard_.fail(text("layer %1 contour %2 %3",
                           {std::to_string(i + 1), std::to_string(k + 1), problem}));
        }
      }
    }
    return result;
  }

private:
  std::shared_ptr<const SlicingStrategy> inner_;
  Guard guard_;
};

Text fileNameProblem(const std::string& name) {
  if (name.empty() || name == "." || name == "..") {
    return "is not a file name";
  }
  if (name.size() > kMaxFileName) {
    return text("is longer than %1 bytes", {std::to_string(kMaxFileName)});
  }
  const bool bad = std::any_of(name.begin(), name.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return c == '/' || c == '\\' || c == ':' || code < 0x20 || code == 0x7F;
  });
  return bad ? text("contains a folder, a colon or a control character") : Text();
}

std::string lowerAscii(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

class GuardedPost final : public PostProcessor {
public:
  GuardedPost(std::shared_ptr<const PostProcessor> inner, Guard guard)
      : inner_(std::move(inner)), guard_(std::move(guard)) {}

  [[nodiscard]] std::vector<OutputFile> post(const program::Program& program,
                                             const Value& params,
                                             const JobContext& context) const override {
    std::vector<OutputFile> files =
        guard_.run(context, [&] { return inner_->post(program, params, context); });
    if (files.empty()) {
      guard_.fail("wrote no file");
    }
    // Controllers and their file servers ignore case.
    std::set<std::string> names;
    for (const OutputFile& file : files) {
      const Text problem = fileNameProblem(file.name);
      if (!problem.empty()) {
        guard_.fail(text("output file name '%1' %2", {file.name, problem}));
      }
      if (!names.insert(lowerAscii(file.name)).second) {
        guard_.fail(text("output file name '%1' appears twice (case is ignored)", {file.name}));
      }
    }
    return files;
  }

private:
  std::shared_ptr<const PostProcessor> inner_;
  Guard guard_;
};

}  // namespace

std::shared_ptr<const SlicingStrategy> guardSlicing(std::shared_ptr<const SlicingStrategy> strategy,
                                                    const std::string& plugin,
                                                    const std::string& component) {
  return std::make_shared<GuardedSlicing>(std::move(strategy), Guard(plugin, component));
}

std::shared_ptr<const PostProcessor> guardPost(std::shared_ptr<const PostProcessor> post,
                                               const std::string& plugin,
                                               const std::string& component) {
  return std::make_shared<GuardedPost>(std::move(post), Guard(plugin, component));
}

}  // namespace wcam::plugin
