#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/fmu/fmi3.h"
#include "app/fmu/instance.h"

/// @file
/// The functions of FMI that a unit has: instances, their values, steps and states.

namespace fmu {
namespace {

/// A copy of all that changes in an instance.
struct State {
  std::string bytes;
};

void expect_count(std::size_t values, std::size_t variables) {
  if (values != variables)
    throw std::invalid_argument("found an array of " + std::to_string(values) +
                                " values, expected one for each of " + std::to_string(variables) +
                                " variables");
}

template <class T>
T& expect_there(T* pointer) {
  if (pointer == nullptr) throw std::invalid_argument("found a null pointer");
  return *pointer;
}

const State& state_of(fmi3FMUState state) { return expect_there(static_cast<State*>(state)); }

Instance* made(const char* token, const char* resources, Messages messages) {
  if (token == nullptr || resources == nullptr)
    throw std::invalid_argument("found no token or no path of the resources");
  const std::string expected = token_of(resources);
  if (token != expected)
    throw std::invalid_argument("found the instantiation token '" + std::string(token) +
                                "', expected that of modelDescription.xml, '" + expected + "'");
  return new Instance{messages, Unit(load_scene(resources, messages))};
}

}  // namespace
}  // namespace fmu

using fmu::guarded;
using fmu::Instance;

fmi3String fmi3GetVersion() { return "3.0"; }

fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources,
                                         fmi3Boolean, fmi3Boolean logging,
                                         fmi3Boolean event_mode_used, fmi3Boolean,
                                         const fmi3ValueReference[], std::size_t intermediate_count,
                                         fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback callback,
                                         fmi3IntermediateUpdateCallback) {
  const fmu::Messages messages(environment, callback, logging);
  const std::string name = "fmi3InstantiateCoSimulation: ";
  try {
    if (event_mode_used) throw std::invalid_argument("the unit has no event mode");
    if (intermediate_count > 0) throw std::invalid_argument("the unit has no intermediate values");
    return fmu::made(token, resources, messages);
  } catch (const std::exception& error) {
    messages.error(name + error.what());
  } catch (...) {
    messages.error(name + "a fault of an unknown kind");
  }
  return nullptr;
}

void fmi3FreeInstance(fmi3Instance instance) { delete static_cast<Instance*>(instance); }

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, std::size_t count,
                               const fmi3String categories[]) {
  return guarded(__func__, instance, [&](Instance& held) {
    held.messages.switch_on(on, {categories, categories + count});
  });
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64,
                                       fmi3Float64 start, fmi3Boolean, fmi3Float64) {
  return guarded(__func__, instance,
                 [&](Instance& held) { held.unit.enter_initialization(start); });
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  return guarded(__func__, instance, [](Instance& held) { held.unit.exit_initialization(); });
}

fmi3Status fmi3Terminate(fmi3Instance instance) {
  return guarded(__func__, instance, [](Instance& held) { held.unit.terminate(); });
}

fmi3Status fmi3Reset(fmi3Instance instance) {
  return guarded(__func__, instance, [](Instance& held) { held.unit.reset(); });
}

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
                          std::size_t count, fmi3Float64 values[], std::size_t nValues) {
  return guarded(__func__, instance, [&](const Instance& held) {
    fmu::expect_count(nValues, count);
    std::transform(references, references + count, values,
                   [&](fmi3ValueReference variable) { return held.unit.get(variable); });
  });
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
                          std::size_t count, const fmi3Float64 values[], std::size_t nValues) {
  return guarded(__func__, instance, [&](Instance& held) {
    fmu::expect_count(nValues, count);
    for (std::size_t i = 0; i < count; ++i) held.unit.set(references[i], values[i]);
  });
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 point, fmi3Float64 size, fmi3Boolean,
                      fmi3Boolean* event_handling_needed, fmi3Boolean* terminate,
                      fmi3Boolean* early_return, fmi3Float64* last_successful_time) {
  return guarded(__func__, instance, [&](Instance& held) {
    for (fmi3Boolean* flag : {event_handling_needed, terminate, early_return})
      fmu::expect_there(flag) = false;
    fmu::expect_there(last_successful_time) = held.unit.time();
    held.unit.do_step(point, size);
    *last_successful_time = held.unit.time();
  });
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return guarded(__func__, instance, [&](const Instance& held) {
    std::string bytes = held.unit.save();
    if (fmu::expect_there(state) == nullptr) *state = new fmu::State;
    static_cast<fmu::State*>(*state)->bytes = std::move(bytes);
  });
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
  return guarded(__func__, instance,
                 [&](Instance& held) { held.unit.restore(fmu::state_of(state).bytes); });
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return guarded(__func__, instance, [&](const Instance&) {
    if (state == nullptr) return;
    delete static_cast<fmu::State*>(*state);
    *state = nullptr;
  });
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state,
                                      std::size_t* size) {
  return guarded(__func__, instance, [&](const Instance&) {
    fmu::expect_there(size) = fmu::state_of(state).bytes.size();
  });
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[],
                                 std::size_t size) {
  return guarded(__func__, instance, [&](const Instance&) {
    const std::string& saved = fmu::state_of(state).bytes;
    if (size != saved.size())
      throw std::invalid_argument("found an array of " + std::to_string(size) +
                                  " bytes, expected " + std::to_string(saved.size()));
    std::memcpy(bytes, saved.data(), size);
  });
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], std::size_t size,
                                   fmi3FMUState* state) {
  return guarded(__func__, instance, [&](const Instance&) {
    std::string saved(reinterpret_cast<const char*>(bytes), size);
    if (fmu::expect_there(state) == nullptr) *state = new fmu::State;
    static_cast<fmu::State*>(*state)->bytes = std::move(saved);
  });
}
