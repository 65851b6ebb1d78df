#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace eyebridge {

/// A small matrix, row by row; all zeros at first. Plain loops in a fixed order instead of a
/// library's vector code: the same bits on every CPU.
template <std::size_t R, std::size_t C>
struct Matrix {
  std::array<double, R * C> values{};

  constexpr double& operator()(std::size_t row, std::size_t column) {
    return values[row * C + column];
  }
  constexpr double operator()(std::size_t row, std::size_t column) const {
    return values[row * C + column];
  }
  friend constexpr bool operator==(const Matrix&, const Matrix&) = default;
};

template <std::size_t N>
using Vector = std::array<double, N>;

template <std::size_t R, std::size_t C>
constexpr Matrix<R, C> operator+(Matrix<R, C> a, const Matrix<R, C>& b) {
  for (std::size_t i = 0; i < R * C; ++i) a.values[i] += b.values[i];
  return a;
}

template <std::size_t R, std::size_t C>
constexpr Matrix<R, C> operator-(Matrix<R, C> a, const Matrix<R, C>& b) {
  for (std::size_t i = 0; i < R * C; ++i) a.values[i] -= b.values[i];
  return a;
}

template <std::size_t R, std::size_t C>
constexpr Matrix<R, C> operator*(double factor, Matrix<R, C> a) {
  for (double& value : a.values) value *= factor;
  return a;
}

template <std::size_t R, std::size_t K, std::size_t C>
constexpr Matrix<R, C> operator*(const Matrix<R, K>& a, const Matrix<K, C>& b) {
  Matrix<R, C> product;
  for (std::size_t row = 0; row < R; ++row) {
    for (std::size_t k = 0; k < K; ++k) {
      for (std::size_t column = 0; column < C; ++column) {
        product(row, column) += a(row, k) * b(k, column);
      }
    }
  }
  return product;
}

template <std::size_t R, std::size_t C>
constexpr Vector<R> operator*(const Matrix<R, C>& a, const Vector<C>& v) {
  Vector<R> product{};
  for (std::size_t row = 0; row < R; ++row) {
    for (std::size_t column = 0; column < C; ++column) product[row] += a(row, column) * v[column];
  }
  return product;
}

template <std::size_t R, std::size_t C>
constexpr Matrix<C, R> transposed(const Matrix<R, C>& a) {
  Matrix<C, R> out;
  for (std::size_t row = 0; row < R; ++row) {
    for (std::size_t column = 0; column < C; ++column) out(column, row) = a(row, column);
  }
  return out;
}

template <std::size_t N>
constexpr Matrix<N, N> diagonal(const Vector<N>& values) {
  Matrix<N, N> out;
  for (std::size_t i = 0; i < N; ++i) out(i, i) = values[i];
  return out;
}

/// The inverse of a symmetric, positive definite matrix, by Cholesky's factors; nothing when it is
/// not one, be it by rounding, or so nearly singular that of a value on the diagonal no more than
/// the share `least` >= 0 is left.
template <std::size_t N>
std::optional<Matrix<N, N>> inverse_of(const Matrix<N, N>& a, double least = 0.0) {
  Matrix<N, N> lower;
  for (std::size_t row = 0; row < N; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      double rest = a(row, column);
      for (std::size_t k = 0; k < column; ++k) rest -= lower(row, k) * lower(column, k);
      if (row != column) {
        lower(row, column) = rest / lower(column, column);
      } else if (rest > least * a(row, row) && rest > 0.0 && std::isfinite(rest)) {
        lower(row, row) = std::sqrt(rest);
      } else {
        return std::nullopt;
      }
    }
  }
  Matrix<N, N> result;
  for (std::size_t column = 0; column < N; ++column) {
    Vector<N> x{};
    x[column] = 1.0;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] -= lower(i, k) * x[k];
      x[i] /= lower(i, i);
    }
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t k = i + 1; k < N; ++k) x[i] -= lower(k, i) * x[k];
      x[i] /= lower(i, i);
    }
    for (std::size_t i = 0; i < N; ++i) result(i, column) = x[i];
  }
  return result;
}

}  // namespace eyebridge
