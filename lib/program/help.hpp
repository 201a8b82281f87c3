// The text below the options that --help prints.
#pragma once

#include <string>

namespace vibro_impact::runner {

// Examples, formats of the tables and exit status, with processes of MPI if `with_mpi`.
std::string footer(bool with_mpi);

}  // namespace vibro_impact::runner
