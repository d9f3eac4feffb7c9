// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/geometry/mesh.hpp"

#include <algorithm>
#include <utility>

namespace wcam::geometry {

namespace {

/// A half-edge in the bucket of its lower vertex: the upper vertex in the high half, the half-edge
/// in the low half, so that one comparison orders both.
using Entry = std::uint64_t;

Entry makeEntry(std::uint32_t upper, std::uint32_t halfEdge) {
  return Entry{upper} << 32 | halfEdge;
}

std::uint32_t upperIn(Entry entry) {
  return static_cast<std::uint32_t>(entry >> 32);
}

std::uint32_t halfEdgeIn(Entry entry) {
  return static_cast<std::uint32_t>(entry);
}

/// Sorts a bucket; most hold some six entries, for which a call of std::sort costs more than the
/// sorting.
void sortBucket(Entry* begin, Entry* end) {
  constexpr std::ptrdiff_t kFew = 24;
  if (end - begin > kFew) {
    std::sort(begin, end);
    return;
  }
  for (Entry* i = begin; i < end; ++i) {
    const Entry entry = *i;
    Entry* place = i;
    for (; place > begin && place[-1] > entry; --place) {
      *place = place[-1];
    }
    *place = entry;
  }
}

std::uint32_t startOf(const TriangleMesh& mesh, std::uint32_t halfEdge) {
  return mesh.triangles[halfEdge / 3][halfEdge % 3];
}

std::uint32_t nextOf(std::uint32_t halfEdge) {
  return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;
}

/// Start of each lower vertex's bucket; one more at the end.
std::vector<std::uint32_t> bucketOffsets(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> offset(mesh.vertices.size() + 1, 0);
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      ++offset[std::min(t[c], t[c == 2 ? 0 : c + 1]) + 1];
    }
  }
  for (std::size_t v = 1; v < offset.size(); ++v) {
    offset[v] += offset[v - 1];
  }
  return offset;
}

/// All half-edges, by lower vertex, then upper vertex, then their own index.
std::vector<Entry> sortedEntries(const TriangleMesh& mesh,
                                 const std::vector<std::uint32_t>& offset) {
  std::vector<Entry> entries(3 * mesh.triangles.size());
  std::vector<std::uint32_t> fill(offset.begin(), offset.end() - 1);
  std::uint32_t h = 0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t[c];
      const std::uint32_t b = t[c == 2 ? 0 : c + 1];
      entries[fill[std::min(a, b)]++] = makeEntry(std::max(a, b), h++);
    }
  }
  for (std::size_t v = 0; v + 1 < offset.size(); ++v) {
    sortBucket(entries.data() + offset[v], entries.data() + offset[v + 1]);
  }
  return entries;
}

}  // namespace

HalfEdges::HalfEdges(const TriangleMesh& mesh) {
  WCAM_ASSERT(mesh.triangles.size() < kNone / 3);
  const std::vector<std::uint32_t> offset = bucketOffsets(mesh);
  const std::vector<Entry> entries = sortedEntries(mesh, offset);
  edgeOf_.resize(entries.size());
  twin_.assign(entries.size(), kNone);
  edgeVertices_.reserve(entries.size() / 2 + 1);
  firstHalfEdge_.reserve(entries.size() / 2 + 1);
  for (std::uint32_t v = 0; v + 1 < offset.size(); ++v) {
    for (std::uint32_t i = offset[v]; i < offset[v + 1];) {
      std::uint32_t end = i + 1;
      while (end < offset[v + 1] && upperIn(entries[end]) == upperIn(entries[i])) {
        ++end;
      }
      const auto edge = static_cast<std::uint32_t>(edgeVertices_.size());
      edgeVertices_.push_back({v, upperIn(entries[i])});
      firstHalfEdge_.push_back(halfEdgeIn(entries[i]));
      for (std::uint32_t k = i; k < end; ++k) {
        edgeOf_[halfEdgeIn(entries[k])] = edge;
      }
      const std::uint32_t first = halfEdgeIn(entries[i]);
      const std::uint32_t second = halfEdgeIn(entries[end - 1]);
      if (end - i == 2 && startOf(mesh, first) != startOf(mesh, second)) {
        twin_[first] = second;
        twin_[second] = first;
      } else {
        ++borderEdgeCount_;
        if (end - i > 1) {
          nonManifoldEdges_.push_back(edge);
        }
      }
      i = end;
    }
  }
}

std::vector<std::vector<std::uint32_t>> HalfEdges::borderLoops(const TriangleMesh& mesh) const {
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<bool> visited(twin_.size(), false);
  for (std::uint32_t start = 0; start < twin_.size(); ++start) {
    if (twin_[start] != kNone || visited[start]) {
      continue;
    }
    std::vector<std::uint32_t> loop;
    // Turning about the end vertex is a permutation of the half-edges, so each loop closes.
    for (std::uint32_t h = start; !visited[h];) {
      visited[h] = true;
      loop.push_back(startOf(mesh, h));
      h = nextOf(h);
      while (twin_[h] != kNone) {
        h = nextOf(twin_[h]);
      }
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace wcam::geometry
