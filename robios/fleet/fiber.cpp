#include "fiber.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <utility>

#include <sys/mman.h>
#include <unistd.h>

#include "flow.hpp"

namespace __cxxabiv1 {
struct __cxa_eh_globals {
  void* caught;
  unsigned uncaught;
};
extern "C" __cxa_eh_globals* __cxa_get_globals() noexcept;
}  // namespace __cxxabiv1

#if defined(__x86_64__)
// Boost goes on with a jump, not with a return, and the processor, which keeps return addresses on
// a stack of its own, then mispredicts each return that follows. With one return more they are all
// predicted between fibers that wait in the same function: a third of the time of a round.
asm(R"(
  .pushsection .text
  .p2align 4
  .type eyebridge_jump, @function
eyebridge_jump:
  .cfi_startproc
  leaq 1f(%rip), %rax
  pushq %rax
  .cfi_adjust_cfa_offset 8
  jmp jump_fcontext@PLT
  .cfi_adjust_cfa_offset -8
  nop
1:
  ret
  .cfi_endproc
  .size eyebridge_jump, . - eyebridge_jump
  .popsection
)");
extern "C" boost::context::detail::transfer_t eyebridge_jump(boost::context::detail::fcontext_t to,
                                                             void* data);
#endif

namespace eyebridge::robios {
namespace {

namespace context = boost::context::detail;

#if defined(__x86_64__)
constexpr auto& jump = eyebridge_jump;
#else
constexpr auto& jump = context::jump_fcontext;
#endif

/// Whose flow was left for the present one; notes where it goes on.
Lane& came_from(const context::transfer_t& transfer) {
  Lane& left = *static_cast<Lane*>(transfer.data);
  left.context = transfer.fctx;
  return left;
}

/// Leaves `me` for `next`; returns when somebody comes back.
void change(Lane& me, Lane& next) {
  me.to = &next;
  me.switching.leave(next.switching);
  Lane& left = came_from(jump(next.context, &me));
  me.switching.arrive(left.switching);
}

std::size_t page_size() {
  static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return size;
}

/// How far below its top a stack begins. Caches tell addresses apart by their last 12 bits first:
/// of many stacks that all begin at a page's end the upper kilobyte would not fit the nearest one.
std::size_t next_shift() {
  constexpr unsigned kUsed = 1024;  // bytes of a waiting program, about
  constexpr unsigned kPage = 4096;
  static std::atomic<unsigned> count = 0;
  return count.fetch_add(kUsed, std::memory_order_relaxed) % kPage;
}

}  // namespace

Fiber::Stack::Stack(std::size_t size)
    : size_((size + page_size() - 1) / page_size() * page_size() + kGuardSize) {
  constexpr int kKind = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK;
  base_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, kKind, -1, 0);
  if (base_ == MAP_FAILED) throw std::bad_alloc();
  mprotect(base_, kGuardSize, PROT_NONE);
}

Fiber::Stack::~Stack() {
  forget_stack(bottom(), usable());
  munmap(base_, size_);
}

Fiber::Fiber(std::function<void()> body, std::size_t stack_size)
    : error_(&errno),
      exceptions_(__cxxabiv1::__cxa_get_globals()),
      stack_(stack_size),
      body_(std::move(body)) {
  const std::size_t shift = next_shift();
  context = context::make_fcontext(stack_.top() - shift, stack_.usable() - shift, &Fiber::enter);
  switching.know(stack_.bottom(), stack_.usable());
}
Fiber::~Fiber() = default;

void Fiber::enter(context::transfer_t from) {
  Lane& left = came_from(from);
  auto& me = static_cast<Fiber&>(*left.to);
  me.switching.arrive(left.switching);
  *me.error_ = 0;
  me.begin_anew();
  me.body_();
  std::abort();  // it leaves
}

void Fiber::resume() {
  Lane home;
  home_ = &home;
  change(home, *this);
  begin_anew();
}

/// Whoever goes on has nothing to do with what the last one did.
void Fiber::begin_anew() const {
  flow = {};
  *exceptions_ = {};
}

void Fiber::leave(Lane& next) {
  const int error = *error_;
  const __cxxabiv1::__cxa_eh_globals exceptions = *exceptions_;
  const Flow state = flow;
  change(*this, next);
  *error_ = error;
  *exceptions_ = exceptions;
  flow = state;
}

void Fiber::suspend() { leave(*home_); }

void Fiber::hand_over(Fiber& next) {
  next.home_ = home_;
  leave(next);
}

void Fiber::leave_for_good() {
  to = home_;
  switching.leave_for_good(home_->switching);
  jump(home_->context, this);
  std::abort();  // nobody goes on with it
}

}  // namespace eyebridge::robios
