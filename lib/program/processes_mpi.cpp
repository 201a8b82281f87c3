#include <mpi.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <thread>

#include "processes.hpp"

namespace vibro_impact {

namespace {

using Row = std::vector<double>;

void send(const Row &row, int to) {
  MPI_Send(row.data(), static_cast<int>(row.size()), MPI_DOUBLE, to, 0, MPI_COMM_WORLD);
}

// Asleep while there is nothing: MPI itself would wait at the cost of a processor.
Row receive(int from) {
  int there = 0, size = 0;
  MPI_Message message;
  MPI_Status status;
  while (MPI_Improbe(from, 0, MPI_COMM_WORLD, &there, &message, &status), there == 0)
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  MPI_Get_count(&status, MPI_DOUBLE, &size);
  Row row(static_cast<std::size_t>(size));
  MPI_Mrecv(row.data(), size, MPI_DOUBLE, &message, MPI_STATUS_IGNORE);
  return row;
}

// The other processes would wait for this one for ever.
void end_all(int rank, const char *why) {
  std::fprintf(stderr, "vibro-impact: process %d: %s\n", rank, why);
  MPI_Abort(MPI_COMM_WORLD, 2);
}

}  // namespace

// A program that mpirun did not start is one process, and does not wait for MPI to begin. (The
// names are those that Open MPI and other starters set.)
Processes::Processes() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr &&
      std::getenv("PMI_RANK") == nullptr)
    return;
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  if (size_ > 1 && level < MPI_THREAD_MULTIPLE)
    end_all(rank_, "this MPI was built without threads");
}

Processes::~Processes() {
  int begun = 0;
  MPI_Initialized(&begun);
  if (begun != 0) MPI_Finalize();
}

void Processes::share_out(int threads, const ComputeRow &compute,
                          const std::function<void(int, const ComputeRow &)> &use) const {
  if (size_ == 1) return use(threads, compute);
  if (rank_ > 0) {
    try {
      for (Row point; !(point = receive(0)).empty();)
        send(compute(static_cast<std::size_t>(point[0])), 0);
    } catch (const std::exception &error) {
      end_all(rank_, error.what());
    }
    return;
  }
  // All are told when it is over.
  struct Others {
    int size;
    ~Others() {
      for (int rank = 1; rank < size; ++rank) send({}, rank);
    }
  } others{size_};
  // Every thread that asks is numbered: the first ones leave all their points to one process each,
  // the others compute theirs.
  std::atomic<int> asked = 0;
  use(threads + size_ - 1, [&](std::size_t point) {
    thread_local const int rank = ++asked;
    if (rank >= size_) return compute(point);
    send({static_cast<double>(point)}, rank);
    return receive(rank);
  });
}

}  // namespace vibro_impact
