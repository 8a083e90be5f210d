#include "hydro/water/square_transform.h"

#include <gtest/gtest.h>

#include <complex>

#include "tests/support/tolerance.h"

namespace hydro {
namespace {

using support::tolerance;

using Eigen::Index;
using Eigen::MatrixXcf;

/// Σ f e^{−ik·x}, as it is written.
MatrixXcf plain(const MatrixXcf& field) {
  const Index n = field.rows();
  Eigen::MatrixXcd line(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index k = 0; k < n; ++k)
      line(j, k) =
          std::polar(1.0, -2 * M_PI * static_cast<double>(j * k % n) / static_cast<double>(n));
  return (line * field.cast<std::complex<double>>() * line).cast<std::complex<float>>();
}

TEST(SquareTransform, IsTheSumOfItsDefinition) {
  for (const Index n : {16, 32, 64, 128}) {
    const MatrixXcf field = MatrixXcf::Random(n, n);
    MatrixXcf found = field;
    MatrixXcf other;
    SquareTransform(n).forward(found, other);
    const MatrixXcf wanted = plain(field);
    EXPECT_LT((found - wanted).norm(), tolerance(5e-7) * wanted.norm()) << n;
  }
}

TEST(SquareTransform, HasAnInverse) {
  for (const Index n : {16, 64, 512}) {
    const MatrixXcf field = MatrixXcf::Random(n, n);
    MatrixXcf found = field, other;
    const SquareTransform transform(n);
    transform.forward(found, other);
    transform.inverse(found, other);
    EXPECT_LT((found - field).norm(), tolerance(1e-6) * field.norm()) << n;
  }
}

/// Rows without a number are left out; the rest is the same.
TEST(SquareTransform, OfAFewRowsIsThatOfAll) {
  MatrixXcf field = MatrixXcf::Zero(64, 64);
  field.block<3, 5>(20, 40).setRandom();
  MatrixXcf found = field, other;
  SquareTransform(64).forward(found, other);
  const MatrixXcf wanted = plain(field);
  EXPECT_LT((found - wanted).norm(), tolerance(5e-7) * wanted.norm());
}

}  // namespace
}  // namespace hydro
