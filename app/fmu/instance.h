#pragma once

#include <exception>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "app/base/reporter.h"
#include "app/fmu/fmi3.h"
#include "app/fmu/unit.h"

/// @file
/// The instance that an importer holds as fmi3Instance, and the boundary between its C and this
/// C++.

namespace fmu {

inline constexpr const char* kErrors = "logStatusError";      ///< Category of failed calls.
inline constexpr const char* kWarnings = "logStatusWarning";  ///< Category of what to know.

/// Gives messages to the importer's callback. Errors are always given; warnings, and notes on the
/// scene, where its logging is on.
class Messages : public app::Reporter {
 public:
  Messages(fmi3InstanceEnvironment environment, fmi3LogMessageCallback callback, bool on)
      : environment_(environment), callback_(callback), on_(on) {}

  void error(const std::string& message) const { give(fmi3Error, kErrors, message); }
  void note(const std::string& message) override;
  void warning(const std::string& message) override { note(message); }

  /// @param categories   Categories that are switched; none: all.
  /// @throws std::invalid_argument for an unknown category
  void switch_on(bool on, const std::set<std::string>& categories);

 private:
  void give(fmi3Status status, const char* category, const std::string& message) const;

  fmi3InstanceEnvironment environment_;
  fmi3LogMessageCallback callback_;
  bool on_;  ///< Warnings are given.
};

/// An instance and its messages.
struct Instance {
  Messages messages;
  Unit unit;
};

/// Runs a call of an importer. An exception becomes an error with a message that names the function
/// and the reason: none leaves the library.
/// @param call   Receives the instance.
template <class Call>
fmi3Status guarded(const char* function, fmi3Instance instance, Call&& call) {
  if (instance == nullptr) return fmi3Error;
  auto& held = *static_cast<Instance*>(instance);
  try {
    std::forward<Call>(call)(held);
    return fmi3OK;
  } catch (const std::exception& error) {
    held.messages.error(std::string(function) + ": " + error.what());
  } catch (...) {
    held.messages.error(std::string(function) + ": a fault of an unknown kind");
  }
  return fmi3Error;
}

}  // namespace fmu
