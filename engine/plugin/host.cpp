// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/host.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/locations.hpp"

#include "library.hpp"
#include "trial.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <set>

namespace wcam::plugin {

namespace fs = std::filesystem;

namespace {

/// A manifest (or what should have one) that was found, and its fate.
struct Candidate {
  fs::path path;
  PluginOrigin origin = PluginOrigin::Installed;
  std::optional<Manifest> manifest;
  Text refusal;  ///< found out for itself: bad manifest, wrong ABI, failed loading
  Text shadow;   ///< in the way of one that comes first
  bool shadowed = false;
  std::optional<LoadedComponents> loaded;

  [[nodiscard]] PluginVerdict verdict() const {
    if (!refusal.empty() || (!shadow.empty() && !shadowed)) {
      return PluginVerdict::Refused;
    }
    if (!shadow.empty()) {
      return PluginVerdict::Shadowed;
    }
    return loaded ? PluginVerdict::Loaded : PluginVerdict::Available;
  }

  [[nodiscard]] bool usable() const { return refusal.empty() && shadow.empty(); }
};

Candidate readCandidate(const fs::path& manifestFile, PluginOrigin origin) {
  Candidate candidate;
  candidate.path = manifestFile;
  candidate.origin = origin;
  try {
    candidate.manifest = readManifest(manifestFile);
    candidate.refusal = abiProblem(static_cast<unsigned>(candidate.manifest->abiMajor),
                                   static_cast<unsigned>(candidate.manifest->abiMinor));
  } catch (const Error& error) {
    candidate.refusal = error.messageText();
  }
  return candidate;
}

Candidate refusedCandidate(const fs::path& path, PluginOrigin origin, Text reason) {
  Candidate candidate;
  candidate.path = path;
  candidate.origin = origin;
  candidate.refusal = std::move(reason);
  return candidate;
}

fs::path manifestOf(fs::path library) {
  return library.replace_extension(".json");
}

Candidate requestedCandidate(const fs::path& file) {
  const fs::path manifest = file.extension() == ".json" ? file : manifestOf(file);
  std::error_code error;
  if (!fs::exists(file, error)) {
    return refusedCandidate(file, PluginOrigin::Requested, "the file does not exist");
  }
  if (!fs::exists(manifest, error)) {
    return refusedCandidate(
        file, PluginOrigin::Requested,
        text("it has no manifest %1 beside it", {pathText(manifest.filename())}));
  }
  return readCandidate(manifest, PluginOrigin::Requested);
}

/// Manifests by name, then libraries that no manifest names.
std::vector<Candidate> scanFolder(const PluginSearch::Folder& folder) {
  std::error_code error;
  if (folder.path.is_relative()) {
    return {refusedCandidate(folder.path, folder.origin,
                             "the folder depends on where the program is started; name its whole "
                             "path")};
  }
  if (!fs::is_directory(folder.path, error)) {
    // The user's and the installed folder need not exist; one that is named should.
    return folder.origin == PluginOrigin::Environment
               ? std::vector{refusedCandidate(
                     folder.path, folder.origin,
                     "WCAM_PLUGIN_PATH names a folder that does not exist")}
               : std::vector<Candidate>{};
  }
  std::vector<fs::path> manifests;
  std::vector<fs::path> libraries;
  for (fs::directory_iterator it(folder.path, error), end; !error && it != end;
       it.increment(error)) {
    const std::string extension = it->path().extension().string();
    if (extension == ".json") {
      manifests.push_back(it->path());
    } else if (extension == ".so") {
      libraries.push_back(it->path());
    }
  }
  if (error) {
    return {refusedCandidate(folder.path, folder.origin,
                             text("the folder cannot be read: %1", {error.message()}))};
  }
  std::sort(manifests.begin(), manifests.end());
  std::sort(libraries.begin(), libraries.end());
  std::vector<Candidate> candidates;
  std::set<std::string> named;
  for (const fs::path& file : manifests) {
    candidates.push_back(readCandidate(file, folder.origin));
    named.insert(file.stem().string() + ".so");
    if (candidates.back().manifest) {
      named.insert(candidates.back().manifest->library);
    }
  }
  for (const fs::path& file : libraries) {
    if (!named.contains(file.filename().string())) {
      candidates.push_back(refusedCandidate(
          file, folder.origin,
          text("it has no manifest %1 beside it", {pathText(manifestOf(file).filename())})));
    }
  }
  return candidates;
}

std::vector<Candidate> scan(const PluginSearch& search) {
  std::vector<Candidate> all;
  for (const fs::path& file : search.files) {
    all.push_back(requestedCandidate(file));
  }
  for (const PluginSearch::Folder& folder : search.folders) {
    for (Candidate& candidate : scanFolder(folder)) {
      all.push_back(std::move(candidate));
    }
  }
  // A folder or file that is named twice counts once.
  std::set<fs::path> seen;
  std::erase_if(all, [&seen](const Candidate& candidate) {
    std::error_code error;
    fs::path key = fs::weakly_canonical(candidate.path, error);
    return !seen.insert(error ? candidate.path : key).second;
  });
  return all;
}

}  // namespace

const char* toString(PluginOrigin origin) noexcept {
  switch (origin) {
    case PluginOrigin::Requested:
      return "requested";
    case PluginOrigin::Environment:
      return "environment";
    case PluginOrigin::User:
      return "user";
    case PluginOrigin::Installed:
      break;
  }
  return "installed";
}

const char* toString(PluginVerdict verdict) noexcept {
  switch (verdict) {
    case PluginVerdict::Available:
      return "available";
    case PluginVerdict::Loaded:
      return "loaded";
    case PluginVerdict::Shadowed:
      return "shadowed";
    case PluginVerdict::Refused:
      break;
  }
  return "refused";
}

PluginSearch defaultPluginSearch(std::vector<fs::path> files, bool userPlugins) {
  PluginSearch search;
  search.files = std::move(files);
  if (userPlugins) {
    const char* variable = std::getenv("WCAM_PLUGIN_PATH");
    for (const std::string& entry : splitText(variable == nullptr ? "" : variable, ':')) {
      if (!entry.empty()) {
        search.folders.push_back({pathFromText(entry), PluginOrigin::Environment});
      }
    }
    if (const fs::path user = userPluginFolder(); !user.empty()) {
      search.folders.push_back({user, PluginOrigin::User});
    }
  }
  search.folders.push_back({installedPluginFolder(), PluginOrigin::Installed});
  return search;
}

struct PluginHost::State {
  PluginSearch search;
  std::recursive_mutex mutex;
  std::vector<Candidate> candidates;
  std::map<std::string, std::shared_ptr<const SlicingComponent>, std::less<>> slicing;
  std::map<std::string, std::shared_ptr<const PostComponent>, std::less<>> posts;

