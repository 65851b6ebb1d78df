#include "exit_handlers.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>

#include "program_image.hpp"

namespace eyebridge::robios {
namespace {

struct Handler {
  ExitHandlers::Kind kind;
  void* function;
  void* argument;
};

struct Table {
  std::mutex mutex;
  std::map<const link_map*, std::vector<Handler>> handlers;
};

Table& table() {
  static auto* const all = new Table;  // programs may end later than static objects
  return *all;
}

std::optional<Handler> take_last(const link_map& image, bool is_quick) {
  const std::lock_guard lock(table().mutex);
  std::vector<Handler>& handlers = table().handlers[&image];
  const auto found = std::find_if(handlers.rbegin(), handlers.rend(), [&](const Handler& handler) {
    return (handler.kind == ExitHandlers::Kind::QuickExit) == is_quick;
  });
  if (found == handlers.rend()) return std::nullopt;
  const Handler last = *found;
  handlers.erase(std::next(found).base());
  return last;
}

}  // namespace

bool ExitHandlers::add(Kind kind, void* function, void* argument, const void* address) {
  const link_map* const image = ProgramImage::around(address);
  if (image == nullptr) return false;
  const std::lock_guard lock(table().mutex);
  table().handlers[image].push_back({kind, function, argument});
  return true;
}

void ExitHandlers::hold() { table().mutex.lock(); }

void ExitHandlers::release() { table().mutex.unlock(); }

void ExitHandlers::run(const link_map& image, bool is_quick, int status) {
  while (const auto handler = take_last(image, is_quick)) {
    if (handler->kind == Kind::ExitWithStatus) {
      reinterpret_cast<void (*)(int, void*)>(handler->function)(status, handler->argument);
    } else {
      reinterpret_cast<void (*)(void*)>(handler->function)(handler->argument);
    }
  }
}

}  // namespace eyebridge::robios
