// Reads a .vtu file by VTK's own reader; prints a Lua table for tests/lua/output/vtu_test.lua.
//   read_vtu <file> <place> …   evaluates every cell at all combinations of the places (numbers in [0, 1])

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

void print(double value) {
  if (std::isfinite(value))
    std::printf("%.17g,", value);
  else
    std::printf("0/0,");
}

/// The point arrays of a cell, interpolated with the functions of the cell.
void print_fields(vtkUnstructuredGrid* grid, vtkCell* cell, const std::vector<double>& functions) {
  vtkPointData* data = grid->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a) {
    vtkDataArray* array = data->GetArray(a);
    std::printf("%s={", array->GetName());
    for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
      double sum = 0;
      for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
        sum += functions[i] * array->GetComponent(cell->GetPointId(static_cast<int>(i)), c);
      print(sum);
    }
    std::printf("},");
  }
}

void print_cell(vtkUnstructuredGrid* grid, vtkIdType number, const std::vector<double>& places) {
  vtkCell* cell = grid->GetCell(number);
  std::printf("{type=%d,degrees={", cell->GetCellType());
  vtkDataArray* degrees = grid->GetCellData()->GetHigherOrderDegrees();
  for (int c = 0; c < 3; ++c) print(degrees ? degrees->GetComponent(number, c) : c < cell->GetCellDimension());
  std::printf("},body=%g,contact=%g,points={\n", grid->GetCellData()->GetArray("body")->GetComponent(number, 0),
              grid->GetCellData()->GetArray("contact")->GetComponent(number, 0));
  const std::size_t n = places.size(), dimension = static_cast<std::size_t>(cell->GetCellDimension());
  std::vector<double> functions(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  for (std::size_t k = 0; k < (dimension > 2 ? n : 1); ++k)
    for (std::size_t j = 0; j < (dimension > 1 ? n : 1); ++j)
      for (std::size_t i = 0; i < n; ++i) {
        const std::array<double, 3> at = {places[i], dimension > 1 ? places[j] : 0, dimension > 2 ? places[k] : 0};
        std::array<double, 3> x;
        int part = 0;
        cell->EvaluateLocation(part, at.data(), x.data(), functions.data());
        std::printf("{at={%.17g,%.17g,%.17g},x={%.17g,%.17g,%.17g},", at[0], at[1], at[2], x[0], x[1], x[2]);
        print_fields(grid, cell, functions);
        std::printf("},\n");
      }
  std::printf("}},\n");
}

} // namespace

int main(int count, char** words) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  if (count < 3 || !reader->CanReadFile(words[1])) {
    std::fprintf(stderr, "usage: read_vtu <file> <place> …, where VTK can read the file\n");
    return 1;
  }
  reader->SetFileName(words[1]);
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  std::vector<double> places;
  for (int i = 2; i < count; ++i) places.push_back(std::atof(words[i]));
  std::printf("return {");
  for (const char* name : {"body_names", "contact_names"}) {
    std::printf("%s={", name);
    if (auto* list = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(name)))
      for (vtkIdType i = 0; i < list->GetNumberOfValues(); ++i) std::printf("'%s',", list->GetValue(i).c_str());
    std::printf("},");
  }
  std::printf("stress='%s %s',cells={\n", grid->GetPointData()->GetArray("stress")->GetComponentName(0),
              grid->GetPointData()->GetArray("stress")->GetComponentName(5));
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) print_cell(grid, c, places);
  std::printf("}}\n");
  return 0;
}
