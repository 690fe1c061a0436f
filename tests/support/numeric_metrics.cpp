// SPDX-License-Identifier: MIT
#include "tests/support/numeric_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/math/affine.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/transform.h"

namespace sinew::test {
namespace {

using Numbers = std::vector<double>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double ratio(double error, double allowed) {
  if (!std::isfinite(error)) return kInfinity;
  if (error == 0) return 0;
  return allowed > 0 ? error / allowed : kInfinity;
}

Numbers numbers_of(const Json& j) { return j.is_number() ? Numbers{j.get<double>()} : j.get<Numbers>(); }
Quat<double> quat_of(const Numbers& v) { return quat_xyzw(v.at(0), v.at(1), v.at(2), v.at(3)); }
Vec3<double> vec_of(const Numbers& v) { return {v.at(0), v.at(1), v.at(2)}; }
double gap(const Numbers& a, const Numbers& b) { return safe_length(vec_of(a) - vec_of(b)); }

const Numbers& need(const Outcome& got, const std::string& key) {
  static const Numbers missing(16, std::numeric_limits<double>::quiet_NaN());
  const auto found = got.find(key);
  return found == got.end() ? missing : found->second;
}

/// max, but NaN counts as infinite.
double worst(std::initializer_list<double> misses) {
  double out = 0;
  for (const double m : misses) out = m <= out ? out : (std::isnan(m) ? kInfinity : m);
  return out;
}

double turn(const Numbers& a, const Numbers& b) { return rotation_angle_between(quat_of(a), quat_of(b)); }
double unit_miss(const Numbers& q, double tolerance) {
  return ratio(std::abs(q.size() == 4 ? safe_length(quat_of(q)) - 1 : safe_length(vec_of(q)) - 1), tolerance);
}

/// The tolerance of element i. `tolerance` is one number for all elements or a list.
double allowed(const Json& tolerance, std::size_t i) {
  return tolerance.is_number() ? tolerance.get<double>() : tolerance.at(i).get<double>();
}

double elements(const Numbers& got, const Numbers& truth, const Json& tolerance) {
  if (got.size() < truth.size()) return kInfinity;
  double out = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    out = worst({out, ratio(std::abs(got[i] - truth[i]), allowed(tolerance, i))});
  return out;
}

/// |got - truth| relative to |truth|. A truth shorter than 1000 floors must only be met within 4 floors.
double relative(const Vec3<double>& got, const Vec3<double>& truth, double tolerance, double floor) {
  const double length = safe_length(truth), error = safe_length(got - truth);
  return length < 1000 * floor ? ratio(error, 4 * floor) : ratio(error, tolerance * length);
}

double rotation_angle(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const Numbers& q = need(got, "q");
  double angle = turn(q, numbers_of(out["q"]));
  if (out.contains("alt"))
    for (const Json& alt : out["alt"]) angle = std::min(angle, turn(q, numbers_of(alt)));
  return worst({ratio(angle, accept["tol"]), unit_miss(q, accept["norm_tol"])});
}

double quat_components(const Json& entry, const Outcome& got) {
  const Json& accept = entry["accept"];
  const Numbers truth = numbers_of(entry["out"]["q"]), &q = need(got, "q");
  const double all = elements(q, truth, accept["tol"]);
  if (!accept.contains("vec_rel_tol") || !accept["vec_rel_tol"].is_number()) return all;
  return worst({all, relative(vec_of(q), vec_of(truth), accept["vec_rel_tol"], accept.value("floor", 0.0))});
}

double vec_relative(const Json& entry, const Outcome& got) {
  const Json& accept = entry["accept"];
  return relative(vec_of(need(got, "v")), vec_of(numbers_of(entry["out"]["v"])), accept["tol"],
                  accept.value("floor", 0.0));
}

double vec_any_direction(const Json& entry, const Outcome& got) {
  const double length = entry["out"]["length"].get<double>();
  return ratio(std::abs(safe_length(vec_of(need(got, "v"))) - length), entry["accept"]["tol"]);
}

double each_number(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const std::string key = accept["key"];
  const double main = elements(need(got, key), numbers_of(out[key]), accept["tol"]);
  if (!accept.contains("n_tol")) return main;
  return worst({main, elements(need(got, "n_linear"), numbers_of(out["n_linear"]), accept["n_tol"])});
}

double columns(const Json& entry, const Outcome& got) {
  const Json& tolerance = entry["accept"]["tol"];
  const Numbers truth = numbers_of(entry["out"]["m"]), &m = need(got, "m");
  double out = 0;
  for (std::size_t i = 0; i < 16; ++i)
    out = worst({out, ratio(std::abs(m.at(i) - truth[i]), allowed(tolerance, i / 4))});
  return out;
}

double relative_elements(const Json& entry, const Outcome& got) {
  const Json& accept = entry["accept"];
  const std::string key = accept["key"];
  const Numbers truth = numbers_of(entry["out"][key]), &m = need(got, key);
  double out = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double limit =
        truth[i] == 0 ? 0
                      : std::max(accept["rel_tol"].get<double>() * std::abs(truth[i]), accept["floor"].get<double>());
    out = worst({out, ratio(std::abs(m.at(i) - truth[i]), limit)});
  }
  return out;
}

double squad(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const double limit = accept["control_tol"];
  return worst({rotation_angle(entry, got), ratio(turn(need(got, "a0"), numbers_of(out["a0"])), limit),
                ratio(turn(need(got, "a1"), numbers_of(out["a1"])), limit)});
}

double euler_compose(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  return worst({elements(need(got, "m"), numbers_of(out["m"]), accept["tol"]),
                ratio(turn(need(got, "q"), numbers_of(out["q"])), accept["quat_tol"])});
}

double euler_rebuild(const Json& entry, const Outcome& got) {
  const double h = need(got, "h").at(0), p = need(got, "p").at(0), r = need(got, "r").at(0);
  const double ch = std::cos(h), sh = std::sin(h), cp = std::cos(p), sp = std::sin(p), cr = std::cos(r),
               sr = std::sin(r);
  const Mat3<double> roll(cr, sr, 0, -sr, cr, 0, 0, 0, 1), pitch(1, 0, 0, 0, cp, sp, 0, -sp, cp),
      head(ch, 0, -sh, 0, 1, 0, sh, 0, ch);
  const Mat3<double> e = roll * pitch * head;
  Numbers rebuilt;
  for (int i = 0; i < 9; ++i) rebuilt.push_back(e[i / 3][i % 3]);
  return elements(rebuilt, numbers_of(entry["in"]["m"]), entry["accept"]["tol"]);
}

double axis_angle(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const Numbers& axis = need(got, "axis");
  const double truth = out["angle"], error = std::abs(need(got, "angle").at(0) - truth),
               floor = accept.value("floor", 0.0);
  const double angle = ratio(error, std::max(accept["angle_rel_tol"].get<double>() * truth, 4 * floor));
  const double limit = accept["axis_tol"];
  if (out["axis"].is_null()) return worst({angle, unit_miss(axis, limit)});
  const Numbers ref = numbers_of(out["axis"]);
  double miss = gap(axis, ref);
  if (accept.value("either_sign", false)) miss = std::min(miss, safe_length(vec_of(axis) + vec_of(ref)));
  return worst({angle, ratio(miss, limit)});
}

double rotates_s_to_t(const Json& entry, const Outcome& got) {
  const Json& accept = entry["accept"];
  const Numbers& q = need(got, "q");
  const Vec3<double> none(0.0);
  const auto s = normalised_or(vec_of(numbers_of(entry["in"]["s"])), none),
             t = normalised_or(vec_of(numbers_of(entry["in"]["t"])), none);
  const Vec3<double> moved = matrix_from_quat(quat_of(q)) * s;
  const double main = worst({unit_miss(q, accept["norm_tol"]), ratio(safe_length(moved - t), accept["tol"])});
  if (!accept["rotation_tol"].is_number()) return main;
  return worst({main, ratio(turn(q, numbers_of(entry["out"]["q"])), accept["rotation_tol"])});
}

double polar(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const Numbers m = numbers_of(entry["in"]["m"]), &r = need(got, "rotation"), &s = need(got, "stretch");
  Mat3<double> rotation, linear;
  for (int i = 0; i < 9; ++i) {
    rotation[i / 3][i % 3] = r.at(i);
    linear[i / 3][i % 3] = m[i / 3 * 4 + i % 3];
  }
  const Mat3<double> stretch(s.at(0), s.at(3), s.at(4), s.at(3), s.at(1), s.at(5), s.at(4), s.at(5), s.at(2));
  const Mat3<double> square = glm::transpose(rotation) * rotation - Mat3<double>(1.0),
                     rest = rotation * stretch - linear;
  double miss = glm::determinant(rotation) > 0 ? 0 : kInfinity;
  for (int i = 0; i < 9; ++i)
    miss = worst({miss, ratio(std::abs(square[i / 3][i % 3]), accept["orthogonal_tol"]),
                  ratio(std::abs(rest[i / 3][i % 3]), accept["rebuild_tol"])});
  miss = worst({miss, elements(need(got, "t"), numbers_of(out["t"]), 0.0)});
  if (accept["rotation_tol"].is_number())
    miss = worst({miss, ratio(turn(need(got, "q"), numbers_of(out["q"])), accept["rotation_tol"])});
  if (accept["stretch_tol"].is_number())
    miss = worst({miss, elements(s, numbers_of(out["stretch"]), accept["stretch_tol"])});
  return miss;
}

double trs(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const Numbers m = numbers_of(entry["in"]["m"]), &q = need(got, "q"), &s = need(got, "s"),
                truth = numbers_of(out["s"]);
  const Mat3<double> rotation = matrix_from_quat(quat_of(q));
  double miss = worst({unit_miss(q, accept["norm_tol"]), elements(need(got, "t"), numbers_of(out["t"]), 0.0)});
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t r = 0; r < 3; ++r) {
      const double entry_miss = std::abs(rotation[static_cast<int>(c)][static_cast<int>(r)] * s.at(c) - m[c * 4 + r]);
      miss = worst({miss, ratio(entry_miss, allowed(accept["rebuild_tol"], c))});
    }
    miss =
        worst({miss, ratio(std::abs(s.at(c) - truth[c]), accept["scale_rel_tol"].get<double>() * std::abs(truth[c]))});
  }
  if (accept["rotation_tol"].is_number())
    miss = worst({miss, ratio(turn(q, numbers_of(out["q"])), accept["rotation_tol"])});
  return miss;
}

