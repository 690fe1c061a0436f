// SPDX-License-Identifier: MIT
#include "runtime/clip/clip.h"

#include <utility>

#include "runtime/clip/clip_layout.h"

namespace sinew {

Clip::Clip() : layout_(std::make_shared<ClipLayout>()) {}
Clip::Clip(ClipLayout&& layout) : layout_(std::make_shared<ClipLayout>(std::move(layout))) {}

const std::string& Clip::name() const noexcept { return layout_->name; }
double Clip::duration_s() const noexcept { return layout_->duration_s; }
std::size_t Clip::joint_count() const noexcept { return layout_->joint_count; }
std::size_t Clip::weight_count() const noexcept { return layout_->base_weights.size(); }
std::size_t Clip::property_count() const noexcept { return layout_->base_properties.size(); }
Clip::Counts Clip::counts() const noexcept { return layout_->counts; }

const std::optional<ClipCertificate>& Clip::certificate() const noexcept { return layout_->certificate; }

const Annotations& Clip::annotations() const noexcept { return layout_->annotations; }

Clip with_annotations(const Clip& clip, Annotations annotations) {
  ClipLayout layout = clip.layout();
  layout.annotations = std::move(annotations);
  return clip_of(std::move(layout));
}

Clip with_certificate(const Clip& clip, const ClipCertificate& certificate) {
  ClipLayout layout = clip.layout();
  layout.certificate = certificate;
  return clip_of(std::move(layout));
}

Clip clip_of(ClipLayout layout) { return Clip(std::move(layout)); }

std::size_t Clip::byte_size() const noexcept {
  std::size_t bytes =
      layout_->base_pose.byte_size() + layout_->base_weights.byte_size() + layout_->base_properties.byte_size();
  for (const TimeGroup& group : layout_->groups) {
    bytes += group.times.byte_size();
    for (const TrackBlock& block : group.blocks)
      bytes += block.rows.size() * sizeof(float) + block.packed.byte_size() +
               block.targets.size() * sizeof(std::uint32_t) + block.places.byte_size();
  }
  return bytes;
}

}  // namespace sinew
