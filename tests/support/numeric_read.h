// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/math/conventions.h"
#include "tests/support/numeric_corpus.h"

namespace sinew::test {

/// Reads the numbers of a case into a kernel's types, and writes a kernel's result as doubles. Every input is exactly a
/// float32, so reading rounds nothing.

template <class T>
T scalar(const Json& j) {
  return static_cast<T>(j.get<double>());
}

template <class T>
Vec3<T> vec3(const Json& j) {
  return {scalar<T>(j.at(0)), scalar<T>(j.at(1)), scalar<T>(j.at(2))};
}

template <class T>
Quat<T> quat(const Json& j) {
  return quat_xyzw(scalar<T>(j.at(0)), scalar<T>(j.at(1)), scalar<T>(j.at(2)), scalar<T>(j.at(3)));
}

/// 3x3 from 9 numbers, or the linear part of 16; column-major.
template <class T>
Mat3<T> mat3(const Json& j) {
  const std::size_t stride = j.size() == 16 ? 4 : 3;
  Mat3<T> m;
  for (std::size_t i = 0; i < 9; ++i)
    m[static_cast<int>(i / 3)][static_cast<int>(i % 3)] = scalar<T>(j.at(i / 3 * stride + i % 3));
  return m;
}

template <class T>
AffineT<T> affine(const Json& j) {
  return affine_from(mat3<T>(j), Vec3<T>(scalar<T>(j.at(12)), scalar<T>(j.at(13)), scalar<T>(j.at(14))));
}

inline std::vector<double> numbers(double x) { return {x}; }

template <class T>
std::vector<double> numbers(const Vec3<T>& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

template <class T>
std::vector<double> numbers(const Quat<T>& q) {
  return {double(q.x), double(q.y), double(q.z), double(q.w)};
}

template <class T, int N>
std::vector<double> numbers(const glm::mat<N, N, T, glm::defaultp>& m) {
  std::vector<double> out;
  for (int c = 0; c < N; ++c)
    for (int r = 0; r < N; ++r) out.push_back(double(m[c][r]));
  return out;
}

}  // namespace sinew::test
