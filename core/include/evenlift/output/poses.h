// Writes the robots' poses for software that controls them: as a table, JSON, or a ROS 2 message.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/report.h"

namespace evenlift {

enum class PoseFormat : std::uint8_t { csv, json, yaml };

// Returns the format for a file name that ends in .csv, .json or .yaml. Returns nothing otherwise.
// O(1).
std::optional<PoseFormat> pose_format_of_file(std::string_view file_name);

// The origin of the coordinates: either that of the polygon's file, or the centre of mass.
enum class PoseOrigin : std::uint8_t { file, com };
std::optional<PoseOrigin> pose_origin_from_name(std::string_view text);  // "file" or "com"
inline constexpr const char* pose_origin_requirement = "the origin of poses must be file or com";

// Returns whether a text can name a coordinate frame: 1 to 255 letters, digits, '_', '-', '.' and
// '/'. It must not begin with a '/', which ROS 2 rejects there. O(bytes).
bool is_frame_name(std::string_view text);
inline constexpr const char* frame_requirement =
    "the frame must be 1 to 255 letters, digits, _, -, . and /, without / at the beginning";

struct PoseOptions {
  PoseOrigin origin = PoseOrigin::file;
  std::string frame = "object";  // see is_frame_name(); not in tables
};

// Returns the position, heading, load and team of each robot, team after team. Robots and teams are
// counted from 1. The position of a robot with a size is the centre of its body; otherwise it is
// the lifting point. The heading is that of PlacedRobot (placed_robots.h). Where the robot lifts
// (at) and touches (contact; not beneath the object) is told, too, so that each format can be read
// back as supports (import.h), and its name if it has one.
//   csv   a row for each robot:
//         robot,team,x,y,heading_deg,load,unit,weight_unit,at_x,at_y,contact_x,contact_y,name
//   json  {"frame", "origin", "unit", "weight_unit", "robots": [{"robot", "team", "x", "y",
//         "heading_deg", "direction": [x, y], "load", "at": [x, y], "contact": [x, y] or null,
//         "name"}]}; `direction` is the heading as a vector of length 1
//   yaml  a geometry_msgs/msg/PoseArray that `ros2 topic pub` accepts, with positions in metres and
//         z = 0. A rotation about the z axis turns the x axis to the heading. Loads, teams and
//         names are in comments, and for robots with a size poses_lift and poses_touch with points
// Tables and JSON are in the placement's units. Numbers have the fewest digits that read back to
// the same double. If the object has no unit, the YAML takes the object's coordinates to be in
// metres, and states this in its first lines. The bytes are the same on every platform. O(n + m).
std::string poses_text(const ShownPlacement& of, PoseFormat format,
                       const PoseOptions& options = {});

}  // namespace evenlift
