// The one place that knows Catch2 2 from 3.
#pragma once

#if EVENLIFT_CATCH2_MAJOR >= 3
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
