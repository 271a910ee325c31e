// SPDX-License-Identifier: Apache-2.0
#include "math/lattice.h"

#include <gtest/gtest.h>

#include "math/gmp_oracle.h"

namespace aresta {
namespace {

Box3 box_to(double reach) {
  Box3 box;
  box.add(Vec3{-reach / 3, 0, 0});
  box.add(Vec3{0, reach, reach / 7});
  return box;
}

TEST(Lattice, HoldsTheBoxAndNoFinerOneDoes) {
  for (const double reach : {1.0, 1.5, 2.0, std::nextafter(2.0, 3.0), 1e-30, 1e30, 0x1p-400, 0.1, 100.0, 0x1p550}) {
    const Lattice lattice = Lattice::holding(box_to(reach));
    EXPECT_TRUE(lattice.holds({0, reach, 0})) << reach;
    EXPECT_FALSE(Lattice(std::ilogb(lattice.step()) - 1).holds({0, reach, 0})) << reach;
  }
  EXPECT_EQ(Lattice::holding(box_to(1)).step(), 0x1p-51);
  EXPECT_EQ(Lattice::holding(box_to(1)).to_lattice({1, -1, 0}), (LatticePoint{Lattice::range, -Lattice::range, 0}));
}

TEST(Lattice, BoxesWithoutSizeHaveOneToo) {
  EXPECT_EQ(Lattice::holding(Box3{}).step(), 1);
  Box3 origin;
  origin.add(Vec3{});
  EXPECT_EQ(Lattice::holding(origin).step(), 1);
  Box3 tiny;
  tiny.add(Vec3{0x1p-1060, 0, 0});
  EXPECT_EQ(Lattice::holding(tiny).step(), 0x1p-500) << "the finest there is";
}

TEST(Lattice, RoundsToTheNearestPointTiesToEven) {
  const Lattice lattice(-2);
  EXPECT_EQ(lattice.to_lattice({0.25, 0.26, 0.37}), (LatticePoint{1, 1, 1}));
  EXPECT_EQ(lattice.to_lattice({0.125, 0.375, -0.625}), (LatticePoint{0, 2, -2}));
  EXPECT_EQ(lattice.from_lattice({1, -3, 0}), (Vec3{0.25, -0.75, 0}));
}

TEST(Lattice, ThereAndBackIsTheSamePoint) {
  oracle::Random random(3);
  for (const int exponent : {-500, -51, -20, 0, 30, 500}) {
    const Lattice lattice(exponent);
    for (int i = 0; i < 1000; ++i) {
      LatticePoint p;
      for (auto& x : p) x = random.between(-Lattice::range, Lattice::range);
      if (i < 8) p = {i & 1 ? Lattice::range : -Lattice::range, i & 2 ? 1 : 0, i & 4 ? Lattice::range - 1 : -1};
      ASSERT_TRUE(lattice.holds(lattice.from_lattice(p)));
      ASSERT_EQ(lattice.to_lattice(lattice.from_lattice(p)), p);
    }
  }
}

}  // namespace
}  // namespace aresta
