#include "app/assembly/resistance_file.h"

#include "tests/app/assembly/file_reader_test.h"
#include "tests/support/tolerance.h"

namespace {

using support::tolerance;
using ResistanceFile = support::FileReaderTest<assembly::read_resistance>;

TEST_F(ResistanceFile, ColumnsMayBeInAnyOrderAndStartAtRest) {
  const hydro::ResistanceCurve curve = read("force;speed\n0;0\n\n3;1  # at one\n12;2\n");
  EXPECT_EQ(curve.speeds(), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(curve.forces(), (std::vector<double>{0, 3, 12}));
  EXPECT_NEAR(curve.at(1.5), 6.75, tolerance(1e-12));
  EXPECT_EQ(read("speed,force\n1,3\n2,12\n").speeds(), curve.speeds());
}

TEST_F(ResistanceFile, AFaultHasItsPlace) {
  const std::string usage = "expected the columns speed [m/s] and force [N]";
  EXPECT_EQ(fault(""), ": the file is empty, " + usage);
  EXPECT_EQ(fault("speed\n1\n"), ": " + usage);
  EXPECT_EQ(fault("speed,power\n"), ":1:12: found 'power' in the header, " + usage);
  const std::string head = "speed,force\n";
  EXPECT_EQ(fault(head), ": found no row with a speed above 0");
  EXPECT_EQ(fault(head + "0,0\n"), ": found no row with a speed above 0");
  EXPECT_EQ(fault(head + "0,1\n2,3\n"), ":2:1: found the force 1 at rest, expected 0");
  EXPECT_EQ(fault(head + "-1,0\n"), ":2:1: found the speed -1, expected one >= 0");
  EXPECT_EQ(fault(head + "1,2\n\n1,3\n"),
            ":4:1: found the speed 1 after 1, expected ascending ones");
  EXPECT_EQ(fault(head + "1,2\n2,-3\n"),
            ":3:1: found the force -3, expected one >= 0 against the motion");
  EXPECT_EQ(fault(head + "1,inf\n"), ":2:3: found 'inf', expected a finite number");
}

}  // namespace
