// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/remedy.hpp"
#include "wcam/plugin/crash_notice.hpp"

#include "library.hpp"
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <new>
#include <set>

namespace wcam::plugin {

namespace {

/// Longest name that common file systems take, bytes.
constexpr std::size_t kMaxFileName = 255;

/// Ids of the components that come with WCAM begin so.
constexpr std::string_view kOwnComponents = "wcam.";

class Guard {
public:
  Guard(const std::string& plugin, const std::string& component)
      : plugin_(plugin),
        component_(component),
        place_(text("plugin %1, component %2", {plugin, component})) {}

  [[noreturn]] void fail(const Text& message, const Text& hint = {}) const {
    throw Error(ErrorCode::JobFailed, message, place_, hint);
  }

  /// What a component refuses in its own words. A place or a setting that cannot work is a check of
  /// the result, anything else a failed job. WCAM's own components say their name; those of others
  /// may not, and who made them matters.
  [[nodiscard]] Error own(const Error& error) const {
    const bool saysName = component_.starts_with(kOwnComponents) && !error.context().empty();
    return {error.code() == ErrorCode::CheckFailed ? ErrorCode::CheckFailed : ErrorCode::JobFailed,
            error.whatText(), saysName ? Text() : place_, error.hintText()};
  }

  /// Runs a call into the plugin. A cancel passes only when it was asked for.
  template <class Call>
  auto run(const JobContext& context, const Call& call) const {
    const PluginCall running(plugin_, component_);
    try {
      return call();
    } catch (const CancelledError&) {
      if (context.cancelled()) {
        throw;
      }
      fail("stopped as if it were cancelled, but nobody asked for it",
           "report this to the vendor of the plugin");
    } catch (const RemediedError& error) {
      throw RemediedError(own(error), error.settings());
    } catch (const Error& error) {
      throw own(error);
    } catch (const std::bad_alloc&) {
      throw;  // the part is too large, which is not the plugin's fault
    } catch (...) {
      fail(text("failed: %1", {currentExceptionText()}), "report this to the vendor of the plugin");
    }
  }

private:
  std::string plugin_;
  std::string component_;
  Text place_;
};

/// Takes what is written to standard output while it lives, so that it does not end up in the
/// report that a script reads there.
class CapturedOutput {
public:
  CapturedOutput() : lock_(mutex()), file_(std::tmpfile()) {
    std::fflush(stdout);
    own_ = file_ != nullptr ? ::dup(STDOUT_FILENO) : -1;
    if (own_ >= 0) {
      ::dup2(::fileno(file_), STDOUT_FILENO);
    }
  }

  ~CapturedOutput() {
    restore();
    if (file_ != nullptr) {
      std::fclose(file_);
    }
  }

  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  /// Ends the capture. @return the first characters
  std::string restore() {
    if (own_ < 0) {
      return {};
    }
    std::cout.flush();
    std::fflush(stdout);
    ::dup2(own_, STDOUT_FILENO);
    ::close(own_);
    own_ = -1;
    std::array<char, 80> text{};
    std::rewind(file_);
    return {text.data(), std::fread(text.data(), 1, text.size(), file_)};
  }

private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }

  std::lock_guard<std::mutex> lock_;
  std::FILE* file_;
  int own_ = -1;
};

/// Line (from 1) of the first "nan" or "inf" that stands for a number; 0 when there is none. Behind
/// a word of three letters or more it is a name ("Operation inf").
std::size_t lineWithoutNumber(std::string_view text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
  };
  constexpr std::size_t kLength = 3;
  std::size_t first = std::string_view::npos;
  for (const std::string_view word : {"nan", "inf"}) {
    for (std::size_t at = text.find(word); at < first; at = text.find(word, at + 1)) {
      if ((at > 0 && part(text[at - 1])) ||
          (at + kLength < text.size() && part(text[at + kLength]))) {
        continue;
      }
      std::size_t end = at;
      while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '-' || text[end - 1] == '+')) {
        --end;
      }
      std::size_t begin = end;
      while (begin > 0 && letter(text[begin - 1])) {
        --begin;
      }
      if (end - begin < kLength) {
        first = at;
      }
    }
  }
  return first == std::string_view::npos
             ? 0
             : 1 + static_cast<std::size_t>(std::count(
                       text.begin(), text.begin() + static_cast<std::ptrdiff_t>(first), '\n'));
}

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
    CapturedOutput output;
    std::vector<OutputFile> files =
        guard_.run(context, [&] { return inner_->post(program, params, context); });
    if (const std::string printed = output.restore(); !printed.empty()) {
      guard_.fail(text("writes to standard output, beginning with '%1'",
                       {printed.substr(0, printed.find('\n'))}),
                  "report this to the vendor of the plugin: a program belongs in the files that "
                  "it returns");
    }
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
      if (file.content.empty()) {
        guard_.fail(text("output file '%1' is empty", {file.name}));
      }
      if (const std::size_t line = lineWithoutNumber(file.content); line > 0) {
        guard_.fail(text("output file '%1' has a value that is no number (nan or inf) in line %2",
                         {file.name, std::to_string(line)}));
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
