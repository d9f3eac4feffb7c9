// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "zip_archive.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace wcam::io {

/// The ZIP package of a 3MF file, with the names of its parts as OPC compares them: without regard
/// to capitals, with escapes (%20) or without.
class Package {
public:
  Package(std::string_view bytes, const std::string& file);

  /// Name of a part as it is looked up, from a path or a URI.
  static std::string partName(std::string_view path);

  [[nodiscard]] bool has(const std::string& part) const { return entries_.count(part) != 0; }

  /// Calls `use` for the unpacked bytes of a part, piece by piece. False when there is no such
  /// part.
  bool read(const std::string& part,
            const JobContext& context,
            const std::function<void(const char*, std::size_t, bool)>& use) const;

  /// What the archive holds when it is no 3MF package: its first entry; empty without any.
  [[nodiscard]] std::string firstName() const;

  [[noreturn]] void fail(const Text& what, const Text& remedy = {}) const {
    archive_.fail(what, remedy);
  }

private:
  ZipArchive archive_;
  std::map<std::string, std::size_t> entries_;
};

/// Name of an element with the namespace that it stands in.
struct XmlName {
  std::string_view space;
  std::string_view local;
};

/// Attributes of an element by local name (without namespace).
class Attributes {
public:
  explicit Attributes(const char** pairs) : pairs_(pairs) {}

  [[nodiscard]] std::string_view get(std::string_view name) const;

private:
  const char** pairs_;
};

/// What reads an XML part.
class XmlHandler {
public:
  virtual ~XmlHandler() = default;
  virtual void start(const XmlName& name, const Attributes& attributes) = 0;

  virtual void end(const XmlName&) {}

  virtual void text(std::string_view) {}
};

/// SAX reading of one XML part; exceptions pass through expat. A document type is refused, and
/// tags longer than any that a model needs.
class XmlReader {
public:
  XmlReader(const Package& package, std::string part, XmlHandler& handler);
  ~XmlReader();

  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// False when the package has no such part.
  bool run(const JobContext& context);

  /// Namespace that a prefix stands for, of those declared so far; empty when it is not declared.
  [[nodiscard]] std::string namespaceOf(const std::string& prefix) const;

  [[noreturn]] void fail(const Text& what, const Text& remedy = {}) const;

private:
  struct Impl;

  const Package& package_;
  std::string part_;
  XmlHandler& handler_;
  std::map<std::string, std::string> namespaces_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::io
