#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace eyebridge::camera {

/// A matrix of fixed size, row by row; starts as zeros.
template <std::size_t R, std::size_t C>
struct Matrix {
  std::array<double, R * C> values{};

  double& operator()(std::size_t row, std::size_t column) { return values[row * C + column]; }
  double operator()(std::size_t row, std::size_t column) const { return values[row * C + column]; }
};

template <std::size_t N>
using Vector = std::array<double, N>;

template <std::size_t R, std::size_t C>
Matrix<R, C> operator+(Matrix<R, C> a, const Matrix<R, C>& b) {
  for (std::size_t i = 0; i < R * C; ++i) a.values[i] += b.values[i];
  return a;
}

template <std::size_t R, std::size_t C>
Matrix<R, C> operator*(double k, Matrix<R, C> a) {
  for (double& value : a.values) value *= k;
  return a;
}

template <std::size_t R, std::size_t K, std::size_t C>
Matrix<R, C> operator*(const Matrix<R, K>& a, const Matrix<K, C>& b) {
  Matrix<R, C> product;
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t k = 0; k < K; ++k) {
      for (std::size_t j = 0; j < C; ++j) product(i, j) += a(i, k) * b(k, j);
    }
  }
  return product;
}

template <std::size_t R, std::size_t C>
Vector<R> operator*(const Matrix<R, C>& a, const Vector<C>& v) {
  Vector<R> product{};
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t j = 0; j < C; ++j) product[i] += a(i, j) * v[j];
  }
  return product;
}

template <std::size_t R, std::size_t C>
Matrix<C, R> transposed(const Matrix<R, C>& a) {
  Matrix<C, R> t;
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t j = 0; j < C; ++j) t(j, i) = a(i, j);
  }
  return t;
}

template <std::size_t N>
Matrix<N, N> diagonal(const Vector<N>& values) {
  Matrix<N, N> d;
  for (std::size_t i = 0; i < N; ++i) d(i, i) = values[i];
  return d;
}

/// Inverse of a symmetric positive definite matrix, by Cholesky's decomposition; none when it is
/// not one, or nearly singular.
template <std::size_t N>
std::optional<Matrix<N, N>> inverse(const Matrix<N, N>& a) {
  Matrix<N, N> lower;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= lower(i, k) * lower(j, k);
      if (i != j) {
        lower(i, j) = sum / lower(j, j);
      } else if (sum > 1e-14 * a(i, i)) {
        lower(i, i) = std::sqrt(sum);
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

}  // namespace eyebridge::camera
