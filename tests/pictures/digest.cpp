// The digest of a picture: its texts with their places, and what is drawn of each curve. It is made
// of the SVG that gnuplot writes, and compared with the stored one, so that no script draws another
// picture unseen. Lengths are in pixels. A line of it is one of
//
//   picture WIDTH HEIGHT
//   curve NAME
//   text x y angle SIZE ANCHOR COLOUR "LABEL", with /slanted/, *bold*, _low and ^high parts
//   STYLE n lowest-x lowest-y highest-x highest-y mean-x mean-y length
//
// The last one has all lines, areas or symbols of one style in a curve: their number of points n,
// the box around the points, their mean, and the length of the lines. The texts of a picture stand
// before its curves, sorted, since versions of gnuplot write them in different orders. Frames and
// ticks stand with the curve before them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Throws std::runtime_error naming a file that cannot be read.
std::string contents(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

// The value of an attribute of a tag, without blanks, or the default if it has none.
std::string attribute(const std::string &tag, const std::string &name,
                      const std::string &otherwise = "") {
  std::size_t begin = tag.find(' ' + name + "=");
  if (begin == std::string::npos) begin = tag.find(' ' + name + " =");
  if (begin == std::string::npos) return otherwise;
  begin = tag.find_first_of("'\"", begin);
  std::string value = tag.substr(begin + 1, tag.find(tag[begin], begin + 1) - begin - 1);
  if (name != "d" && name != "points") std::erase(value, ' ');
  return value == "currentColor" ? otherwise : value;
}

// The shapes of one style in a curve.
struct Ink {
  std::string style;
  int points = 0;
  double lowest[2] = {1e9, 1e9}, highest[2] = {-1e9, -1e9}, sum[2] = {}, length = 0.0;

  // Adds the points of a path. M begins a line, and Z closes it.
  void add(const std::string &path) {
    double place[2], first[2] = {}, last[2] = {};
    bool begins = true;
    for (std::size_t at = path.find_first_of("-0123456789MZ"); at != std::string::npos;
         at = path.find_first_of("-0123456789MZ", at)) {
      if (path[at] == 'M') begins = true;
      if (path[at] == 'Z') length += std::hypot(first[0] - last[0], first[1] - last[1]);
      int read = 0;
      if (std::sscanf(path.c_str() + at, "%lf,%lf%n", &place[0], &place[1], &read) < 2) {
        ++at;
        continue;
      }
      at += static_cast<std::size_t>(read);
      ++points;
      for (int i = 0; i < 2; ++i) {
        lowest[i] = std::min(lowest[i], place[i]);
        highest[i] = std::max(highest[i], place[i]);
        sum[i] += place[i];
      }
      if (begins) std::copy_n(place, 2, first);
      if (!begins) length += std::hypot(place[0] - last[0], place[1] - last[1]);
      std::copy_n(place, 2, last);
      begins = false;
    }
  }
};

// Reads a picture tag by tag.
struct Reader {
  std::string digest, curves, width, colour, place, label;
  std::vector<std::pair<std::string, std::string>> texts = {};  // each label with its line
  std::vector<Ink> inks = {};

  void end_picture() {
    end_curve();
    std::sort(texts.begin(), texts.end());
    for (const auto &[words, line] : texts) digest += line;
    digest += curves;
    texts.clear();
    curves.clear();
  }
  // Each style stands where its first shape is drawn.
  void end_curve() {
    for (const Ink &ink : inks)
      curves +=
          fmt::format("{} {} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}\n", ink.style,
                      ink.points, ink.lowest[0], ink.lowest[1], ink.highest[0], ink.highest[1],
                      ink.sum[0] / ink.points, ink.sum[1] / ink.points, ink.length);
    inks.clear();
  }
  void add(const std::string &style, const std::string &path) {
    const auto same = [&](const Ink &ink) { return ink.style == style; };
    auto ink = std::find_if(inks.begin(), inks.end(), same);
    if (ink == inks.end()) ink = inks.insert(ink, Ink{style});
    ink->add(path);
  }
  // A tag, and the text behind it.
  void take(const std::string &tag, const std::string &text) {
    const std::string name = tag.substr(1, tag.find_first_of(" \t\n>", 1) - 1),
                      transform = attribute(tag, "transform");
    if (name == "svg") {
      end_picture();
      digest += fmt::format("picture {} {}\n", attribute(tag, "width"), attribute(tag, "height"));
    } else if (name == "title" && text != "Gnuplot") {
      end_curve();
      curves += "curve " + text + '\n';
    } else if (name == "g" && !transform.empty()) {
      double x = 0.0, y = 0.0, angle = 0.0;
      std::sscanf(transform.c_str(), "translate(%lf,%lf)rotate(%lf)", &x, &y, &angle);
      place =
          fmt::format("{:.1f} {:.1f} {:.0f} size{} {} {}", x, y, angle, attribute(tag, "font-size"),
                      attribute(tag, "text-anchor"), attribute(tag, "fill"));
    } else if (name == "g" && !attribute(tag, "stroke-width").empty()) {
      width = attribute(tag, "stroke-width");
      colour = attribute(tag, "stroke", attribute(tag, "color"));
    } else if (name == "text" || name == "tspan" || name == "/tspan") {
      const char *mark = attribute(tag, "font-style") == "italic"  ? "/"
                         : attribute(tag, "font-weight") == "bold" ? "*"
                                                                   : "";
      const std::string shift = attribute(tag, "dy", "0");
      if (shift != "0" && !text.empty()) label += shift[0] == '-' ? "^" : "_";
      if (!text.empty()) label += mark + text + mark;
    } else if (name == "/text") {
      if (!label.empty()) texts.emplace_back(label, fmt::format("text {} \"{}\"\n", place, label));
      label.clear();
    } else if (name == "path") {
      add(fmt::format("line {} w{} {}", attribute(tag, "stroke", colour), width,
                      attribute(tag, "stroke-dasharray", "solid")),
          attribute(tag, "d"));
    } else if (name == "polygon") {
      add("area " + attribute(tag, "fill", colour), attribute(tag, "points"));
    } else if (name == "use") {
      // A dot has no transform.
      const std::size_t scale = std::min(transform.find("scale"), transform.size());
      add(fmt::format("{} {} {}", attribute(tag, "xlink:href"), attribute(tag, "color", colour),
                      transform.substr(scale)),
          transform.substr(0, scale) + attribute(tag, "x") + "," + attribute(tag, "y"));
    } else if (name == "image") {
      throw std::runtime_error("an image has no digest: draw it as boxes");
    }
  }
};

std::string digest_of(const std::string &svg) {
  Reader reader;
  for (std::size_t at = 0; (at = svg.find('<', at)) != std::string::npos; ++at) {
    if (svg.compare(at, 5, "<defs") == 0) at = svg.find("</defs", at);  // gnuplot's own symbols
    const std::size_t end = svg.find('>', at);
    reader.take(svg.substr(at, end - at), svg.substr(end + 1, svg.find('<', end) - end - 1));
  }
  reader.end_picture();
  return reader.digest;
}

// Whether two words of a digest agree: places to a pixel (and a thousandth, for lengths), counts to
// half a percent, since a motion that is chaotic depends on rounding, colours to a rounding of a
// palette, and all else exactly.
bool agree(const std::string &one, const std::string &other) {
  int red, green, blue, its_red, its_green, its_blue;
  if (std::sscanf(one.c_str(), "rgb(%d,%d,%d)", &red, &green, &blue) == 3 &&
      std::sscanf(other.c_str(), "rgb(%d,%d,%d)", &its_red, &its_green, &its_blue) == 3)
    return std::abs(red - its_red) + std::abs(green - its_green) + std::abs(blue - its_blue) <= 3;
  char *end = nullptr, *its_end = nullptr;
  const double value = std::strtod(one.c_str(), &end), its = std::strtod(other.c_str(), &its_end);
  if (*end != '\0' || *its_end != '\0') return one == other;
  const bool is_count = one.find('.') == std::string::npos;
  return std::abs(value - its) <= (is_count ? 0.005 : 0.001) * std::abs(value) + (is_count ? 0 : 1);
}

std::vector<std::string> split(const std::string &text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

bool lines_agree(const std::string &one, const std::string &other) {
  const std::size_t quote = std::min(one.find('"'), one.size()),
                    other_quote = std::min(other.find('"'), other.size());
  const auto words = split(one.substr(0, quote), ' '),
             others = split(other.substr(0, other_quote), ' ');
  return one.substr(quote) == other.substr(other_quote) &&
         std::equal(words.begin(), words.end(), others.begin(), others.end(), agree);
}

// Prints the first lines that differ. Returns how many differ.
int compare(const std::string &stored, const std::string &drawn) {
  auto lines = split(stored, '\n'), others = split(drawn, '\n');
  lines.resize(std::max(lines.size(), others.size()));
  others.resize(lines.size());
  int differences = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!lines_agree(lines[i], others[i]) && ++differences <= 5)
      fmt::print("line {}\nstored: {}\ndrawn:  {}\n", i + 1, lines[i], others[i]);
  return differences;
}

}  // namespace

// picture-digest PICTURE.svg STORED.txt [renew]: compares the digests, or stores that of the
// picture.
int main(int argc, char **argv) {
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const std::string drawn = digest_of(contents(arguments.at(0))), stored = arguments.at(1);
    if (arguments.size() == 3) return (std::ofstream(stored) << drawn).flush() ? 0 : 2;
    const int differences = compare(contents(stored), drawn);
    if (differences > 0)
      fmt::print("{}: {} lines differ. `make pictures` stores what is drawn.\n", stored,
                 differences);
    return differences > 0 ? 1 : 0;
  } catch (const std::exception &failure) {
    fmt::print(stderr, "picture-digest: {}\n", failure.what());
    return 2;
  }
}
