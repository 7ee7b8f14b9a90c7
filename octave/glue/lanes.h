// Many runs of a scene in lanes, in the order of what they do: a group of lanes, runs from stop
// to stop, those that have joined, their loops, steps.
#pragma once

#include "lanes_rk4.h"
