// The robots of a placement as poses for those who drive robots: a table, JSON, or a message of ROS
// 2.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/placement.h"

namespace evenlift {

enum class PoseFormat : std::uint8_t { csv, json, yaml };

// The format that a file's name asks for by its ending .csv, .json or .yaml; nothing for any other.
// O(1).
std::optional<PoseFormat> pose_format_of_file(std::string_view file_name);

// Where the coordinates begin: as in the polygon's own file, or at the centre of mass.
enum class PoseOrigin : std::uint8_t { file, com };
std::optional<PoseOrigin> pose_origin_from_name(std::string_view text);  // "file" or "com"
inline constexpr const char* pose_origin_requirement = "the origin of poses is file or com";

// The name of a coordinate frame: 1 to 255 letters, digits, '_', '-', '.' and '/', and no '/' at
// the beginning, which ROS 2 does not take. O(bytes).
bool is_frame_name(std::string_view text);
inline constexpr const char* frame_requirement =
    "the frame is 1 to 255 letters, digits, _, -, . and /, and does not begin with /";

struct PoseOptions {
  PoseOrigin origin = PoseOrigin::file;
  std::string frame = "object";  // see is_frame_name(); a table has no place for it
};

// The robots, team after team, counted from 1: where each stands, where it faces, what it bears and
// its team. A robot with a size stands at the middle of its body, any other where it lifts. It
// faces along the inward normal of the edge at which it lifts, and at a vertex along the middle of
// the normals of the two edges there.
//   csv   a row for each robot: robot,team,x,y,heading_deg,load,unit,weight_unit
//   json  {"frame", "origin", "unit", "weight_unit", "robots": [{"robot", "team", "x", "y",
//         "heading_deg", "direction": [x, y], "load"}]}, direction being the heading as a vector of
//         length 1
//   yaml  a geometry_msgs/msg/PoseArray as `ros2 topic pub` takes it: positions in metres, z = 0; the
//         rotation is about z, and turns x into the heading; loads and teams are comments
// Tables and JSON are in the placement's own units. Numbers are written with the fewest digits that
// read back to the same double. In YAML an object without a unit counts as one in metres, and the
// first lines say so. The same bytes on every platform. O(n + m).
std::string poses_text(const ShownPlacement& of, PoseFormat format,
                       const PoseOptions& options = {});

}  // namespace evenlift
