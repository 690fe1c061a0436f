// SPDX-License-Identifier: MIT
#pragma once

namespace sinew::fuzz {

/// A sound graph that uses every kind of node, transition and condition.
inline constexpr const char* kGraphSeed =
    R"json({"graph":1,"root":"body","parameters":{"speed":{"kind":"number"},"go":{"kind":"trigger"},"f":{"kind":"flag","initial":1.0},
"half":{"kind":"number","formula":"clamp(speed / 2, -1, 1) + if(f and speed > 0.5, 'go-by', 0)"},"go-by":{"kind":"number","initial":0.25}},
"masks":{"arm":["a",{"joint":"b","weight":0.5,"below":false}],"both":[{"mask":"arm","weight":0.5},"c"]},
"variations":{"hurt":{"A":"D","B":"C"}},
"beats":{"left":{"event":"l","mirror":"right"},"right":{"foot":"a","mirror":"left"}},
"nodes":{"body":{"kind":"layers","base":"m","layers":[{"node":"sel","kind":"overlay","weight":0.5,"weight_by":"speed","mask":"both"},{"node":"ext","kind":"additive"},{"node":"x","kind":"mean"},{"node":"y","kind":"overlay_model"}]},
"sel":{"kind":"select","by":"speed","children":["c1","c2"]},"ext":{"kind":"external","pose":1},
"c1":{"kind":"clip","clip":"A","speed":-2,"offset_s":0.3,"loop":false,"mirror":true},"c2":{"kind":"clip","clip":"B","speed_by":"half"},
"x":{"kind":"clip","clip":"C"},"y":{"kind":"clip","clip":"D"},
"m":{"kind":"machine","initial":"s","fades":3,"states":{"s":{"node":"sp","transitions":[{"to":"t","when":[{"kind":"above","parameter":"speed","value":0.1}],"duration_s":0.3,"kind":"inertialize","interruption":"source_then_target","ordered":true}]},
"t":{"node":"c3","transitions":[{"to":"s","when":[{"kind":"played","value":0.7}],"kind":"dead_blend"},{"to":"u","when":[{"kind":"phase","value":0.3},{"kind":"time_in_state","value":0.2}],"sync":"locked","curve":{"start_slope":1,"end_slope":0.5,"keys":[{"at":0.3,"share":0.6},{"at":0.7,"share":0.8}]},"interruption":"target_then_source"}]},
"u":{"node":"m2","transitions":[{"to":"s","duration_s":0.5,"sync":"start","start_by":"beat","interruption":"source"}]}},"any":[{"to":"t","when":[{"kind":"trigger","parameter":"go"}],"to_self":true}],"entry":[{"to":"u","when":[{"kind":"on","parameter":"f"}]}]},
"m2":{"kind":"machine","initial":"a","states":{"a":{"node":"c4","transitions":[{"to":"b","when":[{"kind":"time_in_state","value":0.05}],"sync":"locked","start_by":"time_left"}]},"b":{"node":"c5","transitions":[{"to":"a"}]}}},
"c3":{"kind":"clip","clip":"A"},"c4":{"kind":"clip","clip":"B"},"c5":{"kind":"clip","clip":"C","loop":false},
"sp":{"kind":"blend_space","x":"speed","y":"f","form":"directional","points":[{"x":0,"y":0,"node":"p1"},{"x":1,"y":0,"node":"p2"},{"x":0,"y":1,"node":"p3"}]},
"p1":{"kind":"clip","clip":"A"},"p2":{"kind":"clip","clip":"B","speed":2},"p3":{"kind":"clip","clip":"D","mirror":true}}}
)json";

/// A graph with two references to another one, of which one has parameters and clips of its own.
inline constexpr const char* kReferenceSeed =
    R"json({"graph":1,"root":"m","parameters":{"speed":{"kind":"number","initial":0.3}},"beats":{"left":{"event":"l"}},
"nodes":{"m":{"kind":"machine","initial":"s","states":{"s":{"node":"legs","transitions":[{"to":"t","when":[{"kind":"time_in_state","value":0.1}]}]},"t":{"node":"other"}}},
"legs":{"kind":"graph","file":"other.json","parameters":{"pace":"speed"},"clips":{"A":"D"}},"other":{"kind":"graph","file":"other.json"}}}
)json";

}  // namespace sinew::fuzz
