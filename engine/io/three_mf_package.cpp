// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "three_mf_package.hpp"

#include "wcam/base/error.hpp"

#include "text_scanner.hpp"
#include <expat.h>

#include <algorithm>
#include <exception>
#include <vector>

namespace wcam::io {

namespace {

/// Longest tag, in bytes; those of models have a few hundred. The XML library takes the square of
/// the length of one that goes on and on.
constexpr std::uint64_t kMaxTag = 1 << 20;

int hexDigit(char c) noexcept {
  if (c >= '0' && c <= '9') {
    return c - '0';
  }
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

XmlName nameOf(const char* name) {
  const std::string_view text = name;
  const std::size_t bar = text.rfind('|');
  return bar == std::string_view::npos ? XmlName{{}, text}
                                       : XmlName{text.substr(0, bar), text.substr(bar + 1)};
}

}  // namespace

std::string Package::partName(std::string_view path) {
  std::string name;
  for (std::size_t i = 0; i < path.size(); ++i) {
    char c = path[i];
    const bool escape =
        c == '%' && i + 2 < path.size() && hexDigit(path[i + 1]) >= 0 && hexDigit(path[i + 2]) >= 0;
    if (escape) {
      c = static_cast<char>(hexDigit(path[i + 1]) * 16 + hexDigit(path[i + 2]));
      i += 2;
    }
    name.push_back(c == '\\' ? '/' : c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c);
  }
  // Steps of a path: "." and ".." never lead out of the package.
  std::vector<std::string> steps;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string step = name.substr(begin, end - begin);
    if (step == "..") {
      if (!steps.empty()) {
        steps.pop_back();
      }
    } else if (!step.empty() && step != ".") {
      steps.push_back(step);
    }
    begin = end + 1;
  }
  name.clear();
  for (const std::string& step : steps) {
    name += (name.empty() ? "" : "/") + step;
  }
  return name;
}

Package::Package(std::string_view bytes, const std::string& file) : archive_(bytes, file) {
  const auto& entries = archive_.entries();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto [it, added] = entries_.emplace(partName(entries[i].name), i);
    if (!added && !entries[i].name.ends_with('/')) {
      fail(text("part '%1' is there twice", {printableName(entries[i].name)}));
    }
  }
}

bool Package::read(const std::string& part,
                   const JobContext& context,
                   const std::function<void(const char*, std::size_t, bool)>& use) const {
  const auto it = entries_.find(part);
  if (it == entries_.end()) {
    return false;
  }
  archive_.read(archive_.entries()[it->second], context, use);
  return true;
}

std::string Package::firstName() const {
  return archive_.entries().empty() ? std::string()
                                    : printableName(archive_.entries().front().name);
}

std::string_view Attributes::get(std::string_view name) const {
  for (const char** p = pairs_; *p != nullptr; p += 2) {
    if (nameOf(*p).local == name) {
      return p[1];
    }
  }
  return {};
}

struct XmlReader::Impl {
  explicit Impl(XmlReader& reader)
      : reader_(reader), parser(XML_ParserCreateNS(nullptr, '|'), XML_ParserFree) {
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(parser.get(), onStart, onEnd);
    XML_SetCharacterDataHandler(parser.get(), onText);
    XML_SetNamespaceDeclHandler(parser.get(), onNamespace, nullptr);
    XML_SetStartDoctypeDeclHandler(parser.get(), onDoctype);
  }

  template <class Work>
  void guarded(const Work& work) {
    if (failure) {
      return;
    }
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
      XML_StopParser(parser.get(), XML_FALSE);
    }
  }

  static void onStart(void* self, const char* name, const char** attributes) {
    auto* impl = static_cast<Impl*>(self);
    impl->guarded([&] { impl->reader_.handler_.start(nameOf(name), Attributes(attributes)); });
  }

  static void onEnd(void* self, const char* name) {
    auto* impl = static_cast<Impl*>(self);
    impl->guarded([&] { impl->reader_.handler_.end(nameOf(name)); });
  }

  static void onText(void* self, const char* text, int size) {
    auto* impl = static_cast<Impl*>(self);
    impl->guarded([&] {
      impl->reader_.handler_.text(std::string_view(text, static_cast<std::size_t>(size)));
    });
  }

  static void onNamespace(void* self, const char* prefix, const char* space) {
    auto* impl = static_cast<Impl*>(self);
    impl->guarded([&] {
      impl->reader_.namespaces_.emplace(prefix == nullptr ? "" : prefix,
                                        space == nullptr ? "" : space);
    });
  }

  static void onDoctype(void* self, const char*, const char*, const char*, int) {
    auto* impl = static_cast<Impl*>(self);
    impl->guarded([&] { impl->reader_.fail("a document type is not allowed in 3MF"); });
  }

  void feed(const char* data, std::size_t size, bool last) {
    const XML_Status status =
        XML_Parse(parser.get(), data, static_cast<int>(size), last ? XML_TRUE : XML_FALSE);
    if (failure) {
      std::rethrow_exception(failure);
    }
    if (status != XML_STATUS_OK) {
      reader_.fail(XML_ErrorString(XML_GetErrorCode(parser.get())));
    }
    fed += size;
    const XML_Index at = XML_GetCurrentByteIndex(parser.get());
    if (at >= 0 && fed - std::min(fed, static_cast<std::uint64_t>(at)) > kMaxTag) {
      reader_.fail(wcam::text("a tag is longer than %1 bytes", {std::to_string(kMaxTag)}));
    }
  }

  XmlReader& reader_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser;
  std::exception_ptr failure;
  std::uint64_t fed = 0;
};

XmlReader::XmlReader(const Package& package, std::string part, XmlHandler& handler)
    : package_(package),
      part_(std::move(part)),
      handler_(handler),
      impl_(std::make_unique<Impl>(*this)) {}

XmlReader::~XmlReader() = default;

bool XmlReader::run(const JobContext& context) {
  return package_.read(part_, context, [&](const char* data, std::size_t size, bool last) {
    impl_->feed(data, size, last);
  });
}

std::string XmlReader::namespaceOf(const std::string& prefix) const {
  const auto it = namespaces_.find(prefix);
  return it == namespaces_.end() ? std::string() : it->second;
}

void XmlReader::fail(const Text& what, const Text& remedy) const {
  package_.fail(wcam::text("part '%1', line %2: %3",
                           {printableName(part_),
                            std::to_string(XML_GetCurrentLineNumber(impl_->parser.get())), what}),
                remedy);
}

}  // namespace wcam::io
