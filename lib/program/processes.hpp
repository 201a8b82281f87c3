// The processes that mpirun started the program as, which share out the points of a sweep. Without
// MPI, and without mpirun, there is one.
#pragma once

#include <cstddef>
#include <string>

namespace vibro_impact {

class Processes {
 public:
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
  // To be called by all, with one text each: returns the texts, joined in the order of the ranks.
  std::string joined(const std::string &text) const;
  // Ends the other processes, which would wait for this one, with an exit status.
  void end_others(int status) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace vibro_impact
