#pragma once

#include <span>
#include <string_view>

#include "eyebridge/robot/error_presets.hpp"

namespace eyebridge::files {

/// A number of an error model, as people write it.
struct ErrorParameter {
  std::string_view name;  ///< "sigma"
  std::string_view unit;  ///< "mm"; may follow the number. Empty: none. "flag": there is no number.
  double low;             ///< In that unit.
  double high;            ///< In that unit.
  double divisor;         ///< What is written by this is what `set` takes: 1000 for mm.
  void (*set)(robot::ErrorModels& models, double value);  ///< Flags get 1.
};

/// What of a robot a rule is about.
struct ErrorKind {
  std::string_view name;  ///< "psd"
  std::size_t part;       ///< Where its numbers are: robot::kErrorPart.
  bool numbered;          ///< A robot may have several: "psd:2" names one.
  std::size_t in_order;   ///< So many of the parameters may be given without their names.
  std::span<const ErrorParameter> parameters;
};

/// All kinds, in the order in which messages name them.
std::span<const ErrorKind> error_kinds();

}  // namespace eyebridge::files
