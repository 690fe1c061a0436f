// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/streams.h"

namespace sinew::rewrite {

/// Reorders triangles and vertices for vertex caches and for the codec of EXT_meshopt_compression. Merges vertices that
/// are bit-identical in all attributes and displacements, and removes unused vertices. The rendered result is
/// unchanged.
/// Unchanged are primitives that are not triangle lists, that share only some accessors with others, or that have an
/// extension which may refer to vertices.
/// cost  O(vertices + indices)
void reorder_vertices(Streams& streams, Draft& draft);

/// Merges identical vertices and removes unused ones, without reordering triangles. Primitives without indices get
/// indices if that takes fewer bytes. Vertices of primitives with sparse displacements are unchanged.
/// cost  O(vertices + indices)
void join_vertices(Streams& streams, Draft& draft);

/// Stores each index list in 16 bits if its values allow it, else in 32.
void narrow_indices(Streams& streams, Draft& draft);

}  // namespace sinew::rewrite
