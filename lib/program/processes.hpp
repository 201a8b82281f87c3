// The processes that one program was started as by mpirun: with MPI, where it was found when the
// project was built; else, and when mpirun did not start the program, one.
#pragma once

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact {

class Processes {
 public:
  Processes(int &argc, char **&argv);
  ~Processes();
  Processes(const Processes &) = delete;
  Processes &operator=(const Processes &) = delete;

  int rank() const {
    return rank_;
  }
  // For a sweep.
  Ranks ranks() const;
  // What rank 0 says, on every rank.
  long long said_by_rank_0(long long value) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace vibro_impact
