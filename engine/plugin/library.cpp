// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "library.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/crash_notice.hpp"
#include "wcam/plugin/plugin.hpp"

#include "trust.hpp"
#include <dlfcn.h>
#include <elf.h>

#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>

namespace wcam::plugin {

namespace {

[[noreturn]] void refuse(const Text& reason) {
  throw Error(ErrorCode::PluginRefused, reason);
}

std::string abiText(unsigned major, unsigned minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

/// Takes what a plugin registers and checks it against its manifest.
class CollectingRegistrar final : public Registrar {
public:
  explicit CollectingRegistrar(const Manifest& manifest) : manifest_(manifest) {}

  void addSlicing(ComponentInfo info, SlicingFactory factory) override {
    check(info, ComponentKind::Slicing, factory != nullptr);
    std::string id = info.id;
    components_.slicing.insert_or_assign(
        std::move(id), LoadedComponents::Slicing{std::move(info), std::move(factory)});
  }

  void addPost(ComponentInfo info, PostFactory factory) override {
    check(info, ComponentKind::Post, factory != nullptr);
    std::string id = info.id;
    components_.post.insert_or_assign(std::move(id),
                                      LoadedComponents::Post{std::move(info), std::move(factory)});
  }

  LoadedComponents finish() {
    for (const ComponentEntry& entry : manifest_.components) {
      if (!has(entry.id)) {
        problems_.push_back(
            text("component '%1' of the manifest was not registered by the library", {entry.id}));
      }
    }
    if (!problems_.empty()) {
      refuse(joinTexts(problems_, "; "));
    }
    return std::move(components_);
  }

private:
  [[nodiscard]] bool has(const std::string& id) const {
    return components_.slicing.contains(id) || components_.post.contains(id);
  }

  void check(const ComponentInfo& info, ComponentKind kind, bool hasFactory) {
    const ComponentEntry* entry = nullptr;
    for (const ComponentEntry& candidate : manifest_.components) {
      entry = candidate.id == info.id ? &candidate : entry;
    }
    if (entry == nullptr) {
      problems_.push_back(
          text("component '%1' is registered but not named in the manifest", {info.id}));
    } else if (entry->kind != kind) {
      problems_.push_back(text("component '%1' is registered as %2 but the manifest says %3",
                               {info.id, toString(kind), toString(entry->kind)}));
    }
    if (has(info.id)) {
      problems_.push_back(text("component '%1' is registered twice", {info.id}));
    }
    if (!hasFactory) {
      problems_.push_back(text("component '%1' has no factory", {info.id}));
    }
    if (info.version < 1) {
      problems_.push_back(text("component '%1' has a version below 1", {info.id}));
    }
    for (const std::string& problem : schemaProblems(info.params)) {
      problems_.push_back(text("component '%1': parameter %2", {info.id, problem}));
    }
  }

  const Manifest& manifest_;
  LoadedComponents components_;
  std::vector<Text> problems_;
};

std::string textOf(const char* text) {
  return text == nullptr ? "(none)" : text;
}

void checkDescriptor(const wcam_plugin_descriptor* descriptor, const Manifest& manifest) {
  if (descriptor == nullptr) {
    refuse("its entry point returned no descriptor");
  }
  if (descriptor->struct_size < sizeof(wcam_plugin_descriptor)) {
    refuse(text(
        "its descriptor has %1 bytes instead of %2",
        {std::to_string(descriptor->struct_size), std::to_string(sizeof(wcam_plugin_descriptor))}));
  }
  const Text abi = abiProblem(descriptor->abi_major, descriptor->abi_minor);
  if (!abi.empty()) {
    refuse(abi);
  }
  const std::string fingerprint = textOf(descriptor->cxx_fingerprint);
  if (fingerprint != WCAM_CXX_FINGERPRINT) {
    refuse(
        text("it was built with C++ ABI '%1', this program with '%2'; build it with the same "
             "compiler and options",
             {fingerprint, WCAM_CXX_FINGERPRINT}));
  }
  if (textOf(descriptor->id) != manifest.id) {
    refuse(
        text("the library says id '%1', the manifest '%2'", {textOf(descriptor->id), manifest.id}));
  }
  if (textOf(descriptor->version) != manifest.version) {
    refuse(text("the library says version '%1', the manifest '%2'",
                {textOf(descriptor->version), manifest.version}));
  }
  if (descriptor->register_components == nullptr) {
    refuse("its descriptor has no register function");
  }
}

const wcam_plugin_descriptor* callEntry(void* symbol) {
  try {
    return reinterpret_cast<wcam_plugin_entry_function>(symbol)();
  } catch (...) {
    refuse(text("its entry point failed: %1", {currentExceptionText()}));
  }
}

/// Refuses what is no shared library, and a library that was cut short: the loader maps it without
/// looking at the size of the file, and the process dies at the first access beyond its end.
void checkElf(const std::filesystem::path& library) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(library, error)) {  // opening a pipe would wait
    refuse("its library cannot be loaded: it is not a file");
  }
  std::ifstream file(library, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  Elf64_Ehdr header{};
  file.seekg(0);
  if (!file || !file.read(reinterpret_cast<char*>(&header), sizeof header) ||
      std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64 ||
      header.e_type != ET_DYN || header.e_phentsize != sizeof(Elf64_Phdr)) {
    refuse("its library cannot be loaded: the file is not a 64-bit ELF library");
  }
  file.seekg(static_cast<std::streamoff>(header.e_phoff));
  for (int i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    const bool complete = file.read(reinterpret_cast<char*>(&segment), sizeof segment) &&
                          segment.p_offset <= static_cast<std::uint64_t>(size) &&
                          segment.p_filesz <= static_cast<std::uint64_t>(size) - segment.p_offset;
    if (!complete) {
      refuse("its library cannot be loaded: the file is shorter than its header says");
    }
  }
}

}  // namespace

Text abiProblem(unsigned major, unsigned minor) {
  if (major == WCAM_PLUGIN_ABI_MAJOR && minor <= WCAM_PLUGIN_ABI_MINOR) {
    return {};
  }
  // With an equal major number the minor one is too new.
  const bool newer = major >= WCAM_PLUGIN_ABI_MAJOR;
  return text(newer
                  ? "it was built for plugin ABI %1, this program has %2; install a newer WCAM or "
                    "an older plugin"
                  : "it was built for plugin ABI %1, this program has %2; rebuild the plugin",
              {abiText(major, minor), abiText(WCAM_PLUGIN_ABI_MAJOR, WCAM_PLUGIN_ABI_MINOR)});
}

Text currentExceptionText() {
  try {
    throw;
  } catch (const Error& error) {
    return error.hint().empty() ? error.whatText()
                                : text("%1 (%2)", {error.whatText(), error.hintText()});
  } catch (const std::exception& error) {
    return std::string(error.what());
  } catch (...) {
    return "an exception of unknown type";
  }
}

LoadedComponents loadLibrary(const Manifest& manifest, const std::filesystem::path& library) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(library, error)) {
    refuse(text("its library %1 does not exist", {pathText(library)}));
  }
  if (const Text problem = trustProblem(library); !problem.empty()) {
    refuse(text("its library is not loaded: %1", {problem}));
  }
  checkElf(library);
  const PluginCall loading(manifest.id, {});
  void* handle = dlopen(std::filesystem::absolute(library).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    refuse(text("its library cannot be loaded: %1", {textOf(dlerror())}));
  }
  void* symbol = dlsym(handle, WCAM_PLUGIN_ENTRY_NAME);
  if (symbol == nullptr) {
    refuse("its library has no entry point " WCAM_PLUGIN_ENTRY_NAME);
  }
  const wcam_plugin_descriptor* descriptor = callEntry(symbol);
  checkDescriptor(descriptor, manifest);
  CollectingRegistrar registrar(manifest);
  try {
    descriptor->register_components(static_cast<Registrar*>(&registrar));
  } catch (...) {
    refuse(text("its register function failed: %1", {currentExceptionText()}));
  }
  return registrar.finish();
}

}  // namespace wcam::plugin
