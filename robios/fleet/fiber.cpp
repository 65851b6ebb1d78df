#include "fiber.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

#include <boost/context/detail/fcontext.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include "flow.hpp"
#include "sanitized_switch.hpp"
#include "session.hpp"

// What the C++ runtime keeps of a thread's exceptions: Itanium C++ ABI, section 2.2.2.
namespace __cxxabiv1 {
struct __cxa_eh_globals {
  void* caught;
  unsigned uncaught;
};
extern "C" __cxa_eh_globals* __cxa_get_globals() noexcept;
}  // namespace __cxxabiv1

namespace eyebridge::robios {
namespace {

namespace context = boost::context::detail;

Fiber* running = nullptr;  // One thread runs them all: no thread_local, for speed.

/// What belongs to the fiber that runs, not to the thread.
struct Kept {
  int error = errno;
  __cxxabiv1::__cxa_eh_globals exceptions = *__cxxabiv1::__cxa_get_globals();
  Session* session = Session::here();
  Flow state = flow;

  void restore() const {
    errno = error;
    *__cxxabiv1::__cxa_get_globals() = exceptions;
    Session::set_here(session);
    flow = state;
  }
};

std::size_t page_size() {
  static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return size;
}

/// Memory that takes none until it is touched, above a guard that nothing may touch.
class Stack {
 public:
  explicit Stack(std::size_t size)
      : size_((size + page_size() - 1) / page_size() * page_size() + Fiber::kGuardSize) {
    constexpr int kKind = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK;
    base_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, kKind, -1, 0);
    if (base_ == MAP_FAILED) throw std::bad_alloc();
    mprotect(base_, Fiber::kGuardSize, PROT_NONE);
  }
  ~Stack() { munmap(base_, size_); }
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;

  [[nodiscard]] char* bottom() const { return static_cast<char*>(base_) + Fiber::kGuardSize; }
  [[nodiscard]] char* top() const { return static_cast<char*>(base_) + size_; }
  [[nodiscard]] std::size_t usable() const { return size_ - Fiber::kGuardSize; }

 private:
  std::size_t size_;
  void* base_;
};

}  // namespace

struct Fiber::Impl {
  Impl(std::function<void()> function, std::size_t size)
      : body(std::move(function)),
        stack(size),
        context(context::make_fcontext(stack.top(), stack.usable(), &Impl::enter)) {}

  static void enter(context::transfer_t from) {
    auto& me = *static_cast<Impl*>(from.data);
    me.switching.arrived();
    me.resumer = from.fctx;
    Session::set_here(nullptr);
    flow = {};
    *__cxxabiv1::__cxa_get_globals() = {};
    me.body();
    for (;;) {
      me.switching.leave_for_good();
      context::jump_fcontext(me.resumer, nullptr);
    }
  }

  std::function<void()> body;
  Stack stack;
  context::fcontext_t context;            ///< Where it goes on.
  context::fcontext_t resumer = nullptr;  ///< Where resume() goes on.
  SanitizedSwitch switching;
  bool is_given_up = false;
};

Fiber::Fiber(std::function<void()> body, std::size_t stack_size)
    : impl_(std::make_unique<Impl>(std::move(body), stack_size)) {}
Fiber::~Fiber() = default;

void Fiber::resume() {
  const Kept mine;
  running = this;
  impl_->switching.enter(impl_->stack.bottom(), impl_->stack.usable());
  impl_->context = context::jump_fcontext(impl_->context, impl_.get()).fctx;
  impl_->switching.returned();
  running = nullptr;
  mine.restore();
  if (impl_->is_given_up) delete this;
}

void Fiber::leave_for_good() {
  impl_->is_given_up = true;
  impl_->switching.leave_for_good();
  context::jump_fcontext(impl_->resumer, nullptr);
  std::abort();  // nobody resumes it
}

void Fiber::suspend() {
  Impl& me = *running->impl_;
  const Kept mine;
  me.switching.leave();
  me.resumer = context::jump_fcontext(me.resumer, nullptr).fctx;
  me.switching.arrived();
  mine.restore();
}

}  // namespace eyebridge::robios
