#include <mpi.h>

#include <chrono>
#include <cstdint>
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

constexpr std::uint64_t no_more = UINT64_MAX;

std::mutex talking;  // the threads take turns

// Set by mpirun of Open MPI, by other starters. A program started without is one process, and does
// not wait for MPI to begin.
bool started_by_mpirun() {
  for (const char *name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

template <class Number>
void send(const std::vector<Number> &values, MPI_Datatype type, int to, int tag) {
  const std::lock_guard lock(talking);
  MPI_Send(values.data(), static_cast<int>(values.size()), type, to, tag, MPI_COMM_WORLD);
}

template <class Number>
std::vector<Number> receive(MPI_Datatype type, int from, int tag) {
  for (;;) {
    {
      const std::lock_guard lock(talking);
      int there = 0, size = 0;
      MPI_Status status;
      MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status);
      if (there != 0) {
        MPI_Get_count(&status, type, &size);
        std::vector<Number> values(static_cast<std::size_t>(size));
        MPI_Recv(values.data(), size, type, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        return values;
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
}

void send_point(std::uint64_t point, const Seat &to) {
  send(std::vector{point}, MPI_UINT64_T, to.rank, to.thread);
}

// A row without numbers says that there was an error: rank 0 computes the point itself, and meets
// it.
void serve(const ComputeRow &compute, int thread) {
  for (;;) {
    const std::uint64_t point = receive<std::uint64_t>(MPI_UINT64_T, 0, thread).at(0);
    if (point == no_more) return;
    std::vector<double> row;
    try {
      row = compute(point);
    } catch (...) {
    }
    send(row, MPI_DOUBLE, 0, thread);
  }
}

// The threads of the others that have nothing to do.
class FreeSeats {
 public:
  std::vector<Seat> seats = {};

  std::optional<Seat> take() {
    const std::lock_guard lock(mutex_);
    if (seats.empty()) return std::nullopt;
    const Seat seat = seats.back();
    seats.pop_back();
    return seat;
  }
  void give_back(const Seat &seat) {
    const std::lock_guard lock(mutex_);
    seats.push_back(seat);
  }
  ~FreeSeats() {
    for (const Seat &seat : seats) send_point(no_more, seat);
  }

 private:
  std::mutex mutex_;
};

}  // namespace

Processes::Processes(int &argc, char **&argv) {
  if (!started_by_mpirun()) return;
  int level = 0;
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
  FreeSeats free;
  for (int rank = 1; rank < size_; ++rank)
    for (int thread = 0; thread < threads_of[static_cast<std::size_t>(rank)]; ++thread)
      free.seats.push_back({rank, thread});
  use(threads + static_cast<int>(free.seats.size()), [&](std::size_t point) {
    const std::optional<Seat> seat = free.take();
    if (!seat) return compute(point);
    send_point(point, *seat);
    std::vector<double> row = receive<double>(MPI_DOUBLE, seat->rank, seat->thread);
    free.give_back(*seat);
    return row.empty() ? compute(point) : row;
  });
}

}  // namespace vibro_impact
