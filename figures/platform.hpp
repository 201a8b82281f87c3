// What a result was computed with: versions as the program was compiled, and the processor.
#pragma once

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <Eigen/Core>
#include <array>
#include <cstdio>
#include <memory>
#include <string>

namespace vibro_impact::figures {

// What a command prints; nothing when it cannot be run.
inline std::string output_of(const std::string &command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t count = pipe ? std::fread(part.data(), 1, part.size(), pipe.get()) : 0)
    text.append(part.data(), count);
  return text;
}

inline std::string first_line_of(const std::string &command) {
  const std::string text = output_of("{ " + command + "; } 2>/dev/null");
  return text.substr(0, text.find('\n'));
}

// Its name, and those of its instruction sets that the C library chooses its functions by.
inline std::string processor() {
  const std::string name = first_line_of(
      "{ sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1;"
      " grep -m 1 ^flags /proc/cpuinfo | grep -ow -e fma -e avx2 -e avx512f; } | paste -sd ' '");
  return name.empty() ? first_line_of("uname -m") : name;
}

// With the instruction sets it was told to use beyond those of every such processor.
inline std::string compiler() {
#ifdef __clang__
  std::string text = "clang " __clang_version__;
#else
  std::string text = "g++ " __VERSION__;
#endif
#if defined __AVX512F__
  text += " fma avx2 avx512f";
#elif defined __AVX2__
  text += " avx2";
#endif
  return text;
}

// What decides the last bits of a table.
inline std::string platform() {
  return fmt::format("{}, C library {}, Eigen {}.{}.{}, {}", compiler(), gnu_get_libc_version(),
                     EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, processor());
}

}  // namespace vibro_impact::figures
