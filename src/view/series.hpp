#pragma once
// Pictures that follow each other: numbered PNG files, or a film.

#include <functional>
#include <string>

namespace signorini::view {

/// Whether a file's name stands for a series: it holds a number's place, as in "x-%04d.png", or ends with .mp4.
bool is_series(const std::string& file);

/// Draws `count` pictures: to files numbered from 1, or by ffmpeg to a film of `rate` pictures per second (H.264).
/// `png` makes the bytes of a picture, counted from 0. Throws Error on a name with more than one number, and where
/// there is no ffmpeg.
void write_series(const std::string& file, int count, double rate, const std::function<std::string(int)>& png);

} // namespace signorini::view
