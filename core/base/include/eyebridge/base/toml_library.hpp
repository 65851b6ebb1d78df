#pragma once

// toml++, included here only. With NDEBUG its 3.3 lets clang assume what it asserts, and without
// ends the program; but a file can break an assertion ("[}" does). Neither, so that it goes on to
// the error.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
