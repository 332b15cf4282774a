#include "os/file_kind.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>
#include <utility>

namespace signorini {

namespace {

using namespace std::string_view_literals;

constexpr std::pair<std::string_view, FileKind> signatures[] = {{"SIGNORINI "sv, FileKind::checkpoint},
                                                                {"\x89HDF\r\n\x1a\n"sv, FileKind::hdf5},
                                                                {"\x89PNG\r\n\x1a\n"sv, FileKind::png},
                                                                {"%PDF-"sv, FileKind::pdf},
                                                                {"MFEM "sv, FileKind::mfem},
                                                                {"# nurbs "sv, FileKind::geopdes}};

/// What follows the declaration of a text of markup.
constexpr std::pair<std::string_view, FileKind> elements[] = {{"<!DOCTYPE html"sv, FileKind::html},
                                                              {"<html"sv, FileKind::html},
                                                              {"<VTKFile"sv, FileKind::vtk},
                                                              {"<xml"sv, FileKind::gismo},
                                                              {"<svg"sv, FileKind::svg}};

constexpr std::array<std::string_view, 4> program_endings = {".lua", ".py", ".sh", ".ipynb"};

/// A line of a table: the number of its fields, and whether one of them is a number, a truth value or missing.
struct Fields {
  int count = 0;
  bool value = false;
};

bool is_value(std::string_view field) {
  double number;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  return field.empty() || field == "true" || field == "false" ||
         (error == std::errc() && end == field.data() + field.size());
}

/// Takes a line from a text; nothing if it is not complete. Line breaks within quotes do not end it.
std::optional<std::string_view> take_line(std::string_view& text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    quoted = quoted != (text[i] == '"');
    if (quoted || text[i] != '\n') continue;
    const std::string_view line = text.substr(0, i);
    text.remove_prefix(i + 1);
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
  }
  return std::nullopt;
}

Fields fields_of(std::string_view line) {
  Fields fields;
  bool quoted = false;
  for (std::size_t from = 0, i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != ',')) continue;
    ++fields.count;
    fields.value = fields.value || is_value(line.substr(from, i - from));
    from = i + 1;
  }
  return fields;
}

/// True if a line may be that of the names of a table that has no rows yet: words with commas between them.
bool is_head(std::string_view line) {
  return fields_of(line).count > 1 && std::all_of(line.begin(), line.end(), [](unsigned char c) {
           return std::isalnum(c) || std::string_view("_.-:,\"").find(static_cast<char>(c)) != std::string_view::npos;
         });
}

bool is_table(std::string_view text) {
  int lines = 0, columns = 0;
  bool head = false;
  while (const auto line = take_line(text)) {
    if (line->empty() || line->starts_with('#')) continue;
    const Fields fields = fields_of(*line);
    if (lines++ == 0) {
      columns = fields.count;
      head = is_head(*line);
    } else if (fields.count != columns || !fields.value)
      return false;
  }
  return lines > 1 || head;
}

} // namespace

FileKind kind_of(std::string_view beginning) {
  if (beginning.find_first_not_of('\0') == std::string_view::npos) return FileKind::empty;
  for (const auto& [bytes, kind] : signatures)
    if (beginning.starts_with(bytes)) return kind;
  if (beginning.size() >= 8 && beginning.substr(4, 4) == "ftyp") return FileKind::mp4;
  if (beginning.find('\0') != std::string_view::npos) return FileKind::other;
  const std::size_t start = beginning.find_first_not_of(" \t\r\n");
  const std::string_view text = start == std::string_view::npos ? "" : beginning.substr(start);
  if (text.starts_with('<'))
    for (const auto& [element, kind] : elements)
      if (text.find(element) != std::string_view::npos) return kind;
  if (text.starts_with('{') || text.starts_with('[')) return FileKind::json;
  return is_table(beginning) ? FileKind::table : FileKind::other;
}

bool may_replace(const std::string& file, std::string_view beginning, FileKind kind) {
  const FileKind found = kind_of(beginning);
  if (found == FileKind::empty) return true;
  if (kind != FileKind::json && kind != FileKind::table) return found == kind;
  const std::string ending = std::filesystem::path(file).extension().string();
  if (std::find(program_endings.begin(), program_endings.end(), ending) != program_endings.end()) return false;
  if (found == kind) return true;
  const bool text = found == FileKind::other || found == FileKind::json || found == FileKind::table;
  const bool usual = kind == FileKind::json ? ending == ".json" : ending == ".csv" || ending == ".tsv";
  return text && usual && beginning.find('\0') == std::string_view::npos;
}

Message name_of(FileKind kind) {
  constexpr const char* codes[] = {"os.kind.empty", "os.kind.checkpoint", "os.kind.hdf5",    "os.kind.png",
                                   "os.kind.svg",   "os.kind.pdf",        "os.kind.mp4",     "os.kind.vtk",
                                   "os.kind.html",  "os.kind.gismo",      "os.kind.geopdes", "os.kind.mfem",
                                   "os.kind.json",  "os.kind.table",      "os.kind.other"};
  return Message(codes[static_cast<int>(kind)]);
}

} // namespace signorini
