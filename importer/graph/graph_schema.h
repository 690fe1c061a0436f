// SPDX-License-Identifier: MIT
#pragma once
#include "importer/graph/graph_document.h"
#include "importer/graph/graph_words.h"

// Lists every member of a graph file as (JSON key, C++ member, description). The reader, the writer and the table in
// README.md all use this list. A file must state each `required` member; any other member that it omits keeps its
// default.
namespace sinew::graph_schema {

inline constexpr int kVersion = 1;

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Parameter*) {
  v.required("kind", d.kind, "a number, a flag (0 or 1), or a trigger that a transition uses up");
  v.optional("initial", d.initial, "value at the start");
  v.optional("formula", d.formula, "computes it from others, as `max(speed, 0) / 1.7`; callers do not set it then");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::CurveKey*) {
  v.required("at", d.at, "share of the duration, in (0, 1); it rises from key to key");
  v.required("share", d.share, "of the new state, in [0, 1]");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Curve*) {
  v.optional("start_slope", d.start_slope, "slope at (0, 0); without keys from 0 to 3");
  v.optional("end_slope", d.end_slope, "slope at (1, 1); without keys from 0 to 3");
  v.optional("keys", d.keys, "places between; without them the curve is one cubic");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Condition*) {
  v.required("kind", d.kind, "how a parameter compares with the value, or a time of the state");
  v.optional("parameter", d.parameter, "the parameter; not for time_in_state, played and phase");
  v.optional("value", d.value, "what a number is compared with; seconds; rounds of the main clip; phase in [0, 1)");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Transition*) {
  v.required("to", d.to, "state of the machine");
  v.optional("when", d.when, "conditions, which must all hold");
  v.optional("duration_s", d.duration_s, "seconds of the fade; 0 cuts");
  v.optional("priority", d.priority, "the smallest wins, then the last in the list");
  v.optional("kind", d.kind, "how the pose gets over; a cross-fade where poses contain their root motion");
  v.optional("fade", d.fade, "curve of the fade");
  v.optional("curve", d.curve, "a curve of its own instead; root motion and events follow it, too");
  v.optional("interruption", d.interruption, "the transitions that may interrupt the fade");
  v.optional("ordered", d.ordered, "only smaller priorities of the source interrupt");
  v.optional("sync", d.sync, "start at the place of the old state; locked: and play in step while fading");
  v.optional("start_by", d.start_by, "the place: at the same phase, the same beat, or with as much time left");
  v.optional("to_self", d.to_self, "from any state: may start the active state anew");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::State*) {
  v.required("node", d.node, "the node that plays");
  v.optional("transitions", d.transitions, "ways out");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Point*) {
  v.required("x", d.x, "place");
  v.optional("y", d.y, "place in a plane");
  v.required("node", d.node, "a clip node");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Layer*) {
  v.required("node", d.node, "the node above");
  v.optional("kind", d.kind, "how it joins what lies below");
  v.optional("weight", d.weight, "share");
  v.optional("weight_by", d.weight_by, "number that multiplies the weight");
  v.optional("mask", d.mask, "name of a mask; without it all joints");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Node*) {
  v.required("kind", d.kind, "kind of the node; other members depend on it");
  switch (d.kind) {
    case GraphDocument::NodeKind::clip:
      v.required("clip", d.clip, "name of the clip");
      v.optional("speed", d.speed, "times as fast; below 0 backwards");
      v.optional("speed_by", d.speed_by, "number that multiplies the speed");
      v.optional("offset_s", d.offset_s, "seconds where it starts");
      v.optional("loop", d.loop, "false: it stays at its end");
      v.optional("mirror", d.mirror, "left and right exchanged");
      return;
    case GraphDocument::NodeKind::blend_space:
      v.required("x", d.x, "number");
      v.optional("y", d.y, "number; without it the space is a line");
      v.optional("form", d.form, "in a plane: how a place becomes weights; points of directional are velocities");
      v.optional("angle_factor", d.angle_factor, "directional: how much a turn counts beside a change of speed");
      v.required("points", d.points, "clips and their places; on a line x rises");
      return;
    case GraphDocument::NodeKind::select:
      v.required("by", d.by, "number, rounded: 0 is the first child");
      v.required("children", d.children, "nodes");
      return;
    case GraphDocument::NodeKind::layers:
      v.required("base", d.base, "the lowest node");
      v.optional("layers", d.layers, "nodes above it, from below");
      return;
    case GraphDocument::NodeKind::machine:
      v.required("initial", d.initial, "first state, where no entry rule holds");
      v.optional("fades", d.fades, "fades at once, at most 8");
      v.required("states", d.states, "states by name");
      v.optional("any", d.any, "transitions from any state");
      v.optional("entry", d.entry, "rules that choose the first state");
      return;
    case GraphDocument::NodeKind::external: v.required("pose", d.pose, "index of the caller's pose"); return;
    case GraphDocument::NodeKind::graph:
      v.required("file", d.file, "the file of another graph, beside this one; its root takes the place of the node");
      v.optional("parameters", d.parameters, "names of its parameters here; others keep their names");
      v.optional("clips", d.clips, "clips that it plays instead of its own, by name");
      return;
  }
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::MaskJoint*) {
  v.optional("joint", d.joint, "its name");
  v.optional("mask", d.mask, "instead of a joint: a mask whose entries stand here, with their weights times this one");
  v.optional("weight", d.weight, "share; later entries win, so 0 takes joints out again");
  v.optional("below", d.below, "also all joints below it");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument::Beat*) {
  v.optional("event", d.event, "the clips' event of this name is the beat; without it the name of the beat");
  v.optional("foot", d.foot, "joint that touches the ground; it gives the beats of clips without such events");
  v.optional("mirror", d.mirror, "beat of the other side, for clips that play mirrored");
}

template <class V, class D>
void describe(V& v, D& d, const GraphDocument*) {
  v.required("root", d.root, "the node that makes the pose");
  v.optional("parameters", d.parameters, "by name");
  v.optional("beats", d.beats, "feet by name: where clips of blend spaces and transitions meet");
  v.optional("masks", d.masks, "lists of joints by name; a name alone counts with all below it");
  v.required("nodes", d.nodes, "by name; each is used once");
  v.optional("variations", d.variations, "for other characters, by name: clips that they play instead, by name");
}

}  // namespace sinew::graph_schema
