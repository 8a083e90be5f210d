#include <stdexcept>

#include "app/fmu/fmi3.h"
#include "app/fmu/instance.h"

/// @file
/// The functions of FMI for what modelDescription.xml says a unit does not have. Each returns
/// fmi3Error with a message.

namespace {

fmi3Status absent(const char* function, fmi3Instance instance, const char* reason) {
  return fmu::guarded(function, instance,
                      [&](const fmu::Instance&) { throw std::logic_error(reason); });
}

fmi3Instance no_instance(const char* function, fmi3InstanceEnvironment environment,
                         fmi3LogMessageCallback callback) {
  fmu::Messages(environment, callback, false)
      .error(std::string(function) + ": the unit is one for co-simulation only");
  return nullptr;
}

constexpr const char* kFloat64 = "all variables of the unit are of the type Float64";
constexpr const char* kDependencies = "every output of the unit may depend on all inputs";
constexpr const char* kDerivatives = "the unit has no derivatives";
constexpr const char* kParameters = "the unit has no structural parameters";
constexpr const char* kClocks = "the unit has no clocks";
constexpr const char* kEvents = "the unit has no event mode";
constexpr const char* kCoSimulation = "the unit is one for co-simulation only";

}  // namespace

fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean,
                                          fmi3Boolean, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback callback) {
  return no_instance(__func__, environment, callback);
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean,
                                               fmi3Boolean, fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback callback,
                                               fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback) {
  return no_instance(__func__, environment, callback);
}

#define PLIMSOLL_ABSENT(name, reason, ...)                            \
  fmi3Status name(fmi3Instance instance __VA_OPT__(, ) __VA_ARGS__) { \
    return absent(__func__, instance, reason);                        \
  }

#define PLIMSOLL_ABSENT_TYPE(Type)                                                                \
  PLIMSOLL_ABSENT(fmi3Get##Type, kFloat64, const fmi3ValueReference[], std::size_t, fmi3##Type[], \
                  std::size_t)                                                                    \
  PLIMSOLL_ABSENT(fmi3Set##Type, kFloat64, const fmi3ValueReference[], std::size_t,               \
                  const fmi3##Type[], std::size_t)

PLIMSOLL_ABSENT_TYPE(Float32)
PLIMSOLL_ABSENT_TYPE(Int8)
PLIMSOLL_ABSENT_TYPE(UInt8)
PLIMSOLL_ABSENT_TYPE(Int16)
PLIMSOLL_ABSENT_TYPE(UInt16)
PLIMSOLL_ABSENT_TYPE(Int32)
PLIMSOLL_ABSENT_TYPE(UInt32)
PLIMSOLL_ABSENT_TYPE(Int64)
PLIMSOLL_ABSENT_TYPE(UInt64)
PLIMSOLL_ABSENT_TYPE(Boolean)
PLIMSOLL_ABSENT_TYPE(String)
PLIMSOLL_ABSENT(fmi3GetBinary, kFloat64, const fmi3ValueReference[], std::size_t, std::size_t[],
                fmi3Binary[], std::size_t)
PLIMSOLL_ABSENT(fmi3SetBinary, kFloat64, const fmi3ValueReference[], std::size_t,
                const std::size_t[], const fmi3Binary[], std::size_t)

PLIMSOLL_ABSENT(fmi3GetNumberOfVariableDependencies, kDependencies, fmi3ValueReference,
                std::size_t*)
PLIMSOLL_ABSENT(fmi3GetVariableDependencies, kDependencies, fmi3ValueReference, std::size_t[],
                fmi3ValueReference[], std::size_t[], fmi3DependencyKind[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetDirectionalDerivative, kDerivatives, const fmi3ValueReference[], std::size_t,
                const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t,
                fmi3Float64[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetAdjointDerivative, kDerivatives, const fmi3ValueReference[], std::size_t,
                const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t,
                fmi3Float64[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetOutputDerivatives, kDerivatives, const fmi3ValueReference[], std::size_t,
                const fmi3Int32[], fmi3Float64[], std::size_t)

PLIMSOLL_ABSENT(fmi3EnterConfigurationMode, kParameters)
PLIMSOLL_ABSENT(fmi3ExitConfigurationMode, kParameters)

PLIMSOLL_ABSENT(fmi3GetClock, kClocks, const fmi3ValueReference[], std::size_t, fmi3Clock[])
PLIMSOLL_ABSENT(fmi3SetClock, kClocks, const fmi3ValueReference[], std::size_t, const fmi3Clock[])
PLIMSOLL_ABSENT(fmi3GetIntervalDecimal, kClocks, const fmi3ValueReference[], std::size_t,
                fmi3Float64[], fmi3IntervalQualifier[])
PLIMSOLL_ABSENT(fmi3GetIntervalFraction, kClocks, const fmi3ValueReference[], std::size_t,
                fmi3UInt64[], fmi3UInt64[], fmi3IntervalQualifier[])
PLIMSOLL_ABSENT(fmi3GetShiftDecimal, kClocks, const fmi3ValueReference[], std::size_t,
                fmi3Float64[])
PLIMSOLL_ABSENT(fmi3GetShiftFraction, kClocks, const fmi3ValueReference[], std::size_t,
                fmi3UInt64[], fmi3UInt64[])
PLIMSOLL_ABSENT(fmi3SetIntervalDecimal, kClocks, const fmi3ValueReference[], std::size_t,
                const fmi3Float64[])
PLIMSOLL_ABSENT(fmi3SetIntervalFraction, kClocks, const fmi3ValueReference[], std::size_t,
                const fmi3UInt64[], const fmi3UInt64[])
PLIMSOLL_ABSENT(fmi3SetShiftDecimal, kClocks, const fmi3ValueReference[], std::size_t,
                const fmi3Float64[])
PLIMSOLL_ABSENT(fmi3SetShiftFraction, kClocks, const fmi3ValueReference[], std::size_t,
                const fmi3UInt64[], const fmi3UInt64[])
PLIMSOLL_ABSENT(fmi3ActivateModelPartition, kClocks, fmi3ValueReference, fmi3Float64)

PLIMSOLL_ABSENT(fmi3EnterEventMode, kEvents)
PLIMSOLL_ABSENT(fmi3EnterStepMode, kEvents)
PLIMSOLL_ABSENT(fmi3EvaluateDiscreteStates, kEvents)
PLIMSOLL_ABSENT(fmi3UpdateDiscreteStates, kEvents, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                fmi3Boolean*, fmi3Boolean*, fmi3Float64*)

PLIMSOLL_ABSENT(fmi3EnterContinuousTimeMode, kCoSimulation)
PLIMSOLL_ABSENT(fmi3CompletedIntegratorStep, kCoSimulation, fmi3Boolean, fmi3Boolean*, fmi3Boolean*)
PLIMSOLL_ABSENT(fmi3SetTime, kCoSimulation, fmi3Float64)
PLIMSOLL_ABSENT(fmi3SetContinuousStates, kCoSimulation, const fmi3Float64[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetContinuousStateDerivatives, kCoSimulation, fmi3Float64[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetEventIndicators, kCoSimulation, fmi3Float64[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetContinuousStates, kCoSimulation, fmi3Float64[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetNominalsOfContinuousStates, kCoSimulation, fmi3Float64[], std::size_t)
PLIMSOLL_ABSENT(fmi3GetNumberOfEventIndicators, kCoSimulation, std::size_t*)
PLIMSOLL_ABSENT(fmi3GetNumberOfContinuousStates, kCoSimulation, std::size_t*)
