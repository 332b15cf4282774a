#include "bind/doctor.hpp"
#include "bind/wording/wording.hpp"

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "bind/library.hpp"
#include "bind/versions.hpp"
#include "view/picture.hpp"
#include "view/renderer.hpp"
#include "view/series.hpp"

#include <filesystem>
#include <iomanip>
#include <ostream>
#include <unistd.h>

namespace signorini::bind {

namespace fs = std::filesystem;

namespace {

/// A coloured square, drawn and thrown away.
std::string test_picture() {
  view::Body square;
  square.points.resize(3, 4);
  square.points << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  square.triangles.resize(3, 2);
  square.triangles << 0, 0, 1, 2, 2, 3;
  square.values = VectorX::LinSpaced(4, 0, 1);
  view::PictureOptions options;
  options.title = "signorini";
  options.size = {400, 300};
  const fs::path file = fs::temp_directory_path() / text("signorini-doctor-", getpid(), ".png");
  write_whole(file.string(),
              view::bytes_of(view::figure_of(view::make_plate(std::vector<view::Panel>{{"", {square}}}, options)),
                             view::format_of(file.string())));
  const auto bytes = fs::file_size(file);
  fs::remove(file);
  return text("ok (", bytes, " bytes)");
}

} // namespace

bool doctor(std::ostream& out, int threads, const std::string& readline) {
  const auto row = [&](const char* name, const std::string& value) {
    out << std::left << std::setw(14) << name << value << std::endl;
  };
  bool well = true;
  const auto attempt = [&](const char* name, auto&& check) {
    try {
      row(name, check());
    } catch (const std::exception& error) {
      well = false;
      row(name, text("FAILED: ", worded(error)));
    }
  };
  for (const auto& [name, version] : versions()) row(name.c_str(), version);
  attempt("library", [] { return find_home().string(); });
  row("threads", std::to_string(threads));
  row("readline", readline);
  attempt("renderer", [] { return view::renderer_description(); });
  attempt("drawing", [] { return view::flat_renderer().description(); });
  attempt("test picture", test_picture);
  attempt("films", [] { return view::film_description(); });
  row("all in all", well ? "ok" : "something is missing, see above");
  return well;
}

} // namespace signorini::bind
