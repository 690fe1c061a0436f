// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/platform/files.h"
#include "importer/read/property_pointer.h"
#include "importer/rewrite/carried_document.h"
#include "importer/tool/commands.h"
#include "importer/tool/files/model_output.h"
#include "importer/tool/files/output.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/reference_choice.h"
#include "importer/tool/retarget/map_file.h"
#include "importer/tool/text_table.h"
#include "importer/vrm.h"
#include "importer/vrm_animation.h"
#include "runtime/library/clip_channels.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/map_scenes.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_properties.h"
#include "runtime/retarget/retarget_weights.h"
#include "runtime/retarget/share_twist.h"

namespace sinew::tool {
namespace {

struct RetargetOptions {
  std::string clips, character, out;
  std::optional<std::string> map, reference, onto_reference;
  std::vector<std::string> drop;
  std::string translations = kTranslationRules[0];
  bool keep_rest = false, hold_feet = false;
};

std::string quoted_name(const Skeleton& skeleton, std::uint32_t joint) {
  return skeleton.names[joint].empty() ? fmt::format("node {}", skeleton.node_of_joint[joint])
                                       : in_quotes(skeleton.names[joint]);
}

void print_joints(const char* title, const Skeleton& skeleton, const std::vector<std::uint32_t>& joints) {
  if (joints.empty()) return;
  std::string names;
  for (const std::uint32_t joint : joints) names += (names.empty() ? "" : ", ") + quoted_name(skeleton, joint);
  print_result("{}: {}\n", title, names);
}

void print_names(const char* title, const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + in_quotes(name);
  if (!names.empty()) print_result("{}: {}\n", title, all);
}

void print_map(const SkeletonMap& map, const TwistMap& twists, const Skeleton& source, const Skeleton& target) {
  print_result("{} by {}, heights {:.4g}\n", counted(map.joints.size(), "joint"),
               map.by_names ? "their names" : "the bones of a human body or the map", map.height_ratio);
  for (const MappedJoint& joint : map.joints)
    print_result("  {} follows {}\n", quoted_name(target, joint.target), quoted_name(source, joint.source));
  std::vector<std::uint32_t> resting = map.unmapped_target;
  for (const TwistJoint& twist : twists.joints) {
    print_result("  {} shares the twist of {}\n", quoted_name(target, twist.joint), quoted_name(target, twist.driver));
    std::erase(resting, twist.joint);
  }
  print_joints("joints of the character that rest", target, resting);
  print_joints("joints of the clips that nothing follows", source, map.unmapped_source);
}

/// Holds the feet of a clip. Returns a sentence that says how far they slide without and with holding.
std::string held_feet(const FeetMap& feet, const Animation& animation, const Scene& clips, const Scene& character,
                      Animation& retargeted) {
  const auto slide = [&] {
    return measure_foot_slide(feet, animation, clips.skeleton, retargeted, character.skeleton);
  };
  const FootSlide before = slide();
  hold_feet(feet, animation, clips.skeleton, character.skeleton, retargeted);
  const FootSlide after = slide();
  return fmt::format(", feet slide {} before and {} after in {}", length_text(before.largest),
                     length_text(after.largest), counted(after.contacts, "contact"));
}

/// Copies the properties of a clip to the character, and prints which ones the character does not have.
void carry_properties(const SkeletonMap& map, const Animation& animation, const Scene& clips,
                      const ImportedFile& character, Animation& retargeted) {
  std::vector<std::string> left_out = retarget_properties(animation, map, clips, character.scene, retargeted);
  std::erase_if(retargeted.properties, [&](const PropertyTrack& track) {
    const bool is_lost = !property_is_defined(character.carried->document, character.scene, track.target);
    if (is_lost) left_out.push_back(property_name(character.scene, track.target));
    return is_lost;
  });
  for (const std::string& name : left_out) print_result("  the character has no {}\n", in_quotes(name));
}

/// Gives the character the expressions and the gaze of a VRM animation, and prints what it cannot show.
void carry_face(const Animation& animation, const ImportedFile& clips, const ImportedFile& character,
                Animation& retargeted) {
  if (!clips.vrm || !clips.vrm->is_animation || !character.vrm) return;
  FaceTracks face = face_tracks(animation, *clips.vrm, *character.vrm, character.scene);
  for (const std::string& name : face.not_found)
    print_result("  the character does not show the expression {}\n", in_quotes(name));
  for (WeightAnimation& track : face.weights) {
    std::erase_if(retargeted.weights, [&](const WeightAnimation& other) { return other.instance == track.instance; });
    retargeted.duration_s = std::max(retargeted.duration_s, static_cast<double>(track.weights.times_s.back()));
    retargeted.weights.push_back(std::move(track));
  }
  for (BoneAnimation& eye : face.eyes) {
    std::erase_if(retargeted.bones, [&](const BoneAnimation& other) { return other.joint == eye.joint; });
    retargeted.duration_s = std::max(retargeted.duration_s, eye.end_time());
    retargeted.bones.push_back(std::move(eye));
  }
}

/// Retargets all clips, and prints how far each is from the retargeted poses.
std::vector<Animation> retarget_clips(const ImportedFile& from, const SkeletonMap& map, const TwistMap& twists,
                                      const FeetMap& feet, const ImportedFile& file) {
  const Scene &clips = from.scene, &character = file.scene;
  constexpr double kDegrees = 57.29577951308232;
  std::vector<Animation> all;
  const WeightMap weights = make_weight_map(clips, character);
  print_names("morph targets that the character lacks", weights.not_found);
  for (const Animation& animation : clips.animations) {
    Animation retargeted = retarget_animation(animation, map, clips.skeleton, character.skeleton);
    const RetargetError error = measure_retarget(retargeted, animation, map, clips.skeleton, character.skeleton);
    share_twist(twists, retargeted);
    const std::string slide = feet.legs.empty() ? "" : held_feet(feet, animation, clips, character, retargeted);
    print_result("{}: {}, largest error {:.2g} degrees, {:.2g} units{}\n", in_quotes(animation.name),
                 counted(retargeted.bones.size(), "moved joint"), error.angle_rad * kDegrees, error.distance, slide);
    retarget_weights(weights, animation, clips, character, retargeted);
    carry_face(animation, from, file, retargeted);
    carry_properties(map, animation, clips, file, retargeted);
    all.push_back(std::move(retargeted));
  }
  return all;
}

/// The map by names or bones, or the one of the user's map file.
/// err   what is wrong, as a sentence for the user
tl::expected<SkeletonMap, std::string> map_of(const RetargetOptions& options, const ImportedFile& clips,
                                              const ImportedFile& character) {
  const Skeleton &source = clips.scene.skeleton, &target = character.scene.skeleton;
  SkeletonMapOptions choice;
  if (clips.vrm) choice.source_bones = humanoid_bones_of(clips.vrm->bones);
  if (character.vrm) choice.target_bones = humanoid_bones_of(character.vrm->bones);
  choice.translations = *translation_rule(options.translations);
  if (options.keep_rest) choice.limbs = LimbDirections::of_rest;
  if (options.map)
    if (auto done = read_map_file(*options.map, source, target, choice); !done) return tl::unexpected(done.error());
  const auto from = read_reference(clips.scene, options.reference),
             to = read_reference(character.scene, options.onto_reference);
  if (!from) return tl::unexpected(options.clips + ": " + from.error());
  if (!to) return tl::unexpected(options.character + ": " + to.error());
  choice.source_reference = *from;
  choice.target_reference = *to;
  return make_skeleton_map(clips.scene, character.scene, choice);
}

void print_references(const RetargetOptions& options, const SkeletonMap& map, const Scene& clips,
                      const Scene& character) {
  constexpr double kDegrees = 57.29577951308232;
  if (const auto warning = bind_pose_warning(clips)) print_error(options.clips + ": " + *warning);
  if (const auto warning = bind_pose_warning(character)) print_error(options.character + ": " + *warning);
  print_result("reference: {} of the clips, {} of the character; their bones are {:.2g} degrees apart on average\n",
               reference_text(map.source_reference, options.reference),
               reference_text(map.target_reference, options.onto_reference), map.bone_angle_rad * kDegrees);
}

ExitCode retarget(const RetargetOptions& options) {
  const ResultsToStderr redirected(is_standard_output(platform::path_of(options.out)));
  const auto output = model_output(options.out);
  if (!output) return fail_with(ExitCode::wrong_usage, output.error());
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = plain.make_normals = false;
  const auto clips = load_file(options.clips, plain);
  ImportOptions whole = plain;
  whole.carry_document = true;
  const auto character = load_file(options.character, whole);
  if (!clips || !character) return ExitCode::input_at_fault;
  std::vector<std::filesystem::path> inputs = clips->facts.files;
  inputs.insert(inputs.end(), character->facts.files.begin(), character->facts.files.end());
  if (options.map) inputs.emplace_back(*options.map);
  if (const auto error = find_output_error(*output, inputs)) return fail_with(ExitCode::wrong_usage, *error);

  const Skeleton &source = clips->scene.skeleton, &target = character->scene.skeleton;
  const auto map = map_of(options, *clips, *character);
  if (!map) return fail_with(ExitCode::wrong_usage, map.error());
  if (map->joints.empty())
    return fail_with(ExitCode::input_at_fault, options.character + ": no joint is like one of " + options.clips +
                                                   "; --map FILE says which ones are");
  const FeetMap feet = options.hold_feet ? make_feet_map(*map, source, target) : FeetMap{};
  if (options.hold_feet && feet.legs.empty())
    return fail_with(ExitCode::input_at_fault,
                     options.character + ": no leg with thigh, shank and foot follows one of " + options.clips);
  const TwistMap twists = make_twist_map(*map, target);
  print_map(*map, twists, source, target);
  print_references(options, *map, clips->scene, character->scene);
  const std::vector<Animation> added = retarget_clips(*clips, *map, twists, feet, *character);
  RewriteOptions changes;
  changes.added_animations = added;
  const auto bytes = write_model(*character, options.character, std::move(changes), options.drop, *output);
  if (!bytes) return bytes.error();
  print_result("{}: {} bytes\n", options.out, *bytes);
  return ExitCode::done;
}

}  // namespace

Command retarget_command() {
  auto options = std::make_shared<RetargetOptions>();
  Command command(
      "retarget",
      "Play the clips of one character on another\n"
      "Joints follow those of the same names, or those that are the same bone of a human body: by what a VRM file "
      "says, or by the names of VRM, Mixamo, Unreal, Rigify, Daz and motion capture. Each takes over how far the other "
      "is turned from the reference pose; axes and roll of bones do not matter. Arms and legs point where those of the "
      "clips point, also where one rests with its arms out and the other with its arms down. Bones keep their lengths; "
      "the path of the hips is scaled by their height. Twist joints of arms and legs share what hands, feet, arms and "
      "thighs are twisted. Morph targets, and animated properties of materials, lights and cameras, follow those of "
      "equal names. Expressions and gaze of a VRM animation (.vrma) become morph weights and turns of eyes of a VRM "
      "character.\n"
      "\n"
      "Prints which joint follows which, those that none follows, and how far each clip is from the poses that it was "
      "made of. OUT is CHARACTER with the clips behind its own, and everything else that its file says; what cannot be "
      "carried is listed, and nothing is written unless --drop names it.");
  command.argument("CLIPS", &options->clips, "A .gltf or .glb file with the clips").required();
  command.option("--onto", "CHARACTER", &options->character, "A .gltf or .glb file with the character").required();
  command.option("-o,--output", "OUT", &options->out, "The .glb or .gltf file to write").required();
  command.option("--map", "FILE", &options->map,
                 "JSON with one or both of \"joints\", which joint follows which, and is then all that is mapped,\n"
                 "and \"translations\", RULE of a joint and all below it:\n"
                 "{\"joints\": {\"joint of CHARACTER\": \"joint of CLIPS\", ...},\n"
                 " \"translations\": {\"joint of CHARACTER\": \"by-length\", ...}}");
  add_drop_option(command, options->drop, "What of CHARACTER may be lost");
  command.flag("--hold-feet", options->hold_feet,
               "Feet that are on the ground follow those of CLIPS, and stand still where they do: hips and knees turn. "
               "Prints how far feet slide without and with it");
  command
      .option("--translations", "RULE", &options->translations,
              "hips-by-height: the path of the hips is scaled by their height, bones keep their length (default);\n"
              "by-length: each joint is scaled by the length of its bone; keep: all stay where they rest")
      .one_of({std::begin(kTranslationRules), std::end(kTranslationRules)});
  command.option(
      "--reference", "POSE", &options->reference,
      std::string(kReferenceHelp) +
          "Of CLIPS: turns of joints are\n"
          "measured from it. Default: of rest and bind, of CLIPS and CHARACTER, the two in which the bones of\n"
          "both point most alike; bind only if it is better by half a degree and by a quarter");
  command.option("--onto-reference", "POSE", &options->onto_reference,
                 "The same pose of CHARACTER: rest, bind or CLIP@SECONDS of its own clips");
  command.flag("--keep-rest", options->keep_rest,
               "The rest pose of CLIPS becomes the rest pose of CHARACTER, arms and legs too");
  command.run = [options] { return retarget(*options); };
  return command;
}

}  // namespace sinew::tool
