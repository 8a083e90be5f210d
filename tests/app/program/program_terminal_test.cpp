#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program/program.h"

/// Colours of messages on a terminal, which `script` makes, and what the program says of a command
/// line that it does not understand.

namespace {

using support::Outcome;
using support::Workplace;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kEscape = "\x1b";

class ProgramTerminal : public testing::Test {
 protected:
  ProgramTerminal() {
    // A body below the operating envelope, which both commands warn of, and a wrong folder.
    here.write("speck.yaml",
               "plimsoll: 1\nduration: 0.01\nbodies:\n"
               "  - {name: speck, box: {size: [0.002, 0.002, 0.002]}, density: 500}\n");
    here.write("file", "");
  }

  void SetUp() override {
    if (here.shell("command -v script").code != 0) GTEST_SKIP() << "there is no script";
  }

  /// What the program writes to a terminal.
  std::string on_terminal(const std::string& arguments, const std::string& variables = "") const {
    return here
        .shell(variables + " script -qec '\"$PLIMSOLL\" " + arguments + "' /dev/null </dev/null")
        .out;
  }

  Workplace here;
};

TEST_F(ProgramTerminal, HasWarningsInColor) {
  const std::string colored = ": " + kEscape + "[1;33mwarning:" + kEscape + "[0m outside";
  EXPECT_THAT(on_terminal("check speck.yaml"), HasSubstr(colored));
  EXPECT_THAT(on_terminal("run speck.yaml"), HasSubstr(colored));
  const std::string error = kEscape + "[1;31merror:" + kEscape + "[0m ";
  EXPECT_THAT(on_terminal("view speck.yaml --snapshot /none/x.png", "DISPLAY= WAYLAND_DISPLAY="),
              HasSubstr(error));
}

TEST_F(ProgramTerminal, HasNoColorIfItIsAskedForNone) {
  for (const char* variable : {"NO_COLOR=1", "TERM=dumb"})
    EXPECT_THAT(on_terminal("check speck.yaml", variable),
                AllOf(HasSubstr(": warning: outside"), Not(HasSubstr(kEscape))));
  EXPECT_THAT(on_terminal("check speck.yaml", "NO_COLOR="), HasSubstr(kEscape));
}

TEST_F(ProgramTerminal, IsWhereColorsAreAndNoPipe) {
  for (const std::string command : {"check", "run"}) {
    const Outcome outcome = here.run({command, "speck.yaml"});
    EXPECT_THAT(outcome.out + outcome.err,
                AllOf(HasSubstr(": warning: outside"), Not(HasSubstr(kEscape))));
  }
}

TEST_F(ProgramTerminal, ShowsNoEscapesOfNames) {
  here.write("odd.yaml", "plimsoll: 1\nduration: 1\n\"warning: \\e[31m\": 1\n");
  EXPECT_THAT(on_terminal("check odd.yaml"),
              AllOf(HasSubstr("\\x1b[31m"), Not(HasSubstr("\x1b[31m"))));
}

class ProgramUsage : public testing::Test {
 protected:
  std::string fault(const std::vector<std::string>& words) const {
    const Outcome outcome = here.run(words);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  }
  Workplace here;
};

TEST_F(ProgramUsage, NamesTheNearestCommand) {
  EXPECT_THAT(fault({"rnu", "x.yaml"}), AllOf(StartsWith("found rnu, expected a command: run, "),
                                              HasSubstr("; did you mean run?\n")));
  EXPECT_THAT(fault({"x.yaml"}), HasSubstr("; did you mean plimsoll run x.yaml?\n"));
  EXPECT_THAT(fault({"fly"}), Not(HasSubstr("did you mean")));
}

TEST_F(ProgramUsage, NamesTheCommandThatHasAnOption) {
  EXPECT_THAT(fault({"run", "x.yaml", "--heel", "0:60:5"}),
              StartsWith("plimsoll run has no option --heel; it is one of hydrostatics\n"));
  EXPECT_THAT(fault({"check", "x.yaml", "--quiet"}),
              StartsWith("plimsoll check has no option --quiet; it is one of run, "));
}

TEST_F(ProgramUsage, TellsThePlaceOfAnOptionBeforeTheCommand) {
  EXPECT_THAT(fault({"--quiet", "run", "x.yaml"}),
              StartsWith("found --quiet before the command, expected plimsoll run --quiet\n"));
  EXPECT_THAT(fault({"--out=o", "run", "x.yaml"}),
              StartsWith("found --out before the command, expected plimsoll run --out\n"));
}

}  // namespace