  void resolve();
  void load(Candidate& candidate);
  template <class Wanted>
  void loadEvery(const Wanted& wanted);
  Candidate* owner(std::string_view id, ComponentKind kind);
  Candidate& loadedOwner(std::string_view id, ComponentKind kind);
  /// @param any the kind is not known
  [[noreturn]] void missing(std::string_view id, ComponentKind kind, bool any = false) const;

  template <class Component, class Make>
  std::shared_ptr<const Component> create(
      std::map<std::string, std::shared_ptr<const Component>, std::less<>>& cache,
      std::string_view id,
      ComponentKind kind,
      const Make& make);
};

/// The order in which candidates win ids: that of the search, save that what is installed comes
/// before folders of the user: only `--plugin` puts something else in its place.
std::vector<Candidate*> byRank(std::vector<Candidate>& candidates) {
  std::vector<Candidate*> ranked;
  for (Candidate& candidate : candidates) {
    ranked.push_back(&candidate);
  }
  const auto rank = [](const Candidate* candidate) {
    return candidate->origin == PluginOrigin::Requested   ? 0
           : candidate->origin == PluginOrigin::Installed ? 1
                                                          : 2;
  };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&rank](const Candidate* a, const Candidate* b) { return rank(a) < rank(b); });
  return ranked;
}

/// Decides who wins each plugin id and each component id.
void PluginHost::State::resolve() {
  std::map<std::string, const Candidate*> plugins;
  std::map<std::string, const Candidate*> components;
  const auto inPlaceOf = [](const Candidate& candidate, const Candidate& winner) {
    return winner.origin == PluginOrigin::Installed && candidate.origin != PluginOrigin::Installed;
  };
  for (Candidate* const ranked : byRank(candidates)) {
    Candidate& candidate = *ranked;
    candidate.shadow = {};
    if (!candidate.refusal.empty()) {
      continue;
    }
    const auto [first, won] = plugins.emplace(candidate.manifest->id, &candidate);
    candidate.shadowed = !won && !inPlaceOf(candidate, *first->second);
    if (!won) {
      candidate.shadow =
          candidate.shadowed
              ? text("another plugin of this id comes first: %1", {pathText(first->second->path)})
              : text(
                    "it would take the place of the installed plugin %1; name it with --plugin to "
                    "use it",
                    {pathText(first->second->path)});
      continue;
    }
    for (const ComponentEntry& entry : candidate.manifest->components) {
      const auto found = components.find(entry.id);
      if (found != components.end()) {
        candidate.shadow =
            inPlaceOf(candidate, *found->second)
                ? text(
                      "its component '%1' would take the place of that of the installed plugin %2; "
                      "name it with --plugin to use it",
                      {entry.id, found->second->manifest->id})
                : text("its component '%1' is already provided by plugin %2 (%3)",
                       {entry.id, found->second->manifest->id, pathText(found->second->path)});
      }
    }
    if (!candidate.shadow.empty()) {
      plugins.erase(candidate.manifest->id);
      continue;
    }
    for (const ComponentEntry& entry : candidate.manifest->components) {
      components.emplace(entry.id, &candidate);
    }
  }
}

