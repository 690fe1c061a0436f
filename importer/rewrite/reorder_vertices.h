// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/streams.h"

namespace sinew::rewrite {

/// Orders triangles and vertices as vertex caches and the codec of EXT_meshopt_compression like them, joins vertices
/// whose every attribute and displacement has the same bits, and leaves out vertices that no triangle uses. What is
/// drawn stays the same; vertices get other numbers.
/// Left as they are: primitives that are no lists of triangles, that share some but not all accessors with others, or
/// that have an extension which may name vertices.
/// cost  O(vertices + indices)
void reorder_vertices(Streams& streams, Draft& draft);

/// The same without another order of triangles: joins vertices and leaves out what no triangle uses. Primitives without
/// indices get some where that takes fewer bytes. Vertices of a primitive with sparse displacements stay as they are.
/// cost  O(vertices + indices)
void join_vertices(Streams& streams, Draft& draft);

/// Stores every index list in 16 bits where its vertices allow it, else in 32.
void narrow_indices(Streams& streams, Draft& draft);

}  // namespace sinew::rewrite
