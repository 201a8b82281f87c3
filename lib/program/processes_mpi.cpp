#include <mpi.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "processes.hpp"

namespace vibro_impact {

namespace {

constexpr int request_tag = 1, answer_tag = 2;

// A request: its note and its block, then the text.
using Head = std::array<std::uint64_t, 2>;

// Set by mpirun of Open MPI, by other starters. A program started without is one process, and does
// not wait for MPI to begin.
bool started_by_mpirun() {
  for (const char *name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

std::size_t ask(Ranks::Note note, std::size_t block, std::string_view text) {
  const Head head{static_cast<std::uint64_t>(note), block};
  std::string request(reinterpret_cast<const char *>(head.data()), sizeof head);
  request += text;
  MPI_Send(request.data(), static_cast<int>(request.size()), MPI_BYTE, 0, request_tag,
           MPI_COMM_WORLD);
  std::uint64_t answer = 0;
  MPI_Recv(&answer, 1, MPI_UINT64_T, 0, answer_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return answer;
}

bool serve(const Ranks::Answer &answer) {
  int waiting = 0, size = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, request_tag, MPI_COMM_WORLD, &waiting, &status);
  if (waiting == 0) return false;
  MPI_Get_count(&status, MPI_BYTE, &size);
  std::string request(static_cast<std::size_t>(size), '\0');
  MPI_Recv(request.data(), size, MPI_BYTE, status.MPI_SOURCE, request_tag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  Head head;
  std::memcpy(head.data(), request.data(), sizeof head);
  const std::uint64_t next = answer(static_cast<Ranks::Note>(head[0]), head[1],
                                    std::string_view(request).substr(sizeof head));
  MPI_Send(&next, 1, MPI_UINT64_T, status.MPI_SOURCE, answer_tag, MPI_COMM_WORLD);
  return true;
}

}  // namespace

Processes::Processes(int &argc, char **&argv) {
  if (!started_by_mpirun()) return;
  int level = 0;
  // The threads take turns at talking.
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  if (size_ > 1 && level < MPI_THREAD_SERIALIZED)
    throw std::runtime_error("this MPI was built without threads");
}

Processes::~Processes() {
  int begun = 0;
  MPI_Initialized(&begun);
  if (begun != 0) MPI_Finalize();
}

Ranks Processes::ranks() const {
  return {rank_, size_, ask, serve};
}

long long Processes::said_by_rank_0(long long value) const {
  if (size_ > 1) MPI_Bcast(&value, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
  return value;
}

}  // namespace vibro_impact
