// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "library.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/plugin.hpp"

#include <dlfcn.h>
#include <elf.h>

#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>

namespace wcam::plugin {

namespace {

[[noreturn]] void refuse(const std::string& reason) {
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
        problems_.push_back("component '" + entry.id +
                            "' of the manifest was not registered by the library");
      }
    }
    if (!problems_.empty()) {
      refuse(joinText(problems_, "; "));
    }
    return std::move(components_);
  }

private:
  [[nodiscard]] bool has(const std::string& id) const {
    return components_.slicing.contains(id) || components_.post.contains(id);
  }

  void check(const ComponentInfo& info, ComponentKind kind, bool hasFactory) {
    const std::string name = "component '" + info.id + "'";
    const ComponentEntry* entry = nullptr;
    for (const ComponentEntry& candidate : manifest_.components) {
      entry = candidate.id == info.id ? &candidate : entry;
    }
    if (entry == nullptr) {
      problems_.push_back(name + " is registered but not named in the manifest");
    } else if (entry->kind != kind) {
      problems_.push_back(name + " is registered as " + toString(kind) + " but the manifest says " +
                          toString(entry->kind));
    }
    if (has(info.id)) {
      problems_.push_back(name + " is registered twice");
    }
    if (!hasFactory) {
      problems_.push_back(name + " has no factory");
    }
    if (info.version < 1) {
      problems_.push_back(name + " has a version below 1");
    }
    for (const std::string& problem : schemaProblems(info.params)) {
      problems_.push_back(name);
      problems_.back().append(": parameter ").append(problem);
    }
  }

  const Manifest& manifest_;
  LoadedComponents components_;
  std::vector<std::string> problems_;
};

std::string textOf(const char* text) {
  return text == nullptr ? "(none)" : text;
}

void checkDescriptor(const wcam_plugin_descriptor* descriptor, const Manifest& manifest) {
  if (descriptor == nullptr) {
    refuse("its entry point returned no descriptor");
  }
  if (descriptor->struct_size < sizeof(wcam_plugin_descriptor)) {
    refuse("its descriptor has " + std::to_string(descriptor->struct_size) + " bytes instead of " +
           std::to_string(sizeof(wcam_plugin_descriptor)));
  }
  const std::string abi = abiProblem(descriptor->abi_major, descriptor->abi_minor);
  if (!abi.empty()) {
    refuse(abi);
  }
  const std::string fingerprint = textOf(descriptor->cxx_fingerprint);
  if (fingerprint != WCAM_CXX_FINGERPRINT) {
    refuse("it was built with C++ ABI '" + fingerprint + "', this program with '" +
           WCAM_CXX_FINGERPRINT + "'; build it with the same compiler and options");
  }
  if (textOf(descriptor->id) != manifest.id) {
    refuse("the library says id '" + textOf(descriptor->id) + "', the manifest '" + manifest.id +
           "'");
  }
  if (textOf(descriptor->version) != manifest.version) {
    refuse("the library says version '" + textOf(descriptor->version) + "', the manifest '" +
           manifest.version + "'");
  }
  if (descriptor->register_components == nullptr) {
    refuse("its descriptor has no register function");
  }
}

const wcam_plugin_descriptor* callEntry(void* symbol) {
  try {
    return reinterpret_cast<wcam_plugin_entry_function>(symbol)();
  } catch (...) {
    refuse("its entry point failed: " + currentExceptionText());
  }
}

/// Refuses what is no shared library, and a library that was cut short: the loader maps it without
/// looking at the size of the file, and the process dies at the first access beyond its end.
void checkElf(const std::filesystem::path& library) {
  const std::string reason = "its library cannot be loaded: the file is ";
  std::ifstream file(library, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  Elf64_Ehdr header{};
  file.seekg(0);
  if (!file || !file.read(reinterpret_cast<char*>(&header), sizeof header) ||
      std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64 ||
      header.e_type != ET_DYN || header.e_phentsize != sizeof(Elf64_Phdr)) {
    refuse(reason + "not a 64-bit ELF library");
  }
  file.seekg(static_cast<std::streamoff>(header.e_phoff));
  for (int i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    const bool complete = file.read(reinterpret_cast<char*>(&segment), sizeof segment) &&
                          segment.p_offset <= static_cast<std::uint64_t>(size) &&
                          segment.p_filesz <= static_cast<std::uint64_t>(size) - segment.p_offset;
    if (!complete) {
      refuse(reason + "shorter than its header says");
    }
  }
}

}  // namespace

std::string abiProblem(unsigned major, unsigned minor) {
  if (major == WCAM_PLUGIN_ABI_MAJOR && minor <= WCAM_PLUGIN_ABI_MINOR) {
    return {};
  }
  // With an equal major number the minor one is too new.
  const bool newer = major >= WCAM_PLUGIN_ABI_MAJOR;
  return "it was built for plugin ABI " + abiText(major, minor) + ", this program has " +
         abiText(WCAM_PLUGIN_ABI_MAJOR, WCAM_PLUGIN_ABI_MINOR) +
         (newer ? "; install a newer WCAM or an older plugin" : "; rebuild the plugin");
}

std::string currentExceptionText() {
  try {
    throw;
  } catch (const Error& error) {
    return error.hint().empty() ? error.what()
                                : std::string(error.what()) + " (" + error.hint() + ")";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception of unknown type";
  }
}

LoadedComponents loadLibrary(const Manifest& manifest, const std::filesystem::path& library) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(library, error)) {
    refuse("its library " + pathText(library) + " does not exist");
  }
  checkElf(library);
  void* handle = dlopen(std::filesystem::absolute(library).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    refuse("its library cannot be loaded: " + textOf(dlerror()));
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
    refuse("its register function failed: " + currentExceptionText());
  }
  return registrar.finish();
}

}  // namespace wcam::plugin
