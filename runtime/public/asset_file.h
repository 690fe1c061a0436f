// SPDX-License-Identifier: MIT
#pragma once
/// Scenes in .sinew files, which load without the importer: skeletons, models, clips, pages of long clips, bounds,
/// skeleton LODs, motion graphs.
///
///     const auto file = sinew::AssetFile::open(bytes);
///     if (!file) return log(describe(file.error()));
///     const auto scene = sinew::read_scene(*file);  // owns its memory: the bytes are not needed any longer
#include "runtime/asset_file/asset_file.h"
#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/read_pages.h"
#include "runtime/asset_file/write_asset_file.h"
