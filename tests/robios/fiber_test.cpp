#include "fiber.hpp"

#include <cerrno>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "flow.hpp"

namespace eyebridge::robios {
namespace {

/// Fibers that write into one text what they do.
struct Story {
  std::string text;
  std::vector<std::unique_ptr<Fiber>> fibers;

  Fiber& add(std::function<void(Fiber&)> body) {
    const std::size_t mine = fibers.size();
    fibers.push_back(std::make_unique<Fiber>([this, mine, body = std::move(body)] {
      body(*fibers[mine]);
      fibers[mine]->leave_for_good();
    }));
    return *fibers.back();
  }
};

TEST(Fiber, GoesOnWhereItSuspended) {
  Story story;
  Fiber& fiber = story.add([&](Fiber& me) {
    story.text += "a";
    me.suspend();
    story.text += "b";
    me.suspend();
    story.text += "c";
  });
  for (int i = 0; i < 3; ++i) {
    story.text += "-";
    fiber.resume();
  }
  EXPECT_EQ(story.text, "-a-b-c");
}

TEST(Fiber, HandsOverToOthersBeforeTheResumerGoesOn) {
  Story story;
  const auto turn = [&](const char* name) {
    return [&story, name](Fiber& me) {
      for (int round = 0; round < 3; ++round) {
        story.text += name;
        Fiber& next = *story.fibers[&me == story.fibers[0].get() ? 1 : 2];
        if (&me == &next) {
          me.suspend();
        } else {
          me.hand_over(next);
        }
      }
    };
  };
  story.add(turn("a"));
  story.add(turn("b"));
  story.add(turn("c"));
  for (int round = 0; round < 3; ++round) {
    story.text += "-";
    story.fibers[0]->resume();
  }
  EXPECT_EQ(story.text, "-abc-abc-abc");
}

TEST(Fiber, LeavesForTheResumerThatBeganItAll) {
  Story story;
  story.add([&](Fiber& me) {
    story.text += "a";
    me.hand_over(*story.fibers[1]);
    story.text += "A";
  });
  story.add([&](Fiber&) { story.text += "b"; });
  story.fibers[0]->resume();
  story.text += "-";
  story.fibers.pop_back();
  story.fibers[0]->resume();
  EXPECT_EQ(story.text, "ab-A");
}

TEST(Fiber, KeepsItsErrnoAndItsFlow) {
  Story story;
  int other = 0;
  auto* const robot = reinterpret_cast<Session*>(&other);
  story.add([&](Fiber& me) {
    errno = ENOENT;
    flow.session = robot;
    const InCall in_call;
    me.hand_over(*story.fibers[1]);
    EXPECT_EQ(errno, ENOENT);
    EXPECT_EQ(flow.session, robot);
    EXPECT_EQ(flow.calls, 1);
  });
  story.add([&](Fiber& me) {
    // Nothing is left from the one that handed over.
    EXPECT_EQ(errno, 0);
    EXPECT_EQ(flow.session, nullptr);
    EXPECT_EQ(flow.calls, 0);
    errno = EAGAIN;
    me.suspend();
  });
  story.fibers[0]->resume();
  EXPECT_EQ(flow.session, nullptr);
  EXPECT_EQ(flow.calls, 0);
  story.fibers[0]->resume();
  story.fibers[1]->resume();
}

TEST(Fiber, HandlesExceptionsOfItsOwn) {
  Story story;
  const auto handle = [&](const char* what, bool hands_over) {
    return [&story, what, hands_over](Fiber& me) {
      try {
        throw std::runtime_error(what);
      } catch (const std::exception&) {
        if (hands_over) {
          me.hand_over(*story.fibers[1]);
        } else {
          me.suspend();
        }
        try {
          throw;  // the one that is handled here
        } catch (const std::exception& error) {
          story.text += error.what();
        }
      }
      EXPECT_EQ(std::current_exception(), nullptr);
    };
  };
  story.add(handle("first ", true));
  story.add(handle("second ", false));
  story.fibers[0]->resume();
  EXPECT_EQ(std::current_exception(), nullptr);
  story.fibers[0]->resume();
  story.fibers[1]->resume();
  EXPECT_EQ(story.text, "first second ");
}

TEST(Fiber, IsForgottenInTheMiddleOfItsBody) {
  Story story;
  story.add([&](Fiber& me) { me.hand_over(*story.fibers[1]); });
  story.add([&](Fiber& me) {
    story.text += "b";
    me.suspend();
    story.text += "never";
  });
  story.fibers[0]->resume();
  story.fibers.clear();
  EXPECT_EQ(story.text, "b");
}

TEST(Fiber, KeepsWhatLiesDeepOnItsStack) {
  Story story;
  constexpr int kDeep = 2000;
  constexpr std::size_t kFibers = 20;
  const auto dive = [&](const auto& self, Fiber& me, std::size_t mine, int depth) -> int {
    volatile int here = depth;
    if (depth < kDeep) {
      const int below = self(self, me, mine, depth + 1);
      return below + (here == depth ? 1 : 0);
    }
    for (int round = 0; round < 3; ++round) {
      if (mine + 1 < kFibers) {
        me.hand_over(*story.fibers[mine + 1]);
      } else {
        me.suspend();
      }
    }
    return 1;
  };
  int whole = 0;
  for (std::size_t i = 0; i < kFibers; ++i) {
    story.add([&, i](Fiber& me) { whole += dive(dive, me, i, 1) == kDeep ? 1 : 0; });
  }
  for (int round = 0; round < 3; ++round) story.fibers[0]->resume();
  for (const auto& fiber : story.fibers) fiber->resume();
  EXPECT_EQ(whole, static_cast<int>(kFibers));
}

}  // namespace
}  // namespace eyebridge::robios
