#include "render/shared_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(SharedLibrary, AMissingOneIsAnErrorThatNamesThePackage) {
  EXPECT_THAT(error_of([] { SharedLibrary("libnowhere.so.7", "libnowhere7"); }),
              AllOf(HasSubstr("--camera"), HasSubstr("libnowhere.so.7"),
                    HasSubstr("apt-get install libnowhere7")));
}

TEST(SharedLibrary, AFunctionIsFoundOrItsAbsenceIsAnError) {
  const SharedLibrary library("libm.so.6", "libc6");
  EXPECT_EQ(library.get<double (*)(double)>("sqrt")(9.0), 3.0);
  EXPECT_THAT(error_of([&] { (void)library.get<void (*)()>("no_such_function"); }),
              HasSubstr("no_such_function"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
