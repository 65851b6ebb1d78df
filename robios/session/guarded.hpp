#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "eyebridge/base/result.hpp"
#include "flow.hpp"
#include "session.hpp"

namespace eyebridge::robios {

/// guarded() once the call may go on.
template <class Value, class Body>
Value carry_out(Session& session, const Call& call, Value failure, Body&& body) {
  const InCall in_call;
  try {
    session.charge(call);
    Result<Value> result = body(session);
    if (result) {
      session.succeeded(call.name);
      return *result;
    }
    session.failed(call.name, result.error());
  } catch (const std::exception& error) {
    session.failed(call.name, Error{Errc::Corrupt, error.what()});
  }
  return failure;
}

/// The one place where C++ ends and C begins: nothing is thrown across it.
///
/// Charges the call's cost to the robot's clock, runs `body(session)` and returns its value; on
/// failure returns `failure` (the call's documented failure value), logs the reason (not again and
/// again), and keeps it for EYEBRIDGELastError(). After the run's end nothing is done any more.
template <class Value, class Body>
Value guarded(const Call& call, Value failure, Body&& body) {
  Session& session = Session::instance();  // ends the process itself on a ConfigError
  if (!session.may_call(call.name)) return failure;
  return carry_out(session, call, failure, std::forward<Body>(body));
}

/// For calls that have to write somewhere.
inline tl::unexpected<Error> null_pointer() {
  return fail(Errc::OutOfRange, "a null pointer was given");
}

}  // namespace eyebridge::robios