template <class Wanted>
void PluginHost::State::loadEvery(const Wanted& wanted) {
  const std::lock_guard lock(mutex);
  // A refusal may promote a candidate that was shadowed: look again until nothing changes.
  for (bool changed = true; changed;) {
    changed = false;
    for (Candidate& candidate : candidates) {
      if (candidate.usable() && !candidate.loaded && wanted(candidate)) {
        changed = true;
        candidate.refusal = trialProblem(candidate.path);
        if (candidate.refusal.empty()) {
          load(candidate);
        } else {
          resolve();
        }
      }
    }
  }
}

void PluginHost::State::load(Candidate& candidate) {
  if (candidate.loaded) {
    return;
  }
  try {
    candidate.loaded = loadLibrary(*candidate.manifest,
                                   candidate.path.parent_path() / candidate.manifest->library);
  } catch (const Error& error) {
    candidate.refusal = error.messageText();
    resolve();
  }
}

Candidate* PluginHost::State::owner(std::string_view id, ComponentKind kind) {
  for (Candidate& candidate : candidates) {
    if (!candidate.usable()) {
      continue;
    }
    for (const ComponentEntry& entry : candidate.manifest->components) {
      if (entry.id == id && entry.kind == kind) {
        return &candidate;
      }
    }
  }
  return nullptr;
}

Candidate& PluginHost::State::loadedOwner(std::string_view id, ComponentKind kind) {
  while (Candidate* candidate = owner(id, kind)) {
    load(*candidate);
    if (candidate->usable()) {
      return *candidate;
    }
  }
  missing(id, kind);
}

/// "acme.com" for com.acme.post.demo; empty for ids that begin with no top-level domain.
std::string domainOf(std::string_view id) {
  const std::vector<std::string> labels = splitText(id, '.');
  constexpr std::size_t kLongestCountry = 3;
  return labels.size() < 3 || labels[0].size() > kLongestCountry || labels[0] == "wcam"
             ? std::string()
             : labels[1] + "." + labels[0];
}

void PluginHost::State::missing(std::string_view id, ComponentKind kind, bool any) const {
  std::vector<Text> reasons;
  std::vector<std::string> names;
  std::string otherKind;
  for (const Candidate& candidate : candidates) {
    if (!candidate.manifest) {
      continue;
    }
    for (const ComponentEntry& entry : candidate.manifest->components) {
      const bool fits = any || entry.kind == kind;
      if (entry.id == id && fits && candidate.verdict() == PluginVerdict::Refused) {
        reasons.push_back(text("plugin %1 (%2) is refused: %3",
                               {candidate.manifest->id, pathText(candidate.path),
                                candidate.refusal.empty() ? candidate.shadow : candidate.refusal}));
      } else if (candidate.usable() && fits) {
        names.push_back(entry.id);
      } else if (candidate.usable() && entry.id == id) {
        otherKind = toString(entry.kind);
      }
    }
  }
  const bool isStrategy = kind == ComponentKind::Slicing;
  const std::string name(id);
  if (!reasons.empty()) {
    throw Error(ErrorCode::PluginRefused,
                text(any          ? "component '%1' cannot be used: %2"
                     : isStrategy ? "strategy '%1' cannot be used: %2"
                                  : "post-processor '%1' cannot be used: %2",
                     {name, joinTexts(reasons, "; ")}),
                {}, "install a plugin that fits, or see `camcli plugins list`");
  }
  std::vector<std::string> places;
  for (const fs::path& file : search.files) {
    places.push_back(pathText(file));
  }
  for (const PluginSearch::Folder& folder : search.folders) {
    places.push_back(pathText(folder.path));
  }
  Text hint =
      text("looked in: %1", {places.empty() ? text("nowhere") : Text(joinText(places, ", "))});
  if (!otherKind.empty()) {
    hint = text("it is of kind %1; %2", {otherKind, hint});
  } else if (const auto near = nearestName(id, names)) {
    hint = text("did you mean '%1'? %2", {*near, hint});
  }
  if (const std::string maker = domainOf(id); !maker.empty()) {
    hint = text("its maker is the owner of %1; %2", {maker, hint});
  }
  throw Error(ErrorCode::PluginMissing,
              text(any          ? "no plugin provides the component '%1'"
                   : isStrategy ? "no plugin provides the strategy '%1'"
                                : "no plugin provides the post-processor '%1'",
                   {name}),
              {}, hint);
}

