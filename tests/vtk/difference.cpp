// Compares pairs of PNG files; prints a Lua table for tests/lua/picture/golden_test.lua.
//   difference <file> <file> …   per pair the largest difference between means over squares of 8 × 8 pixels, 0 to 255
//                                (256 for different sizes): antialiasing of letters changes a mean slightly, a moved
//                                line or text strongly

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr int square = 8;

double mean(vtkImageData& image, int left, int low, int c) {
  const int* size = image.GetDimensions();
  double sum = 0;
  int count = 0;
  for (int y = low; y < std::min(low + square, size[1]); ++y)
    for (int x = left; x < std::min(left + square, size[0]); ++x, ++count)
      sum += image.GetScalarComponentAsDouble(x, y, 0, c);
  return sum / count;
}

double difference(const char* first, const char* second) {
  vtkNew<vtkPNGReader> a, b;
  a->SetFileName(first), b->SetFileName(second);
  a->Update(), b->Update();
  vtkImageData &one = *a->GetOutput(), &other = *b->GetOutput();
  const int* size = one.GetDimensions();
  if (!std::equal(size, size + 2, other.GetDimensions())) return 256;
  double most = 0;
  for (int y = 0; y < size[1]; y += square)
    for (int x = 0; x < size[0]; x += square)
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(mean(one, x, y, c) - mean(other, x, y, c)));
  return most;
}

} // namespace

int main(int count, char** files) {
  std::printf("return {");
  for (int i = 1; i + 1 < count; i += 2) std::printf("%.1f,", difference(files[i], files[i + 1]));
  std::printf("}\n");
}
