// Without MPI.
#include <cstdlib>

#include "processes.hpp"

namespace vibro_impact {

namespace {

// The number in a variable of the environment, which Open MPI or a starter of the PMI kind has set.
int number_in(const char *open_mpi, const char *pmi, int otherwise) {
  for (const char *name : {open_mpi, pmi})
    if (const char *text = std::getenv(name)) return std::atoi(text);
  return otherwise;
}

}  // namespace

Processes::Processes()
    : rank_(number_in("OMPI_COMM_WORLD_RANK", "PMI_RANK", 0)),
      size_(number_in("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", 1)) {
}

Processes::~Processes() = default;

bool Processes::with_mpi() {
  return false;
}

std::size_t Processes::value_of_first(std::size_t value) const {
  return value;
}

std::string Processes::joined(const std::string &text) const {
  return text;
}

void Processes::end_others(int) const {
}

}  // namespace vibro_impact
