// With MPI.
#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <deque>

#include "processes.hpp"

namespace vibro_impact {

namespace {

static_assert(sizeof(std::size_t) == sizeof(std::uint64_t));

// The number of tasks that have been taken. It stands in the memory of rank 0, and every process
// adds to it without the help of rank 0.
class Counter {
 public:
  explicit Counter(bool on_this_rank) {
    std::uint64_t *number = nullptr;
    MPI_Win_allocate(on_this_rank ? sizeof(std::uint64_t) : 0, sizeof(std::uint64_t), MPI_INFO_NULL,
                     MPI_COMM_WORLD, &number, &window_);
    MPI_Win_lock_all(0, window_);
    if (on_this_rank) *number = 0;
    MPI_Win_sync(window_);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  // Adds to the number, and returns the number before.
  std::uint64_t add(std::uint64_t count) {
    std::uint64_t before = 0;
    MPI_Fetch_and_op(&count, &before, MPI_UINT64_T, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return before;
  }
  // To be called by all.
  void end() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }

 private:
  MPI_Win window_ = MPI_WIN_NULL;
};

// The texts that are on their way to rank 0. The process does not wait for their arrival.
class Sent {
 public:
  void add(const std::string &text) {
    messages_.push_back({text, MPI_REQUEST_NULL});
    Message &message = messages_.back();
    MPI_Isend(message.text.data(), static_cast<int>(message.text.size()), MPI_CHAR, 0, 0,
              MPI_COMM_WORLD, &message.request);
    for (int arrived = 1; arrived != 0 && !messages_.empty();) {
      MPI_Test(&messages_.front().request, &arrived, MPI_STATUS_IGNORE);
      if (arrived != 0) messages_.pop_front();
    }
  }
  void wait() {
    for (Message &message : messages_) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
  }

 private:
  struct Message {
    std::string text;
    MPI_Request request;
  };
  std::deque<Message> messages_;
};

std::string receive(const MPI_Status &status) {
  int length = 0;
  MPI_Get_count(&status, MPI_CHAR, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  MPI_Recv(text.data(), length, MPI_CHAR, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

}  // namespace

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

std::vector<std::size_t> Processes::from_rank_0(std::vector<std::size_t> numbers) const {
  if (size_ == 1) return numbers;
  std::uint64_t count = numbers.size();
  MPI_Bcast(&count, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  numbers.resize(count);
  MPI_Bcast(numbers.data(), static_cast<int>(count), MPI_UINT64_T, 0, MPI_COMM_WORLD);
  return numbers;
}

// An empty text says that a process has ended. Rank 0 receives the texts of the others whenever it
// has one of its own.
void Processes::share_out(std::size_t tasks, const Work &work, const Take &keep) const {
  if (size_ == 1) return share_out_on_threads(tasks, work, keep);
  Counter taken(rank_ == 0);
  Sent sent;
  int others = size_ - 1;
  const auto take_message = [&](const MPI_Status &status) {
    const std::string text = receive(status);
    if (text.empty())
      --others;
    else
      keep(text);
  };
  const auto send = [&](const std::string &text) {
    if (rank_ > 0) return sent.add(text);
    keep(text);
    MPI_Status status;
    for (int waiting = 1; waiting != 0;) {
      MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &waiting, &status);
      if (waiting != 0) take_message(status);
    }
  };
  for (std::size_t end = 0; end < tasks;) {
    const std::size_t count = tasks_at_once(tasks - end, size()), begin = taken.add(count);
    end = begin + count;
    for (std::size_t task = begin; task < std::min(end, tasks); ++task) work(task, send);
  }
  if (rank_ > 0) sent.add("");
  sent.wait();
  while (rank_ == 0 && others > 0) {
    MPI_Status status;
    MPI_Probe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
    take_message(status);
  }
  taken.end();
}

void Processes::end_others(int status) const {
  if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, status);
}

}  // namespace vibro_impact
