// Lists with an entry for each mass, pair or stop. Those of up to four entries allocate no memory:
// half of the time to begin a run would be spent on it.
#pragma once

#include <boost/container/small_vector.hpp>

namespace vibro_impact::detail {

template <class T>
using List = boost::container::small_vector<T, 4>;

}  // namespace vibro_impact::detail
