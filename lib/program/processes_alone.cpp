// Without MPI. Processes that mpirun started know how many they are, by a variable of Open MPI or
// of a starter of the PMI kind, and nothing else of each other.
#include <cstdlib>

#include "processes.hpp"

namespace vibro_impact {

namespace {

int number_in(const char *variable, int otherwise) {
  const char *text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : otherwise;
}

}  // namespace

Processes::Processes()
    : rank_(number_in("OMPI_COMM_WORLD_RANK", number_in("PMI_RANK", 0))),
      size_(number_in("OMPI_COMM_WORLD_SIZE", number_in("PMI_SIZE", 1))) {
}

Processes::~Processes() = default;

bool Processes::with_mpi() {
  return false;
}

std::vector<std::size_t> Processes::from_rank_0(std::vector<std::size_t> numbers) const {
  return numbers;
}

void Processes::share_out(std::size_t tasks, const Work &work, const Take &keep) const {
  share_out_on_threads(tasks, work, keep);
}

void Processes::end_others(int) const {
}

}  // namespace vibro_impact
