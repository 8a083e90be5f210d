#pragma once

#include <cstddef>
#include <cstdint>

/// @file
/// The C interface of the Functional Mock-up Interface 3.0 (https://fmi-standard.org): the types
/// and functions that its specification describes, under the names that it gives them. An importer
/// finds the functions by these names in the library of a unit.
///
/// A function returns fmi3OK, or another status whose message the log callback of the instance has
/// received. Arrays are those of the importer; `nValues` counts their numbers.

extern "C" {

using fmi3Float32 = float;
using fmi3Float64 = double;
using fmi3Int8 = std::int8_t;
using fmi3UInt8 = std::uint8_t;
using fmi3Int16 = std::int16_t;
using fmi3UInt16 = std::uint16_t;
using fmi3Int32 = std::int32_t;
using fmi3UInt32 = std::uint32_t;
using fmi3Int64 = std::int64_t;
using fmi3UInt64 = std::uint64_t;
using fmi3Boolean = bool;
using fmi3Clock = bool;
using fmi3String = const char*;  ///< UTF-8, ended by a zero.
using fmi3Byte = std::uint8_t;
using fmi3Binary = const fmi3Byte*;
using fmi3ValueReference = std::uint32_t;  ///< Number of a variable in modelDescription.xml.
using fmi3Instance = void*;                ///< Null where no instance could be made.
using fmi3InstanceEnvironment = void*;     ///< Belongs to the importer, for its callbacks.
using fmi3FMUState = void*;                ///< A copy of all that changes in an instance.

/// How a call has ended, the worst last.
enum fmi3Status {
  fmi3OK,
  fmi3Warning,  ///< Done, with a message.
  fmi3Discard,  ///< Not done; the instance is as before.
  fmi3Error,    ///< Not done; the instance may be reset or freed.
  fmi3Fatal     ///< No instance of the process can go on.
};

enum fmi3DependencyKind {
  fmi3Independent,
  fmi3Constant,
  fmi3Fixed,
  fmi3Tunable,
  fmi3Discrete,
  fmi3Dependent
};

enum fmi3IntervalQualifier { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged };

using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment, fmi3Status, fmi3String category,
                                        fmi3String message);
using fmi3ClockUpdateCallback = void (*)(fmi3InstanceEnvironment);
using fmi3IntermediateUpdateCallback = void (*)(fmi3InstanceEnvironment, fmi3Float64 time,
                                                fmi3Boolean set_requested, fmi3Boolean get_allowed,
                                                fmi3Boolean step_finished,
                                                fmi3Boolean can_return_early,
                                                fmi3Boolean* early_return_requested,
                                                fmi3Float64* early_return_time);
using fmi3LockPreemptionCallback = void (*)();
using fmi3UnlockPreemptionCallback = void (*)();

// An importer sees these functions and nothing else of the library.
#pragma GCC visibility push(default)

// Instances, and the states that they pass through.
fmi3String fmi3GetVersion();
fmi3Status fmi3SetDebugLogging(fmi3Instance, fmi3Boolean on, std::size_t count,
                               const fmi3String categories[]);
fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment, fmi3LogMessageCallback);
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                         fmi3Boolean visible, fmi3Boolean logging,
                                         fmi3Boolean event_mode_used,
                                         fmi3Boolean early_return_allowed,
                                         const fmi3ValueReference intermediate_variables[],
                                         std::size_t intermediate_count, fmi3InstanceEnvironment,
                                         fmi3LogMessageCallback, fmi3IntermediateUpdateCallback);
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token,
                                               fmi3String resources, fmi3Boolean visible,
                                               fmi3Boolean logging, fmi3InstanceEnvironment,
                                               fmi3LogMessageCallback, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback);
void fmi3FreeInstance(fmi3Instance);
fmi3Status fmi3EnterInitializationMode(fmi3Instance, fmi3Boolean tolerance_defined,
                                       fmi3Float64 tolerance, fmi3Float64 start,
                                       fmi3Boolean stop_defined, fmi3Float64 stop);
fmi3Status fmi3ExitInitializationMode(fmi3Instance);
fmi3Status fmi3EnterEventMode(fmi3Instance);
fmi3Status fmi3Terminate(fmi3Instance);
fmi3Status fmi3Reset(fmi3Instance);

// Values, for each type of variable a function to get and one to set them.
#define PLIMSOLL_FMI3_VALUES(Type)                                                                 \
  fmi3Status fmi3Get##Type(fmi3Instance, const fmi3ValueReference references[], std::size_t count, \
                           fmi3##Type values[], std::size_t nValues);                              \
  fmi3Status fmi3Set##Type(fmi3Instance, const fmi3ValueReference references[], std::size_t count, \
                           const fmi3##Type values[], std::size_t nValues);
PLIMSOLL_FMI3_VALUES(Float32)
PLIMSOLL_FMI3_VALUES(Float64)
PLIMSOLL_FMI3_VALUES(Int8)
PLIMSOLL_FMI3_VALUES(UInt8)
PLIMSOLL_FMI3_VALUES(Int16)
PLIMSOLL_FMI3_VALUES(UInt16)
PLIMSOLL_FMI3_VALUES(Int32)
PLIMSOLL_FMI3_VALUES(UInt32)
PLIMSOLL_FMI3_VALUES(Int64)
PLIMSOLL_FMI3_VALUES(UInt64)
PLIMSOLL_FMI3_VALUES(Boolean)
PLIMSOLL_FMI3_VALUES(String)
#undef PLIMSOLL_FMI3_VALUES
fmi3Status fmi3GetBinary(fmi3Instance, const fmi3ValueReference references[], std::size_t count,
                         std::size_t sizes[], fmi3Binary values[], std::size_t nValues);
