// Counts non-white pixels at the edges of PNG files; prints a Lua table for tests/lua/picture/clipping_test.lua.
//   rim <file> …   per file { width, height, number of edge pixels that are not white }

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdio>

namespace {

bool is_white(vtkImageData& image, int x, int y) {
  for (int c = 0; c < 3; ++c)
    if (image.GetScalarComponentAsDouble(x, y, 0, c) < 250) return false;
  return true;
}

} // namespace

int main(int count, char** files) {
  std::printf("return {");
  for (int i = 1; i < count; ++i) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(files[i]);
    reader->Update();
    vtkImageData& image = *reader->GetOutput();
    const int width = image.GetDimensions()[0], height = image.GetDimensions()[1];
    int ink = 0;
    for (int x = 0; x < width; ++x) ink += !is_white(image, x, 0) + !is_white(image, x, height - 1);
    for (int y = 0; y < height; ++y) ink += !is_white(image, 0, y) + !is_white(image, width - 1, y);
    std::printf("{%d,%d,%d},", width, height, ink);
  }
  std::printf("}\n");
}
