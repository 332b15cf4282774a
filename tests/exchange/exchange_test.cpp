// Patches of other programs: files written by hand from the descriptions of the formats, bitwise round trips, and
// messages about damaged files.
#include "exchange/exchange.hpp"

#include "nurbs/directions.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/shapes.hpp"
#include "os/whole_file.hpp"
#include "scratch.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace signorini::exchange {
namespace exchange_test {

using namespace nurbs;

using signorini::test::holds;
using signorini::test::message_of;
using signorini::test::ScratchFolder;

std::vector<Patch> sample(const std::string& name) {
  return read_geometry(std::string(SAMPLE_DIR) + "/" + name).patches;
}

VectorX at(const Patch& patch, std::initializer_list<double> xi) {
  return evaluate(patch, Eigen::Map<const VectorX>(xi.begin(), static_cast<Eigen::Index>(xi.size())));
}

TEST(Exchange, ReadsGismoCurvesSurfacesAndVolumes) {
  const auto patches = sample("gismo.xml");
  ASSERT_EQ(patches.size(), 3U);
  EXPECT_EQ(patches[0].direction(0).degree(), 1);
  EXPECT_EQ(patches[0].direction(1).degree(), 2);
  for (double t : {0.0, 0.2, 0.7, 1.0}) {
    EXPECT_NEAR(at(patches[0], {0, t}).norm(), 1, 1e-15);
    EXPECT_NEAR(at(patches[0], {0.5, t}).norm(), 1.5, 1e-15);
    EXPECT_NEAR(at(patches[2], {t}).norm(), 1, 1e-15);
  }
  EXPECT_LT((at(patches[0], {1, 1}) - Vec<2>(0, 2)).norm(), 1e-15);
  EXPECT_LT((at(patches[1], {0.5, 1, 0.25}) - Vec<3>(1, 3, 1)).norm(), 1e-15);
  EXPECT_EQ(patches[1].direction(2).elements(), 2);
}

TEST(Exchange, ReadsOldAndNewGeopdesFiles) {
  const auto ring = sample("geopdes_v07.txt");
  ASSERT_EQ(ring.size(), 1U);
  for (double t : {0.0, 0.3, 1.0}) {
    const VectorX x = at(ring[0], {0.5, t, 0.25});
    EXPECT_NEAR(x.head<2>().norm(), 2, 2e-15);
    EXPECT_NEAR(x(2), 0.5, 1e-15);
  }
  const auto squares = sample("geopdes_v21.txt");
  ASSERT_EQ(squares.size(), 2U);
  EXPECT_LT((at(squares[0], {0.25, 0.75}) - Vec<2>(0.25, 0.75)).norm(), 1e-15);
  EXPECT_LT((at(squares[1], {0.25, 0.75}) - Vec<2>(1.25, 0.75)).norm(), 1e-15);
  EXPECT_EQ(squares[1].direction(0).elements(), 2);
}

TEST(Exchange, ReadsMfemMeshes) {
  const auto disc = sample("mfem.mesh");
  ASSERT_EQ(disc.size(), 1U);
  for (double t : {0.0, 0.3, 1.0}) {
    EXPECT_NEAR(at(disc[0], {t, 0}).norm(), 2, 1e-15);
    EXPECT_NEAR(at(disc[0], {1, t}).norm(), 2, 1e-15);
  }
  EXPECT_LT(at(disc[0], {0.5, 0.5}).norm(), 1e-15);
}

/// Compares knots, weights and control points bitwise.
void expect_same(const Patch& read, const Patch& written) {
  ASSERT_EQ(read.parametric_dimension(), written.parametric_dimension());
  EXPECT_EQ(read.directions(), written.directions());
  EXPECT_EQ(read.points(), written.points());
  EXPECT_EQ(read.weights(), written.weights());
}

TEST(Exchange, RoundTripsPreserveAllBits) {
  ScratchFolder folder;
  nurbs::test::Random random(3);
  for (int i = 0; i < 60; ++i) {
    const int dimension = 2 + i % 2, parametric = 1 + i % dimension;
    const Patch patch = nurbs::test::random_patch(random, parametric, dimension);
    const Patch other = elevate(nurbs::test::random_patch(random, parametric, dimension), 0, 1);
    for (const std::string& form : forms()) {
      const std::vector<Patch> written = form == "mfem" ? std::vector{patch} : std::vector{patch, other};
      write_geometry(folder.file(form), {written}, form);
      const std::vector<Patch> read = read_geometry(folder.file(form)).patches;
      ASSERT_EQ(read.size(), written.size());
      for (std::size_t k = 0; k < read.size(); ++k) expect_same(read[k], written[k]);
      if (form != "gismo") {
        EXPECT_EQ(read[0].homogeneous(), patch.homogeneous());
      }
    }
  }
}

TEST(Exchange, WritesPolynomialPatchesToXmlWithoutWeights) {
  ScratchFolder folder;
  const Patch square = rectangle(1, 1, Vec<2>::Zero());
  write_geometry(folder.file("p.xml"), {{square}}, form_named_by("p.xml"));
  const std::string text = read_file(folder.file("p.xml"));
  EXPECT_TRUE(holds(text, {"TensorBSpline2"}));
  EXPECT_FALSE(holds(text, {"weights"}));
  expect_same(read_geometry(folder.file("p.xml")).patches[0], square);
}

TEST(Exchange, WritesAMultiPatchToXmlForPatchesOfOneKind) {
  ScratchFolder folder;
  const auto text_of = [&](const std::vector<Patch>& patches) {
    write_geometry(folder.file("p.xml"), {patches}, "gismo");
    return read_file(folder.file("p.xml"));
  };
  const Patch square = rectangle(1, 1, Vec<2>::Zero());
  const std::string wanted = "<MultiPatch parDim=\"2\" id=\"3\">\n    <patches type=\"id_range\">0 2</patches>";
  EXPECT_TRUE(holds(text_of({square, square, square}), {wanted}));
  EXPECT_FALSE(holds(text_of({square, face(square, {0, false})}), {"MultiPatch"}));
}

TEST(Exchange, RecognizesFormatsByExtension) {
  EXPECT_EQ(form_named_by("a.xml"), "gismo");
  EXPECT_EQ(form_named_by("b/a.TXT"), "geopdes");
  EXPECT_EQ(form_named_by("a.mesh"), "mfem");
  EXPECT_EQ(form_named_by("a.csv"), "");
}

/// The message for an invalid text, starting with the line: ":4: exchange.text.number: …".
std::string refusal(const std::string& text) {
  ScratchFolder folder;
  const std::string file = folder.file("f");
  std::ofstream(file) << text;
  try {
    read_geometry(file);
  } catch (const Error& error) {
    const Message& message = error.message();
    if (message.code != "exchange.file.at_line") return message.code;
    return ":" + std::to_string(std::get<long long>(message.data[1].second)) + ": " +
           bare_text(std::get<std::vector<Message>>(message.data[2].second).front());
  }
  return "no error";
}

std::string replaced(const std::string& name, const std::string& from, const std::string& to) {
  std::string text = read_file(std::string(SAMPLE_DIR) + "/" + name);
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TEST(Exchange, RejectsInvalidFilesWithTheLine) {
  EXPECT_EQ(refusal(""), "exchange.file.empty");
  EXPECT_EQ(refusal("solid bracket"), "exchange.file.form");
  EXPECT_EQ(refusal("# nothing\n"), "exchange.geopdes.comments");

  EXPECT_EQ(refusal("<xml/>"), "exchange.gismo.nothing");

  const char *ring = "geopdes_v07.txt", *squares = "geopdes_v21.txt", *mesh = "mfem.mesh", *xml = "gismo.xml";
  const struct {
    const char *sample, *from, *to, *message; ///< the beginning of the message
  } cases[] = {
      {ring, "\n3\n", "\n4\n", ":3: exchange.text.integer: expected = (exchange.expected.parameters)"},
      {ring, "1 2 1\n", "1 2 1.5\n",
       ":4: exchange.text.integer: expected = (exchange.expected.degree), low = 1, high = 15, word = 1.5"},
      {ring, "0 0 0 1 1 1", "0 0 0 1 1 x", ":7: exchange.text.number: expected = (exchange.expected.knot), word = x"},
      {ring, "0 0 0 1 1 1", "0 0 1 0 1 1", ":7: nurbs.knots."},
      {ring, "\n1 1 0.7", "\n-1 1 0.7", ":12: nurbs.patch.weight: number = 0, weight = -1"},
      {squares, " 2 2 2 1 1", " 2 2 3 1 1", ":23: exchange.geopdes.patches: expected = 3, word = INTERFACE"},
      {mesh, "v1.0", "v2.0", "exchange.mfem.title"},
      {mesh, "patches", "weights", ":31: exchange.mfem.weights"},
      {mesh, "_cartesian", "_polar", ":41: exchange.mfem.points: word = "},
      {mesh, "elements\n1", "elements\n2\n1 3 0 1 2 3", ":51: exchange.mfem.patches: expected = 2"},
      {mesh, " 1.4142135623730951 1.4142135623730951 1", "1 2",
       ":50: exchange.text.end: expected = (exchange.expected.weight)"},
      {xml, "</xml>", "", "exchange.gismo.xml"},
      {xml, "TensorNurbs2", "THBSpline2", ":7: exchange.gismo.geometry: type = THBSpline2"},
      {xml, "degree=\"2\"", "degree=\"x\"",
       ":14: exchange.text.integer: expected = (exchange.expected.attribute: attribute = degree"},
      {xml, "0 0 1 1 <", "0 0 1 <", ":11: nurbs.knots."},
      {xml, "1 0\n2 0", "1 0\n2 zero",
       ":25: exchange.text.number: expected = (exchange.expected.coordinate), word = zero"},
      {xml, "0 2\n</coefs>", "0\n</coefs>", ":29: exchange.gismo.too_few: element = coefs, count = 11, expected = 12"},
      {xml, "1</weights>", "1 1</weights>", ":22: exchange.gismo.too_many: element = weights, expected = 6"},
      {xml, "geoDim=\"2\"", "geoDim=\"1\"",
       ":24: exchange.text.integer: expected = (exchange.expected.attribute: attribute = geoDim"}};
  for (const auto& [sample, from, to, message] : cases) {
    const std::string refused = refusal(replaced(sample, from, to));
    EXPECT_TRUE(refused.starts_with(message)) << refused;
  }
}

TEST(Exchange, DamagedFilesAreReadOrRejectedWithoutCrash) {
  ScratchFolder folder;
  nurbs::test::Random random(11);
  const std::string file = folder.file("f"), letters = "0 1.-e#<>/\"\nPx9";
  int refused = 0, taken = 0;
  for (const char* name : {"gismo.xml", "geopdes_v07.txt", "geopdes_v21.txt", "mfem.mesh"})
    for (int i = 0; i < 150; ++i) {
      std::string text = replaced(name, " ", " ");
      const auto place = [&] {
        return static_cast<std::size_t>(nurbs::test::integer(random, 0, static_cast<int>(text.size()) - 1));
      };
      if (i % 3 == 0) {
        text.resize(place());
      } else if (i % 3 == 1) {
        text[place()] =
            letters[static_cast<std::size_t>(nurbs::test::integer(random, 0, static_cast<int>(letters.size()) - 1))];
      } else {
        text.erase(place(), static_cast<std::size_t>(nurbs::test::integer(random, 1, 20)));
      }
      std::ofstream(file) << text;
      const std::string message = message_of([&] { taken += !read_geometry(file).patches.empty(); });
      if (message == "no error") continue;
      ++refused;
      EXPECT_TRUE(holds(message, {": file = " + file}));
    }
  EXPECT_GT(refused, 200);
  EXPECT_GT(taken, 50);
}

/// A file of a few kilobytes can claim any number of control points; memory is taken only for those that it can hold.
TEST(Exchange, RejectsMoreControlPointsThanTheFileHolds) {
  ScratchFolder folder;
  const std::string file = folder.file("f");
  std::string knots = "0 0";
  for (int i = 1; i < 199; ++i) knots += " " + std::to_string(i);
  knots += " 199 199";
  std::string vectors;
  for (int d = 0; d < 3; ++d) vectors += "1 200 " + knots + "\n";
  std::ofstream(file) << "MFEM NURBS mesh v1.0\nelements\n1\n1 5 0 1 2 3 4 5 6 7\npatches\nknotvectors\n3\n"
                      << vectors << "dimension\n3\ncontrolpoints\n0 0 0 1\n";
  EXPECT_TRUE(holds(message_of([&] { read_geometry(file); }), {"exchange.text.too_short: count = 32000000"}));
  std::ofstream(file) << "3 3 1 0 1\n1 1 1\n200 200 200\n" << knots << "\n" << knots << "\n" << knots << "\n0 0 0\n";
  EXPECT_TRUE(holds(message_of([&] { read_geometry(file); }), {"exchange.text.too_short"}));
}

/// Sides of the boundary with one attribute of many elements with the same vertices would be a list of all pairs.
TEST(Exchange, RejectsSidesOfManyElements) {
  ScratchFolder folder;
  const std::string file = folder.file("f");
  std::ofstream(file)
      << "MFEM NURBS mesh v1.0\nelements\n3\n1 3 0 1 2 3\n1 3 0 1 2 3\n1 3 0 1 2 3\nboundary\n1\n1 1 0 1\n"
      << "patches\n";
  EXPECT_TRUE(holds(message_of([&] { read_geometry(file); }), {"exchange.mfem.shared: count = 3"}));
}

TEST(Exchange, RejectsWhatAFormatCannotRepresent) {
  ScratchFolder folder;
  const Patch square = rectangle(1, 1, Vec<2>::Zero());
  const auto refused = [&](const std::vector<Patch>& patches, const std::string& form) {
    return message_of([&] { write_geometry(folder.file("p"), {patches}, form); });
  };
  EXPECT_EQ(refused({}, "gismo"), "exchange.write.nothing");
  EXPECT_TRUE(holds(refused({square, reverse(reverse(square, 0), 1)}, "mfem"), {"exchange.mfem.opposite"}));
  EXPECT_TRUE(holds(refused({square, face(square, {0, false})}, "geopdes"), {"exchange.geopdes.mixed: number = 1"}));
  EXPECT_TRUE(holds(refused({square}, "iges"), {"exchange.write.form: form = iges, known = (gismo, geopdes, mfem)"}));
  EXPECT_EQ(folder.count(), 0);
}

} // namespace exchange_test
} // namespace signorini::exchange
