// The processes that mpirun started the program as, which share out the chains of a sweep. Without
// MPI, and without mpirun, there is one.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace vibro_impact {

// How many tasks a process takes at once when so many are left: an eighth of its part, so that no
// process works long after the others have ended, and asks a few hundred times in all.
std::size_t tasks_at_once(std::size_t left, std::size_t processes);

class Processes {
 public:
  // Takes what a task has computed.
  using Take = std::function<void(const std::string &text)>;
  // Computes a task, and calls `send` with each of its texts.
  using Work = std::function<void(std::size_t task, const Take &send)>;

  Processes();
  ~Processes();
  Processes(const Processes &) = delete;
  Processes &operator=(const Processes &) = delete;

  // Whether the program was built with MPI. Without it, processes started by mpirun know their
  // number and cannot share anything out.
  static bool with_mpi();

  std::size_t rank() const {
    return static_cast<std::size_t>(rank_);
  }
  std::size_t size() const {
    return static_cast<std::size_t>(size_);
  }
  // To be called by all: the numbers of rank 0.
  std::vector<std::size_t> from_rank_0(std::vector<std::size_t> numbers) const;
  // To be called by all. Does the tasks from 0 to `tasks`, without `tasks`. A process that is free
  // takes the next ones from one queue, and waits for no other until the queue is empty. `keep` is
  // called on rank 0, by one thread at a time, with every text that is sent. The texts of a task
  // arrive in their order, those of several tasks in any order. One process uses all its threads,
  // and each of several processes uses one. Throws what the work and `keep` throw.
  void share_out(std::size_t tasks, const Work &work, const Take &keep) const;
  // Ends the other processes, which would wait for this one, with an exit status.
  void end_others(int status) const;

 private:
  int rank_ = 0, size_ = 1;
};

// `Processes::share_out` for one process.
void share_out_on_threads(std::size_t tasks, const Processes::Work &work,
                          const Processes::Take &keep);

}  // namespace vibro_impact
