#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::localisation {

/// A small matrix of doubles, all zeros at first. Plain loops in a fixed order instead of a
/// library's vector code: the same bits on every CPU.
template <std::size_t R, std::size_t C>
struct Matrix {
  std::array<double, R * C> cells{};  ///< Row by row.

  constexpr double& operator()(std::size_t row, std::size_t column) {
    return cells[row * C + column];
  }
  constexpr double operator()(std::size_t row, std::size_t column) const {
    return cells[row * C + column];
  }
  friend constexpr bool operator==(const Matrix&, const Matrix&) = default;
};

using Matrix2 = Matrix<2, 2>;
using Matrix3 = Matrix<3, 3>;
using Vector3 = Matrix<3, 1>;

template <std::size_t N>
constexpr Matrix<N, N> diagonal(const std::array<double, N>& values) {
  Matrix<N, N> out;
  for (std::size_t i = 0; i < N; ++i) out(i, i) = values[i];
  return out;
}

template <std::size_t R, std::size_t C>
constexpr Matrix<R, C> operator+(const Matrix<R, C>& a, const Matrix<R, C>& b) {
  Matrix<R, C> out;
  for (std::size_t i = 0; i < R * C; ++i) out.cells[i] = a.cells[i] + b.cells[i];
  return out;
}

template <std::size_t R, std::size_t C>
constexpr Matrix<R, C> operator-(const Matrix<R, C>& a, const Matrix<R, C>& b) {
  Matrix<R, C> out;
  for (std::size_t i = 0; i < R * C; ++i) out.cells[i] = a.cells[i] - b.cells[i];
  return out;
}

template <std::size_t R, std::size_t C>
constexpr Matrix<R, C> operator*(double factor, const Matrix<R, C>& a) {
  Matrix<R, C> out;
  for (std::size_t i = 0; i < R * C; ++i) out.cells[i] = factor * a.cells[i];
  return out;
}

template <std::size_t R, std::size_t K, std::size_t C>
constexpr Matrix<R, C> operator*(const Matrix<R, K>& a, const Matrix<K, C>& b) {
  Matrix<R, C> out;
  for (std::size_t row = 0; row < R; ++row) {
    for (std::size_t column = 0; column < C; ++column) {
      for (std::size_t k = 0; k < K; ++k) out(row, column) += a(row, k) * b(k, column);
    }
  }
  return out;
}

template <std::size_t R, std::size_t C>
constexpr Matrix<C, R> transposed(const Matrix<R, C>& a) {
  Matrix<C, R> out;
  for (std::size_t row = 0; row < R; ++row) {
    for (std::size_t column = 0; column < C; ++column) out(column, row) = a(row, column);
  }
  return out;
}

/// The inverse of a symmetric, positive definite matrix, by Cholesky's factors; nothing when it is
/// not positive definite, be it by rounding.
template <std::size_t N>
std::optional<Matrix<N, N>> inverse_of(const Matrix<N, N>& a) {
  Matrix<N, N> lower;
  for (std::size_t row = 0; row < N; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      double rest = a(row, column);
      for (std::size_t k = 0; k < column; ++k) rest -= lower(row, k) * lower(column, k);
      if (row == column) {
        if (!(rest > 0.0) || !std::isfinite(rest)) return std::nullopt;
        lower(row, row) = std::sqrt(rest);
      } else {
        lower(row, column) = rest / lower(column, column);
      }
    }
  }
  Matrix<N, N> inverse_lower;
  for (std::size_t column = 0; column < N; ++column) {
    for (std::size_t row = column; row < N; ++row) {
      double rest = row == column ? 1.0 : 0.0;
      for (std::size_t k = column; k < row; ++k) rest -= lower(row, k) * inverse_lower(k, column);
      inverse_lower(row, column) = rest / lower(row, row);
    }
  }
  return transposed(inverse_lower) * inverse_lower;
}

/// Where something is believed to be, and how surely.
struct PoseEstimate {
  Pose pose;           ///< In the world, metres, radians.
  Matrix3 covariance;  ///< Of x, y and theta: m^2, m rad, rad^2.
};

/// Square of Mahalanobis's distance of the true pose from `estimate`, in its own covariance: the
/// normalised estimation error squared (NEES) of Y. Bar-Shalom, X. R. Li and T. Kirubarajan,
/// "Estimation with Applications to Tracking and Navigation" (2001), section 5.4. Nothing when the
/// covariance is not positive definite.
std::optional<double> normalised_error_squared(const PoseEstimate& estimate, const Pose& truth);

}  // namespace eyebridge::localisation
