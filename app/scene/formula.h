#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

/// @file
/// Formulas in the time t, as scenes have them.

namespace scene {

/// Says what is wrong with a formula, and at which character: `found sinn at character 4, …`.
class FormulaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A formula in the time `t` [s], with the constants `pi` and `e`, the operators + - * / ^, the
/// comparisons and logic < <= > >= == != && ||, the choice `a ? b : c`, and the functions of
/// `formula_functions()`. Angles of the functions are in radians. It calls nothing else, and has
/// no texts, assignments and names of its own.
class Formula {
 public:
  /// @throws FormulaError if the text is no formula
  explicit Formula(const std::string& text);
  ~Formula();
  Formula(Formula&&) noexcept;
  Formula& operator=(Formula&&) noexcept;

  /// Returns its value, which need not be finite. It is called from one thread at a time.
  double at(double time) const;
  /// True if the value may jump: the formula compares, chooses or rounds.
  bool jumps() const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// Returns the value of a formula without the time, with further constants.
/// @throws FormulaError
double evaluated(const std::string& text, const std::map<std::string, double>& constants);

/// True for names that have a meaning in formulas: `t`, the constants and the functions.
bool is_formula_name(const std::string& name);

/// Returns the functions of formulas as a text: `sin, cos, …`.
std::string formula_functions();

}  // namespace scene
