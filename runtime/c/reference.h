// SPDX-License-Identifier: MIT
#pragma once
#ifdef __cplusplus
extern "C" {
#endif

/// The pose that mirroring and retargeting measure motion from.
typedef enum sinew_reference {
  SINEW_REFERENCE_CHOSEN = 0,  ///< the rest pose, or the bind pose of the skins if that suits clearly better
  SINEW_REFERENCE_REST = 1,    ///< the transforms of the nodes
  SINEW_REFERENCE_BIND = 2,    ///< the pose in which meshes were bound to their skins
  SINEW_REFERENCE_GIVEN = 3    ///< a pose of the caller, for example a frame of a clip
} sinew_reference;

#ifdef __cplusplus
}
#endif