double vector_turn(const Numbers& a, const Numbers& b) {
  const auto u = normalised_or(vec_of(a), Vec3<double>(0)), v = normalised_or(vec_of(b), Vec3<double>(0));
  return 2 * std::atan2(safe_length(u - v), safe_length(u + v));
}

double normal(const Json& entry, const Outcome& got) {
  const double limit = entry["accept"]["tol"], unit = 4e-7;
  double miss = 0;
  for (const char* key : {"n", "n_outward"})
    if (got.contains(key) && entry["out"][key].is_array())
      miss = worst({miss, unit_miss(need(got, key), unit),
                    ratio(vector_turn(need(got, key), numbers_of(entry["out"][key])), limit)});
  return got.contains("n") ? miss : kInfinity;
}

double finite(const Json& entry, const Outcome& got) {
  double miss = 0;
  for (const double v : need(got, entry["accept"]["key"])) miss = worst({miss, ratio(v - v, 1)});
  return miss;
}

double skin(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const auto against = [&](const Json& truth) {
    double miss = worst({ratio(gap(need(got, "p"), numbers_of(truth["p"])), accept["tol"]),
                         ratio(turn(need(got, "q"), numbers_of(truth["q"])), accept["rotation_tol"])});
    if (truth.contains("n"))
      miss = worst({miss, ratio(vector_turn(need(got, "n"), numbers_of(truth["n"])), accept["n_tol"])});
    return miss;
  };
  double best = against(out);
  if (out.contains("alt"))
    for (const Json& alt : out["alt"]) best = std::min(best, against(alt));
  return best;
}