fmi3Status fmi3SetBinary(fmi3Instance, const fmi3ValueReference references[], std::size_t count,
                         const std::size_t sizes[], const fmi3Binary values[], std::size_t nValues);
fmi3Status fmi3GetClock(fmi3Instance, const fmi3ValueReference references[], std::size_t count,
                        fmi3Clock values[]);
fmi3Status fmi3SetClock(fmi3Instance, const fmi3ValueReference references[], std::size_t count,
                        const fmi3Clock values[]);
fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance, fmi3ValueReference, std::size_t*);
fmi3Status fmi3GetVariableDependencies(fmi3Instance, fmi3ValueReference dependent,
                                       std::size_t dependent_elements[],
                                       fmi3ValueReference independents[],
                                       std::size_t independent_elements[],
                                       fmi3DependencyKind kinds[], std::size_t count);

// Copies of all that changes.
fmi3Status fmi3GetFMUState(fmi3Instance, fmi3FMUState*);
fmi3Status fmi3SetFMUState(fmi3Instance, fmi3FMUState);
fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState*);
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance, fmi3FMUState, std::size_t*);
fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState, fmi3Byte bytes[], std::size_t size);
fmi3Status fmi3DeserializeFMUState(fmi3Instance, const fmi3Byte bytes[], std::size_t size,
                                   fmi3FMUState*);

// Derivatives.
fmi3Status fmi3GetDirectionalDerivative(fmi3Instance, const fmi3ValueReference unknowns[],
                                        std::size_t unknown_count,
                                        const fmi3ValueReference knowns[], std::size_t known_count,
                                        const fmi3Float64 seed[], std::size_t seed_count,
                                        fmi3Float64 sensitivity[], std::size_t sensitivity_count);
fmi3Status fmi3GetAdjointDerivative(fmi3Instance, const fmi3ValueReference unknowns[],
                                    std::size_t unknown_count, const fmi3ValueReference knowns[],
                                    std::size_t known_count, const fmi3Float64 seed[],
                                    std::size_t seed_count, fmi3Float64 sensitivity[],
                                    std::size_t sensitivity_count);

// Structural parameters, clocks and events.
fmi3Status fmi3EnterConfigurationMode(fmi3Instance);
fmi3Status fmi3ExitConfigurationMode(fmi3Instance);
fmi3Status fmi3GetIntervalDecimal(fmi3Instance, const fmi3ValueReference references[],
                                  std::size_t count, fmi3Float64 intervals[],
                                  fmi3IntervalQualifier qualifiers[]);
fmi3Status fmi3GetIntervalFraction(fmi3Instance, const fmi3ValueReference references[],
                                   std::size_t count, fmi3UInt64 counters[],
                                   fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[]);
fmi3Status fmi3GetShiftDecimal(fmi3Instance, const fmi3ValueReference references[],
                               std::size_t count, fmi3Float64 shifts[]);
fmi3Status fmi3GetShiftFraction(fmi3Instance, const fmi3ValueReference references[],
                                std::size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[]);
fmi3Status fmi3SetIntervalDecimal(fmi3Instance, const fmi3ValueReference references[],
                                  std::size_t count, const fmi3Float64 intervals[]);
fmi3Status fmi3SetIntervalFraction(fmi3Instance, const fmi3ValueReference references[],
                                   std::size_t count, const fmi3UInt64 counters[],
                                   const fmi3UInt64 resolutions[]);
fmi3Status fmi3SetShiftDecimal(fmi3Instance, const fmi3ValueReference references[],
                               std::size_t count, const fmi3Float64 shifts[]);
fmi3Status fmi3SetShiftFraction(fmi3Instance, const fmi3ValueReference references[],
                                std::size_t count, const fmi3UInt64 counters[],
                                const fmi3UInt64 resolutions[]);
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance);
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance, fmi3Boolean* need_update, fmi3Boolean* terminate,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* states_changed,
                                    fmi3Boolean* next_event_defined, fmi3Float64* next_event);

// Model exchange.
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance);
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance, fmi3Boolean no_earlier_state,
                                       fmi3Boolean* enter_event_mode, fmi3Boolean* terminate);
fmi3Status fmi3SetTime(fmi3Instance, fmi3Float64 time);
fmi3Status fmi3SetContinuousStates(fmi3Instance, const fmi3Float64 states[], std::size_t count);
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance, fmi3Float64 derivatives[],
                                             std::size_t count);
fmi3Status fmi3GetEventIndicators(fmi3Instance, fmi3Float64 indicators[], std::size_t count);
fmi3Status fmi3GetContinuousStates(fmi3Instance, fmi3Float64 states[], std::size_t count);
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance, fmi3Float64 nominals[],
                                             std::size_t count);
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance, std::size_t*);
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance, std::size_t*);

// Co-simulation.
fmi3Status fmi3EnterStepMode(fmi3Instance);
fmi3Status fmi3GetOutputDerivatives(fmi3Instance, const fmi3ValueReference references[],
                                    std::size_t count, const fmi3Int32 orders[],
                                    fmi3Float64 values[], std::size_t nValues);
fmi3Status fmi3DoStep(fmi3Instance, fmi3Float64 point, fmi3Float64 size,
                      fmi3Boolean no_earlier_state, fmi3Boolean* event_handling_needed,
                      fmi3Boolean* terminate, fmi3Boolean* early_return,
                      fmi3Float64* last_successful_time);

// Scheduled execution.
fmi3Status fmi3ActivateModelPartition(fmi3Instance, fmi3ValueReference clock, fmi3Float64 time);

#pragma GCC visibility pop

}  // extern "C"