template <class Component, class Make>
std::shared_ptr<const Component> PluginHost::State::create(
    std::map<std::string, std::shared_ptr<const Component>, std::less<>>& cache,
    std::string_view id,
    ComponentKind kind,
    const Make& make) {
  const std::lock_guard lock(mutex);
  if (const auto found = cache.find(id); found != cache.end()) {
    return found->second;
  }
  while (true) {
    Candidate& candidate = loadedOwner(id, kind);
    std::shared_ptr<const Component> component;
    try {
      component = make(candidate);
    } catch (...) {
      candidate.refusal = text("the factory of component '%1' failed: %2",
                               {std::string(id), currentExceptionText()});
      resolve();
      continue;
    }
    if (component == nullptr) {
      candidate.refusal = text("the factory of component '%1' returned nothing", {std::string(id)});
      resolve();
      continue;
    }
    return cache.emplace(id, std::move(component)).first->second;
  }
}

PluginHost::PluginHost(const PluginSearch& search) : state_(std::make_unique<State>()) {
  state_->search = search;
  state_->candidates = scan(search);
  state_->resolve();
}

PluginHost::~PluginHost() = default;

std::vector<PluginReport> PluginHost::reports() const {
  const std::lock_guard lock(state_->mutex);
  std::vector<PluginReport> reports;
  for (const Candidate& candidate : state_->candidates) {
    PluginReport report;
    report.path = candidate.path;
    report.origin = candidate.origin;
    report.verdict = candidate.verdict();
    report.reason = candidate.refusal.empty() ? candidate.shadow : candidate.refusal;
    if (candidate.manifest) {
      report.id = candidate.manifest->id;
      report.name = candidate.manifest->name;
      report.version = candidate.manifest->version;
      report.abi = std::to_string(candidate.manifest->abiMajor) + "." +
                   std::to_string(candidate.manifest->abiMinor);
      report.components = candidate.manifest->components;
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

std::vector<ComponentEntry> PluginHost::components() const {
  const std::lock_guard lock(state_->mutex);
  std::vector<ComponentEntry> entries;
  for (const Candidate& candidate : state_->candidates) {
    if (candidate.usable()) {
      entries.insert(entries.end(), candidate.manifest->components.begin(),
                     candidate.manifest->components.end());
    }
  }
  std::sort(entries.begin(), entries.end(),
            [](const ComponentEntry& a, const ComponentEntry& b) { return a.id < b.id; });
  return entries;
}

void PluginHost::loadAll() const {
  state_->loadEvery([](const Candidate&) { return true; });
}

void PluginHost::loadRequested() const {
  state_->loadEvery(
      [](const Candidate& candidate) { return candidate.origin == PluginOrigin::Requested; });
}

std::shared_ptr<const SlicingComponent> PluginHost::findSlicing(std::string_view id) const {
  return state_->create(
      state_->slicing, id, ComponentKind::Slicing, [id](const Candidate& candidate) {
        const auto& found = candidate.loaded->slicing.find(id)->second;
        std::shared_ptr<const SlicingStrategy> strategy = found.factory();
        const Manifest& manifest = *candidate.manifest;
        return strategy == nullptr
                   ? nullptr
                   : std::make_shared<const SlicingComponent>(SlicingComponent{
                         found.info, manifest.id, manifest.version,
                         guardSlicing(std::move(strategy), manifest.id, found.info.id)});
      });
}

std::shared_ptr<const PostComponent> PluginHost::findPost(std::string_view id) const {
  return state_->create(state_->posts, id, ComponentKind::Post, [id](const Candidate& candidate) {
    const auto& found = candidate.loaded->post.find(id)->second;
    std::shared_ptr<const PostProcessor> post = found.factory();
    const Manifest& manifest = *candidate.manifest;
    return post == nullptr ? nullptr
                           : std::make_shared<const PostComponent>(PostComponent{
                                 found.info, manifest.id, manifest.version,
                                 guardPost(std::move(post), manifest.id, found.info.id)});
  });
}

ComponentInfo PluginHost::info(std::string_view id) const {
  for (const ComponentEntry& entry : components()) {
    if (entry.id == id && entry.kind == ComponentKind::Slicing) {
      return findSlicing(id)->info;
    }
    if (entry.id == id && entry.kind == ComponentKind::Post) {
      return findPost(id)->info;
    }
  }
  state_->missing(id, ComponentKind::Post, true);
}

}  // namespace wcam::plugin
