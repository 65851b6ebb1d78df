#include "fiber.hpp"

#include <cerrno>
#include <cstdlib>
#include <new>
#include <utility>

#include <sys/mman.h>
#include <unistd.h>

#include "flow.hpp"
#include "session.hpp"

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

std::size_t page_size() {
  static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return size;
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
  context_ = context::make_fcontext(stack_.top(), stack_.usable(), &Fiber::enter);
}
Fiber::~Fiber() = default;

void Fiber::enter(context::transfer_t from) {
  auto& me = *static_cast<Fiber*>(from.data);
  me.switching_.arrived();
  me.resumer_ = from.fctx;
  me.body_();
  me.leave_for_good();
}

void Fiber::resume() {
  switching_.enter(stack_.bottom(), stack_.usable());
  context_ = context::jump_fcontext(context_, this).fctx;
  switching_.returned();
  Session::set_here(nullptr);
  flow = {};
  *exceptions_ = {};
}

void Fiber::suspend() {
  const int error = *error_;
  const __cxxabiv1::__cxa_eh_globals exceptions = *exceptions_;
  Session* const session = Session::here();
  const Flow state = flow;
  switching_.leave();
  resumer_ = context::jump_fcontext(resumer_, nullptr).fctx;
  switching_.arrived();
  *error_ = error;
  *exceptions_ = exceptions;
  Session::set_here(session);
  flow = state;
}

void Fiber::leave_for_good() {
  switching_.leave_for_good();
  context::jump_fcontext(resumer_, nullptr);
  std::abort();  // nobody resumes it
}

}  // namespace eyebridge::robios
