// The processes that one program was started as by mpirun: with MPI, where it was found when the
// project was built; else, and when mpirun did not start the program, one.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace vibro_impact {

// The row of numbers of a point; several threads may ask at once.
using ComputeRow = std::function<std::vector<double>(std::size_t point)>;

class Processes {
 public:
  Processes();
  ~Processes();
  Processes(const Processes &) = delete;
  Processes &operator=(const Processes &) = delete;

  int rank() const {
    return rank_;
  }
  // To be called once, by all. On rank 0: use(all, row) is called with `threads` and one for every
  // other process, and a `compute` that leaves the points of these to them. On the others: computes
  // what rank 0 asks for until `use` is over. What `compute` throws there is said in one line, and
  // ends all.
  void share_out(int threads, const ComputeRow &compute,
                 const std::function<void(int all, const ComputeRow &row)> &use) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace vibro_impact
