#include "view/vtk/parts.hpp"

#include "base/error.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cstdint>

namespace signorini::view {
namespace {

constexpr int best_quality = 2;

/// The picture on white with even sizes: VTK's writer fills incomplete chroma pixels with green.
void put_on_even(vtkImageData& film, vtkImageData& picture, int components) {
  const int width = picture.GetDimensions()[0], height = picture.GetDimensions()[1];
  film.SetDimensions(width + width % 2, height + height % 2, 1);
  film.AllocateScalars(VTK_UNSIGNED_CHAR, components);
  const auto row = [&](vtkImageData& image, int y) {
    return static_cast<std::uint8_t*>(image.GetScalarPointer(0, y, 0));
  };
  // The added row is the lowest one, because rows go upwards.
  std::fill_n(row(film, 0), components * film.GetDimensions()[0], 255);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* const to = row(film, y + height % 2);
    std::fill_n(std::copy_n(row(picture, y), components * width, to), components * (width % 2), 255);
  }
}

} // namespace

void draw_ogv(const std::string& file, int count, int rate, const PictureMaker& png) {
  vtkNew<vtkPNGReader> reader;
  vtkNew<vtkImageData> film;
  vtkNew<vtkOggTheoraWriter> writer;
  writer->SetInputData(film);
  writer->SetFileName(file.c_str());
  writer->SetRate(rate);
  writer->SetQuality(best_quality);
  writer->SubsamplingOn(); // chroma subsampling, which all players support
  std::array<int, 2> size{};
  for (int i = 0; i < count; ++i) {
    const std::string bytes = png(i);
    reader->SetMemoryBuffer(bytes.data());
    reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
    reader->Modified();
    reader->Update();
    vtkImageData& picture = *reader->GetOutput();
    const int components = picture.GetNumberOfScalarComponents();
    require(components == 3, "view.film.transparent");
    const std::array<int, 2> next = {picture.GetDimensions()[0], picture.GetDimensions()[1]};
    require(i == 0 || next == size, "view.film.sizes",
            {{"width", size[0]}, {"height", size[1]}, {"next_width", next[0]}, {"next_height", next[1]}});
    put_on_even(*film, picture, components);
    film->Modified();
    if (i == 0) size = next, writer->Start();
    writer->Write();
    if (writer->GetError() != 0) break; // the disk is full
  }
  writer->End();
}

} // namespace signorini::view
