#include "view/vtk/relief_actors.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>

namespace signorini::view {
namespace {

/// From pixels towards the eye to what the camera sees beneath the plane of the drawing.
struct Depth {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(const std::vector<Vec3>& points) {
    for (const Vec3& p : points) low = std::min(low, p[2]), high = std::max(high, p[2]);
  }
  double operator()(double z) const { return -0.9 + 0.8 * (z - low) / std::max(high - low, 1e-12); }
};

vtkSmartPointer<vtkPoints> points_of(const std::vector<Vec3>& points, const Depth& depth) {
  auto result = vtkSmartPointer<vtkPoints>::New();
  for (const Vec3& p : points) result->InsertNextPoint(p[0], p[1], depth(p[2]));
  return result;
}

vtkSmartPointer<vtkFloatArray> normals_of(const std::vector<Vec3>& normals) {
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetNumberOfComponents(3);
  for (const Vec3& n : normals) result->InsertNextTuple(n.data());
  return result;
}

/// Three points each, in their order.
vtkSmartPointer<vtkCellArray> loose_triangles(std::size_t count) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (vtkIdType t = 0; t < static_cast<vtkIdType>(count); ++t) cells->InsertNextCell({3 * t, 3 * t + 1, 3 * t + 2});
  return cells;
}

template <std::size_t N>
vtkSmartPointer<vtkUnsignedCharArray> colours_of(const std::vector<std::array<std::uint8_t, N>>& colours) {
  auto result = vtkSmartPointer<vtkUnsignedCharArray>::New();
  result->SetNumberOfComponents(N);
  for (const auto& colour : colours) result->InsertNextTypedTuple(colour.data());
  return result;
}

/// Little shade, so that colours keep their meaning: what faces the light shows them as the colour bar does.
void light_up(vtkActor& actor) {
  actor.GetProperty()->SetAmbient(0.72);
  actor.GetProperty()->SetDiffuse(0.32);
  actor.GetProperty()->SetSpecular(0);
}

vtkSmartPointer<vtkActor> surface_actor(const Shaded& surface, const Depth& depth) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_of(surface.points, depth));
  data->GetPointData()->SetNormals(normals_of(surface.normals));
  vtkNew<vtkCellArray> cells;
  for (const auto& t : surface.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  data->SetPolys(cells);
  vtkNew<vtkFloatArray> values;
  for (double value : surface.values) values->InsertNextValue(static_cast<float>(value));
  data->GetPointData()->SetScalars(values);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  colour_by_value(*mapper, surface.range, surface.colours);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  light_up(*actor);
  return actor;
}

vtkSmartPointer<vtkActor> ink_actor(const Ink& ink, const Depth& depth) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_of(ink.corners, depth));
  data->SetPolys(loose_triangles(ink.colours.size()));
  data->GetCellData()->SetScalars(colours_of(ink.colours));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  return flat_actor(*mapper);
}

/// Blended in the order given over the ground, behind the depths of all else. In the pass of opaque surfaces, because
/// OpenGL blends there too; VTK's pass for translucent ones keeps buffers that cost more time than all the drawing.
vtkSmartPointer<vtkActor> veil_actor(const Veil& veil) {
  constexpr double farthest = -0.98, nearest = -0.92;
  vtkNew<vtkPoints> points;
  const double step = (nearest - farthest) / static_cast<double>(veil.corners.size());
  for (std::size_t i = 0; i < veil.corners.size(); ++i)
    points->InsertNextPoint(veil.corners[i][0], veil.corners[i][1], farthest + step * static_cast<double>(i - i % 3));
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals_of(veil.normals));
  data->SetPolys(loose_triangles(veil.colours.size()));
  data->GetCellData()->SetScalars(colours_of(veil.colours));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->ForceOpaqueOn();
  light_up(*actor);
  return actor;
}

} // namespace

vtkSmartPointer<vtkActor> flat_actor(vtkPolyDataMapper& mapper) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(&mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

void colour_by_value(vtkPolyDataMapper& mapper, const std::array<double, 2>& range, const std::vector<Rgb>& colours) {
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(static_cast<vtkIdType>(colours.size()));
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const Rgb& c = colours[i];
    table->SetTableValue(static_cast<vtkIdType>(i), c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
  }
  table->SetTableRange(range[0], range[1]);
  mapper.SetLookupTable(table);
  mapper.UseLookupTableScalarRangeOn();
  mapper.InterpolateScalarsBeforeMappingOn();
}

void add_relief(vtkRenderer& renderer, const Relief& relief) {
  Depth depth;
  for (const Shaded& surface : relief.surfaces) depth.take(surface.points);
  depth.take(relief.ink.corners);
  if (depth.low > depth.high && relief.veil.colours.empty()) return;
  if (!relief.veil.colours.empty()) renderer.AddActor(veil_actor(relief.veil)); // first: it is drawn beneath
  for (const Shaded& surface : relief.surfaces) renderer.AddActor(surface_actor(surface, depth));
  if (!relief.ink.colours.empty()) renderer.AddActor(ink_actor(relief.ink, depth));
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetPosition(-0.3, 0.45, 1); // from over the reader's left shoulder
  light->SetFocalPoint(0, 0, 0);
  renderer.AddLight(light);
}

} // namespace signorini::view
