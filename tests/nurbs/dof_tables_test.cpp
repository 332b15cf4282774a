// Published numbers of degrees of freedom, every row from share/reference, for the setups of the published problems.
#include "nurbs/discretization.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

namespace signorini::nurbs {
namespace dof_tables_test {

using Rows = std::vector<std::map<std::string, std::string>>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Reads a table by its header; the first line is a comment.
Rows read(const std::string& name) {
  std::ifstream file(REFERENCE_DIR "/" + name);
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  const auto header = split(line);
  Rows rows;
  while (std::getline(file, line)) {
    const auto cells = split(line);
    rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i) rows.back()[header[i]] = i < cells.size() ? cells[i] : "";
  }
  return rows;
}

struct Count {
  int interface, total;
  int bulk() const { return total - interface; }
};

Count count(const Patch& patch, std::vector<int> elements, const std::string& label, const std::string& contact) {
  const int dimension = patch.dimension();
  Plan plan;
  plan.elements = std::move(elements);
  plan.contact = {side_of(contact, dimension)};
  plan.labels.assign(static_cast<std::size_t>(dimension) - 1, parse_label(label));
  plan.thickness_degree = 1;
  const Discretization space(patch, plan);
  return {dimension * static_cast<int>(space.face_functions(plan.contact.front()).size()),
          dimension * space.functions()};
}

int value(const std::map<std::string, std::string>& row, const char* column) {
  return std::stoi(row.at(column));
}

TEST(DofTables, Ironing2dTable72) {
  const Rows rows = read("ironing2d_dofs_table7_2.csv");
  ASSERT_EQ(rows.size(), 8u);
  for (const auto& row : rows) {
    const std::string label = row.at("discretization");
    const Count die = count(half_annulus(0.3, 0.5, Eigen::Vector2d(0.75, 1.5)), {6, 2}, label, "south");
    const Count slab = count(rectangle(3, 1, Eigen::Vector2d(0, 0)), {8, 3}, label, "north");
    EXPECT_EQ(die.interface, value(row, "die_interface")) << label;
    EXPECT_EQ(die.bulk(), value(row, "die_bulk")) << label;
    EXPECT_EQ(die.total, value(row, "die_total")) << label;
    EXPECT_EQ(slab.interface, value(row, "slab_interface")) << label;
    EXPECT_EQ(slab.bulk(), value(row, "slab_bulk")) << label;
    EXPECT_EQ(slab.total, value(row, "slab_total")) << label;
    EXPECT_EQ(die.total + slab.total, value(row, "total")) << label;
  }
}

TEST(DofTables, Hertz2dTable74) {
  const Rows rows = read("hertz2d_dofs_table7_4.csv");
  ASSERT_EQ(rows.size(), 21u);
  for (const auto& row : rows) {
    // m1 … m6 have 9, 18, 36, … elements along the arc.
    const int n = 1 << (std::stoi(row.at("mesh").substr(1)) - 1);
    const Count ring =
        count(quarter_annulus(0.1, 1, Eigen::Vector2d(0, 1), -90), {9 * n, 48}, row.at("discretization"), "south");
    EXPECT_EQ(ring.interface, value(row, "interface")) << row.at("mesh") << " " << row.at("discretization");
    EXPECT_EQ(ring.bulk(), value(row, "bulk")) << row.at("mesh") << " " << row.at("discretization");
    EXPECT_EQ(ring.total, value(row, "total")) << row.at("mesh") << " " << row.at("discretization");
  }
}

TEST(DofTables, PeelingTables78AndB2) {
  const Rows rows = read("peeling2d_table7_8_and_B2.csv");
  ASSERT_EQ(rows.size(), 39u);
  const std::map<std::string, std::vector<int>> meshes{{"m1", {160, 8}}, {"m2", {200, 10}}, {"m3", {240, 12}}};
  for (const auto& row : rows) {
    const Count strip =
        count(rectangle(200, 10, Eigen::Vector2d(0, 0)), meshes.at(row.at("mesh")), row.at("discretization"), "south");
    EXPECT_EQ(strip.total, value(row, "dofs")) << row.at("mesh") << " " << row.at("discretization");
  }
}

TEST(DofTables, Ironing3dTable711) {
  const Rows rows = read("ironing3d_dofs_table7_11.csv");
  ASSERT_EQ(rows.size(), 8u);
  for (const auto& row : rows) {
    const std::string label = row.at("discretization");
    const int n = row.at("mesh") == "fine" ? 2 : 1;
    const Count slab = count(block({100, 30, 22}, Eigen::Vector3d(0, 0, 0)), {18 * n, 6 * n, 4 * n}, label, "back");
    // The cap is one biquadratic span: existing knots would keep their continuity and add unknowns at higher degrees.
    const Patch cap = spherical_indenter(10, 10, 11, 25.5, 1, Eigen::Vector3d(0, 0, 22));
    const Count indenter = count(cap, {5 * n, 5 * n, 3 * n}, label, "front");
    EXPECT_EQ(slab.interface, value(row, "slab_interface")) << label;
    EXPECT_EQ(slab.bulk(), value(row, "slab_bulk")) << label;
    EXPECT_EQ(slab.total, value(row, "slab_total")) << label;
    EXPECT_EQ(indenter.interface, value(row, "indenter_interface")) << label;
    EXPECT_EQ(indenter.bulk(), value(row, "indenter_bulk")) << label;
    EXPECT_EQ(indenter.total, value(row, "indenter_total")) << label;
    EXPECT_EQ(slab.total + indenter.total, value(row, "total")) << label;
  }
}

} // namespace dof_tables_test
} // namespace signorini::nurbs
