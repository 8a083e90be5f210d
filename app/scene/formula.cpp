#include "app/scene/formula.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "app/base/words.h"

namespace scene {
namespace {

using Function = double (*)(double);

double sign_of(double x) { return static_cast<double>((x > 0) - (x < 0)); }

/// A function of one argument. One that jumps makes its formula jump.
struct NamedFunction {
  const char* name;
  Function function;
  bool jumps = false;
};

constexpr std::array<NamedFunction, 20> kFunctions = {{
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"ln", [](double x) { return std::log(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"floor", [](double x) { return std::floor(x); }, true},
    {"ceil", [](double x) { return std::ceil(x); }, true},
    {"round", [](double x) { return std::round(x); }, true},
    {"sign", [](double x) { return sign_of(x); }, true},
    {"step", [](double x) { return x >= 0 ? 1.0 : 0.0; }, true},
    // From 0 at x <= 0 to 1 at x >= 1 with a slope that has no jump.
    {"smooth",
     [](double x) {
       const double s = std::clamp(x, 0.0, 1.0);
       return s * s * (3 - 2 * s);
     }},
}};

constexpr std::array<const char*, 5> kManyArguments = {"atan2", "mod", "clamp", "min", "max"};

/// Longest formula in characters.
constexpr std::size_t kLongestFormula = 1000;

double remainder_of(double x, double y) { return x - y * std::floor(x / y); }

void define_all(mu::Parser& parser) {
  parser.ClearFun();
  parser.ClearConst();
  parser.ClearInfixOprt();
  parser.DefineInfixOprt("-", [](double x) { return -x; });
  parser.DefineInfixOprt("+", [](double x) { return x; });
  for (const NamedFunction& f : kFunctions) parser.DefineFun(f.name, f.function);
  parser.DefineFun("atan2", [](double y, double x) { return std::atan2(y, x); });
  parser.DefineFun("mod", [](double x, double y) { return remainder_of(x, y); });
  parser.DefineFun("clamp",
                   [](double x, double lo, double hi) { return std::min(std::max(x, lo), hi); });
  parser.DefineFun("min", [](const double* x, int n) { return *std::min_element(x, x + n); });
  parser.DefineFun("max", [](const double* x, int n) { return *std::max_element(x, x + n); });
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineConst("e", std::numbers::e);
}

/// The names that a formula may have besides those of its own.
std::vector<std::string> known_names() {
  std::vector<std::string> names = {"pi", "e"};
  for (const NamedFunction& f : kFunctions) names.emplace_back(f.name);
  for (const char* name : kManyArguments) names.emplace_back(name);
  return names;
}

/// A name in a formula and where it begins.
struct Word {
  std::string text;
  std::size_t at = 0;
};

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool in_number(char c) { return std::isdigit(static_cast<unsigned char>(c)) || c == '.'; }

/// Returns the end of the number that begins at `i`, with its exponent.
std::size_t end_of_number(const std::string& text, std::size_t i) {
  while (i < text.size() && in_number(text[i])) ++i;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t k = i + 1;
    if (k < text.size() && (text[k] == '+' || text[k] == '-')) ++k;
    if (k < text.size() && std::isdigit(static_cast<unsigned char>(text[k])))
      for (i = k; i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));) ++i;
  }
  return i;
}

std::vector<Word> words_in(const std::string& text) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < text.size();) {
    if (in_number(text[i])) {
      i = end_of_number(text, i);
    } else if (begins_name(text[i])) {
      const std::size_t begin = i;
      while (i < text.size() && in_name(text[i])) ++i;
      words.push_back({text.substr(begin, i - begin), begin});
    } else {
      ++i;
    }
  }
  return words;
}

[[noreturn]] void refuse(const std::string& what, std::size_t at, const std::string& expected) {
  throw FormulaError(fmt::format("found {} at character {}, expected {}", what, at + 1, expected));
}

/// Refuses characters that formulas do not have, and a = that assigns.
void check_characters(const std::string& text) {
  if (text.size() > kLongestFormula)
    throw FormulaError(fmt::format("found {} characters, expected a formula of at most {}",
                                   text.size(), kLongestFormula));
  const std::string signs = "+-*/^()<>=!&|?:,._ \t\n";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!std::isalnum(static_cast<unsigned char>(c)) && signs.find(c) == std::string::npos)
      refuse(
          static_cast<unsigned char>(c) < 0x80 && c > ' ' ? std::string(1, c) : "a letter or sign",
          i, "a formula");
    if (c != '=') continue;
    const bool ends = i > 0 && std::string("<>=!").find(text[i - 1]) != std::string::npos;
    if (!ends && (i + 1 == text.size() || text[i + 1] != '='))
      refuse("=", i, "== to compare; a formula assigns nothing");
  }
}

