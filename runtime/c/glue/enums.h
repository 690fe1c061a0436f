// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/result.h"
#include "runtime/c/frame.h"
#include "runtime/c/glue/enum_pairs.h"
#include "runtime/c/library.h"
#include "runtime/c/playback.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/retarget.h"
#include "runtime/c/root_motion.h"
#include "runtime/c/scene.h"
#include "runtime/c/update_levels.h"
#include "runtime/library/clip_library.h"
#include "runtime/lod/update_rate.h"
#include "runtime/model/mesh.h"
#include "runtime/plan/needs.h"
#include "runtime/playback/root_motion.h"
#include "runtime/retarget/skeleton_map.h"

// Enumerations that C and C++ share. Each C++ value is paired with the C value of the same number.

namespace sinew::c {

template <>
inline constexpr auto kEnum<ErrorCode> =
    enum_values<ErrorCode, sinew_error>({{ErrorCode::ok, SINEW_OK},
                                         {ErrorCode::size_mismatch, SINEW_SIZE_MISMATCH},
                                         {ErrorCode::overlapping_buffers, SINEW_OVERLAPPING_BUFFERS},
                                         {ErrorCode::index_out_of_range, SINEW_INDEX_OUT_OF_RANGE},
                                         {ErrorCode::parents_not_first, SINEW_PARENTS_NOT_FIRST},
                                         {ErrorCode::times_not_increasing, SINEW_TIMES_NOT_INCREASING},
                                         {ErrorCode::too_few_keys, SINEW_TOO_FEW_KEYS},
                                         {ErrorCode::not_finite, SINEW_NOT_FINITE},
                                         {ErrorCode::unsupported, SINEW_UNSUPPORTED},
                                         {ErrorCode::coincident_poses, SINEW_COINCIDENT_POSES},
                                         {ErrorCode::rank_deficient, SINEW_RANK_DEFICIENT},
                                         {ErrorCode::busy, SINEW_BUSY},
                                         {ErrorCode::not_normalised, SINEW_NOT_NORMALISED},
                                         {ErrorCode::no_plan, SINEW_NO_PLAN},
                                         {ErrorCode::wrong_plan, SINEW_WRONG_PLAN},
                                         {ErrorCode::moved_from, SINEW_MOVED_FROM},
                                         {ErrorCode::too_many_layers, SINEW_TOO_MANY_LAYERS},
                                         {ErrorCode::wrong_page, SINEW_WRONG_PAGE},
                                         {ErrorCode::not_in_needs, SINEW_NOT_IN_NEEDS},
                                         {ErrorCode::negative_weight, SINEW_NEGATIVE_WEIGHT},
                                         {ErrorCode::not_a_fraction, SINEW_NOT_A_FRACTION},
                                         {ErrorCode::two_times, SINEW_TWO_TIMES},
                                         {ErrorCode::too_large, SINEW_TOO_LARGE},
                                         {ErrorCode::no_cut, SINEW_NO_CUT},
                                         {ErrorCode::unknown_character, SINEW_UNKNOWN_CHARACTER},
                                         {ErrorCode::follows_itself, SINEW_FOLLOWS_ITSELF},
                                         {ErrorCode::outside_of_clip, SINEW_OUTSIDE_OF_CLIP}});

template <>
inline constexpr auto kEnum<Topology> = enum_values<Topology, sinew_topology>({{Topology::points, SINEW_POINTS},
                                                                               {Topology::lines, SINEW_LINES},
                                                                               {Topology::triangles, SINEW_TRIANGLES}});

template <>
inline constexpr auto kEnum<Skinning> =
    enum_values<Skinning, sinew_skinning>({{Skinning::linear, SINEW_SKIN_LINEAR},
                                           {Skinning::dual_quaternion, SINEW_SKIN_DUAL_QUATERNION},
                                           {Skinning::center_of_rotation, SINEW_SKIN_CENTER_OF_ROTATION}});

template <>
inline constexpr auto kEnum<NormalRule> = enum_values<NormalRule, sinew_normal_rule>(
    {{NormalRule::linear, SINEW_NORMALS_LINEAR}, {NormalRule::cofactor, SINEW_NORMALS_COFACTOR}});

template <>
inline constexpr auto kEnum<LayerKind> =
    enum_values<LayerKind, sinew_layer_kind>({{LayerKind::blend, SINEW_LAYER_BLEND},
                                              {LayerKind::add_to_rest, SINEW_LAYER_ADD_TO_REST},
                                              {LayerKind::add_to_start, SINEW_LAYER_ADD_TO_START}});

template <>
inline constexpr auto kEnum<PoseOpKind> =
    enum_values<PoseOpKind, sinew_op_kind>({{PoseOpKind::rest, SINEW_OP_REST},
                                            {PoseOpKind::sample, SINEW_OP_SAMPLE},
                                            {PoseOpKind::sample_mirrored, SINEW_OP_SAMPLE_MIRRORED},
                                            {PoseOpKind::rest_mirrored, SINEW_OP_REST_MIRRORED},
                                            {PoseOpKind::external, SINEW_OP_EXTERNAL},
                                            {PoseOpKind::mean, SINEW_OP_MEAN},
                                            {PoseOpKind::overlay, SINEW_OP_OVERLAY},
                                            {PoseOpKind::overlay_model, SINEW_OP_OVERLAY_MODEL},
                                            {PoseOpKind::add_to_rest, SINEW_OP_ADD_TO_REST},
                                            {PoseOpKind::add, SINEW_OP_ADD},
                                            {PoseOpKind::override_joints, SINEW_OP_OVERRIDE_JOINTS},
                                            {PoseOpKind::procedure, SINEW_OP_PROCEDURE},
                                            {PoseOpKind::inertialize, SINEW_OP_INERTIALIZE},
                                            {PoseOpKind::dead_blend, SINEW_OP_DEAD_BLEND},
                                            {PoseOpKind::cached, SINEW_OP_CACHED}});

template <>
inline constexpr auto kEnum<OverrideSpace> =
    enum_values<OverrideSpace, sinew_override_space>({{OverrideSpace::local, SINEW_OVERRIDE_LOCAL},
                                                      {OverrideSpace::model, SINEW_OVERRIDE_MODEL},
                                                      {OverrideSpace::world, SINEW_OVERRIDE_WORLD}});

template <>
inline constexpr auto kEnum<PlayMode> = enum_values<PlayMode, sinew_play_mode>({{PlayMode::loop, SINEW_PLAY_LOOP},
                                                                                {PlayMode::clamp, SINEW_PLAY_CLAMP},
                                                                                {PlayMode::ping_pong,
                                                                                 SINEW_PLAY_PING_PONG},
                                                                                {PlayMode::once, SINEW_PLAY_ONCE}});

template <>
inline constexpr auto kEnum<RootTurn> =
    enum_values<RootTurn, sinew_root_turn>({{RootTurn::none, SINEW_ROOT_TURN_NONE},
                                            {RootTurn::heading, SINEW_ROOT_TURN_HEADING},
                                            {RootTurn::full, SINEW_ROOT_TURN_FULL},
                                            {RootTurn::heading_euler, SINEW_ROOT_TURN_HEADING_EULER}});

template <>
inline constexpr auto kEnum<UpdateLevel> =
    enum_values<UpdateLevel, sinew_update_level>({{UpdateLevel::every, SINEW_UPDATE_EVERY},
                                                  {UpdateLevel::every_second, SINEW_UPDATE_EVERY_SECOND},
                                                  {UpdateLevel::every_fourth, SINEW_UPDATE_EVERY_FOURTH}});

template <>
inline constexpr auto kEnum<IfUnbound> = enum_values<IfUnbound, sinew_if_unbound>(
    {{IfUnbound::leave_out, SINEW_LEAVE_OUT}, {IfUnbound::refuse, SINEW_REFUSE}});

template <>
inline constexpr auto kEnum<LimbDirections> = enum_values<LimbDirections, sinew_limb_directions>(
    {{LimbDirections::of_source, SINEW_LIMBS_OF_SOURCE}, {LimbDirections::of_rest, SINEW_LIMBS_OF_REST}});

template <>
inline constexpr auto kEnum<TranslationRule> =
    enum_values<TranslationRule, sinew_translation_rule>({{TranslationRule::hips_by_height, SINEW_HIPS_BY_HEIGHT},
                                                          {TranslationRule::by_length, SINEW_BY_LENGTH},
                                                          {TranslationRule::keep, SINEW_KEEP}});

}  // namespace sinew::c
