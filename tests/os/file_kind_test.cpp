#include "os/file_kind.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace file_kind_test {

TEST(FileKind, IsThatOfTheFirstBytes) {
  const std::pair<const char*, FileKind> cases[] = {
      {"", FileKind::empty},
      {"SIGNORINI checkpoint\n", FileKind::checkpoint},
      {"\x89HDF\r\n\x1a\n", FileKind::hdf5},
      {"\x89PNG\r\n\x1a\n", FileKind::png},
      {"%PDF-1.5", FileKind::pdf},
      {"<?xml version=\"1.0\"?>\n<svg xmlns", FileKind::svg},
      {"<?xml version=\"1.0\"?>\n<VTKFile type", FileKind::vtk},
      {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n", FileKind::gismo},
      {"<!DOCTYPE html>\n<html><svg>", FileKind::html},
      {"MFEM NURBS mesh v1.0", FileKind::mfem},
      {"# nurbs geometry v.2.1", FileKind::geopdes},
      {" {\"a\": 1}", FileKind::json},
      {"step,fx\n1,0.5\n2,\n", FileKind::table},
      {"# source: a test\nlabel,\"a,b\"\n\"two\nlines\",-1e-3\n", FileKind::table},
      {"x\n1\n2\n", FileKind::table},
      {"step,fx\n1,0.5\n2,0.", FileKind::table}, // the last line is not complete
      {"order,steps,fx\n", FileKind::table},     // without rows
      {"-- my study\n", FileKind::other},
      {"Dear reader, this is a text.\n", FileKind::other},
      {"a,b=1,2\n", FileKind::other},
      {"local a, b = 1, 2\nprint(a)\n", FileKind::other},
      {"Dear reader, this is\na text, and nothing else.\n", FileKind::other},
      {"#!/bin/sh\necho 1\n", FileKind::other},
  };
  for (const auto& [bytes, kind] : cases) EXPECT_EQ(kind_of(bytes), kind) << bytes;
  EXPECT_EQ(kind_of(std::string(100, '\0')), FileKind::empty);
  EXPECT_EQ(kind_of(std::string("\0\0\0 ftypisom", 12)), FileKind::mp4);
}

TEST(FileKind, OutputsReplaceTheirOwnKind) {
  const std::string text = "any text\n", table = "a,b\n1,2\n";
  EXPECT_TRUE(may_replace("a.h5", "", FileKind::hdf5));
  EXPECT_TRUE(may_replace("a", "\x89HDF\r\n\x1a\n", FileKind::hdf5));
  EXPECT_FALSE(may_replace("a.h5", text, FileKind::hdf5));
  EXPECT_FALSE(may_replace("a.h5", "SIGNORINI checkpoint\n", FileKind::hdf5));
  EXPECT_TRUE(may_replace("a.csv", text, FileKind::table));
  EXPECT_TRUE(may_replace("a.txt", table, FileKind::table));
  EXPECT_FALSE(may_replace("a.txt", text, FileKind::table));
  EXPECT_FALSE(may_replace("a.csv", "%PDF-1.5", FileKind::table));
  EXPECT_FALSE(may_replace("a.csv", std::string("a\0b", 3), FileKind::table));
  EXPECT_TRUE(may_replace("a.json", "3\n", FileKind::json));
  EXPECT_FALSE(may_replace("a.txt", "3\n", FileKind::json));
  EXPECT_FALSE(may_replace("study.lua", table, FileKind::table)); // it may look like one
  EXPECT_FALSE(may_replace("notes.ipynb", "{\"cells\": []}", FileKind::json));
}

} // namespace file_kind_test
} // namespace signorini
