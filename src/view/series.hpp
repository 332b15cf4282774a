#pragma once
// Series of pictures: numbered files or a film.

#include "view/figure.hpp"

namespace signorini::view {

/// True if a file name is that of a film: it ends with .mp4.
bool is_film(const std::string& file);

/// True if a file name denotes a series: a film, or a placeholder for a number, as in "x-%04d.png".
bool is_series(const std::string& file);

/// PNG for the pictures of a film. Throws Error unless numbered files end with .png, .svg or .pdf.
Format series_format(const std::string& file);

/// How films are made, for --doctor: ".mp4 by ffmpeg".
std::string film_description();

/// Draws `count` pictures: to files numbered from 1, or to a film of `rate` pictures per second, H.264 by the program
/// ffmpeg, written atomically. `picture` returns the bytes of picture i (from 0) in the format of series_format().
/// Throws Error on a name with more than one number, and when ffmpeg is missing.
void write_series(const std::string& file, int count, double rate, const PictureMaker& picture);

} // namespace signorini::view
