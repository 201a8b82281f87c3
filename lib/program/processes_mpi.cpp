#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "processes.hpp"

namespace vibro_impact {

namespace {

// A thread of another process: what is sent to it and what it answers bear its number.
struct Seat {
  int rank, thread;
};

using Row = std::vector<double>;

void send(const Row &row, const Seat &to) {
  MPI_Send(row.data(), static_cast<int>(row.size()), MPI_DOUBLE, to.rank, to.thread,
           MPI_COMM_WORLD);
}

// Asleep while there is nothing: MPI itself would wait at the cost of a processor.
Row receive(const Seat &from) {
  int there = 0, size = 0;
  MPI_Message message;
  MPI_Status status;
  while (MPI_Improbe(from.rank, from.thread, MPI_COMM_WORLD, &there, &message, &status), there == 0)
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  MPI_Get_count(&status, MPI_DOUBLE, &size);
  Row row(static_cast<std::size_t>(size));
  MPI_Mrecv(row.data(), size, MPI_DOUBLE, &message, MPI_STATUS_IGNORE);
  return row;
}

// Computes the points that come until a message without one. The answer to a point that ends with
// an error is a row without numbers: rank 0 then computes the point itself, and meets the error.
void serve(const ComputeRow &compute, int thread) {
  const Seat master{0, thread};
  for (Row point; !(point = receive(master)).empty();) {
    Row row;
    try {
      row = compute(static_cast<std::size_t>(point[0]));
    } catch (...) {
    }
    send(row, master);
  }
}

}  // namespace

// A program that mpirun did not start is one process, and does not wait for MPI to begin. (The
// names are those that Open MPI and other starters set.)
Processes::Processes(int &argc, char **&argv) {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr &&
      std::getenv("PMI_RANK") == nullptr)
    return;
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_MULTIPLE, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  if (size_ > 1 && level < MPI_THREAD_MULTIPLE)
    throw std::runtime_error("this MPI was built without threads");
}

Processes::~Processes() {
  int begun = 0;
  MPI_Initialized(&begun);
  if (begun != 0) MPI_Finalize();
}

void Processes::share_out(int threads, const ComputeRow &compute,
                          const std::function<void(int, const ComputeRow &)> &use) const {
  if (size_ == 1) return use(threads, compute);
  std::vector<int> threads_of(static_cast<std::size_t>(size_));
  MPI_Allgather(&threads, 1, MPI_INT, threads_of.data(), 1, MPI_INT, MPI_COMM_WORLD);
  if (rank_ > 0) {
    std::vector<std::jthread> others;
    for (int thread = 1; thread < threads; ++thread) others.emplace_back(serve, compute, thread);
    return serve(compute, 0);
  }
  // The threads of the others that have nothing to do; all of them are told when it is over.
  struct Free {
    std::vector<Seat> seats = {};
    std::mutex mutex = {};
    ~Free() {
      for (const Seat &seat : seats) send({}, seat);
    }
  } free;
  for (int rank = 1; rank < size_; ++rank)
    for (int thread = 0; thread < threads_of[static_cast<std::size_t>(rank)]; ++thread)
      free.seats.push_back({rank, thread});
  use(threads + static_cast<int>(free.seats.size()), [&](std::size_t point) {
    std::optional<Seat> seat;
    if (const std::lock_guard lock(free.mutex); !free.seats.empty()) {
      seat = free.seats.back();
      free.seats.pop_back();
    }
    if (!seat) return compute(point);
    send({static_cast<double>(point)}, *seat);
    const Row row = receive(*seat);
    const std::lock_guard lock(free.mutex);
    free.seats.push_back(*seat);
    return row.empty() ? compute(point) : row;
  });
}

}  // namespace vibro_impact
