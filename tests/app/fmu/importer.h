#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/fmu/fmi3.h"

/// @file
/// An importer of units: it knows of a unit what modelDescription.xml says, and calls it by the
/// functions of FMI.

namespace support {

/// The functions of a library that an importer needs.
struct UnitFunctions {
  decltype(&fmi3InstantiateCoSimulation) instantiate;
  decltype(&fmi3FreeInstance) free_instance;
  decltype(&fmi3EnterInitializationMode) enter_initialization;
  decltype(&fmi3ExitInitializationMode) exit_initialization;
  decltype(&fmi3SetFloat64) set;
  decltype(&fmi3GetFloat64) get;
  decltype(&fmi3DoStep) do_step;
  decltype(&fmi3Terminate) terminate;
  decltype(&fmi3Reset) reset;
};

/// The functions that this program is linked with.
UnitFunctions linked_functions();

/// A variable as modelDescription.xml has it.
struct DescribedVariable {
  fmi3ValueReference reference = 0;
  std::string causality, unit;
  std::string start;  ///< Empty: none is given.
};

/// The content of modelDescription.xml.
struct Description {
  std::string token, identifier;
  double step = 0;
  std::map<std::string, DescribedVariable> variables;
};
Description described(const std::string& xml);

/// An instance of a unit. Calls that a test expects to succeed are checked by it.
class Importer {
 public:
  Importer(UnitFunctions functions, Description description, const std::filesystem::path& resources,
           bool logging = false);
  ~Importer();
  Importer(const Importer&) = delete;
  Importer& operator=(const Importer&) = delete;

  fmi3Instance instance() const { return instance_; }
  const Description& description() const { return description_; }
  /// Messages of the unit since the last call.
  std::string said();

  fmi3ValueReference reference(const std::string& name) const {
    return description_.variables.at(name).reference;
  }
  /// Passes the initialization with the start values of all inputs, as some importers do.
  void initialize(bool with_start_values = false);
  void set(const std::string& name, double value);
  double get(const std::string& name) const;
  /// Values of all outputs in the order of their names.
  std::vector<double> outputs() const;
  fmi3Status do_step(double size);
  /// Takes steps of a size. Each is expected to succeed.
  void step(int count, double size);
  void reset();

 private:
  UnitFunctions functions_;
  Description description_;
  std::string said_;
  double time_ = 0;
  fmi3Instance instance_;
};

}  // namespace support