std::string expected_names(const std::vector<std::string>& own) {
  std::vector<std::string> names(own.begin(), own.end());
  names.insert(names.end(), {"pi", "e", "a function"});
  return app::enumerate(names, "or");
}

/// @param own   Names that the formula has besides constants and functions.
void check_names(const std::string& text, const std::vector<std::string>& own) {
  std::vector<std::string> known = known_names();
  known.insert(known.begin(), own.begin(), own.end());
  for (const Word& word : words_in(text)) {
    if (std::find(known.begin(), known.end(), word.text) != known.end()) continue;
    const std::string hint = app::did_you_mean(word.text, known);
    throw FormulaError(fmt::format("found the unknown name {} at character {}{}", word.text,
                                   word.at + 1,
                                   hint.empty() ? ", expected " + expected_names(own) : hint));
  }
}

/// The parser with all that formulas may have. @throws FormulaError
void set_expression(mu::Parser& parser, const std::string& text) {
  parser.SetExpr(text);
  int values = 0;
  parser.Eval(values);
  if (values != 1) throw FormulaError("has several values, expected one");
}

bool may_jump(const std::string& text) {
  if (text.find_first_of("<>=!&|?") != std::string::npos) return true;
  for (const Word& word : words_in(text)) {
    if (word.text == "mod") return true;
    for (const NamedFunction& f : kFunctions)
      if (f.jumps && word.text == f.name) return true;
  }
  return false;
}

/// Says in the terms of a formula what the parser has found.
std::string explained(const mu::Parser::exception_type& error, const std::string& text) {
  const std::size_t at = static_cast<std::size_t>(std::max(error.GetPos(), 0));
  const std::string where =
      at >= text.size() ? "at the end" : fmt::format("at character {}", at + 1);
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF:
    case mu::ecEMPTY_EXPRESSION:
      return "ends too early, expected another term";
    case mu::ecMISSING_PARENS:
    case mu::ecUNEXPECTED_PARENS:
      return fmt::format("has a bracket without its partner {}", where);
    case mu::ecTOO_MANY_PARAMS:
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("calls a function with too {} arguments {}",
                         error.GetCode() == mu::ecTOO_MANY_PARAMS ? "many" : "few", where);
    case mu::ecUNEXPECTED_ARG_SEP:
    case mu::ecUNEXPECTED_ARG:
      return fmt::format("has a comma {} that separates no arguments", where);
    default:
      break;
  }
  const std::string token = error.GetToken();
  return fmt::format("cannot be read {}{}, expected a formula", where,
                     token.empty() ? "" : ", where it has " + token.substr(0, 20));
}

}  // namespace

struct Formula::Parser {
  explicit Parser(const std::string& text) : jumps(may_jump(text)) {
    define_all(parser);
    parser.DefineVar("t", &time);
    set_expression(parser, text);
  }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  mu::Parser parser;
  double time = 0;  ///< The variable `t`.
  bool jumps;
};

Formula::Formula(const std::string& text) {
  check_characters(text);
  check_names(text, {"t"});
  try {
    parser_ = std::make_unique<Parser>(text);
  } catch (const mu::Parser::exception_type& error) {
    throw FormulaError(explained(error, text));
  }
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

double Formula::at(double time) const {
  parser_->time = time;
  try {
    return parser_->parser.Eval();
  } catch (const mu::Parser::exception_type&) {
    return std::nan("");
  }
}

bool Formula::jumps() const { return parser_->jumps; }

double evaluated(const std::string& text, const std::map<std::string, double>& constants) {
  // To make a parser takes most of the time, and ${i} of a repeated block is only a name.
  if (const auto named = constants.find(text); named != constants.end()) return named->second;
  check_characters(text);
  std::vector<std::string> own;
  for (const auto& [name, value] : constants) own.push_back(name);
  check_names(text, own);
  try {
    mu::Parser parser;
    define_all(parser);
    for (const auto& [name, value] : constants) parser.DefineConst(name, value);
    set_expression(parser, text);
    return parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw FormulaError(explained(error, text));
  }
}

bool is_formula_name(const std::string& name) {
  const std::vector<std::string> known = known_names();
  return name == "t" || std::find(known.begin(), known.end(), name) != known.end();
}

std::string formula_functions() {
  std::vector<std::string> names = known_names();
  names.erase(names.begin(), names.begin() + 2);
  return app::enumerate(names, "and");
}

}  // namespace scene
