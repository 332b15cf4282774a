#include "exchange/exchange.hpp"

#include "exchange/text.hpp"
#include "os/whole_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace signorini::exchange {

namespace {

struct Form {
  std::string name, ending;
  FileKind kind;
  Geometry (*read)(const std::string& file, const std::string& text);
  std::string (*write)(const Geometry& geometry);
};

const std::vector<Form> known = {{"gismo", ".xml", FileKind::gismo, read_gismo, gismo},
                                 {"geopdes", ".txt", FileKind::geopdes, read_geopdes, geopdes},
                                 {"mfem", ".mesh", FileKind::mfem, read_mfem, mfem}};

/// The format of a text, recognized from its beginning.
const Form& form_of(const std::string& file, const std::string& text) {
  std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; // byte-order mark
  while (begin < text.size() && std::isspace(static_cast<unsigned char>(text[begin]))) ++begin;
  const std::string_view start = std::string_view(text).substr(begin);
  require(!start.empty(), "exchange.file.empty", {{"file", file}});
  if (start.front() == '<') return known[0];
  if (start.starts_with("MFEM")) return known[2];
  require(start.front() == '#' || std::isdigit(static_cast<unsigned char>(start.front())), "exchange.file.form",
          {{"file", file}});
  return known[1];
}

} // namespace

std::vector<std::string> forms() {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const Form& form : known) names.push_back(form.name);
  return names;
}

std::string form_named_by(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const Form& form : known)
    if (form.ending == ending) return form.name;
  return "";
}

Geometry read_geometry(const std::string& file) {
  const std::string text = read_file(file);
  return form_of(file, text).read(file, text);
}

void write_geometry(const std::string& file, const Geometry& geometry, const std::string& form) {
  require(!geometry.patches.empty(), "exchange.write.nothing");
  for (const Form& one : known)
    if (one.name == form) return write_output(file, one.write(geometry), one.kind);
  fail("exchange.write.form", {{"form", form}, {"known", forms()}});
}

} // namespace signorini::exchange
