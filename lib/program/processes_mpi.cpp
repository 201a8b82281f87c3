// With MPI.
#include <mpi.h>

#include <cstdlib>
#include <numeric>
#include <vector>

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

std::string Processes::joined(const std::string &text) const {
  if (size() == 1) return text;
  const int length = static_cast<int>(text.size());
  std::vector<int> lengths(size(), 0);
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, MPI_COMM_WORLD);
  std::vector<int> begins(lengths.size(), 0);
  std::exclusive_scan(lengths.begin(), lengths.end(), begins.begin(), 0);
  std::string all(static_cast<std::size_t>(begins.back() + lengths.back()), '\0');
  MPI_Allgatherv(text.data(), length, MPI_CHAR, all.data(), lengths.data(), begins.data(), MPI_CHAR,
                 MPI_COMM_WORLD);
  return all;
}

void Processes::end_others(int status) const {
  if (size() > 1) MPI_Abort(MPI_COMM_WORLD, status);
}

}  // namespace vibro_impact
