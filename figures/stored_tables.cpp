#include "stored_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "platform.hpp"
#include "table_reader.hpp"

namespace vibro_impact::figures {

namespace {

std::string first_line(const std::filesystem::path &path) {
  std::ifstream file = opened(path.string());
  std::string line;
  std::getline(file, line);
  return line;
}

std::vector<std::vector<std::string>> rows_of(const std::filesystem::path &path) {
  std::ifstream file = opened(path.string());
  return read_rows(file, path.string(), 1);
}

// As a line of a table.
std::string joined(std::vector<std::string> cells) {
  for (std::string &cell : cells)
    if (cell.find(',') != std::string::npos) cell = in_quotes(cell);
  return fmt::format("{}", fmt::join(cells, ","));
}

}  // namespace

Sums sums_of(const std::filesystem::path &folder, const std::string &platform) {
  std::string command = fmt::format("cd '{}' && sha256sum --", folder.string());
  bool any = false;
  for (const auto &entry : std::filesystem::directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".csv" && kind != ".png") continue;
    command += fmt::format(" '{}'", entry.path().filename().string());
    any = true;
  }
  if (!any) return {platform, {}};
  Sums sums{platform, {}};
  std::istringstream lines(output_of(command));
  for (std::string sum, name; lines >> sum >> name;) sums.of[name] = sum;
  if (sums.of.empty()) throw std::runtime_error("sha256sum: printed nothing");
  return sums;
}

Sums read_sums(const std::filesystem::path &path) {
  std::ifstream file = opened(path.string());
  Sums sums;
  const std::string mark = "# platform: ";
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(mark))
      sums.platform = line.substr(mark.size());
    else if (const std::size_t gap = line.find("  "); gap != std::string::npos)
      sums.of[line.substr(gap + 2)] = line.substr(0, gap);
  }
  return sums;
}

std::string text_of(const Sums &sums) {
  std::string text = fmt::format("# platform: {}\n", sums.platform);
  for (const auto &[name, sum] : sums.of) text += fmt::format("{}  {}\n", sum, name);
  return text;
}

Extract extract(const std::filesystem::path &table, std::size_t most, double until) {
  auto rows = rows_of(table);
  rows.erase(std::find_if(rows.begin(), rows.end(),
                          [until](const auto &cells) {
                            const auto value = as_number(cells[0]);
                            return value && *value > until;
                          }),
             rows.end());
  Extract found{.header = first_line(table), .rows_in_all = rows.size()};
  const std::size_t kept = std::min(most, rows.size());
  for (std::size_t k = 0; k < kept; ++k) {
    const std::size_t number = kept == 1 ? 0 : k * (rows.size() - 1) / (kept - 1);
    found.numbers.push_back(number);
    found.rows.push_back(rows[number]);
  }
  return found;
}

std::string text_of(const Extract &extract) {
  std::string text = fmt::format("row of {},{}\n", extract.rows_in_all, extract.header);
  for (std::size_t k = 0; k < extract.rows.size(); ++k)
    text += fmt::format("{},{}\n", extract.numbers[k], joined(extract.rows[k]));
  return text;
}

Extract read_extract(const std::filesystem::path &file) {
  const std::string header = first_line(file), mark = "row of ";
  const std::size_t comma = header.find(',');
  if (!header.starts_with(mark) || comma == std::string::npos)
    throw std::runtime_error(file.string() + ": is no extract of a table");
  const auto count = [&](const std::string &cell) {
    return static_cast<std::size_t>(number_in(file.string(), cell));
  };
  Extract found{.header = header.substr(comma + 1),
                .rows_in_all = count(header.substr(mark.size(), comma - mark.size()))};
  for (auto &cells : rows_of(file)) {
    found.numbers.push_back(count(cells[0]));
    cells.erase(cells.begin());
    found.rows.push_back(std::move(cells));
  }
  return found;
}

Rules read_rules(const std::filesystem::path &path) {
  std::ifstream file = opened(path.string());
  Rules rules;
  for (const auto &cells : read_rows(file, path.string(), 4)) {
    Rule rule;
    rule.compared = cells[1] != "not compared";
    if (rule.compared) rule.tolerance = number_in(path.string(), cells[1]);
    rule.until = cells[2].empty() ? std::numeric_limits<double>::infinity()
                                  : number_in(path.string(), cells[2]);
    rule.reason = cells[3];
    rules[cells[0]] = rule;
  }
  return rules;
}

const Rule &rule_for(const Rules &rules, const std::string &table) {
  const Rule *best = nullptr;
  std::size_t length = 0;
  for (const auto &[name, rule] : rules)
    if (table.starts_with(name) && name.size() >= length) {
      best = &rule;
      length = name.size();
    }
  if (best == nullptr) throw std::runtime_error(table + ": no rule says how it is compared");
  return *best;
}

Difference difference(const Extract &fresh, const Extract &stored) {
  if (fresh.header != stored.header) return {.reason = "has other columns: " + fresh.header};
  if (fresh.rows_in_all != stored.rows_in_all)
    return {.reason = fmt::format("has {} rows, not {}", fresh.rows_in_all, stored.rows_in_all)};
  if (fresh.numbers != stored.numbers) return {.reason = "other rows are stored"};
  std::vector<std::string> names;
  std::istringstream columns(stored.header);
  for (std::string name; std::getline(columns, name, ',');) names.push_back(name);
  Difference found;
  for (std::size_t column = 0; !stored.rows.empty() && column < stored.rows[0].size(); ++column) {
    const bool estimate = column < names.size() && names[column] == "error";
    double size = estimate ? 1.0 : 0.0, largest = 0.0;
    std::size_t at = 0;
    for (std::size_t k = 0; k < stored.rows.size(); ++k) {
      if (fresh.rows[k].size() != stored.rows[k].size())
        return {.reason = fmt::format("row {} has other cells", stored.numbers[k])};
      const std::string &a = fresh.rows[k][column], &b = stored.rows[k][column];
      const auto x = as_number(a), y = as_number(b);
      const bool numbers = x && y && std::isfinite(*x) && std::isfinite(*y);
      if (!numbers && a != b)
        return {.reason = fmt::format("row {} has {}, not {}", stored.numbers[k], a, b)};
      if (!numbers) continue;
      size = std::max(size, std::abs(*y));
      if (std::abs(*x - *y) > largest) {
        largest = std::abs(*x - *y);
        at = k;
      }
    }
    if (largest == 0.0 || largest / size <= found.largest) continue;
    found.largest = largest / size;
    found.where = fmt::format("row {}, column {}", stored.numbers[at], column + 1);
  }
  return found;
}

}  // namespace vibro_impact::figures
