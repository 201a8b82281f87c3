#include "packed_record.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace vibro_impact {

namespace {

// The parts of a record in their order, once for both directions.
template <class Bytes, class Record>
void pass(Bytes &&bytes, Record &record) {
  auto &[period, to_come, counts, lyapunov, pairs, impact_velocities, state, work, counters] =
      record;
  auto &[periods, impacts, sticks, chatters, dual] = counts;
  bytes(period, to_come, periods, impacts, sticks, chatters, dual, lyapunov, pairs,
        impact_velocities, state.instant, state.displacement, state.velocity, state.held, work,
        counters);
}

struct Packer {
  std::string &bytes;

  template <class... Parts>
  void operator()(const Parts &...parts) {
    (put(parts), ...);
  }
  template <class Value>
  requires std::is_trivially_copyable_v<Value>
  void put(const Value &value) {
    bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
  }
  void put(const std::optional<double> &value) {
    put(value.has_value());
    put(value.value_or(0.0));
  }
  template <class Value>
  void put(const std::vector<Value> &values) {
    put(values.size());
    for (const Value &value : values) put(value);
  }
};

struct Unpacker {
  std::string_view &bytes;

  template <class... Parts>
  void operator()(Parts &...parts) {
    (take(parts), ...);
  }
  template <class Value>
  requires std::is_trivially_copyable_v<Value>
  void take(Value &value) {
    if (bytes.size() < sizeof value) throw std::runtime_error("a record is cut short");
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
  }
  void take(std::optional<double> &value) {
    bool there = false;
    double number = 0.0;
    take(there);
    take(number);
    if (there) value = number;
  }
  template <class Value>
  void take(std::vector<Value> &values) {
    std::size_t size = 0;
    take(size);
    if (size > bytes.size()) throw std::runtime_error("a record is cut short");
    values.resize(size);
    for (Value &value : values) take(value);
  }
};

}  // namespace

void pack(const OrbitRecord &record, std::string &bytes) {
  pass(Packer{bytes}, record);
}

OrbitRecord unpack(std::string_view &bytes) {
  OrbitRecord record;
  pass(Unpacker{bytes}, record);
  return record;
}

}  // namespace vibro_impact