double candy(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  double miss = 0;
  for (const std::string key : {"lbs_p", "dqs_p", "cor_p"}) {
    const Numbers& p = need(got, key);
    double error = gap(p, numbers_of(out[key]));
    // At a half turn both directions are right. Dual quaternions and centers of rotation use the same rotation.
    if (out.contains("alt") && key != "lbs_p")
      error = std::min(error, gap(p, numbers_of(out["alt"].value(key, out["alt"]["dqs_p"]))));
    miss = worst({miss, ratio(error, accept["tol"])});
    if (key == "lbs_p") continue;
    const double radius = std::hypot(p.at(1), p.at(2)), truth = out[key == "dqs_p" ? "dqs_radius" : "cor_radius"];
    miss = worst({miss, ratio(std::abs(radius - truth), accept["radius_rel_tol"].get<double>() * truth)});
  }
  return miss;
}

double depth(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const double main = ratio(std::abs(need(got, "depth").at(0) - out["depth"].get<double>()), accept["depth_tol"]);
  if (!accept.contains("distance_rel_tol") || !accept["distance_rel_tol"].is_number()) return main;
  const double truth = out["distance_from_stored"];
  return worst(
      {main, ratio(std::abs(need(got, "distance").at(0) - truth), accept["distance_rel_tol"].get<double>() * truth)});
}

double unit_vector(const Json& entry, const Outcome& got) {
  const Json& accept = entry["accept"];
  return unit_miss(need(got, accept["key"]), accept["norm_tol"]);
}

double vector_angle(const Json& entry, const Outcome& got) {
  const Json &out = entry["out"], &accept = entry["accept"];
  const std::string key = accept["key"];
  double miss =
      worst({unit_vector(entry, got), ratio(vector_turn(need(got, key), numbers_of(out[key])), accept["tol"])});
  for (const char* q : {"q0", "q1"})
    if (accept.contains("q_tol") && got.contains(q))
      miss = worst({miss, elements(need(got, q), numbers_of(out[q]), accept["q_tol"])});
  return miss;
}

}  // namespace

double numeric_miss(const Json& entry, const Outcome& got) {
  static const std::map<std::string, double (*)(const Json&, const Outcome&)> metrics = {
      {"rotation_angle", rotation_angle},
      {"quat_components", quat_components},
      {"vec_relative", vec_relative},
      {"vec_any_direction", vec_any_direction},
      {"max_abs", each_number},
      {"components", each_number},
      {"elements", each_number},
      {"columns", columns},
      {"relative_elements", relative_elements},
      {"squad", squad},
      {"euler_compose", euler_compose},
      {"euler_rebuild", euler_rebuild},
      {"axis_angle", axis_angle},
      {"rotates_s_to_t", rotates_s_to_t},
      {"polar", polar},
      {"trs", trs},
      {"normal", normal},
      {"finite", finite},
      {"skin", skin},
      {"candy", candy},
      {"depth", depth},
      {"unit_vector", unit_vector},
      {"vector_angle", vector_angle}};
  const auto found = metrics.find(entry["accept"]["metric"].get<std::string>());
  return found == metrics.end() ? kInfinity : found->second(entry, got);
}

}  // namespace sinew::test
