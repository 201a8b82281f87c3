// With MPI.
#include <mpi.h>

#include <cstdlib>

#include "processes.hpp"

namespace vibro_impact {

// A program that mpirun did not start is one process, and does not wait for MPI to begin. The names
// are those that Open MPI and other starters set.
Processes::Processes() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr &&
      std::getenv("PMI_RANK") == nullptr)
    return;
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Processes::~Processes() {
  int begun = 0;
  MPI_Initialized(&begun);
  if (begun != 0) MPI_Finalize();
}

bool Processes::with_mpi() {
  return true;
}

// Each process in turn sends its text to all others.
std::string Processes::joined(const std::string &text) const {
  if (size_ == 1) return text;
  std::string all;
  for (int rank = 0; rank < size_; ++rank) {
    std::string part = rank == rank_ ? text : "";
    auto length = static_cast<int>(part.size());
    MPI_Bcast(&length, 1, MPI_INT, rank, MPI_COMM_WORLD);
    part.resize(static_cast<std::size_t>(length));
    MPI_Bcast(part.data(), length, MPI_CHAR, rank, MPI_COMM_WORLD);
    all += part;
  }
  return all;
}

void Processes::end_others(int status) const {
  if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, status);
}

}  // namespace vibro_impact
