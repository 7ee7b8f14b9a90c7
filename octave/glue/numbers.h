// Numbers on their way to Octave, and subroutines that a scene has to have.
#pragma once

#include <octave/oct.h>
#include <octave/parse.h>

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <dlfcn.h>

#include "fortran.h"
#include "host/implicit/implicit.h"

static const double no_number = std::numeric_limits<double>::quiet_NaN ();

static void absent_routine (const std::string& name);

static fortran
routine (const char *name)
{
  const gsmbp_routine *r = emitted (name);
  if (! r)
    absent_routine (name);
  return fortran {r->sub};
}

template <typename list>
static Matrix
result (const list& x, int rows, int cols = 1)
{
  Matrix m (rows, cols);
  for (octave_idx_type i = 0; i < m.numel (); i++)
    m.xelem (i) = double (x[i]);
  return m;
}
