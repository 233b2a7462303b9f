// Every kind of bad input, with the one line that it must give.
#include "binary_files.hpp"
#include "scene/read.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

struct Bad {
  std::string name, content, message;  // the message without the folder
};

std::string message_of(const TemporaryFolder& folder, const std::filesystem::path& file) {
  try {
    if (file.extension() == ".cameras") {
      read_cameras(file);
    } else {
      read_polygons(file);
    }
  } catch (const InputError& e) {
    const std::string message = e.what(), prefix = folder.path().string() + "/";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
  }
  return "no error";
}

void expect_messages(const std::vector<Bad>& cases) {
  const TemporaryFolder folder;
  for (const Bad& bad : cases) EXPECT_EQ(message_of(folder, folder.write(bad.name, bad.content)), bad.message);
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(BadInput, Files) {
  expect_messages({{"a.obj", "", "a.obj: file: is empty"},
                   {"a.ply", "", "a.ply: file: is empty"},
                   {"a.off", "", "a.off: file: is empty"},
                   {"a.stl", "", "a.stl: file: is empty"},
                   {"a.cameras", "", "a.cameras: file: is empty"},
                   {"a.txt", "f", "a.txt: file: has none of the extensions .obj, .ply, .off, .stl"},
                   {"a", "f", "a: file: has none of the extensions .obj, .ply, .off, .stl"}});
  const TemporaryFolder folder;
  EXPECT_EQ(message_of(folder, folder.path() / "none.obj"),
            "none.obj: file: cannot be opened: No such file or directory");
  std::filesystem::create_directory(folder.path() / "folder.obj");
  EXPECT_EQ(message_of(folder, folder.path() / "folder.obj"), "folder.obj: file: is a folder");
}

TEST(BadInput, Obj) {
  expect_messages({
      {"a.obj", square, "a.obj: file: holds no polygon"},
      {"a.obj", std::string("\x01\x02\0\xff garbage\n\x7f", 15), "a.obj: file: holds no polygon"},
      {"a.obj", "v 0 0 nan\nf 1 1 1\n", "a.obj:1: vertex 0: 'nan' is not a finite number"},
      {"a.obj", "\nv 0 -inf 0\n", "a.obj:2: vertex 0: '-inf' is not a finite number"},
      {"a.obj", square + "v 1e999 0 0\n", "a.obj:5: vertex 4: '1e999' is too large for a double"},
      {"a.obj", "v 0 -1e99999999999999999999 0\n",
       "a.obj:1: vertex 0: '-1e99999999999999999999' is too large for a double"},
      {"a.obj", "v 0 0\n", "a.obj:1: vertex 0: z is missing"},
      {"a.obj", "v\n", "a.obj:1: vertex 0: x is missing"},
      {"a.obj", "v 0 1,5 0\n", "a.obj:1: vertex 0: '1,5' is not a number"},
      {"a.obj", "v 0 0x10 0\n", "a.obj:1: vertex 0: '0x10' is not a number"},
      {"a.obj", "v 0 +-1 0\n", "a.obj:1: vertex 0: '+-1' is not a number"},
      {"a.obj", "v 0 0 0 x\n", "a.obj:1: vertex 0: 'x' is not a number"},
      {"a.obj", "v 0 \x01\x80 0\n", "a.obj:1: vertex 0: '\?\?' is not a number"},
      {"a.obj", square + "f 1 2\n", "a.obj:5: polygon 0: has fewer than 3 vertices"},
      {"a.obj", square + "f 1 2 3\nf\n", "a.obj:6: polygon 1: has fewer than 3 vertices"},
      {"a.obj", square + "f 1 2 5\n", "a.obj:5: polygon 0: vertex 5 is out of range, the file has 4"},
      {"a.obj", square + "f 1 2 0\n", "a.obj:5: polygon 0: vertex 0 is out of range, they are numbered from 1"},
      {"a.obj", square + "f 1 2 -5\n", "a.obj:5: polygon 0: vertex -5 is out of range, the file has 4"},
      {"a.obj", square + "f 1 2 4294967296\n", "a.obj:5: polygon 0: vertex 4294967296 is out of range, the file has 4"},
      {"a.obj", square + "f 1 2 99999999999999999999\n", "a.obj:5: polygon 0: '99999999999999999999' is out of range"},
      {"a.obj", square + "f 1 2 3.5\n", "a.obj:5: polygon 0: '3.5' is not an integer"},
      {"a.obj", square + "f 1 2/x 3\n", "a.obj:5: polygon 0: 'x' is not an integer"},
      {"a.obj", square + "f 1 2/1/1/1 3\n", "a.obj:5: polygon 0: '1/1' is not an integer"},
      {"a.obj", square + "f 1 \\\n2 \\\nx\n", "a.obj:7: polygon 0: 'x' is not an integer"},
  });
}

TEST(BadInput, Ply) {
  const std::string begin = "ply\nformat ascii 1.0\n",
                    vertices = "property float x\nproperty float y\nproperty float z\n",
                    faces = "property list uchar int vertex_indices\n",
                    head = begin + "element vertex 3\n" + vertices + "element face 1\n" + faces + "end_header\n";
  expect_messages({
      {"a.ply", "plx\n", "a.ply:1: header: the file does not begin with the word ply"},
      {"a.ply", "ply\nformat ascii 1.0\n", "a.ply:3: header: the file ends before end_header"},
      {"a.ply", "ply\nend_header\n", "a.ply:2: header: says no format"},
      {"a.ply", "ply\nformat ascii 2.0\n", "a.ply:2: header: version '2.0' of PLY files is not known"},
      {"a.ply", "ply\nformat mixed 1.0\n", "a.ply:2: header: 'mixed' is no format of PLY files"},
      {"a.ply", "ply\nwhat\n", "a.ply:2: header: 'what' is no word of a PLY header"},
      {"a.ply", begin + "property float x\n", "a.ply:3: header: a property stands before the first element"},
      {"a.ply", begin + "element vertex -1\n", "a.ply:3: header: a number of elements is negative"},
      {"a.ply", begin + "element vertex 1\nproperty quad x\n", "a.ply:4: header: 'quad' is no type"},
      {"a.ply", begin + "element vertex 1\nproperty float x\nproperty int x\n",
       "a.ply:5: header: property 'x' comes twice"},
      {"a.ply", begin + "element vertex 0\n" + vertices + "element vertex 0\n",
       "a.ply:7: header: element 'vertex' comes twice"},
      {"a.ply", begin + "element vertex 1\nproperty list int float x\n", "a.ply:4: header: property 'x' is a list"},
      {"a.ply", begin + "element vertex 1\nproperty float x\nend_header\n",
       "a.ply:3: header: vertices have no property y"},
      {"a.ply", begin + "element face 1\nproperty int x\nend_header\n",
       "a.ply:3: header: faces have no list vertex_indices"},
      {"a.ply", begin + "element vertex 4000000000\n" + vertices + "end_header\n0 0 0\n",
       "a.ply:3: header: says 4000000000 elements, which the file has no room for"},
      {"a.ply",
       begin + "element vertex 3\n" + vertices + "element face 99\n" + faces + "end_header\n0 0 0\n0 0 0\n0 0 0\n",
       "a.ply:7: header: says 99 elements, which the file has no room for"},
      {"a.ply", head + "0 0 0\n0 0 inf\n0 1 0\n3 0 1 2\n", "a.ply:11: vertex 1: 'inf' is not a finite number"},
      {"a.ply", head + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "a.ply:13: polygon 0: has fewer than 3 vertices"},
      {"a.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
       "a.ply:13: polygon 0: vertex 3 is out of range, the file has 3"},
      {"a.ply", head + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 3\n", "a.ply:13: polygon 0: a list has a negative length"},
      {"a.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "a.ply:14: polygon 0: the file ends before it is complete"},
      {"a.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n7\n",
       "a.ply:14: file: more numbers follow than the header counts"},
      {"a.ply", binary_ply(false).substr(0, binary_ply(false).size() - 1),
       "a.ply: polygon 0: the file ends before it is complete"},
      {"a.ply", binary_ply(true) + "x", "a.ply: file: more numbers follow than the header counts"},
      {"a.ply", begin + "element vertex 0\n" + vertices + "end_header\n", "a.ply: file: holds no polygon"},
  });
}

TEST(BadInput, PlyBinaryCoordinateIsNaN) {
  std::string bytes = binary_ply(false);
  const std::size_t body = bytes.find("end_header\n") + 11;
  bytes.replace(body, 8, "\xff\xff\xff\xff\xff\xff\xff\xff");
  expect_messages({{"a.ply", bytes, "a.ply: vertex 0: a coordinate is not a finite number"}});
}

TEST(BadInput, Off) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  expect_messages({
      {"a.off", "# nothing\n", "a.off:2: header: the file has no word OFF"},
      {"a.off", "3 1 0\n", "a.off:1: header: '3' is not the word OFF"},
      {"a.off", "4OFF\n3 1 0\n", "a.off:1: header: '4OFF': only vertices with three coordinates are read"},
      {"a.off", "nOFF\n3 1 0\n", "a.off:1: header: 'nOFF': only vertices with three coordinates are read"},
      {"a.off", "OFF BINARY\n", "a.off:1: header: 'BINARY': only OFF files in ASCII are read"},
      {"a.off", "OFF\n", "a.off:2: header: number of vertices is missing, the file ends"},
      {"a.off", "OFF\n3 -1\n0 0 0\n1 0 0\n0 1 0\n",
       "a.off:2: header: number of polygons is -1, which the file has no room for"},
      {"a.off", "OFF\n4000000000 1\n",
       "a.off:2: header: number of vertices is 4000000000, which the file has no room for"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "a.off:5: vertex 2: is missing, the file ends"},
      {"a.off", "OFF\n3 1 0\n" + vertices, "a.off:6: polygon 0: is missing, the file ends"},
      {"a.off", "OFF\n3 1 0\n" + vertices + "3 0 1\n", "a.off:6: polygon 0: vertex is missing"},
      {"a.off", "OFF\n3 1 0\n" + vertices + "3 0 1 3\n",
       "a.off:6: polygon 0: vertex 3 is out of range, the file has 3"},
      {"a.off", "OFF\n3 1 0\n" + vertices + "2 0 1\n", "a.off:6: polygon 0: has fewer than 3 vertices"},
      {"a.off", "OFF\n3 1 0\n" + vertices + "3 0 1 2\n3 0 1 2\n",
       "a.off:7: file: '3' stands behind the last polygon that the header counts"},
      {"a.off", "OFF\n3 1 0\n0 0 1e400\n", "a.off:3: vertex 0: '1e400' is too large for a double"},
  });
}

TEST(BadInput, Stl) {
  const std::string begin = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  std::string too_many = binary_stl(), infinite = binary_stl();
  too_many[83] = '\x7f';
  too_many[0] = 'x';
  infinite.replace(84 + 12, 4, std::string("\0\0\x80\x7f", 4));
  expect_messages({
      {"a.stl", "solid\nendsolid\n", "a.stl: file: holds no polygon"},
      {"a.stl", "garbage", "a.stl: header: the file ends within it"},
      {"a.stl", begin + "endloop\n", "a.stl:6: polygon 0: has fewer than 3 vertices"},
      {"a.stl", begin + "vertex 0 1\n", "a.stl:6: polygon 0: z is missing"},
      {"a.stl", begin + "vertex 0 1 0\nvertex 0 0 0\n", "a.stl:7: polygon 0: 'vertex' stands where 'endloop' belongs"},
      {"a.stl", begin + "vertex 0 1 0\nendloop\nendfacet\n", "a.stl:9: polygon 1: the file ends before endsolid"},
      {"a.stl", begin + "vertex 0 1 nan\n", "a.stl:6: polygon 0: 'nan' is not a finite number"},
      {"a.stl", too_many, "a.stl: header: says 2130706434 facets, the file has room for 2"},
      {"a.stl", "x" + binary_stl().substr(1, 150), "a.stl: header: says 2 facets, the file has room for 1"},
      {"a.stl", infinite, "a.stl: polygon 0: a coordinate is not a finite number"},
  });
}

TEST(BadInput, Cameras) {
  expect_messages({
      {"a.cameras", "# none\n", "a.cameras: file: holds no camera"},
      {"a.cameras", "0 0 0  0 1 0  0 0 1  60\n", "a.cameras:1: camera 0: aspect is missing"},
      {"a.cameras", "0 0 0  0 1 0  0 0 1  60 1 1\n", "a.cameras:1: camera 0: '1' is one number too many"},
      {"a.cameras", "0 0 0  0 1 0  0 0 1  60 1\n\n0 0 0  0 1 0  0 x 1  60 1\n",
       "a.cameras:3: camera 1: 'x' is not a number"},
      {"a.cameras", "0 0 0  0 0 0  0 0 1  60 1\n", "a.cameras:1: camera 0: forward is zero"},
      {"a.cameras", "0 0 0  0 1 0  0 0 0  60 1\n", "a.cameras:1: camera 0: up is zero"},
      {"a.cameras", "0 0 0  0 1 0  0 -2 0  60 1\n", "a.cameras:1: camera 0: up points along forward"},
      {"a.cameras", "0 0 0  0 1 0  0 0 1  180 1\n", "a.cameras:1: camera 0: angle is not between 0 and 180 degrees"},
      {"a.cameras", "0 0 0  0 1 0  0 0 1  60 0\n", "a.cameras:1: camera 0: aspect is not positive"},
      {"a.cameras", "0 0 0  0 1 0  0 0 1  60 1e300\n",
       "a.cameras:1: camera 0: angle or aspect is beyond what can be drawn"},
      {"a.cameras", "0 0 nan  0 1 0  0 0 1  60 1\n", "a.cameras:1: camera 0: 'nan' is not a finite number"},
  });
}

}  // namespace
}  // namespace sightline::test
