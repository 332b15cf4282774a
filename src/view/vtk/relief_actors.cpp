#include "view/vtk/parts.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace signorini::view {
namespace {

Eigen::Map<const Points> columns(const std::vector<Vec<3>>& points) {
  return {points.empty() ? nullptr : points.front().data(), 3, static_cast<Eigen::Index>(points.size())};
}

/// Maps z towards the eye to the depth range of the camera beneath the drawing plane.
struct Depth {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(const Points& points) {
    if (points.cols() == 0) return;
    low = std::min(low, points.row(2).minCoeff());
    high = std::max(high, points.row(2).maxCoeff());
  }
  Points operator()(Points points) const {
    points.row(2).array() = -0.9 + 0.8 / std::max(high - low, 1e-12) * (points.row(2).array() - low);
    return points;
  }
};

vtkSmartPointer<vtkFloatArray> floats(const MatrixX& columns) {
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetNumberOfComponents(static_cast<int>(columns.rows()));
  result->SetNumberOfTuples(columns.cols());
  Eigen::Map<Eigen::MatrixXf>(result->GetPointer(0), columns.rows(), columns.cols()) = columns.cast<float>();
  return result;
}

/// Triangles; unlit without normals.
vtkSmartPointer<vtkPolyData> mesh(const Points& points, const Points& normals, const Triangles& triangles) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> places;
  places->SetData(floats(points));
  data->SetPoints(places);
  vtkNew<vtkCellArray> cells;
  for (const auto& t : triangles.colwise()) cells->InsertNextCell({t[0], t[1], t[2]});
  data->SetPolys(cells);
  if (normals.cols() > 0) data->GetPointData()->SetNormals(floats(normals));
  return data;
}

/// Separate triangles of three successive points, each in its own color.
template <std::size_t N>
vtkSmartPointer<vtkPolyData> plain_mesh(const Points& points, const Points& normals,
                                        const std::vector<std::array<std::uint8_t, N>>& colors) {
  Triangles triangles(3, points.cols() / 3);
  std::iota(triangles.reshaped().begin(), triangles.reshaped().end(), 0);
  auto data = mesh(points, normals, triangles);
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetNumberOfComponents(N);
  for (const auto& color : colors) scalars->InsertNextTypedTuple(color.data());
  data->GetCellData()->SetScalars(scalars);
  return data;
}

vtkSmartPointer<vtkPolyDataMapper> add_actor(vtkRenderer& renderer, vtkPolyData& data, bool forced_opaque,
                                             bool plain = false) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(&data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  if (forced_opaque) actor->ForceOpaqueOn();
  vtkProperty& look = *actor->GetProperty();
  if (data.GetPointData()->GetNormals() == nullptr)
    look.LightingOff();
  else {
    // Weak shading of fields, so that colors keep their meaning: faces towards the light have the colors of the bar.
    look.SetAmbient(plain ? 0.5 : 0.72);
    look.SetDiffuse(plain ? 0.55 : 0.32);
    look.SetSpecular(0); // would differ from tile to tile, because VTK takes the view as a central one
  }
  renderer.AddActor(actor);
  return mapper;
}

/// Values are interpolated before coloring.
void add_field(vtkRenderer& renderer, const Field& field, const Depth& depth) {
  const auto data = mesh(depth(field.points), field.normals, field.triangles);
  data->GetPointData()->SetScalars(floats(field.values.transpose()));
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(static_cast<vtkIdType>(field.colors.size()));
  for (std::size_t i = 0; i < field.colors.size(); ++i) {
    const Rgb& c = field.colors[i];
    table->SetTableValue(static_cast<vtkIdType>(i), c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
  }
  table->SetNanColor(field.missing[0] / 255.0, field.missing[1] / 255.0, field.missing[2] / 255.0, 1);
  table->SetTableRange(field.range[0], field.range[1]);
  const bool plain = field.colors.front() == field.colors.back(); // a body without a field
  const auto mapper = add_actor(renderer, *data, false, plain);
  mapper->SetLookupTable(table);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
}

/// Blended in the given order over the background, behind everything else. Drawn in the pass of opaque surfaces, where
/// OpenGL blends as well; VTK's passes for translucent surfaces need buffers that take longer than all the drawing.
void add_translucent(vtkRenderer& renderer, const Translucent& triangles) {
  constexpr double farthest = -0.98, nearest = -0.92;
  Points points = columns(triangles.corners);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points(2, i) =
        farthest + (nearest - farthest) * static_cast<double>(i - i % 3) / static_cast<double>(points.cols());
  add_actor(renderer, *plain_mesh(points, columns(triangles.normals), triangles.colors), true);
}

} // namespace

void add_relief(vtkRenderer& renderer, const Relief& relief) {
  Depth depth;
  for (const Field& field : relief.fields) depth.take(field.points);
  depth.take(columns(relief.ink.corners));
  if (!relief.translucent.colors.empty())
    add_translucent(renderer, relief.translucent); // first, because it is beneath everything else
  for (const Field& field : relief.fields) add_field(renderer, field, depth);
  if (!relief.ink.colors.empty())
    add_actor(renderer, *plain_mesh(depth(columns(relief.ink.corners)), {}, relief.ink.colors), false);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetPosition(-0.3, 0.45, 1); // above left of the viewer
  light->SetFocalPoint(0, 0, 0);
  renderer.AddLight(light);
}

} // namespace signorini::view
