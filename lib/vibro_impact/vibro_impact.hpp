// Everything a user of the library includes.
#pragma once

#include "vibro_impact/simulate.hpp"
#include "vibro_impact/table.hpp"
