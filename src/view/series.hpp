#pragma once
// Pictures that follow each other: numbered files, or a film.

#include "view/figure.hpp"

namespace signorini::view {

/// Whether a file's name is that of a film: it ends with .mp4 or .ogv.
bool is_film(const std::string& file);

/// Whether a file's name stands for a series: a film, or a number's place in it, as in "x-%04d.png".
bool is_series(const std::string& file);

/// That of a film's pictures is PNG. Throws Error unless numbered files end in .png, .svg or .pdf.
Format series_format(const std::string& file);

/// What films can be written here, for --doctor: ".ogv by VTK, .mp4 by ffmpeg".
std::string film_description();

/// Draws `count` pictures: to files numbered from 1, or to a film of `rate` pictures per second, .mp4 (H.264) by the
/// program ffmpeg, .ogv (Theora, a whole number per second) by VTK; a film is whole or not there. `picture` makes
/// the bytes of one, counted from 0, in the format of series_format(). Throws Error on a name with more than one
/// number, and where there is no ffmpeg or a VTK without Theora.
void write_series(const std::string& file, int count, double rate, const PictureMaker& picture);

} // namespace signorini::view
