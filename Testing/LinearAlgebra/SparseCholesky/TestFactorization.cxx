// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "SparseCholesky/Factorization.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using namespace Meshes;

TEST(Factorization, IsGivenUpWhenTold)
{
  // The second one is large enough to be asked about while it is factored.
  for (const int levels : { 3, 6 })
  {
    const System system(Potato(levels), 4, 0.0);
    const SparseMatrix matrix = system.Matrices.Energy + system.Matrices.Mass;
    const ComplexVector b = RandomVector(matrix.rows(), 1);
    int calls = 0;
    Factorization stopped;
    const ProgressFunction stop = [&](double) { return calls++ < (levels == 6 ? 1 : 0); };
    EXPECT_THROW(stopped.Compute(matrix, Progress(stop)), Stopped);
    EXPECT_EQ(calls, levels == 6 ? 2 : 1);
    struct Trouble
    {
    };
    const ProgressFunction trouble = [](double) -> bool { throw Trouble(); };
    EXPECT_THROW(stopped.Compute(matrix, Progress(trouble)), Trouble);
    // Others know nothing of it, and what they compute is the same as without questions.
    Factorization asked;
    Factorization plain;
    const ProgressFunction goOn = [](double) { return true; };
    ASSERT_TRUE(asked.Compute(matrix, Progress(goOn)));
    ASSERT_TRUE(plain.Compute(matrix));
    EXPECT_EQ(asked.Solve(b), plain.Solve(b));
    EXPECT_LT((matrix * plain.Solve(b) - b).norm(), 1e-10 * b.norm());
  }
}
